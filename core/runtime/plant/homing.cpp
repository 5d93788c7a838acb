#include "core/runtime/plant/homing.h"

#include <algorithm>
#include <cmath>

namespace camwright {

// Every method with a switch is the same task seen from one of two sides: cross one edge of a switch in a given direction,
// slowly, and take that place or the next index pulse. `mirror` turns the methods that start negative into those that
// start positive; in what follows "positive" is the start's direction.
struct HomingSequence::Recipe {
    enum class Sensor : std::uint8_t { None, Home, Limit };
    Sensor sensor = Sensor::None;
    int mirror = 1;          ///< 1 or -1
    bool upperEdge = false;  ///< which edge of the active stretch
    int crossing = -1;       ///< direction in which the edge is crossed
    bool index = false;
    bool cam = false;        ///< the active stretch lies inside the travel; the limit behind it turns the search
};

bool isHomingMethodSupported(int method)
{
    return (method >= 1 && method <= 14) || (method >= 17 && method <= 30) || (method >= 33 && method <= 35) || method == 37;
}

std::optional<HomingSequence::Recipe> HomingSequence::recipeOf(int method)
{
    using Sensor = Recipe::Sensor;
    if (!isHomingMethodSupported(method))
        return std::nullopt;
    if (method == 33 || method == 34)
        return Recipe{Sensor::None, 1, false, method == 33 ? -1 : 1, true, false};
    if (method >= 35)
        return Recipe{};
    const bool index = method <= 14;
    const int kind = index ? method : method - 16;
    switch (kind) {
    case 1: return Recipe{Sensor::Limit, -1, false, -1, index, false};
    case 2: return Recipe{Sensor::Limit, 1, false, -1, index, false};
    case 3: return Recipe{Sensor::Home, 1, false, -1, index, false};
    case 4: return Recipe{Sensor::Home, 1, false, 1, index, false};
    case 5: return Recipe{Sensor::Home, -1, false, -1, index, false};
    case 6: return Recipe{Sensor::Home, -1, false, 1, index, false};
    default: break;
    }
    const int mirror = kind <= 10 ? 1 : -1;
    const int variant = (kind - 7) % 4; // lower edge outside, lower inside, upper inside, upper outside
    return Recipe{Sensor::Home, mirror, variant >= 2, variant % 2 == 0 ? -1 : 1, index, true};
}

bool homeSwitchActive(const HomingMachine& machine, int method, double position)
{
    const int kind = method >= 17 && method <= 30 ? method - 16 : method;
    if (kind == 3 || kind == 4)
        return position >= machine.homeSwitch;
    if (kind == 5 || kind == 6)
        return position <= machine.homeSwitch;
    return position >= machine.homeSwitch && position <= machine.homeSwitch + machine.homeCamWidth;
}

bool HomingSequence::sensorAt(const HomingMachine& machine, const Recipe& recipe, double position) const
{
    if (recipe.sensor == Recipe::Sensor::Limit)
        return recipe.mirror > 0 ? position >= machine.upperLimit : position <= machine.lowerLimit;
    return homeSwitchActive(machine, m_method, position);
}

/// The place of the edge that was passed, if one was.
std::optional<double> HomingSequence::edgeBetween(
    const HomingMachine& machine, const Recipe& recipe, double before, double after) const
{
    if (sensorAt(machine, recipe, before) == sensorAt(machine, recipe, after))
        return std::nullopt;
    if (recipe.sensor == Recipe::Sensor::Limit)
        return recipe.mirror > 0 ? machine.upperLimit : machine.lowerLimit;
    const double upper = machine.homeSwitch + machine.homeCamWidth;
    const bool passedLower = std::min(before, after) <= machine.homeSwitch && std::max(before, after) >= machine.homeSwitch;
    return !recipe.cam || passedLower ? machine.homeSwitch : upper;
}

void HomingSequence::add(int direction, Event event, bool fast)
{
    m_legs[m_count++] = {static_cast<std::int8_t>(direction), event, fast};
}

/// Legs from where the axis stands, in the mirrored direction: with the sensor active, inactive below it, or behind it
/// after the limit switch turned the search.
void HomingSequence::plan(const Recipe& recipe, bool active, bool fromLimit)
{
    m_count = 0;
    m_leg = 0;
    const int m = recipe.mirror;
    // Crossing the lower edge downwards or the upper edge upwards leaves the active stretch.
    const bool leaving = recipe.upperEdge == (recipe.crossing > 0);
    const int outward = recipe.upperEdge ? 1 : -1;
    if (active) {
        add(m * outward, Event::Fall, true);
        if (leaving)
            add(-m * outward, Event::Rise, false);
    } else if (fromLimit) {
        add(-m, Event::Rise, true);
        if (!leaving && !recipe.upperEdge)
            add(-m, Event::Fall, true);
        if (!leaving && recipe.upperEdge)
            add(m, Event::Fall, false);
    } else {
        add(m, Event::Rise, true);
        if (!leaving)
            add(m * outward, Event::Fall, true);
    }
    add(m * recipe.crossing, leaving ? Event::Fall : Event::Rise, false);
}

void HomingSequence::start(int method, const HomingMachine& machine, double position)
{
    *this = {};
    m_method = method;
    const auto recipe = recipeOf(method);
    if (!recipe) {
        m_state = State::Failed;
        return;
    }
    m_state = State::Searching;
    m_reference = position;
    if (recipe->sensor != Recipe::Sensor::None)
        plan(*recipe, sensorAt(machine, *recipe, position), false);
    else if (recipe->index)
        add(recipe->crossing, Event::Index, false);
    if (m_count == 0)
        m_state = State::Found; // 35 and 37: here
}

/// The leg found what it looked for.
void HomingSequence::next(double reference)
{
    m_reference = reference;
    ++m_leg;
    if (m_leg < m_count)
        return;
    const auto recipe = recipeOf(m_method);
    const Leg last = m_legs[m_count - 1];
    if (recipe->index && last.event != Event::Index) {
        m_legs[0] = {last.direction, Event::Index, false};
        m_count = 1;
        m_leg = 0;
        return;
    }
    m_state = State::Found;
}

/// A limit switch that is not the sensor: turns the first search of a method with a cam, fails anything else.
bool HomingSequence::hitLimit(const HomingMachine& machine, const Recipe& recipe, double before, double after)
{
    const bool atUpper = after > before && after >= machine.upperLimit;
    const bool atLower = after < before && after <= machine.lowerLimit;
    if (!atUpper && !atLower)
        return false;
    const bool ahead = (recipe.mirror > 0) == atUpper;
    if (recipe.sensor == Recipe::Sensor::Limit && ahead)
        return false;
    if (recipe.cam && ahead && !m_turned && m_leg == 0 && m_legs[0].event == Event::Rise) {
        m_turned = true;
        plan(recipe, false, true);
        return true;
    }
    m_state = State::Failed;
    return true;
}

void HomingSequence::observe(const HomingMachine& machine, double before, double after)
{
    if (m_state != State::Searching || before == after)
        return;
    const auto recipe = recipeOf(m_method);
    const Leg leg = m_legs[m_leg];
    const bool forward = (after > before) == (leg.direction > 0);
    if (!forward)
        return; // still braking from the leg before
    if (leg.event == Event::Index) {
        const double turn = machine.countsPerTurn;
        const double low = std::floor((std::min(before, after) - machine.indexOffset) / turn);
        const double high = std::floor((std::max(before, after) - machine.indexOffset) / turn);
        if (low != high)
            return next(high * turn + machine.indexOffset);
    } else if (const auto edge = edgeBetween(machine, *recipe, before, after)) {
        const bool rise = sensorAt(machine, *recipe, after);
        if (rise == (leg.event == Event::Rise))
            return next(*edge);
    }
    hitLimit(machine, *recipe, before, after);
}

HomingSequence::Demand HomingSequence::demand() const
{
    if (m_state != State::Searching)
        return {};
    return {m_legs[m_leg].direction, m_legs[m_leg].fast};
}

void HomingSequence::save(ByteWriter& writer) const
{
    for (const Leg& leg : m_legs) {
        writer.put(leg.direction);
        writer.put(leg.event);
        writer.put(leg.fast);
    }
    writer.put(m_count);
    writer.put(m_leg);
    writer.put(m_method);
    writer.put(m_state);
    writer.put(m_turned);
    writer.put(m_reference);
}

void HomingSequence::restore(ByteReader& reader)
{
    for (Leg& leg : m_legs) {
        leg.direction = reader.get<std::int8_t>();
        leg.event = reader.get<Event>();
        leg.fast = reader.getBool();
    }
    m_count = reader.get<std::uint8_t>();
    m_leg = reader.get<std::uint8_t>();
    m_method = reader.get<int>();
    m_state = reader.get<State>();
    m_turned = reader.getBool();
    m_reference = reader.get<double>();
    const bool sound = m_count <= m_legs.size() && (m_state != State::Searching || (m_leg < m_count && recipeOf(m_method)));
    if (!sound) {
        *this = {};
        reader.fail();
    }
}

} // namespace camwright
