#include "core/runtime/executor/access.h"
#include "core/runtime/executor/bcd.h"
#include "core/runtime/executor/handlers.h"

#include <algorithm>
#include <limits>
#include <type_traits>

namespace camwright {

namespace {

/// What a counter remembers besides its value and bit. The second input and the reset of a call are put here just before
/// it by CounterArm.
struct Hidden {
    std::uint8_t up = 0;      ///< inputs of the last execution
    std::uint8_t down = 0;
    std::uint8_t armReset = 0;
    std::uint8_t armDown = 0;
};
static_assert(sizeof(Hidden) == CounterStateBytes);

template <class T>
class CounterRun {
public:
    CounterRun(Frame& frame, const Step* step)
        : m_frame(frame), m_counter(frame.code->counters[step->extra]), m_hidden(load<Hidden>(frame, m_counter.state)),
          m_value(number(load<T>(frame, m_counter.value))), m_preset(number(load<T>(frame, step->b))), m_input(frame.bytes[step->a] != 0)
    {
    }

    const Step* run(const Step* step)
    {
        const bool output = count();
        m_hidden.up = m_input ? 1 : 0;
        m_hidden.down = m_hidden.armDown;
        store(m_frame, m_counter.state, m_hidden);
        store(m_frame, m_counter.value, isBcd() ? static_cast<T>(toBcd(m_value)) : m_value);
        storeBit(m_frame, m_counter.bit, m_counter.bitMask, output);
        m_frame.bytes[step->dest] = output ? 1 : 0;
        return step + 1;
    }

private:
    bool isBcd() const { return m_counter.kind >= CounterKind::KoyoCnt; }

    /// A value of memory; of digits, the number they make, which has at most as many digits as there is room for.
    T number(T stored) const
    {
        constexpr std::int64_t Greatest = sizeof(T) == 2 ? 9999 : 99'999'999;
        const auto digits = static_cast<std::make_unsigned_t<T>>(stored);
        return isBcd() ? static_cast<T>(std::min(Greatest, fromBcd(digits))) : stored;
    }

    bool count()
    {
        const bool upEdge = m_input && !m_hidden.up;
        const bool downEdge = m_hidden.armDown && !m_hidden.down;
        switch (m_counter.kind) {
        case CounterKind::Up:
        case CounterKind::T600Up:
            if (m_hidden.armReset)
                m_value = 0;
            else if (upEdge)
                up();
            return m_value >= m_preset;
        case CounterKind::Down:
            if (m_hidden.armReset)
                m_value = m_preset;
            else if (upEdge && m_value > 0)
                down();
            return m_value <= 0;
        case CounterKind::KoyoCnt:
            if (m_hidden.armReset)
                m_value = 0;
            else if (upEdge)
                upTo(9999);
            return m_value >= m_preset;
        case CounterKind::KoyoUdc:
            if (m_hidden.armReset)
                m_value = 0;
            else if (upEdge != downEdge)
                upEdge ? upTo(99'999'999) : downToZero();
            return m_value >= m_preset;
        case CounterKind::UpDown:
            if (m_hidden.armReset)
                m_value = 0;
            else if (upEdge != downEdge)
                upEdge ? up() : down();
            return m_value >= m_preset;
        case CounterKind::T600UpDown: // one input that counts, one that tells the direction
            if (upEdge)
                m_hidden.armDown ? down() : up();
            return m_value >= m_preset;
        }
        return false;
    }

    void upTo(std::int64_t greatest)
    {
        if (m_value < greatest)
            ++m_value;
    }

    void downToZero()
    {
        if (m_value > 0)
            --m_value;
    }

    void up()
    {
        if (m_value < std::numeric_limits<T>::max())
            ++m_value;
    }

    void down()
    {
        if (m_value > std::numeric_limits<T>::min())
            --m_value;
    }

    Frame& m_frame;
    const CounterStep& m_counter;
    Hidden m_hidden;
    T m_value;
    T m_preset;
    bool m_input;
};

template <class T>
const Step* runCounter(Frame& frame, const Step* step)
{
    return CounterRun<T>(frame, step).run(step);
}

} // namespace

Handler counterHandler(bool isWide)
{
    return isWide ? runCounter<std::int32_t> : runCounter<std::int16_t>;
}

const Step* armCounter(Frame& frame, const Step* step)
{
    const CounterStep& counter = frame.code->counters[step->extra];
    auto hidden = load<Hidden>(frame, counter.state);
    hidden.armReset = frame.bytes[step->a] != 0 ? 1 : 0;
    hidden.armDown = frame.bytes[step->b] != 0 ? 1 : 0;
    store(frame, counter.state, hidden);
    return step + 1;
}

const Step* resetCounter(Frame& frame, const Step* step)
{
    if (frame.bytes[step->a] != 0) {
        const CounterStep& counter = frame.code->counters[step->extra];
        if (counter.isWide)
            store<std::int32_t>(frame, counter.value, 0);
        else
            store<std::int16_t>(frame, counter.value, 0);
        storeBit(frame, counter.bit, counter.bitMask, false);
    }
    return step + 1;
}

} // namespace camwright
