#include "core/runtime/executor/access.h"
#include "core/runtime/executor/bcd.h"
#include "core/runtime/executor/handlers.h"
#include "core/runtime/executor/timerstate.h"

#include <algorithm>

namespace camwright {

namespace {

/// TMR and TMRF (4 digits, 0 without input) and TMRA and TMRAF (8 digits, keep their value; TimerReset sets it back). The
/// value goes on after the preset is reached, up to all nines. Nothing counts in the scan in which the input comes on.
template <class Word, bool Accumulates>
const Step* runKoyoTimer(Frame& frame, const Step* step)
{
    constexpr std::int64_t Greatest = sizeof(Word) == 2 ? 9999 : 99'999'999;
    const TimerStep& timer = frame.code->timers[step->extra];
    auto hidden = load<HiddenTimer>(frame, timer.state);
    const bool input = frame.bytes[step->a] != 0;
    std::int64_t value = fromBcd(load<Word>(frame, timer.value));
    if (input && hidden.input != 0)
        value = std::min(Greatest, value + std::min(hidden.unitsUntil(frame.now.count(), timer.baseNs), Greatest));
    else if (!Accumulates) {
        value = 0;
        hidden.fraction = 0;
    }
    const bool output = (input || Accumulates) && value >= fromBcd(load<Word>(frame, step->b));
    hidden.input = input ? 1 : 0;
    hidden.known = 1;
    hidden.last = frame.now.count();
    store(frame, timer.state, hidden);
    store(frame, timer.value, static_cast<Word>(toBcd(value)));
    storeBit(frame, timer.bit, timer.bitMask, output);
    frame.bytes[step->dest] = output ? 1 : 0;
    return step + 1;
}

} // namespace

Handler koyoTimerHandler(TimerKind kind)
{
    const bool accumulates = kind == TimerKind::KoyoTmra || kind == TimerKind::KoyoTmraf;
    return accumulates ? runKoyoTimer<std::uint32_t, true> : runKoyoTimer<std::uint16_t, false>;
}

} // namespace camwright
