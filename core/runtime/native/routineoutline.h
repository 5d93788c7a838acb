#pragma once

#include "core/language/ir/ir.h"
#include "core/runtime/memory/memory.h"

#include <cstdint>
#include <vector>

namespace camwright::native {

/// What one look from the end to the beginning tells of a routine: where jumps go, and which memory is looked at again
/// before the line ends.
class RoutineOutline {
public:
    static constexpr std::uint32_t NoLabel = 0;

    RoutineOutline(const IrRoutine& routine, const Memory& memory);

    /// Labels are numbered from 1, in no particular order.
    std::uint32_t labelAt(std::uint32_t instruction) const { return m_labels[instruction]; }
    std::uint32_t labelCount() const { return m_labelCount; }
    /// Whether a jump comes to the label from below: nothing is known there of what registers hold.
    bool isLoop(std::uint32_t label) const { return m_isLoop[label]; }
    bool hasLoops() const { return m_hasLoops; }
    /// Load or Store: its memory is read, or its byte written, again soon.
    bool isLookedAtAgain(std::uint32_t instruction) const { return m_again[instruction]; }

private:
    void findLabels(const IrRoutine& routine);
    void findRepeats(const IrRoutine& routine, const Memory& memory);

    std::vector<std::uint32_t> m_labels;
    std::vector<bool> m_isLoop{false};
    std::vector<bool> m_again;
    std::uint32_t m_labelCount = 0;
    bool m_hasLoops = false;
};

} // namespace camwright::native
