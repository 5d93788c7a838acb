#include "core/base/realmath.h"
#include "core/runtime/executor/access.h"
#include "core/runtime/executor/handlers.h"
#include "core/runtime/executor/numbers.h"

namespace camwright {

namespace {

/// Picks the instance of a handler template for a data type.
template <template <class> class Operation>
Handler forType(DataType type)
{
    switch (type) {
    case DataType::Bool:
    case DataType::Byte:
    case DataType::Usint: return Operation<std::uint8_t>::run;
    case DataType::Word:
    case DataType::Uint: return Operation<std::uint16_t>::run;
    case DataType::Dword:
    case DataType::Udint: return Operation<std::uint32_t>::run;
    case DataType::Lword:
    case DataType::Ulint: return Operation<std::uint64_t>::run;
    case DataType::Sint: return Operation<std::int8_t>::run;
    case DataType::Int: return Operation<std::int16_t>::run;
    case DataType::Time:
    case DataType::Dint: return Operation<std::int32_t>::run;
    case DataType::Lint: return Operation<std::int64_t>::run;
    case DataType::Real: return Operation<float>::run;
    case DataType::Lreal: return Operation<double>::run;
    }
    return nullptr;
}

template <class T>
struct Copy {
    static const Step* run(Frame& frame, const Step* step)
    {
        store(frame, step->dest, canonical(load<T>(frame, step->a)));
        return step + 1;
    }
};

/// dest := function(a, b), of one type.
template <auto Function>
struct Binary {
    template <class T>
    struct Of {
        static const Step* run(Frame& frame, const Step* step)
        {
            store(frame, step->dest, Function.template operator()<T>(load<T>(frame, step->a), load<T>(frame, step->b)));
            return step + 1;
        }
    };
};

template <auto Function>
struct Unary {
    template <class T>
    struct Of {
        static const Step* run(Frame& frame, const Step* step)
        {
            store(frame, step->dest, Function.template operator()<T>(load<T>(frame, step->a)));
            return step + 1;
        }
    };
};

template <auto Function>
struct Shift {
    template <class T>
    struct Of {
        static const Step* run(Frame& frame, const Step* step)
        {
            store(frame, step->dest, Function.template operator()<T>(load<T>(frame, step->a), load<std::uint32_t>(frame, step->b)));
            return step + 1;
        }
    };
};

template <auto Function>
struct Comparison {
    template <class T>
    struct Of {
        static const Step* run(Frame& frame, const Step* step)
        {
            frame.bytes[step->dest] = Function(load<T>(frame, step->a), load<T>(frame, step->b)) ? 1 : 0;
            return step + 1;
        }
    };
};

template <class T>
struct Divide {
    static const Step* run(Frame& frame, const Step* step)
    {
        const T divisor = load<T>(frame, step->b);
        if (divisor == T{0})
            frame.fault(step->extra);
        store(frame, step->dest, divided(load<T>(frame, step->a), divisor));
        return step + 1;
    }
};

template <class T>
struct Remainder {
    static const Step* run(Frame& frame, const Step* step)
    {
        const T divisor = load<T>(frame, step->b);
        if (divisor == T{0})
            frame.fault(step->extra);
        store(frame, step->dest, remainder(load<T>(frame, step->a), divisor));
        return step + 1;
    }
};

template <class T>
struct SquareRoot {
    static const Step* run(Frame& frame, const Step* step)
    {
        const T value = load<T>(frame, step->a);
        if (value < T{0})
            frame.fault(step->extra);
        store(frame, step->dest, squareRoot(value));
        return step + 1;
    }
};

/// A function of LREAL on a float type; a REAL is rounded once. No handler is asked for other types.
template <auto Function>
struct RealFunction {
    template <class T>
    struct Of {
        static const Step* run(Frame& frame, const Step* step)
        {
            store(frame, step->dest, canonical(static_cast<T>(Function(static_cast<double>(load<T>(frame, step->a))))));
            return step + 1;
        }
    };
};

template <auto Function>
struct RealFunction2 {
    template <class T>
    struct Of {
        static const Step* run(Frame& frame, const Step* step)
        {
            const auto a = static_cast<double>(load<T>(frame, step->a));
            const auto b = static_cast<double>(load<T>(frame, step->b));
            store(frame, step->dest, canonical(static_cast<T>(Function(a, b))));
            return step + 1;
        }
    };
};

template <template <class> class Operation>
Handler forFloat(DataType type)
{
    return type == DataType::Real ? Operation<float>::run : type == DataType::Lreal ? Operation<double>::run : nullptr;
}

template <class From, class Conversion>
struct To {
    template <class T>
    struct Of {
        static const Step* run(Frame& frame, const Step* step)
        {
            store(frame, step->dest, Conversion::template convert<T>(load<From>(frame, step->a)));
            return step + 1;
        }
    };
};

template <class Conversion>
struct FromTo {
    template <class From>
    static Handler to(DataType type) { return forType<To<From, Conversion>::template Of>(type); }

