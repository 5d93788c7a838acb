#pragma once

#include "core/runtime/blocks/interrupttable.h"
#include "core/runtime/blocks/realtimeclock.h"
#include "core/runtime/executor/blockhost.h"

namespace camwright {

/// The blocks a program may call: data blocks, clock and interrupts here, everything else at the host of the motion system.
class ProgramBlocks final : public BlockHost {
public:
    /// Both outlive it.
    ProgramBlocks(const ControllerImage& image, BlockHost& motion) : m_interrupts(image), m_motion(motion) {}

    void call(InstructionId instruction, const BlockInstance& instance, PinValues& pins) override;

    InterruptTable& interrupts() { return m_interrupts; }
    RealTimeClock& clock() { return m_clock; }

    void save(ByteWriter& writer) const;
    void restore(ByteReader& reader);

private:
    bool callInterrupts(InstructionId instruction, const BlockInstance& instance, PinValues& pins);
    bool callClock(InstructionId instruction, const BlockInstance& instance, PinValues& pins);

    InterruptTable m_interrupts;
    RealTimeClock m_clock;
    BlockHost& m_motion;
};

} // namespace camwright
