#include "core/runtime/blocks/interrupttable.h"

#include "core/family/kinco/kincoareas.h"

#include <algorithm>

namespace camwright {

namespace {

/// Events that came while interrupts were disabled, or faster than the controller's cycle, are run at most so often.
constexpr std::uint32_t MostWaiting = 100;

constexpr Time KincoTimeBase = 100us; // KS-CPU: timed interrupts count 0.1 ms

struct KincoTimedEvent {
    std::uint32_t number;
    std::uint32_t periodByte; ///< of SM
};
constexpr KincoTimedEvent KincoTimedEvents[] = {{3, 22}, {4, 24}};

/// Rising edge of I0.3 is 19, falling 20; up to I0.0 with 25 and 26 (common form of this tool family).
constexpr std::uint32_t FirstKincoEdge = 19;
constexpr std::uint32_t KincoEdgeInputs = 4;

} // namespace

InterruptTable::InterruptTable(const ControllerImage& image) : m_image(image), m_isKinco(image.target.family == "kinco")
{
    if (m_isKinco) {
        for (const KincoTimedEvent& event : KincoTimedEvents)
            m_events.push_back({event.number, InterruptCause::Timed, valueAddress(kinco::SM, event.periodByte, DataType::Word), {}, 0, 0, {}, false});
        for (std::uint32_t i = 0; i < 2 * KincoEdgeInputs; ++i) {
            const Address input = bitAddress(kinco::I, 0, KincoEdgeInputs - 1 - i / 2);
            m_events.push_back({FirstKincoEdge + i, i % 2 == 0 ? InterruptCause::Rising : InterruptCause::Falling, input, {}, 0, 0, {}, false});
        }
        return;
    }
    for (const InterruptSource& source : image.configuration.interrupts)
        m_events.push_back({static_cast<std::uint32_t>(m_events.size()), source.cause, source.input, source.period, 1 + source.routine, 0, {}, false});
}

void InterruptTable::start(Time now, const Level& level)
{
    m_isEnabled = m_isKinco;
    for (Event& event : m_events) {
        event.waiting = 0;
        event.due = now + event.period;
        if (m_isKinco)
            event.routine = 0;
        if (event.cause != InterruptCause::Timed)
            event.level = level(event.place);
    }
}

InterruptTable::Event* InterruptTable::find(std::uint32_t number)
{
    const auto found = std::ranges::find(m_events, number, &Event::number);
    return found == m_events.end() ? nullptr : &*found;
}

bool InterruptTable::isInterrupt(std::uint32_t routine) const
{
    return routine < m_image.program.routines.size() && m_image.program.routines[routine].kind == RoutineKind::Interrupt;
}

void InterruptTable::attach(std::uint32_t number, std::uint32_t routine, const Memory& memory, Time now)
{
    Event* event = find(number);
    if (!event || !isInterrupt(routine))
        return;
    if (event->cause == InterruptCause::Timed) {
        const Time period = KincoTimeBase * memory.read(event->place).asInteger();
        const bool goesOn = event->routine != 0 && period == event->period; // attached again in every scan, it keeps its beat
        event->period = period;
        event->due = goesOn ? event->due : now + period;
    }
    event->routine = 1 + routine;
}

void InterruptTable::detach(std::uint32_t number)
{
    if (Event* event = find(number)) {
        event->routine = 0;
        event->waiting = 0;
    }
}

void InterruptTable::watchTime(Event& event, Time now)
{
    if (event.routine == 0 || event.period <= Time{} || now < event.due)
        return;
    const std::int64_t times = (now - event.due) / event.period + 1;
    event.due += event.period * times;
    event.waiting = static_cast<std::uint32_t>(std::min<std::int64_t>(MostWaiting, event.waiting + times));
}

void InterruptTable::watchInput(Event& event, bool level)
{
    const bool came = level != event.level && level == (event.cause == InterruptCause::Rising);
    event.level = level;
    if (came && event.routine != 0)
        event.waiting = std::min(MostWaiting, event.waiting + 1);
}

void InterruptTable::watch(Time now, const Level& level)
{
    for (Event& event : m_events) {
        if (event.cause == InterruptCause::Timed)
            watchTime(event, now);
        else
            watchInput(event, level(event.place));
        if (!m_isEnabled)
            event.waiting = std::min(event.waiting, 1u);
    }
}

std::optional<std::uint32_t> InterruptTable::take()
{
    if (!m_isEnabled)
        return std::nullopt;
    for (Event& event : m_events) {
        if (event.waiting == 0 || event.routine == 0)
            continue;
        --event.waiting;
        return event.routine - 1;
    }
    return std::nullopt;
}

void InterruptTable::save(ByteWriter& writer) const
{
    writer.put(m_isEnabled);
    for (const Event& event : m_events) {
        writer.put(event.period.count());
        writer.put(event.routine);
        writer.put(event.waiting);
        writer.put(event.due.count());
        writer.put(event.level);
    }
}

void InterruptTable::restore(ByteReader& reader)
{
    m_isEnabled = reader.getBool();
    for (Event& event : m_events) {
        event.period = Time(reader.get<std::int64_t>());
        event.routine = reader.get<std::uint32_t>();
        event.waiting = reader.get<std::uint32_t>();
        event.due = Time(reader.get<std::int64_t>());
        event.level = reader.getBool();
        const bool sane = event.waiting <= MostWaiting && event.period >= Time{} && (event.routine == 0 || isInterrupt(event.routine - 1));
        if (!sane)
            reader.fail();
    }
}

} // namespace camwright
