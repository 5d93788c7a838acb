#pragma once

#include <asmjit/core.h>
#include <cstddef>
#include <cstdint>

namespace camwright::native {

/// Pages of the process that hold machine code. They are written while they cannot be executed, and executed when they can
/// no longer be written.
class CodePages {
public:
    CodePages() = default;
    CodePages(const CodePages&) = delete;
    CodePages& operator=(const CodePages&) = delete;
    ~CodePages();

    /// Puts the code there; false if the system gives no such pages. Once.
    bool fill(asmjit::CodeHolder& code);
    const std::uint8_t* data() const { return static_cast<const std::uint8_t*>(m_data); }
    std::size_t codeBytes() const { return m_codeBytes; }

private:
    void* m_data = nullptr;
    std::size_t m_bytes = 0;
    std::size_t m_codeBytes = 0;
};

} // namespace camwright::native
