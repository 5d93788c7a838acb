#pragma once

#include "core/base/bytes.h"

#include <array>
#include <cstdint>
#include <optional>

namespace camwright {

/// The switches of the machine in counts, seen in the drive's direction.
struct HomingMachine {
    double lowerLimit = 0;      ///< active at and below
    double upperLimit = 0;      ///< active at and above
    double homeSwitch = 0;
    double homeCamWidth = 0;
    double countsPerTurn = 10000;
    double indexOffset = 0;
};

/// True for the methods our simulated drives do (CONTRACTS 29): 1 … 14, 17 … 30, 33, 34, 35, 37.
bool isHomingMethodSupported(int method);

/// The home switch as the homing method expects the machine to be built: methods 3, 4, 19, 20 active above its edge; 5, 6,
/// 21, 22 active below; the others a cam from its edge upwards.
bool homeSwitchActive(const HomingMachine& machine, int method, double position);

/// Runs one homing (CiA 402, 0x6098) step by step. It sees the machine only through positions before and after a step.
class HomingSequence {
public:
    enum class State : std::uint8_t { Idle, Searching, Found, Failed };
    struct Demand {
        int direction = 0;      ///< -1, 0, 1
        bool fast = false;
    };

    void start(int method, const HomingMachine& machine, double position);
    void cancel() { m_state = State::Idle; }
    /// The shaft moved from `before` to `after`.
    void observe(const HomingMachine& machine, double before, double after);

    State state() const { return m_state; }
    Demand demand() const;
    double reference() const { return m_reference; } ///< the place found

    void save(ByteWriter& writer) const;
    void restore(ByteReader& reader);

private:
    enum class Event : std::uint8_t { Rise, Fall, Index };
    struct Leg {
        std::int8_t direction = 0;
        Event event = Event::Rise;
        bool fast = false;
    };
    struct Recipe;

    static std::optional<Recipe> recipeOf(int method);
    bool sensorAt(const HomingMachine& machine, const Recipe& recipe, double position) const;
    std::optional<double> edgeBetween(const HomingMachine& machine, const Recipe& recipe, double before, double after) const;
    void plan(const Recipe& recipe, bool active, bool fromLimit);
    void add(int direction, Event event, bool fast);
    void next(double reference);
    bool hitLimit(const HomingMachine& machine, const Recipe& recipe, double before, double after);

    std::array<Leg, 4> m_legs{};
    std::uint8_t m_count = 0;
    std::uint8_t m_leg = 0;
    int m_method = 0;
    State m_state = State::Idle;
    bool m_turned = false;      ///< already came back from a limit
    double m_reference = 0;
};

} // namespace camwright
