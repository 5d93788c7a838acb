#pragma once

#include "core/runtime/motionsystem.h"

namespace camwright {

/// A controller that runs its program only.
class NoMotion final : public MotionSystem, private BlockHost {
public:
    BlockHost& blocks() override { return *this; }
    void beginScan() override {}
    void endScan() override {}
    void startProgram() override {}
    void stopProgram() override {}
    bool isReleased() const override { return true; }
    bool isReady() const override { return true; }
    void cycle(std::uint64_t, Time) override {}
    void powerCycle(Time) override {}
    std::size_t axisCount() const override { return 0; }
    std::string axisName(std::size_t) const override { return {}; }
    std::string axisUnit(std::size_t) const override { return {}; }
    AxisStatus axisStatus(std::size_t) const override { return {}; }
    double read(std::size_t, AxisField) const override { return 0; }
    double readPlant(std::size_t, AxisField) const override { return 0; }
    double busLoadPercent() const override { return 0; }
    Result<void> panel(const input::Panel& command) override;
    void heartbeat(const input::Heartbeat&) override {}
    void stopAllAxes() override {}
    Result<void> inject(const input::InjectFault& fault) override;
    void save(ByteWriter&) const override {}
    void restore(ByteReader&) override {}

private:
    void call(InstructionId, const BlockInstance&, PinValues&) override {}
};

} // namespace camwright
