#pragma once

#include "core/language/image/controllerimage.h"
#include "core/runtime/engine.h"

#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace camwright {

/// A KS101M with two axes and a program of MC_* calls, made without a compiler: each call is one network whose EN is a bit.
class KincoBench {
public:
    static constexpr std::string_view kAlwaysOn = "%SM0.0";

    KincoBench();

    /// Adds a call; operands as in the instruction list, constants plain. Returns the number of the call.
    void call(std::string_view mnemonic, const std::vector<std::string>& operands, std::string_view enable = kAlwaysOn);
    AxisConfiguration& axis(std::size_t index) { return m_image.configuration.axes[index]; }
    ControllerImage& image() { return m_image; }

    /// Loads the program, starts it, and steps until it runs.
    void start();
    Bytes imageBytes() const;

    ControllerEngine& engine() { return m_engine; }
    void step(Time span) { m_engine.step(span); }
    /// Steps until `condition` holds; false after `limit`.
    bool stepUntil(const std::function<bool()>& condition, Time limit);

    void set(std::string_view name, double value);
    void setBit(std::string_view name, bool value = true) { set(name, value ? 1 : 0); }
    double number(std::string_view name) const;
    bool bit(std::string_view name) const { return number(name) != 0; }
    int state(int axis = 1) const { return static_cast<int>(number("axis." + std::to_string(axis) + ".state")); }

    /// The drive of axis 1 homes by method 19: forwards to the edge of the home switch (0x6098, by MC_WPARAS). The bench
    /// uses %M500 to %M511 and %VB3000 to %VB3011 for it; call before start().
    void addHomingMethod();
    void writeHomingMethod();

    Result<void> panel(AxisCommandKind kind, double position = 0, double velocity = 0, std::uint16_t axis = 0);
    void beat();
    /// Steps with a heartbeat every 20 ms.
    void stepBeating(Time span);
    std::vector<LogEntry> logged(Code code) const;

private:
    ControllerImage m_image;
    ControllerEngine m_engine;
};

} // namespace camwright
