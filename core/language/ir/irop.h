#pragma once

#include "core/base/datatype.h"

#include <cstdint>
#include <string_view>

namespace camwright {

/// The operations. The numbers are permanent: images carry them, and a number is never used again for something else.
/// Integers wrap around at the width of their type. NaN results are the canonical NaN (CONTRACTS 12).
enum class IrOp : std::uint8_t {
    Nop = 0,
    Jump = 1,          ///< to `index`
    JumpIf = 2,        ///< to `index` if a
    JumpIfNot = 3,     ///< to `index` if not a
    Call = 4,          ///< routine `index`
    Return = 5,
    CallOn = 6,        ///< routine `index` (of kind Block) with the instance at `address`
    CallAt = 7,        ///< routine `index` (of kind Block) with the instance at pointer a
    Const = 8,         ///< dest := constant
    Load = 9,          ///< dest := memory
    Store = 10,        ///< memory := a
    Not = 16,          ///< BOOL, or all bits of an integer
    And = 17,
    Or = 18,
    Xor = 19,
    Add = 24,
    Sub = 25,
    Mul = 26,
    Div = 27,          ///< by zero: integers give 0, floats what IEEE 754 says; flagged either way. MIN / -1 wraps to MIN
    Mod = 28,          ///< sign of the dividend; by zero: 0, flagged. Integers only
    Neg = 29,
    Abs = 30,          ///< of the smallest integer: itself
    Sqrt = 31,         ///< floats; of a negative number: NaN, flagged
    Min = 32,
    Max = 33,
    Select = 34,       ///< dest := b if a (BOOL), else register `index`; both of `type`
    ShiftLeft = 40,    ///< by b (DWORD); a count of the width or more gives 0
    ShiftRight = 41,   ///< fills with 0, for signed types too
    RotateLeft = 42,   ///< by b modulo the width
    RotateRight = 43,
    Equal = 48,        ///< compares `type`, gives BOOL; with NaN only NotEqual is true
    NotEqual = 49,
    Greater = 50,
    GreaterEqual = 51,
    Less = 52,
    LessEqual = 53,
    Convert = 64,      ///< `from` to `type`: integers truncate, float to integer rounds to even, saturates, NaN gives 0
    Truncate = 65,     ///< float `from` to integer `type` towards zero, saturates, NaN gives 0
    Saturate = 66,     ///< integer `from` to integer `type`, out of range gives the nearest end
    RisingEdge = 72,   ///< dest := a and not a of last time, which is kept at state[index] and 0 before the first time
    FallingEdge = 73,  ///< dest := not a and a of last time
    Timer = 80,        ///< timer `index`: a is the input, b the preset (INT; DINT where its value has 32 bits), dest the output
    TimerReset = 81,   ///< timer `index`: value 0, output off, as if never started, if a
    Counter = 82,      ///< counter `index`: a counts, b is the preset (type of the counter), dest the output; see CounterArm
    CounterArm = 83,   ///< counter `index`: a is the reset (Up, T600*) or load (Down) input, b the second count input
    CounterReset = 84, ///< counter `index`: value 0, output off, if a
    Block = 90,        ///< block `index`: a is EN. Called on every pass; what EN = 0 means is the block's affair
    // Computed places. A *pointer* is a DWORD register that holds an offset in VariablesArea, of which the verifier knows
    // how many bytes from there may be touched; an *index* is a DWORD register of which it knows a bound. So the accesses
    // themselves need no check while running. Only the operations here make pointers and indices; once stored in memory
    // they are plain DWORDs, which Reach makes pointers again. `count`, `stride` are as in irConstant().
    Place = 100,       ///< dest (pointer) := where `address` lies; `constant`: bytes from there. In VariablesArea or InstanceArea
    Reach = 101,       ///< dest (pointer) := a (DWORD), if `constant` bytes from there are inside VariablesArea; else a fault, and on to `index`
    Bound = 102,       ///< dest (index) := a (DINT) - lower, if that is 0 … count - 1; else a fault, and on to `index`. `constant`: lower, count
    Element = 103,     ///< dest (pointer) := pointer a + index b * stride. `constant`: stride, bytes from there
    LoadAt = 104,      ///< dest := memory at pointer a + `address.byte`; the area is VariablesArea
    StoreAt = 105,     ///< memory at pointer b + `address.byte` := a
    LoadElement = 106, ///< dest := memory at `address` + index b * `constant`
    StoreElement = 107,///< memory at `address` + index b * `constant` := a
    Move = 108,        ///< `constant` bytes at pointer a := those at pointer b, as if through a copy
    Now = 110,         ///< dest (LINT) := the controller's time in ns at which the scan runs
    // Floats, by core/base/realmath.h, the same bits on every machine; a REAL is computed as LREAL and rounded. Where a function
    // has no value the result is NaN, without a fault.
    Sin = 112,
    Cos = 113,
    Tan = 114,
    Asin = 115,
    Acos = 116,
    Atan = 117,
    Atan2 = 118,       ///< the angle of the point (b, a)
    Exp = 119,
    Ln = 120,
    Log = 121,         ///< base 10
    Power = 122,       ///< a to the power of b
};

/// Bound: the lower end of the range and how many numbers it has. Element: stride, and bytes from the new pointer on.
constexpr std::uint64_t irConstant(std::uint32_t first, std::uint32_t second)
{
    return first | std::uint64_t{second} << 32;
}
constexpr std::uint32_t irFirst(std::uint64_t constant) { return static_cast<std::uint32_t>(constant); }
constexpr std::uint32_t irSecond(std::uint64_t constant) { return static_cast<std::uint32_t>(constant >> 32); }

/// Which fields of an instruction an operation uses, for reader, writer and verifier.
struct IrShape {
    enum class Index : std::uint8_t { None, Target, Routine, Timer, Counter, Block, EdgeState, Register };
    bool known = false;          ///< false: no such operation
    bool dest = false, a = false, b = false;
    bool address = false, constant = false, from = false;
    Index index = Index::None;
};

const IrShape& shapeOf(IrOp op);
std::string_view name(IrOp op);

/// Call, CallOn, CallAt: `index` is a routine that runs now.
constexpr bool isCall(IrOp op)
{
    return op == IrOp::Call || op == IrOp::CallOn || op == IrOp::CallAt;
}

/// The type of what `op` writes to its destination when its operands are of `type`.
DataType resultType(IrOp op, DataType type);
/// The type of operand a: that of the operation, but for conversions, conditions and computed places.
DataType firstOperandType(IrOp op, DataType type, DataType from);
/// The type of operand b: that of the operation, but DWORD for the count of shifts, for pointers and indices.
DataType secondOperandType(IrOp op, DataType type);
/// Whether the operation exists for the type; Convert and its like also look at `from`.
bool isAllowed(IrOp op, DataType type, DataType from);

} // namespace camwright
