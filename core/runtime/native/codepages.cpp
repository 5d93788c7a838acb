#include "core/runtime/native/codepages.h"

namespace camwright::native {

using asmjit::VirtMem::MemoryFlags;

CodePages::~CodePages()
{
    if (m_data)
        asmjit::VirtMem::release(m_data, m_bytes);
}

bool CodePages::fill(asmjit::CodeHolder& code)
{
    if (code.flatten() != asmjit::kErrorOk || code.resolveUnresolvedLinks() != asmjit::kErrorOk)
        return false;
    const std::size_t page = asmjit::VirtMem::info().pageSize;
    m_bytes = (code.codeSize() + page - 1) / page * page;
    if (asmjit::VirtMem::alloc(&m_data, m_bytes, MemoryFlags::kAccessRW) != asmjit::kErrorOk) {
        m_data = nullptr;
        return false;
    }
    if (code.relocateToBase(reinterpret_cast<std::uintptr_t>(m_data)) != asmjit::kErrorOk)
        return false;
    m_codeBytes = code.codeSize();
    if (code.copyFlattenedData(m_data, m_bytes) != asmjit::kErrorOk)
        return false;
    asmjit::VirtMem::flushInstructionCache(m_data, m_codeBytes);
    return asmjit::VirtMem::protect(m_data, m_bytes, MemoryFlags::kAccessRX) == asmjit::kErrorOk;
}

} // namespace camwright::native
