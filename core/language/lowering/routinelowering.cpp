#include "core/language/lowering/routinelowering.h"

#include <algorithm>

namespace camwright {

void RoutineLowering::lower(const CheckedProgram& program)
{
    for (const CheckedNetwork& network : program.networks) {
        m_network = network.number;
        for (const CheckedRung& rung : network.rungs) {
            m_isRungOpen = false;
            beginFlowAnew();
            for (const CheckedStatement& statement : rung.statements)
                lower(statement);
        }
    }
    closeGuard();
    landJumps();
    for (const std::size_t jump : m_ends)
        m_ir.land(jump);
}

void RoutineLowering::lower(const CheckedStatement& statement)
{
    m_ir.setSource(m_context.source(m_network, statement.range));
    const bool needsFlow = statement.role == StatementRole::Block && statement.instruction->executes == Executes::OnFlow;
    if (!needsFlow)
        closeGuard();
    switch (statement.role) {
    case StatementRole::Load:
    case StatementRole::And:
    case StatementRole::Or: return combine(statement.role, contact(statement));
    case StatementRole::Flow: return lowerFlow(statement);
    case StatementRole::Output: return lowerOutput(statement);
    case StatementRole::Block: return lowerBlock(statement);
    default: m_isRungOpen = true; return lowerStructure(statement);
    }
}

void RoutineLowering::openGuard()
{
    if (m_guard != NoRegister && m_guard == m_flow)
        return;
    closeGuard();
    m_guard = flow();
    m_guardJump = m_ir.jumpIf(false, m_guard);
}

void RoutineLowering::closeGuard()
{
    if (m_guard == NoRegister)
        return;
    m_ir.land(m_guardJump);
    m_guard = NoRegister;
}

/// Local memory is laid out routine behind routine: each has its own, as documented, without a stack at run time.
IrAddress RoutineLowering::place(const Address& address, std::uint32_t routine) const
{
    IrAddress out = m_context.elements.place(address);
    if (address.area != VariablesArea && m_context.family.area(address.area).local)
        out.byte += routine * m_context.model.area(address.area).bytes;
    return out;
}

const Address* RoutineLowering::addressOf(const CheckedOperand& operand)
{
    if (const auto* address = std::get_if<AddressOperand>(&operand.value))
        return &address->address;
    if (const auto* block = std::get_if<BlockOperand>(&operand.value))
        return &block->start;
    return nullptr;
}

DataType RoutineLowering::typeOf(const CheckedOperand& operand)
{
    if (const auto* address = std::get_if<AddressOperand>(&operand.value))
        return address->type;
    if (const auto* constant = std::get_if<ConstantOperand>(&operand.value))
        return constant->value.type;
    if (const auto* block = std::get_if<BlockOperand>(&operand.value))
        return block->elementType;
    return operand.pin->types.isEmpty() ? DataType::Bool : operand.pin->types.list().front();
}

const CheckedOperand* RoutineLowering::operandAt(const CheckedStatement& statement, std::string_view pin)
{
    const auto found = std::ranges::find_if(statement.operands, [&](const CheckedOperand& o) { return o.pin->name == pin; });
    return found == statement.operands.end() ? nullptr : &*found;
}

/// One type for all operands: that of the operands in memory. Where they differ in sign (TS600 words carry no type of their
/// own, TS-MEM-05), the signed one, because that is what the instruction set computes with.
DataType RoutineLowering::commonType(const CheckedStatement& statement) const
{
    std::optional<DataType> ofMemory, ofConstant;
    for (const CheckedOperand& operand : statement.operands) {
        if (operand.pin->name == "N") // the count of a shift is a BYTE of its own
            continue;
        const DataType own = typeOf(operand);
        std::optional<DataType>& kind = std::holds_alternative<ConstantOperand>(operand.value) ? ofConstant : ofMemory;
        if (!kind || isSigned(own) || isFloat(own))
            kind = own;
    }
    const DataType type = ofMemory ? *ofMemory : ofConstant.value_or(statement.type);
    return type;
}

IrRegister RoutineLowering::read(const CheckedOperand& operand, DataType type)
{
    if (const auto* constant = std::get_if<ConstantOperand>(&operand.value))
        return m_ir.constant(type, constant->value.bits);
    if (const auto* array = std::get_if<AddressOperand>(&operand.value); array && array->elements > 0)
        return readElement(*array, type);
    const Address* address = addressOf(operand);
    return address ? m_ir.load(type, place(*address)) : m_ir.constant(type, 0);
}

void RoutineLowering::write(const CheckedOperand& operand, DataType type, IrRegister value)
{
    if (const auto* array = std::get_if<AddressOperand>(&operand.value); array && array->elements > 0)
        return writeElement(*array, type, value);
    if (const Address* address = addressOf(operand))
        m_ir.store(type, place(*address), value);
}

IrPin RoutineLowering::pinOf(const CheckedOperand& operand) const
{
    IrPin pin;
    if (const auto* routine = std::get_if<ProgramOperand>(&operand.value)) {
        pin.kind = IrPin::Kind::Constant;
        pin.type = DataType::Udint;
        pin.constant = m_context.routineByName(routine->name);
        return pin;
    }
    pin.type = typeOf(operand);
    if (const Address* address = addressOf(operand)) {
        pin.kind = IrPin::Kind::Memory;
        pin.address = place(*address);
    } else if (const auto* constant = std::get_if<ConstantOperand>(&operand.value)) {
        pin.kind = IrPin::Kind::Constant;
        pin.constant = constant->value.bits;
    } else if (operand.pin->direction == PinDirection::In && !operand.pin->defaultValue.empty()) {
        if (const Result<Value> value = parseValue(pin.type, operand.pin->defaultValue)) {
            pin.kind = IrPin::Kind::Constant;
            pin.constant = value->bits;
        }
    }
    return pin;
}

} // namespace camwright
