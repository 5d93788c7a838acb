#include "core/runtime/executor/scratch.h"

namespace camwright {

void ConstantPool::add(std::uint64_t bits)
{
    if (m_numbers.try_emplace(bits, static_cast<std::uint32_t>(m_bits.size())).second)
        m_bits.push_back(bits);
}

void SlotAllocator::beginRoutine(bool mayReuse)
{
    m_mayReuse = mayReuse;
    m_free.clear();
    m_returned.clear();
}

std::uint32_t SlotAllocator::take()
{
    if (m_free.empty()) {
        m_end += 8;
        return m_end - 8;
    }
    const std::uint32_t offset = m_free.back();
    m_free.pop_back();
    return offset;
}

void SlotAllocator::settle()
{
    if (m_mayReuse)
        m_free.insert(m_free.end(), m_returned.begin(), m_returned.end());
    m_returned.clear();
}

} // namespace camwright
