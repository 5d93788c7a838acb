#include "core/runtime/log/controllerlog.h"

#include "core/runtime/log/saveddiagnostic.h"

namespace camwright {

void ControllerLog::setMoment(std::uint64_t cycle, Time time)
{
    m_cycle = cycle;
    m_time = time;
}

void ControllerLog::add(Code code, std::vector<std::string> arguments)
{
    add(diagnostic(code, std::move(arguments)));
}

void ControllerLog::add(Diagnostic message)
{
    if (m_entries.size() == kCapacity)
        m_entries.pop_front();
    m_entries.push_back({m_next++, m_cycle, m_time, std::move(message)});
}

std::vector<LogEntry> ControllerLog::since(std::uint64_t sequence) const
{
    std::vector<LogEntry> out;
    for (const LogEntry& entry : m_entries) {
        if (entry.sequence >= sequence)
            out.push_back(entry);
    }
    return out;
}

void ControllerLog::save(ByteWriter& writer) const
{
    writer.put(m_next);
    writer.put(m_cycle);
    writer.put(m_time.count());
    writer.put(static_cast<std::uint32_t>(m_entries.size()));
    for (const LogEntry& entry : m_entries) {
        writer.put(entry.sequence);
        writer.put(entry.cycle);
        writer.put(entry.time.count());
        saveDiagnostic(writer, entry.message);
    }
}

void ControllerLog::restore(ByteReader& reader)
{
    m_entries.clear();
    m_next = reader.get<std::uint64_t>();
    m_cycle = reader.get<std::uint64_t>();
    m_time = Time(reader.get<std::int64_t>());
    const auto count = reader.get<std::uint32_t>();
    for (std::uint32_t i = 0; i < count && reader.ok(); ++i) {
        LogEntry entry;
        entry.sequence = reader.get<std::uint64_t>();
        entry.cycle = reader.get<std::uint64_t>();
        entry.time = Time(reader.get<std::int64_t>());
        entry.message = restoreDiagnostic(reader);
        m_entries.push_back(std::move(entry));
    }
    while (m_entries.size() > kCapacity)
        m_entries.pop_front();
}

} // namespace camwright
