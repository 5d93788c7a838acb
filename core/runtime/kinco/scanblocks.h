#pragma once

#include "core/base/bytes.h"
#include "core/runtime/executor/blockhost.h"
#include "core/runtime/kinco/callsite.h"
#include "core/runtime/kinco/exchange.h"

namespace camwright::kinco {

/// The scan's half of the MC_* instructions: finds edges, collects what the calls want, shows what motion answered. It
/// shares nothing with the motion task but the two exchange buffers, swapped at the scan's edges (CONTRACTS 10).
class ScanBlocks : public BlockHost {
public:
    ScanBlocks(const CallSites& sites, std::size_t axes);

    /// A program start: every call forgets its EXEC, so that a held EXEC is an edge of the first scan.
    void startProgram();
    /// At a scan's start.
    void take(const MotionReports& reports) { m_reports = reports; }
    /// At a scan's end.
    const ScanCommands& commands() const { return m_commands; }

    void call(InstructionId instruction, const BlockInstance& instance, PinValues& pins) override;

    void save(ByteWriter& writer) const;
    void restore(ByteReader& reader);

private:
    struct Memory {
        bool exec = false;             ///< EXEC of the last enabled pass
        bool shown = true;             ///< the end of the last execution is in the outputs
        std::uint32_t written = 0;     ///< MC_RPARAS: cells already written
    };

    void collect(const CallSite& site, std::uint32_t number, PinValues& pins);
    void start(const CallSite& site, std::uint32_t number, PinValues& pins);
    void readList(const CallSite& site, std::uint32_t number, PinValues& pins);
    void show(const CallSite& site, std::uint32_t number, PinValues& pins);
    void showCells(const CallSite& site, std::uint32_t number, PinValues& pins);
    void showState(PinValues& pins) const;

    const CallSites& m_sites;
    std::vector<Memory> m_memory;
    ScanCommands m_commands;
    MotionReports m_reports;
};

} // namespace camwright::kinco
