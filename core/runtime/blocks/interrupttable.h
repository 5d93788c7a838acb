#pragma once

#include "core/base/bytes.h"
#include "core/base/time.h"
#include "core/family/address.h"
#include "core/language/image/controllerimage.h"
#include "core/runtime/memory/memory.h"

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

namespace camwright {

/// Which routine each event starts, and which events have come. Kinco: ATCH gives an event a routine; TS600: every
/// interrupt routine has its event from the image. Two events at one moment start their routines in the order of the
/// events' numbers, which on the TS600 is that of the programs (ours). An event that comes while interrupts are disabled
/// waits, once. Edges are looked for at every cycle of the controller, 1 ms (ours).
class InterruptTable {
public:
    explicit InterruptTable(const ControllerImage& image);

    /// STOP to RUN. Levels are taken as they are, so an input that is on gives no edge.
    using Level = std::function<bool(const Address&)>;
    void start(Time now, const Level& level);

    /// Nothing happens for an event this controller does not have; one that never comes may be attached.
    void attach(std::uint32_t event, std::uint32_t routine, const Memory& memory, Time now);
    void detach(std::uint32_t event);
    void enable(bool on) { m_isEnabled = on; }

    /// Looks at time and inputs.
    void watch(Time now, const Level& level);
    /// The routine to run next, taken off what waits; nothing while interrupts are disabled.
    std::optional<std::uint32_t> take();

    void save(ByteWriter& writer) const;
    void restore(ByteReader& reader);

private:
    struct Event {
        std::uint32_t number = 0;
        InterruptCause cause = InterruptCause::Timed;
        Address place;                ///< the input; of a timed Kinco event the word of its period
        Time period{};
        std::uint32_t routine = 0;    ///< 1 + its index; 0: none
        std::uint32_t waiting = 0;    ///< times it has come
        Time due{};
        bool level = false;
    };

    Event* find(std::uint32_t number);
    bool isInterrupt(std::uint32_t routine) const;
    static void watchTime(Event& event, Time now);
    static void watchInput(Event& event, bool level);

    const ControllerImage& m_image;
    bool m_isKinco;
    bool m_isEnabled = false;
    std::vector<Event> m_events; ///< by number
};

} // namespace camwright
