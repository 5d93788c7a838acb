#pragma once

#include "core/base/bytes.h"
#include "core/base/time.h"
#include "core/family/family.h"
#include "core/runtime/executor/executor.h"

#include <memory>
#include <vector>

namespace camwright {

/// IR instructions a scan may execute for each millisecond of its watchdog time (CONTRACTS 10: the watchdog counts
/// operations; the number is ours).
inline constexpr std::uint64_t kWatchdogOperationsPerMs = 2000;

/// Where an image names no watchdog time.
inline constexpr Time kDefaultWatchdog = 500ms;

/// The main scan: when it begins and ends, its process image, forces and watchdog. A scan's code runs at its beginning and
/// its end comes the family's modelled scan time later (CONTRACTS 10); a constant period counts from beginning to beginning.
class ScanTask {
public:
    ScanTask(const Family& family, ScanExecutor executor);

    Memory& memory() { return m_executor.memory(); }
    const Memory& memory() const { return m_executor.memory(); }
    const ControllerImage& image() const { return m_executor.image(); }

    /// Memory and hidden state as after power-on.
    void powerOn();
    /// STOP to RUN: timers and edges start anew, memory stays (ours; the manuals do not say).
    void start(Time now);
    /// Outputs take their STOP values, 0 (KS-CPU-05; no setting for others exists yet).
    void stop();
    bool isRunning() const { return m_running; }

    /// True once, when the running scan's end has come.
    bool endsAt(Time now);
    bool beginsAt(Time now) const { return m_running && !m_inScan && now >= m_nextStart; }
    ScanReport run(Time now, BlockHost& host);
    /// One pass of an interrupt routine, on the process image as it is (ours).
    ScanReport runInterrupt(std::uint32_t routine, Time now, BlockHost& host);
    /// An input as its terminal has it, or as it is forced.
    bool inputLevel(const Address& address) const;
    Time modelledTime() const { return m_scanTime; }
    Time watchdog() const { return m_watchdog; }

    /// Writes memory; for an input terminal the terminal too, which stays.
    bool write(const Address& address, const Value& value);
    void force(const Address& address, const Value& value);
    bool release(const Address& address);
    void releaseAll() { m_forces.clear(); }
    const std::vector<Force>& forces() const { return m_forces; }
    bool isForced(const Address& address) const;

    /// Terminals of another program's task; sizes may differ.
    void takeTerminals(const ScanTask& other);

    void save(ByteWriter& writer) const;
    bool restore(ByteReader& reader);

private:
    struct Terminals {
        AreaId area = 0;
        std::vector<std::uint8_t> bytes;
    };

    void takeInputs();
    void setTerminal(Terminals& terminals, const Address& address, const Value& value);
    void prepare(Time now);

    const Family& m_family;
    ScanExecutor m_executor;
    Time m_scanTime;
    Time m_period{};
    Time m_watchdog;
    std::vector<Terminals> m_inputs;
    std::vector<Force> m_forces;      ///< sorted by address
    bool m_running = false, m_inScan = false;
    bool m_firstScan = false, m_firstAfterPowerOn = true;
    bool m_toggle = false, m_error = false;
    Time m_nextStart{}, m_end{};
};

} // namespace camwright