    static Handler pick(DataType from, DataType type)
    {
        switch (from) {
        case DataType::Bool: return nullptr;
        case DataType::Byte:
        case DataType::Usint: return to<std::uint8_t>(type);
        case DataType::Word:
        case DataType::Uint: return to<std::uint16_t>(type);
        case DataType::Dword:
        case DataType::Udint: return to<std::uint32_t>(type);
        case DataType::Lword:
        case DataType::Ulint: return to<std::uint64_t>(type);
        case DataType::Sint: return to<std::int8_t>(type);
        case DataType::Int: return to<std::int16_t>(type);
        case DataType::Time:
        case DataType::Dint: return to<std::int32_t>(type);
        case DataType::Lint: return to<std::int64_t>(type);
        case DataType::Real: return to<float>(type);
        case DataType::Lreal: return to<double>(type);
        }
        return nullptr;
    }
};

constexpr auto Sum = []<class T>(T a, T b) { return sum(a, b); };
constexpr auto Difference = []<class T>(T a, T b) { return difference(a, b); };
constexpr auto Product = []<class T>(T a, T b) { return product(a, b); };
constexpr auto Smaller = []<class T>(T a, T b) { return smaller(a, b); };
constexpr auto Larger = []<class T>(T a, T b) { return larger(a, b); };
constexpr auto Negated = []<class T>(T a) { return difference(T{0}, a); };
constexpr auto Absolute = []<class T>(T a) { return absolute(a); };
constexpr auto BitAnd = []<class T>(T a, T b) { return bitAnd(a, b); };
constexpr auto BitOr = []<class T>(T a, T b) { return bitOr(a, b); };
constexpr auto BitXor = []<class T>(T a, T b) { return bitXor(a, b); };
constexpr auto BitNot = []<class T>(T a) { return bitNot(a); };
constexpr auto ShiftedLeft = []<class T>(T a, std::uint32_t count) { return shiftedLeft(a, count); };
constexpr auto ShiftedRight = []<class T>(T a, std::uint32_t count) { return shiftedRight(a, count); };
constexpr auto RotatedLeft = []<class T>(T a, std::uint32_t count) { return rotatedLeft(a, count); };
constexpr auto RotatedRight = []<class T>(T a, std::uint32_t count) { return rotatedLeft(a, -count); };
constexpr auto IsEqual = [](auto a, auto b) { return a == b; };
constexpr auto IsNotEqual = [](auto a, auto b) { return a != b; };
constexpr auto IsGreater = [](auto a, auto b) { return a > b; };
constexpr auto IsGreaterEqual = [](auto a, auto b) { return a >= b; };
constexpr auto IsLess = [](auto a, auto b) { return a < b; };
constexpr auto IsLessEqual = [](auto a, auto b) { return a <= b; };

} // namespace

Handler copyHandler(DataType type)
{
    return forType<Copy>(type);
}

Handler computingHandler(IrOp op, DataType type, DataType from)
{
    switch (op) {
    case IrOp::Not: return forType<Unary<BitNot>::Of>(type);
    case IrOp::And: return forType<Binary<BitAnd>::Of>(type);
    case IrOp::Or: return forType<Binary<BitOr>::Of>(type);
    case IrOp::Xor: return forType<Binary<BitXor>::Of>(type);
    case IrOp::Add: return forType<Binary<Sum>::Of>(type);
    case IrOp::Sub: return forType<Binary<Difference>::Of>(type);
    case IrOp::Mul: return forType<Binary<Product>::Of>(type);
    case IrOp::Div: return forType<Divide>(type);
    case IrOp::Mod: return forType<Remainder>(type);
    case IrOp::Neg: return forType<Unary<Negated>::Of>(type);
    case IrOp::Abs: return forType<Unary<Absolute>::Of>(type);
    case IrOp::Sqrt: return forType<SquareRoot>(type);
    case IrOp::Min: return forType<Binary<Smaller>::Of>(type);
    case IrOp::Max: return forType<Binary<Larger>::Of>(type);
    case IrOp::ShiftLeft: return forType<Shift<ShiftedLeft>::Of>(type);
    case IrOp::ShiftRight: return forType<Shift<ShiftedRight>::Of>(type);
    case IrOp::RotateLeft: return forType<Shift<RotatedLeft>::Of>(type);
    case IrOp::RotateRight: return forType<Shift<RotatedRight>::Of>(type);
    case IrOp::Equal: return forType<Comparison<IsEqual>::Of>(type);
    case IrOp::NotEqual: return forType<Comparison<IsNotEqual>::Of>(type);
    case IrOp::Greater: return forType<Comparison<IsGreater>::Of>(type);
    case IrOp::GreaterEqual: return forType<Comparison<IsGreaterEqual>::Of>(type);
    case IrOp::Less: return forType<Comparison<IsLess>::Of>(type);
    case IrOp::LessEqual: return forType<Comparison<IsLessEqual>::Of>(type);
    case IrOp::Convert: return FromTo<ConvertRounding>::pick(from, type);
    case IrOp::Truncate: return FromTo<ConvertTruncating>::pick(from, type);
    case IrOp::Sin: return forFloat<RealFunction<sine>::Of>(type);
    case IrOp::Cos: return forFloat<RealFunction<cosine>::Of>(type);
    case IrOp::Tan: return forFloat<RealFunction<tangent>::Of>(type);
    case IrOp::Asin: return forFloat<RealFunction<arcSine>::Of>(type);
    case IrOp::Acos: return forFloat<RealFunction<arcCosine>::Of>(type);
    case IrOp::Atan: return forFloat<RealFunction<arcTangent>::Of>(type);
    case IrOp::Atan2: return forFloat<RealFunction2<arcTangent2>::Of>(type);
    case IrOp::Exp: return forFloat<RealFunction<exponential>::Of>(type);
    case IrOp::Ln: return forFloat<RealFunction<naturalLogarithm>::Of>(type);
    case IrOp::Log: return forFloat<RealFunction<decimalLogarithm>::Of>(type);
    case IrOp::Power: return forFloat<RealFunction2<power>::Of>(type);
    case IrOp::Saturate: return FromTo<ConvertSaturating>::pick(from, type);
    default: return nullptr;
    }
}

} // namespace camwright
