#include "core/language/st/lowering/bodylowering.h"

namespace camwright::st {

// Where values lie.

namespace {

IrAddress variablesAt(std::uint32_t offset)
{
    return {VariablesArea, IrAddress::WholeByte, offset};
}

} // namespace

ValuePlace BodyLowering::placeOf(const Symbol& symbol)
{
    ValuePlace place;
    switch (symbol.storage) {
    case Storage::Static: place.address = variablesAt(symbol.offset); break;
    case Storage::Instance: place.address = {InstanceArea, IrAddress::WholeByte, symbol.offset}; break;
    case Storage::Located: place.address = m_link.placeOf(symbol.address); break;
    case Storage::Constant: break;
    }
    if (!symbol.isPointer)
        return place;
    Type pointer;
    pointer.data = DataType::Dword;
    return reached(load(place, pointer), symbol.type->size);
}

/// A pointer from memory, checked to reach so many bytes.
ValuePlace BodyLowering::reached(IrRegister stored, std::uint32_t bytes)
{
    IrInstruction guard = m_ir.make(IrOp::Reach, DataType::Dword);
    guard.a = stored;
    guard.constant = bytes;
    m_guards.push_back(m_ir.here());
    ValuePlace place;
    place.kind = ValuePlace::Kind::Pointer;
    place.pointer = m_ir.define(guard);
    place.reach = bytes;
    return place;
}

ValuePlace BodyLowering::placeOf(const Expr& expr)
{
    switch (expr.kind) {
    case ExprKind::Name:
    case ExprKind::Address: return placeOf(*expr.symbol);
    case ExprKind::Member: return memberOf(placeOf(*expr.left), expr.symbol->offset);
    case ExprKind::Index: return elementOf(expr);
    case ExprKind::Dereference: return reached(value(*expr.left), expr.type->size);
    default: break;
    }
    ValuePlace place; // THIS and SUPER
    place.address = {InstanceArea, IrAddress::WholeByte, 0};
    return place;
}

ValuePlace BodyLowering::memberOf(const ValuePlace& place, std::uint32_t offset)
{
    ValuePlace out = place;
    if (place.kind == ValuePlace::Kind::Fixed) {
        out.address.byte += offset;
    } else if (place.kind == ValuePlace::Kind::Pointer) {
        out.offset += offset;
    } else {
        out.kind = ValuePlace::Kind::Pointer;
        out.pointer = pointerTo(place, place.stride);
        out.reach = place.stride;
        out.offset = offset;
    }
    return out;
}

ValuePlace BodyLowering::elementOf(const Expr& expr)
{
    ValuePlace place = placeOf(*expr.left);
    const Type* array = expr.left->type;
    for (const Argument& argument : expr.arguments) {
        place = indexed(place, *array, *argument.value);
        array = array->element;
    }
    return place;
}

ValuePlace BodyLowering::indexed(ValuePlace place, const Type& array, const Expr& subscript)
{
    const std::uint32_t stride = array.element->size;
    if (place.kind == ValuePlace::Kind::Element) {
        place.pointer = pointerTo(place, array.size);
        place.kind = ValuePlace::Kind::Pointer;
        place.offset = 0;
        place.reach = array.size;
    }
    if (subscript.constant)
        return memberOf(place, static_cast<std::uint32_t>(subscript.constant->integer - array.low) * stride);
    const IrRegister index = boundedIndex(subscript, array);
    if (place.kind == ValuePlace::Kind::Fixed) {
        place.kind = ValuePlace::Kind::Element;
        place.index = index;
        place.stride = stride;
        place.reach = array.size;
        return place;
    }
    IrInstruction element = m_ir.make(IrOp::Element, DataType::Dword);
    element.a = pointerTo(place, array.size);
    element.b = index;
    element.constant = irConstant(stride, stride);
    place.pointer = m_ir.define(element);
    place.offset = 0;
    place.reach = stride;
    return place;
}

IrRegister BodyLowering::boundedIndex(const Expr& subscript, const Type& array)
{
    IrInstruction guard = m_ir.make(IrOp::Bound, DataType::Dint);
    guard.a = value(subscript);
    if (subscript.type->data != DataType::Dint)
        guard.a = m_ir.convert(IrOp::Saturate, subscript.type->data, DataType::Dint, guard.a);
    guard.constant = irConstant(static_cast<std::uint32_t>(array.low), static_cast<std::uint32_t>(array.high - array.low + 1));
    m_guards.push_back(m_ir.here());
    return m_ir.define(guard);
}

/// A pointer register to a place in VariablesArea or the instance.
IrRegister BodyLowering::pointerTo(const ValuePlace& place, std::uint32_t bytes)
{
    if (place.kind == ValuePlace::Kind::Pointer) {
        if (place.offset == 0)
            return place.pointer;
        // A fixed step forward is an element 1 of two that lie so far apart.
        IrInstruction one = m_ir.make(IrOp::Bound, DataType::Dint);
        one.a = integer(DataType::Dint, 1);
        one.constant = irConstant(0, 2);
        m_guards.push_back(m_ir.here());
        IrInstruction step = m_ir.make(IrOp::Element, DataType::Dword);
        step.b = m_ir.define(one);
        step.a = place.pointer;
        step.constant = irConstant(place.offset, bytes);
        return m_ir.define(step);
    }
    IrInstruction begin = m_ir.make(IrOp::Place, DataType::Dword);
    begin.address = place.address;
    if (place.kind == ValuePlace::Kind::Fixed) {
        begin.constant = bytes;
        return m_ir.define(begin);
    }
    begin.constant = place.reach;
    IrInstruction element = m_ir.make(IrOp::Element, DataType::Dword);
    element.a = m_ir.define(begin);
    element.b = place.index;
    element.constant = irConstant(place.stride, bytes);
    return m_ir.define(element);
}

IrRegister BodyLowering::load(const ValuePlace& place, const Type& type)
{
    switch (place.kind) {
    case ValuePlace::Kind::Fixed: return m_ir.load(type.data, place.address);
    case ValuePlace::Kind::Element: {
        IrInstruction i = m_ir.make(IrOp::LoadElement, type.data);
        i.b = place.index;
        i.address = place.address;
        i.constant = place.stride;
        return m_ir.define(i);
    }
    case ValuePlace::Kind::Pointer: break;
    }
    IrInstruction i = m_ir.make(IrOp::LoadAt, type.data);
    i.a = place.pointer;
    i.address = variablesAt(place.offset);
    return m_ir.define(i);
}

void BodyLowering::store(const ValuePlace& place, const Type& type, IrRegister value)
{
    if (place.kind == ValuePlace::Kind::Fixed)
        return m_ir.store(type.data, place.address, value);
    const bool isElement = place.kind == ValuePlace::Kind::Element;
    IrInstruction i = m_ir.make(isElement ? IrOp::StoreElement : IrOp::StoreAt, type.data);
    i.a = value;
    i.b = isElement ? place.index : place.pointer;
    i.address = isElement ? place.address : variablesAt(place.offset);
    i.constant = isElement ? place.stride : 0;
    m_ir.emit(i);
}

void BodyLowering::move(const ValuePlace& to, const ValuePlace& from, std::uint32_t bytes)
{
    if (bytes == 0)
        return;
    IrInstruction i = m_ir.make(IrOp::Move, DataType::Dword);
    i.b = pointerTo(from, bytes);
    i.a = pointerTo(to, bytes);
    i.constant = bytes;
    m_ir.emit(i);
}

} // namespace camwright::st
