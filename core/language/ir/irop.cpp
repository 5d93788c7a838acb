#include "core/language/ir/irop.h"

namespace camwright {

namespace {

struct Row {
    IrOp op;
    std::string_view name;
    std::string_view fields; ///< d dest, a, b, m memory address, c constant, f from
    IrShape::Index index = IrShape::Index::None;
};

constexpr Row Rows[] = {
    {IrOp::Nop, "nop", ""},
    {IrOp::Jump, "jump", "", IrShape::Index::Target},
    {IrOp::JumpIf, "jump_if", "a", IrShape::Index::Target},
    {IrOp::JumpIfNot, "jump_if_not", "a", IrShape::Index::Target},
    {IrOp::Call, "call", "", IrShape::Index::Routine},
    {IrOp::Return, "return", ""},
    {IrOp::CallOn, "call_on", "m", IrShape::Index::Routine},
    {IrOp::CallAt, "call_at", "a", IrShape::Index::Routine},
    {IrOp::Const, "const", "dc"},
    {IrOp::Load, "load", "dm"},
    {IrOp::Store, "store", "am"},
    {IrOp::Not, "not", "da"},
    {IrOp::And, "and", "dab"},
    {IrOp::Or, "or", "dab"},
    {IrOp::Xor, "xor", "dab"},
    {IrOp::Add, "add", "dab"},
    {IrOp::Sub, "sub", "dab"},
    {IrOp::Mul, "mul", "dab"},
    {IrOp::Div, "div", "dab"},
    {IrOp::Mod, "mod", "dab"},
    {IrOp::Neg, "neg", "da"},
    {IrOp::Abs, "abs", "da"},
    {IrOp::Sqrt, "sqrt", "da"},
    {IrOp::Min, "min", "dab"},
    {IrOp::Max, "max", "dab"},
    {IrOp::Select, "select", "dab", IrShape::Index::Register},
    {IrOp::ShiftLeft, "shift_left", "dab"},
    {IrOp::ShiftRight, "shift_right", "dab"},
    {IrOp::RotateLeft, "rotate_left", "dab"},
    {IrOp::RotateRight, "rotate_right", "dab"},
    {IrOp::Equal, "equal", "dab"},
    {IrOp::NotEqual, "not_equal", "dab"},
    {IrOp::Greater, "greater", "dab"},
    {IrOp::GreaterEqual, "greater_equal", "dab"},
    {IrOp::Less, "less", "dab"},
    {IrOp::LessEqual, "less_equal", "dab"},
    {IrOp::Convert, "convert", "daf"},
    {IrOp::Truncate, "truncate", "daf"},
    {IrOp::Saturate, "saturate", "daf"},
    {IrOp::RisingEdge, "rising_edge", "da", IrShape::Index::EdgeState},
    {IrOp::FallingEdge, "falling_edge", "da", IrShape::Index::EdgeState},
    {IrOp::Timer, "timer", "dab", IrShape::Index::Timer},
    {IrOp::TimerReset, "timer_reset", "a", IrShape::Index::Timer},
    {IrOp::Counter, "counter", "dab", IrShape::Index::Counter},
    {IrOp::CounterArm, "counter_arm", "ab", IrShape::Index::Counter},
    {IrOp::CounterReset, "counter_reset", "a", IrShape::Index::Counter},
    {IrOp::Block, "block", "a", IrShape::Index::Block},
    {IrOp::Place, "place", "dmc"},
    {IrOp::Reach, "reach", "dac", IrShape::Index::Target},
    {IrOp::Bound, "bound", "dac", IrShape::Index::Target},
    {IrOp::Element, "element", "dabc"},
    {IrOp::LoadAt, "load_at", "dam"},
    {IrOp::StoreAt, "store_at", "abm"},
    {IrOp::LoadElement, "load_element", "dbmc"},
    {IrOp::StoreElement, "store_element", "abmc"},
    {IrOp::Move, "move", "abc"},
    {IrOp::Now, "now", "d"},
    {IrOp::Sin, "sin", "da"},
    {IrOp::Cos, "cos", "da"},
    {IrOp::Tan, "tan", "da"},
    {IrOp::Asin, "asin", "da"},
    {IrOp::Acos, "acos", "da"},
    {IrOp::Atan, "atan", "da"},
    {IrOp::Atan2, "atan2", "dab"},
    {IrOp::Exp, "exp", "da"},
    {IrOp::Ln, "ln", "da"},
    {IrOp::Log, "log", "da"},
    {IrOp::Power, "power", "dab"},
};

const Row* row(IrOp op)
{
    for (const Row& r : Rows) {
        if (r.op == op)
            return &r;
    }
    return nullptr;
}

struct ShapeTable {
    IrShape shapes[256];

