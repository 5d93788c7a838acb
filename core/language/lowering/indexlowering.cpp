#include "core/language/lowering/routinelowering.h"

#include "core/family/invt/invtareas.h"

namespace camwright {

// Arrays with a variable subscript (TS-IDX). A subscript outside the array reads 0 and writes nothing (ours; the manual is
// silent) and sets SM23 (TS-IDX-09).

namespace {

constexpr std::uint32_t SubscriptFlag = 23;

} // namespace

RoutineLowering::Element RoutineLowering::elementOf(const AddressOperand& array)
{
    IrRegister index = m_ir.load(array.index.type, place(array.index));
    if (array.index.type == DataType::Int)
        index = m_ir.convert(IrOp::Convert, DataType::Int, DataType::Dint, index);
    const IrRegister zero = m_ir.constant(DataType::Dint, 0);
    const IrRegister notBelow = m_ir.compute(IrOp::GreaterEqual, DataType::Dint, index, zero);
    const IrRegister notAbove = m_ir.compute(IrOp::Less, DataType::Dint, index, m_ir.constant(DataType::Dint, array.elements));
    Element out;
    out.isInside = m_ir.compute(IrOp::And, DataType::Bool, notBelow, notAbove);
    const IrAddress flag = place(bitAddress(invt::SM, SubscriptFlag));
    const IrRegister isOutside = m_ir.compute(IrOp::Not, DataType::Bool, out.isInside);
    m_ir.store(DataType::Bool, flag, m_ir.compute(IrOp::Or, DataType::Bool, m_ir.load(DataType::Bool, flag), isOutside));
    // The verifier wants a proof: a bound that never fails, since the number is 0 where the subscript is outside.
    m_ends.push_back(m_ir.here() + 1);
    out.number = m_ir.bound(m_ir.select(DataType::Dint, out.isInside, index, zero), array.elements);
    return out;
}

IrRegister RoutineLowering::readElement(const AddressOperand& array, DataType type)
{
    const Element element = elementOf(array);
    const IrRegister value = m_ir.loadElement(type, place(array.address), element.number, byteWidth(type));
    return m_ir.select(type, element.isInside, value, m_ir.constant(type, 0));
}

void RoutineLowering::writeElement(const AddressOperand& array, DataType type, IrRegister value)
{
    const Element element = elementOf(array);
    const std::size_t skip = m_ir.jumpIf(false, element.isInside);
    m_ir.storeElement(type, place(array.address), element.number, byteWidth(type), value);
    m_ir.land(skip);
}

} // namespace camwright
