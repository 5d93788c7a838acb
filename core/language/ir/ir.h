#pragma once

#include "core/base/datatype.h"
#include "core/family/address.h"
#include "core/language/ir/irop.h"

#include <cstdint>
#include <string>
#include <vector>

namespace camwright {

/// A place in memory as instructions name it. The area number is also the alias class: two operands of different areas
/// never overlap, two of the same area may (KS-MEM-02), and only those need looking at.
struct IrAddress {
    static constexpr std::uint8_t WholeByte = 0xFF; ///< a BOOL with a byte of its own, 0 or 1 (CONTRACTS 8)

    AreaId area = 0;
    std::uint8_t bit = WholeByte; ///< 0 … 7 for a BOOL inside a byte; WholeByte for everything else
    std::uint32_t byte = 0;     ///< offset in the area

    bool operator==(const IrAddress&) const = default;
};

/// A virtual register: numbered from 0 in each routine, written by exactly one instruction, read only after it on every
/// path. It holds one value of the type of its instruction.
using IrRegister = std::uint32_t;
inline constexpr IrRegister NoRegister = 0xFFFFFFFF;

/// One operation of at most three addresses. Which fields count is told by `shapeOf(op)`; the others are zero.
struct IrInstruction {
    IrOp op = IrOp::Nop;
    DataType type = DataType::Bool; ///< of the operands, and of the result unless the operation says otherwise
    DataType from = DataType::Bool; ///< Convert: type of the operand
    IrRegister dest = NoRegister;
    IrRegister a = NoRegister;
    IrRegister b = NoRegister;
    IrAddress address;              ///< Load, Store; where an access with an index or through a pointer begins
    std::uint32_t index = 0;        ///< jump target, routine, timer, counter, block or edge slot; Select: third register
    std::uint64_t constant = 0;     ///< Const: the bits as they lie in memory, zero-extended; else see the operation
    std::uint32_t source = 0;       ///< 1 + index into DebugMap::sources, 0: nowhere; not part of the program's hash

    bool operator==(const IrInstruction&) const = default;
};

/// How a timer counts. TON, TOF and TP are Kinco's, with IEC meaning; the T600 four are TS-TMR-01 … 04.
/// Those of Koyo count in BCD: 4 digits in a word, TMRA and TMRAF (which keep their value) 8 digits in two.
enum class TimerKind : std::uint8_t { Ton = 1, Tof = 2, Tp = 3, T600Ton = 4, T600Tonr = 5, T600Tof = 6, T600Tmon = 7,
    KoyoTmr = 8, KoyoTmrf = 9, KoyoTmra = 10, KoyoTmraf = 11 };

/// One timer element: its value (INT, in units of the base, at most 32767) and its bit lie in memory where programs and
/// people see them, what else it must remember lies in the hidden state.
struct IrTimer {
    TimerKind kind = TimerKind::Ton;
    IrAddress value;
    IrAddress bit;
    std::uint32_t state = 0;        ///< offset of TimerStateBytes in the hidden state; one per element, not per call
    std::int64_t baseNs = 100000000;

    bool operator==(const IrTimer&) const = default;
};

/// Type of a timer's value and preset.
constexpr DataType valueType(TimerKind kind)
{
    return kind == TimerKind::KoyoTmra || kind == TimerKind::KoyoTmraf ? DataType::Dint : DataType::Int;
}

enum class CounterKind : std::uint8_t { Up = 1, Down = 2, UpDown = 3, T600Up = 4, T600UpDown = 5,
    KoyoCnt = 6, KoyoUdc = 7 }; ///< the last two in BCD, of 4 and 8 digits

/// One counter element: value (INT, or DINT where `type` says so) and bit in memory, edges in the hidden state.
struct IrCounter {
    CounterKind kind = CounterKind::Up;
    DataType type = DataType::Int;
    IrAddress value;
    IrAddress bit;
    std::uint32_t state = 0;        ///< offset of CounterStateBytes in the hidden state

    bool operator==(const IrCounter&) const = default;
};

inline constexpr std::uint32_t TimerStateBytes = 24;
inline constexpr std::uint32_t CounterStateBytes = 4;
inline constexpr std::uint32_t MaximumStateBytes = 1u << 24;

/// What a call passes to one pin of a block: a constant, or a place in memory; nothing where an optional pin is left open.
struct IrPin {
    enum class Kind : std::uint8_t { Open = 0, Constant = 1, Memory = 2 };
    Kind kind = Kind::Open;
    DataType type = DataType::Bool; ///< of the pin's value, or of one element where the pin is the start of a block
    std::uint64_t constant = 0;
    IrAddress address;

    bool operator==(const IrPin&) const = default;
};

/// One call of a block the engine implements (MC_*): which instruction, which instance of it, its pins in catalogue order.
struct IrBlock {
    std::uint16_t instruction = 0;  ///< permanent number of the catalogue (InstructionId)
    std::uint32_t instance = 0;     ///< counts the block calls of the image from 0
    std::vector<IrPin> pins;

    bool operator==(const IrBlock&) const = default;
};

/// Block: the body or a method of a function block. It runs with an instance, called by CallOn and CallAt only.
enum class RoutineKind : std::uint8_t { Main = 0, Subroutine = 1, Interrupt = 2, Block = 3 };

/// In a routine of kind Block the instance it runs with: addresses count from its first byte. It is a stretch of
/// VariablesArea, so these two areas may overlap, as an exception to the rule at IrAddress.
inline constexpr AreaId InstanceArea = 0xFD;

/// A program organisation unit after lowering.
struct IrRoutine {
    std::string name;
    RoutineKind kind = RoutineKind::Main;
    std::uint32_t registers = 0;
    std::vector<IrInstruction> code;
    std::uint32_t instanceBytes = 0; ///< Block: size of its instance

    bool operator==(const IrRoutine&) const = default;
};

/// The program of an image. Exactly one routine is Main; calls never form a cycle.
struct IrProgram {
    std::vector<IrRoutine> routines;
    std::vector<IrTimer> timers;
    std::vector<IrCounter> counters;
    std::vector<IrBlock> blocks;
    std::uint32_t stateBytes = 0;   ///< size of the hidden state: edges, timers, counters

    bool operator==(const IrProgram&) const = default;
};

/// Calls nest at most this deep, Main not counted (TS600: 6 levels with Main, TS-SBR-01; ours for Kinco).
inline constexpr unsigned MaximumCallDepth = 16;

} // namespace camwright
