#pragma once

#include "core/base/time.h"
#include "core/base/value.h"
#include "core/family/address.h"
#include "core/family/instructionid.h"
#include "core/language/ir/ir.h"
#include "core/runtime/memory/memory.h"

#include <cstdint>
#include <optional>

namespace camwright {

/// The pins of one block call, in catalogue order, bound to memory. Valid only during the call.
class PinValues {
public:
    PinValues(Memory& memory, const IrBlock& block) : m_memory(memory), m_block(block) {}

    std::size_t count() const { return m_block.pins.size(); }
    bool isOpen(std::size_t pin) const;
    bool isConstant(std::size_t pin) const;
    /// The value now; zero BOOL for an open pin.
    Value read(std::size_t pin) const;
    /// Nothing happens for an open or constant pin.
    void write(std::size_t pin, const Value& value);
    void write(std::size_t pin, bool value) { write(pin, Value::ofBool(value)); }
    /// Where a pin that is the start of a block lies; its elements are read and written with element(). No value for
    /// constants and open pins.
    std::optional<Address> address(std::size_t pin) const;
    /// Element `index` of a block that starts at the pin, in the pin's own type; no value where it would leave the area.
    std::optional<Address> element(std::size_t pin, std::uint32_t index) const;

    Memory& memory() { return m_memory; }
    const IrBlock& block() const { return m_block; }

private:
    Memory& m_memory;
    const IrBlock& m_block;
};

/// Which call it is and how it is made.
struct BlockInstance {
    std::uint32_t number = 0;       ///< counts the block calls of the image from 0; the engine keeps its state by it
    bool enabled = false;           ///< EN; a call is made on every pass, enabled or not (KS-MC-12, -18, -19, -22)
    Time now{};
};

/// Blocks the executor does not know itself: motion, communication. Called on the scan's thread, in program order.
class BlockHost {
public:
    virtual ~BlockHost() = default;
    virtual void call(InstructionId instruction, const BlockInstance& instance, PinValues& pins) = 0;
};

} // namespace camwright