    ShapeTable()
    {
        for (const Row& r : Rows) {
            IrShape& s = shapes[static_cast<unsigned>(r.op)];
            s.known = true;
            s.index = r.index;
            for (const char field : r.fields) {
                s.dest |= field == 'd';
                s.a |= field == 'a';
                s.b |= field == 'b';
                s.address |= field == 'm';
                s.constant |= field == 'c';
                s.from |= field == 'f';
            }
        }
    }
};

bool isComparison(IrOp op)
{
    return op >= IrOp::Equal && op <= IrOp::LessEqual;
}

bool isEdge(IrOp op)
{
    return op == IrOp::RisingEdge || op == IrOp::FallingEdge;
}

bool isConversionAllowed(IrOp op, DataType type, DataType from)
{
    switch (op) {
    case IrOp::Convert: return type != DataType::Bool && from != DataType::Bool;
    case IrOp::Truncate: return isInteger(type) && isFloat(from);
    default: return isInteger(type) && isInteger(from);
    }
}

} // namespace

const IrShape& shapeOf(IrOp op)
{
    static const ShapeTable table;
    return table.shapes[static_cast<unsigned>(op)];
}

std::string_view name(IrOp op)
{
    const Row* r = row(op);
    return r ? r->name : std::string_view("?");
}

DataType resultType(IrOp op, DataType type)
{
    if (op == IrOp::Bound)
        return DataType::Dword;
    const bool givesBool = isComparison(op) || isEdge(op) || op == IrOp::Timer || op == IrOp::Counter;
    return givesBool ? DataType::Bool : type;
}

DataType secondOperandType(IrOp op, DataType type)
{
    switch (op) {
    case IrOp::ShiftLeft:
    case IrOp::ShiftRight:
    case IrOp::RotateLeft:
    case IrOp::RotateRight:
    case IrOp::StoreAt:
    case IrOp::LoadElement:
    case IrOp::StoreElement: return DataType::Dword;
    default: return type;
    }
}

DataType firstOperandType(IrOp op, DataType type, DataType from)
{
    const IrShape& shape = shapeOf(op);
    switch (op) {
    case IrOp::Select: return DataType::Bool;
    case IrOp::Reach:
    case IrOp::CallAt:
    case IrOp::LoadAt: return DataType::Dword;
    case IrOp::Bound: return DataType::Dint;
    default: break;
    }
    if (shape.index != IrShape::Index::None)
        return DataType::Bool;
    return shape.from ? from : type;
}

bool isAllowed(IrOp op, DataType type, DataType from)
{
    switch (op) {
    case IrOp::Const:
    case IrOp::Load:
    case IrOp::Store:
    case IrOp::Select:
    case IrOp::LoadAt:
    case IrOp::StoreAt:
    case IrOp::LoadElement:
    case IrOp::StoreElement:
    case IrOp::Equal:
    case IrOp::NotEqual: return true;
    case IrOp::Place:
    case IrOp::Reach:
    case IrOp::Element:
    case IrOp::Move: return type == DataType::Dword;
    case IrOp::Bound: return type == DataType::Dint;
    case IrOp::Now: return type == DataType::Lint;
    case IrOp::Not:
    case IrOp::And:
    case IrOp::Or:
    case IrOp::Xor: return !isFloat(type);
    case IrOp::Mod:
    case IrOp::ShiftLeft:
    case IrOp::ShiftRight:
    case IrOp::RotateLeft:
    case IrOp::RotateRight: return isInteger(type);
    case IrOp::Sin:
    case IrOp::Cos:
    case IrOp::Tan:
    case IrOp::Asin:
    case IrOp::Acos:
    case IrOp::Atan:
    case IrOp::Atan2:
    case IrOp::Exp:
    case IrOp::Ln:
    case IrOp::Log:
    case IrOp::Power:
    case IrOp::Sqrt: return isFloat(type);
    case IrOp::Convert:
    case IrOp::Truncate:
    case IrOp::Saturate: return isConversionAllowed(op, type, from);
    case IrOp::Timer:
    case IrOp::Counter: return type == DataType::Int || type == DataType::Dint;
    case IrOp::Add:
    case IrOp::Sub:
    case IrOp::Mul:
    case IrOp::Div:
    case IrOp::Neg:
    case IrOp::Abs:
    case IrOp::Min:
    case IrOp::Max:
    case IrOp::Greater:
    case IrOp::GreaterEqual:
    case IrOp::Less:
    case IrOp::LessEqual: return type != DataType::Bool;
    default: return type == DataType::Bool; // control, edges, calls: the type means nothing
    }
}

} // namespace camwright
