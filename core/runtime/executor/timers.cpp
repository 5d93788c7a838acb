#include "core/runtime/executor/access.h"
#include "core/runtime/executor/handlers.h"
#include "core/runtime/executor/timerstate.h"

#include <algorithm>

namespace camwright {

namespace {

using Hidden = HiddenTimer;

constexpr std::int64_t GreatestValue = 32767;

/// One execution of one timer: state in, state out.
class TimerRun {
public:
    TimerRun(Frame& frame, const Step* step)
        : m_frame(frame), m_timer(frame.code->timers[step->extra]), m_hidden(load<Hidden>(frame, m_timer.state)),
          m_value(load<std::int16_t>(frame, m_timer.value)), m_preset(load<std::int16_t>(frame, step->b)),
          m_input(frame.bytes[step->a] != 0), m_output(loadBit(frame, m_timer.bit, m_timer.bitMask))
    {
    }

    const Step* finish(const Step* step)
    {
        m_hidden.input = m_input ? 1 : 0;
        m_hidden.known = 1;
        m_hidden.last = m_frame.now.count();
        store(m_frame, m_timer.state, m_hidden);
        store(m_frame, m_timer.value, static_cast<std::int16_t>(m_value));
        storeBit(m_frame, m_timer.bit, m_timer.bitMask, m_output);
        m_frame.bytes[step->dest] = m_output ? 1 : 0;
        return step + 1;
    }

    bool rising() const { return m_input && !m_hidden.input; }
    bool falling() const { return !m_input && m_hidden.input; }

    void clear()
    {
        m_value = 0;
        m_hidden.fraction = 0;
    }

    /// Adds the time since the last execution, in whole units of the base.
    void advance()
    {
        const std::int64_t units = m_hidden.unitsUntil(m_frame.now.count(), m_timer.baseNs);
        m_value = std::min(GreatestValue, m_value + std::min(units, GreatestValue - std::min<std::int64_t>(m_value, 0)));
    }

    void ton();
    void tof();
    void tp();
    void t600Ton();
    void t600Tonr();
    void t600Tof();
    void t600Tmon();

private:
    bool reached() const { return m_value >= m_preset; }

    /// Counts up to the preset and ends there; true when it has.
    bool advanceToPreset()
    {
        advance();
        if (!reached())
            return false;
        m_value = std::max<std::int64_t>(m_preset, 0);
        m_hidden.timing = 0;
        return true;
    }

    Frame& m_frame;
    const TimerStep& m_timer;
    Hidden m_hidden;
    std::int64_t m_value;
    std::int64_t m_preset;
    bool m_input;
    bool m_output;
};

/// IEC 61131-3 TON. The value goes on to 32767 after the preset is reached (KS-VC-02; the manuals do not say, ours).
void TimerRun::ton()
{
    if (!m_input) {
        clear();
        m_output = false;
        return;
    }
    if (rising())
        clear();
    else
        advance();
    m_output = reached();
}

/// IEC 61131-3 TOF. Off until the input was on once.
void TimerRun::tof()
{
    if (m_input) {
        clear();
        m_output = true;
        m_hidden.timing = 0;
    } else if (falling()) {
        clear();
        m_hidden.timing = 1;
        m_output = m_preset > 0;
    } else if (m_hidden.timing && advanceToPreset()) {
        m_output = false;
    }
}

/// IEC 61131-3 TP: a pulse of the preset's length; the value falls to 0 when the pulse is over and the input off.
void TimerRun::tp()
{
    if (m_hidden.timing) {
        if (advanceToPreset())
            m_output = false;
    } else if (rising()) {
        clear();
        m_hidden.timing = m_preset > 0 ? 1 : 0;
        m_output = m_preset > 0;
    }
    if (!m_hidden.timing && !m_input)
        clear();
}

/// TS-TMR-01.
void TimerRun::t600Ton()
{
    if (!m_hidden.known || !m_input) {
        clear();
        m_output = false;
        return;
    }
    if (!rising())
        advance();
    m_output = reached();
}

/// TS-TMR-02.
void TimerRun::t600Tonr()
{
    if (!m_hidden.known) {
        clear();
        m_output = false;
        return;
    }
    if (!m_input)
        return;
    if (!rising())
        advance();
    m_output = reached();
}

/// TS-TMR-03.
void TimerRun::t600Tof()
{
    tof();
}

/// TS-TMR-04. Timing begins from the value that is there.
void TimerRun::t600Tmon()
{
    if (m_hidden.timing) {
        advance();
    } else if (rising()) {
        m_hidden.timing = 1;
        m_hidden.fraction = 0;
    }
    if (!m_hidden.timing)
        return;
    m_output = !reached();
    if (!m_output) {
        clear();
        m_hidden.timing = 0;
    }
}

template <auto Kind>
const Step* runTimer(Frame& frame, const Step* step)
{
    TimerRun run(frame, step);
    (run.*Kind)();
    return run.finish(step);
}

} // namespace

Handler timerHandler(TimerKind kind)
{
    switch (kind) {
    case TimerKind::Ton: return runTimer<&TimerRun::ton>;
    case TimerKind::Tof: return runTimer<&TimerRun::tof>;
    case TimerKind::Tp: return runTimer<&TimerRun::tp>;
    case TimerKind::T600Ton: return runTimer<&TimerRun::t600Ton>;
    case TimerKind::T600Tonr: return runTimer<&TimerRun::t600Tonr>;
    case TimerKind::T600Tof: return runTimer<&TimerRun::t600Tof>;
    case TimerKind::T600Tmon: return runTimer<&TimerRun::t600Tmon>;
    case TimerKind::KoyoTmr:
    case TimerKind::KoyoTmrf:
    case TimerKind::KoyoTmra:
    case TimerKind::KoyoTmraf: return koyoTimerHandler(kind);
    }
    return nullptr;
}

const Step* resetTimer(Frame& frame, const Step* step)
{
    if (frame.bytes[step->a] != 0) {
        const TimerStep& timer = frame.code->timers[step->extra];
        auto hidden = load<Hidden>(frame, timer.state);
        hidden.timing = 0;
        hidden.fraction = 0;
        hidden.last = frame.now.count();
        store(frame, timer.state, hidden);
        if (valueType(timer.kind) == DataType::Dint)
            store<std::int32_t>(frame, timer.value, 0);
        else
            store<std::int16_t>(frame, timer.value, 0);
        storeBit(frame, timer.bit, timer.bitMask, false);
    }
    return step + 1;
}

} // namespace camwright
