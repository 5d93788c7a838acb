#include "core/language/st/lowering/bodylowering.h"

namespace camwright::st {

// Calls.

namespace {

/// The operation of a function of one real; Nop if it is none.
IrOp realOperation(Standard standard)
{
    switch (standard) {
    case Standard::Sin: return IrOp::Sin;
    case Standard::Cos: return IrOp::Cos;
    case Standard::Tan: return IrOp::Tan;
    case Standard::Asin: return IrOp::Asin;
    case Standard::Acos: return IrOp::Acos;
    case Standard::Atan: return IrOp::Atan;
    case Standard::Exp: return IrOp::Exp;
    case Standard::Ln: return IrOp::Ln;
    case Standard::Log: return IrOp::Log;
    default: return IrOp::Nop;
    }
}

} // namespace

ValuePlace BodyLowering::parameterPlace(const Symbol& parameter, const ValuePlace* instance)
{
    if (parameter.storage == Storage::Instance && instance)
        return memberOf(*instance, parameter.offset);
    ValuePlace place;
    place.address = {VariablesArea, IrAddress::WholeByte, parameter.offset};
    return place;
}

/// The instance a callee works on; nothing for functions.
std::optional<ValuePlace> BodyLowering::instanceOf(const Expr& callee, const PouInfo& pou)
{
    if (pou.tree->kind == PouKind::Function)
        return std::nullopt;
    if (pou.tree->kind == PouKind::FunctionBlock)
        return placeOf(callee);
    if (callee.kind == ExprKind::Member)
        return placeOf(*callee.left);
    ValuePlace self;
    self.address = {InstanceArea, IrAddress::WholeByte, 0};
    return self;
}

IrRegister BodyLowering::call(const Expr& call)
{
    if (call.intrinsic != 0)
        return standardCall(call);
    if (call.left->symbol && call.left->symbol->kind == SymbolKind::Subroutine) {
        m_ir.control(IrOp::Call, m_link.subroutineOf(call.left->symbol->standard));
        return NoRegister;
    }
    const PouInfo& pou = *call.symbol->pou;
    std::optional<ValuePlace> instance = instanceOf(*call.left, pou);
    if (instance && instance->kind == ValuePlace::Kind::Element) {
        const std::uint32_t bytes = instance->stride;
        instance->pointer = pointerTo(*instance, bytes);
        instance->kind = ValuePlace::Kind::Pointer;
        instance->offset = 0;
        instance->reach = bytes;
    }
    const ValuePlace* place = instance ? &*instance : nullptr;
    passArguments(call, pou, place);
    callRoutine(pou, place);
    takeOutputs(call, pou, place);
    return pou.result && pou.result->type->isScalar() ? load(parameterPlace(*pou.result, nullptr), *pou.result->type) : NoRegister;
}

/// Every value is computed before the first is passed, so that f(f(x)) does not overwrite its own arguments.
void BodyLowering::passArguments(const Expr& call, const PouInfo& pou, const ValuePlace* instance)
{
    struct Passed {
        const Symbol* parameter;
        IrRegister value;
        std::optional<ValuePlace> bytes;
    };
    std::vector<Passed> passed;
    for (const Argument& argument : call.arguments) {
        if (!argument.value || !argument.symbol || argument.symbol->section == Section::Output)
            continue;
        const Type& type = *argument.symbol->type;
        if (argument.symbol->section == Section::InOut)
            passed.push_back({argument.symbol, pointerTo(placeOf(*argument.value), type.size), std::nullopt});
        else if (type.isScalar())
            passed.push_back({argument.symbol, value(*argument.value), std::nullopt});
        else
            passed.push_back({argument.symbol, NoRegister, placeOf(*argument.value)});
    }
    if (pou.tree->kind != PouKind::FunctionBlock)
        resetInputs(call, pou);
    Type pointer;
    pointer.data = DataType::Dword;
    for (const Passed& p : passed) {
        const ValuePlace to = parameterPlace(*p.parameter, instance);
        if (p.bytes)
            move(to, *p.bytes, p.parameter->type->size);
        else
            store(to, p.parameter->isPointer ? pointer : *p.parameter->type, p.value);
    }
}

/// Inputs of functions and methods that are not given have their initial values.
void BodyLowering::resetInputs(const Expr& call, const PouInfo& pou)
{
    static const Constant zero;
    for (const Symbol* parameter : pou.parameters) {
        bool isGiven = false;
        for (const Argument& argument : call.arguments)
            isGiven |= argument.symbol == parameter && argument.value;
        if (isGiven || parameter->section != Section::Input || !parameter->type->isScalar())
            continue;
        const Expr* initial = parameter->initial ? parameter->initial : parameter->type->initial;
        store(parameterPlace(*parameter, nullptr), *parameter->type, constantOf(*parameter->type, initial && initial->constant ? *initial->constant : zero));
    }
}

void BodyLowering::callRoutine(const PouInfo& pou, const ValuePlace* instance)
{
    const std::uint32_t routine = m_link.routineOf(pou);
    if (!instance)
        return m_ir.control(IrOp::Call, routine);
    const bool isFixed = instance->kind == ValuePlace::Kind::Fixed;
    IrInstruction i = m_ir.make(isFixed ? IrOp::CallOn : IrOp::CallAt, DataType::Bool);
    i.index = routine;
    if (isFixed)
        i.address = instance->address;
    else
        i.a = pointerTo(*instance, (pou.owner ? pou.owner : &pou)->type->size);
    m_ir.emit(i);
}

void BodyLowering::takeOutputs(const Expr& call, const PouInfo&, const ValuePlace* instance)
{
    for (const Argument& argument : call.arguments) {
        if (!argument.value || !argument.symbol || argument.symbol->section != Section::Output)
            continue;
        const Type& from = *argument.symbol->type;
        const Type& to = *argument.value->type;
        const ValuePlace output = parameterPlace(*argument.symbol, instance);
        if (!from.isScalar()) {
            move(placeOf(*argument.value), output, from.size);
            continue;
        }
        IrRegister result = load(output, from);
        if (from.kind != TypeKind::Enum && from.kind != TypeKind::Reference)
            result = convert(from.elementary, to.elementary, result, false);
        if (argument.isNegated)
            result = m_ir.compute(IrOp::Not, DataType::Bool, result);
        store(placeOf(*argument.value), to, result);
    }
}

IrRegister BodyLowering::mux(const Expr& call)
{
    const DataType type = call.type->data;
    std::vector<IrRegister> values;
    for (const Argument& argument : call.arguments)
        values.push_back(value(*argument.value));
    IrRegister out = values.back();
    for (std::size_t i = values.size() - 1; i-- > 1;) {
        const IrRegister number = integer(DataType::Dint, static_cast<std::int64_t>(i - 1));
        const IrRegister isChosen = m_ir.compute(IrOp::Equal, DataType::Dint, values[0], number);
        out = select(type, isChosen, values[i], out);
    }
    return out;
}

IrRegister BodyLowering::standardCall(const Expr& call)
{
    const Standard standard = standardOf(call.intrinsic);
    const DataType type = call.type->data;
    if (standard == Standard::Now)
        return m_ir.define(m_ir.make(IrOp::Now, DataType::Lint));
    if (standard == Standard::Mux)
        return mux(call);
    const Argument& first = *call.arguments.first;
    if (standard == Standard::Ref)
        return pointerTo(placeOf(*first.value), first.value->type->size);
    const IrRegister a = value(*first.value);
    const auto fold = [&](IrOp op) {
        IrRegister out = a;
        for (const Argument* argument = first.next; argument; argument = argument->next)
            out = m_ir.compute(op, type, out, value(*argument->value));
        return out;
    };
    switch (standard) {
    case Standard::Convert: return convert(convertsFrom(call.intrinsic), convertsTo(call.intrinsic), a, convertTruncates(call.intrinsic));
    case Standard::Abs: return m_ir.compute(IrOp::Abs, type, a);
    case Standard::Sqrt: return m_ir.compute(IrOp::Sqrt, type, a);
    case Standard::Not: return m_ir.compute(IrOp::Not, type, a);
    case Standard::Max: return fold(IrOp::Max);
    case Standard::Min: return fold(IrOp::Min);
    case Standard::Limit: {
        const IrRegister in = value(*first.next->value);
        const IrRegister most = value(*first.next->next->value);
        return m_ir.compute(IrOp::Min, type, m_ir.compute(IrOp::Max, type, a, in), most);
    }
    case Standard::Sel: {
        const IrRegister no = value(*first.next->value);
        const IrRegister yes = value(*first.next->next->value);
        return select(type, a, yes, no);
    }
    case Standard::Shl:
    case Standard::Shr:
    case Standard::Rol:
    case Standard::Ror: {
        const IrRegister count = asData(DataType::Dint, DataType::Dword, value(*first.next->value));
        const IrOp op = standard == Standard::Shl ? IrOp::ShiftLeft : standard == Standard::Shr ? IrOp::ShiftRight : standard == Standard::Rol ? IrOp::RotateLeft : IrOp::RotateRight;
        return m_ir.compute(op, type, a, count);
    }
    case Standard::Atan2: return m_ir.compute(IrOp::Atan2, type, a, value(*first.next->value));
    default: break;
    }
    const IrOp op = realOperation(standard);
    return op == IrOp::Nop ? a : m_ir.compute(op, type, a); // else MOVE
}

} // namespace camwright::st
