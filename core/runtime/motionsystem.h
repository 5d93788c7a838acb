#pragma once

#include "core/base/bytes.h"
#include "core/base/result.h"
#include "core/base/time.h"
#include "core/online/controllerlink.h"
#include "core/runtime/engineinput.h"
#include "core/runtime/executor/blockhost.h"
#include "core/runtime/valueref.h"

#include <cstdint>
#include <string>

namespace camwright {

/// The hidden motion task of a family with everything behind it: axes, bus, drives. The engine calls it in the order of an
/// instant: inputs, endScan(), cycle(), beginScan(). Program and motion meet only in the two exchange buffers that
/// beginScan() and endScan() swap (CONTRACTS 10).
class MotionSystem {
public:
    virtual ~MotionSystem() = default;

    virtual BlockHost& blocks() = 0;
    virtual void beginScan() = 0;
    virtual void endScan() = 0;
    /// STOP to RUN: calls forget their edges; panels let go.
    virtual void startProgram() = 0;
    /// The program has stopped, for whatever reason: its calls end, every axis is stopped and then released.
    virtual void stopProgram() = 0;
    /// No axis has power and none is about to.
    virtual bool isReleased() const = 0;

    /// The bus has tried every node: a program may start.
    virtual bool isReady() const = 0;

    virtual void cycle(std::uint64_t cycle, Time now) = 0;
    /// Supply off and on.
    virtual void powerCycle(Time now) = 0;

    virtual std::size_t axisCount() const = 0;
    virtual std::string axisName(std::size_t axis) const = 0;
    virtual std::string axisUnit(std::size_t axis) const = 0; ///< "mm", "°"
    virtual AxisStatus axisStatus(std::size_t axis) const = 0;
    virtual double read(std::size_t axis, AxisField field) const = 0;
    virtual double readPlant(std::size_t axis, AxisField field) const = 0; ///< State and Error give 0
    virtual double busLoadPercent() const = 0;

    virtual Result<void> panel(const input::Panel& command) = 0;
    virtual void heartbeat(const input::Heartbeat& beat) = 0;
    virtual void stopAllAxes() = 0;
    virtual Result<void> inject(const input::InjectFault& fault) = 0;

    virtual void save(ByteWriter& writer) const = 0;
    virtual void restore(ByteReader& reader) = 0;
};

} // namespace camwright
