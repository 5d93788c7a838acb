#include "core/language/lowering/routinelowering.h"

namespace camwright {

namespace {

IrOp comparingOp(ContactForm form)
{
    switch (form) {
    case ContactForm::NotEqual: return IrOp::NotEqual;
    case ContactForm::Greater: return IrOp::Greater;
    case ContactForm::GreaterEqual: return IrOp::GreaterEqual;
    case ContactForm::Less: return IrOp::Less;
    case ContactForm::LessEqual: return IrOp::LessEqual;
    default: return IrOp::Equal;
    }
}

} // namespace

/// The flow as a register; on where a group has just begun.
IrRegister RoutineLowering::flow()
{
    if (m_flow == NoRegister)
        m_flow = m_ir.constant(DataType::Bool, 1);
    return m_flow;
}

IrRegister RoutineLowering::comparison(const CheckedStatement& statement)
{
    const DataType type = commonType(statement);
    const IrRegister a = read(statement.operands[0], type);
    const IrRegister b = read(statement.operands[1], type);
    return m_ir.compute(comparingOp(statement.form), type, a, b);
}

IrRegister RoutineLowering::contact(const CheckedStatement& statement)
{
    if (statement.form >= ContactForm::Equal)
        return comparison(statement);
    const IrRegister bit = read(statement.operands[0], DataType::Bool);
    switch (statement.form) {
    case ContactForm::NormallyClosed: return m_ir.compute(IrOp::Not, DataType::Bool, bit);
    case ContactForm::Rising: return m_ir.element(IrOp::RisingEdge, DataType::Bool, m_context.elements.edge(), bit);
    case ContactForm::Falling: return m_ir.element(IrOp::FallingEdge, DataType::Bool, m_context.elements.edge(), bit);
    default: return bit;
    }
}

void RoutineLowering::combine(StatementRole role, IrRegister contact)
{
    const bool begins = !m_isRungOpen || (m_flow == NoRegister && role != StatementRole::Or);
    if (role == StatementRole::Load && !begins)
        m_loads.push_back(m_flow);
    if (role == StatementRole::Load || begins)
        m_flow = contact;
    else
        m_flow = m_ir.compute(role == StatementRole::Or ? IrOp::Or : IrOp::And, DataType::Bool, flow(), contact);
    m_isRungOpen = true;
}

void RoutineLowering::lowerStructure(const CheckedStatement& statement)
{
    switch (statement.role) {
    case StatementRole::AndBlock:
    case StatementRole::OrBlock: {
        if (m_loads.empty())
            return;
        const IrOp op = statement.role == StatementRole::AndBlock ? IrOp::And : IrOp::Or;
        m_flow = m_ir.compute(op, DataType::Bool, m_loads.back(), flow());
        m_loads.pop_back();
        return;
    }
    case StatementRole::PushFlow: m_pushed.push_back(flow()); return;
    case StatementRole::ReadFlow:
        if (!m_pushed.empty())
            m_flow = m_pushed.back();
        return;
    case StatementRole::PopFlow:
        if (!m_pushed.empty()) {
            m_flow = m_pushed.back();
            m_pushed.pop_back();
        }
        return;
    case StatementRole::OpenAnd:
    case StatementRole::OpenOr:
        m_groups.push_back({statement.role, flow()});
        m_flow = statement.operands.empty() || std::holds_alternative<NoOperand>(statement.operands[0].value)
            ? NoRegister
            : contact(statement);
        return;
    default: break;
    }
    if (m_groups.empty())
        return;
    const Group group = m_groups.back();
    m_groups.pop_back();
    m_flow = m_ir.compute(group.kind == StatementRole::OpenAnd ? IrOp::And : IrOp::Or, DataType::Bool, group.outer, flow());
}

void RoutineLowering::lowerFlow(const CheckedStatement& statement)
{
    switch (statement.instruction->id) {
    case InstructionId::KincoRTrig:
        m_flow = m_ir.element(IrOp::RisingEdge, DataType::Bool, m_context.elements.edge(), flow());
        return;
    case InstructionId::KincoFTrig:
        m_flow = m_ir.element(IrOp::FallingEdge, DataType::Bool, m_context.elements.edge(), flow());
        return;
    default: m_flow = m_ir.compute(IrOp::Not, DataType::Bool, flow()); return; // NOT, INV
    }
}

} // namespace camwright
