#pragma once

#include <cstdint>
#include <map>
#include <vector>

namespace camwright {

/// One copy of each constant of a program, 8 bytes each, in the order of their first use.
class ConstantPool {
public:
    explicit ConstantPool(std::uint32_t offset) : m_offset(offset) {}

    void add(std::uint64_t bits);
    std::uint32_t offsetOf(std::uint64_t bits) const { return m_offset + 8 * m_numbers.at(bits); }
    std::uint32_t end() const { return m_offset + 8 * static_cast<std::uint32_t>(m_bits.size()); }
    const std::vector<std::uint64_t>& bits() const { return m_bits; }

private:
    std::uint32_t m_offset;
    std::map<std::uint64_t, std::uint32_t> m_numbers;
    std::vector<std::uint64_t> m_bits;
};

/// Hands out 8 bytes for each register that must lie somewhere. Registers of different routines never share, so a call
/// leaves those of its caller alone.
class SlotAllocator {
public:
    explicit SlotAllocator(std::uint32_t offset) : m_end(offset) {}

    /// `mayReuse`: false where instructions run again after later ones (backward jumps).
    void beginRoutine(bool mayReuse);
    std::uint32_t take();
    /// Nobody reads the slot after the steps that are still pending; it may be taken again after settle().
    void giveBack(std::uint32_t offset) { m_returned.push_back(offset); }
    /// No step is pending.
    void settle();
    std::uint32_t end() const { return m_end; }

private:
    std::uint32_t m_end;
    bool m_mayReuse = true;
    std::vector<std::uint32_t> m_free;
    std::vector<std::uint32_t> m_returned;
};

} // namespace camwright
