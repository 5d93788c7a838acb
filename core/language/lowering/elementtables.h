#pragma once

#include "core/family/family.h"
#include "core/language/ir/ir.h"

#include <cstdint>
#include <map>
#include <utility>

namespace camwright {

/// An address as instructions name it: bit-only elements and variables without an address are a byte each (CONTRACTS 8).
IrAddress irAddress(const Family& family, const Address& address);

/// What the routines of a program share: timers and counters by element, block instances, the hidden state. An element has
/// one state however many instructions name it.
class ElementTables {
public:
    /// `variableBytes`: of VariablesArea, of which what comes behind is free.
    ElementTables(const Family& family, IrProgram& program, std::uint32_t variableBytes)
        : m_family(family), m_program(program), m_variableBytes(variableBytes)
    {
    }

    /// Index of a timer of this kind on the element that `element` is the bit or value of.
    std::uint32_t timer(TimerKind kind, const Address& element);
    std::uint32_t counter(CounterKind kind, const Address& element);
    const IrCounter& counterAt(std::uint32_t index) const { return m_program.counters[index]; }
    const IrTimer& timerAt(std::uint32_t index) const { return m_program.timers[index]; }
    /// Number of a new FOR loop (Koyo).
    std::uint32_t loop() { return m_loops++; }
    /// A place of its own behind the variables, which no text can name.
    IrAddress work(DataType type);
    std::uint32_t variableBytes() const { return m_variableBytes; }
    /// One byte of hidden state.
    std::uint32_t edge();
    /// Index of a new block, which is also its instance number.
    std::uint32_t block(InstructionId instruction, std::vector<IrPin> pins);

    /// An address as instructions name it: BOOLs of areas with a byte per bit have no bit number.
    IrAddress place(const Address& address) const;

private:
    struct Element {
        IrAddress value;
        IrAddress bit;
        std::uint32_t number = 0;
    };
    Element elementAt(const Address& address) const;
    std::uint32_t stateOf(std::map<std::uint32_t, std::uint32_t>& states, std::uint32_t number, std::uint32_t bytes);

    const Family& m_family;
    std::uint32_t m_loops = 0;
    IrProgram& m_program;
    std::uint32_t m_variableBytes;
    std::map<std::uint32_t, std::uint32_t> m_timerStates;   ///< element number to offset
    std::map<std::uint32_t, std::uint32_t> m_counterStates;
    std::map<std::pair<std::uint32_t, TimerKind>, std::uint32_t> m_timers;
    std::map<std::pair<std::uint32_t, CounterKind>, std::uint32_t> m_counters;
};

} // namespace camwright
