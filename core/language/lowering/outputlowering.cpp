#include "core/language/lowering/routinelowering.h"

namespace camwright {

void RoutineLowering::lowerOutput(const CheckedStatement& statement)
{
    const CheckedOperand& operand = statement.operands[0];
    switch (statement.instruction->id) {
    case InstructionId::KincoStn:
        return write(operand, DataType::Bool, m_ir.compute(IrOp::Not, DataType::Bool, flow()));
    case InstructionId::KoyoPd:
        return write(operand, DataType::Bool, m_ir.element(IrOp::RisingEdge, DataType::Bool, m_context.elements.edge(), flow()));
    case InstructionId::KincoS:
    case InstructionId::KoyoSet:
    case InstructionId::InvtSet:
        return write(operand, DataType::Bool, m_ir.compute(IrOp::Or, DataType::Bool, read(operand, DataType::Bool), flow()));
    case InstructionId::KincoR:
    case InstructionId::KoyoRst:
    case InstructionId::InvtRst: return lowerReset(statement);
    default: return write(operand, DataType::Bool, flow()); // ST, OUT
    }
}

/// A timer or counter loses its value with its bit.
void RoutineLowering::lowerReset(const CheckedStatement& statement)
{
    const CheckedOperand& operand = statement.operands[0];
    const Address* address = addressOf(operand);
    const AreaKind kind = address && address->area != VariablesArea ? m_context.family.area(address->area).kind : AreaKind::Bytes;
    const bool isKoyo = statement.instruction->id == InstructionId::KoyoRst;
    if (kind == AreaKind::TimerBits || kind == AreaKind::TimerValues) {
        m_ir.control(IrOp::TimerReset, m_context.elements.timer(isKoyo ? TimerKind::KoyoTmr : TimerKind::T600Ton, *address), flow());
    } else if (kind == AreaKind::CounterBits || kind == AreaKind::CounterValues) {
        m_ir.control(IrOp::CounterReset, m_context.elements.counter(isKoyo ? CounterKind::KoyoCnt : CounterKind::T600UpDown, *address), flow());
    } else {
        const IrRegister off = m_ir.compute(IrOp::Not, DataType::Bool, flow());
        write(operand, DataType::Bool, m_ir.compute(IrOp::And, DataType::Bool, read(operand, DataType::Bool), off));
    }
}

void RoutineLowering::lowerBlock(const CheckedStatement& statement)
{
    if (statement.form >= ContactForm::Equal)
        return combine(StatementRole::And, comparison(statement));
    if (lowerControl(statement))
        return;
    if (lowerElement(statement) || lowerComputing(statement) || lowerKoyo(statement))
        return;
    lowerEngineBlock(statement);
}

/// Everything else is the engine's. Most is called on every pass and sees EN, because EN falling means something there.
void RoutineLowering::lowerEngineBlock(const CheckedStatement& statement)
{
    if (statement.instruction->executes == Executes::OnFlow)
        openGuard();
    std::vector<IrPin> pins;
    for (const CheckedOperand& operand : statement.operands)
        pins.push_back(pinOf(operand));
    const std::uint32_t block = m_context.elements.block(statement.instruction->id, std::move(pins));
    m_ir.control(IrOp::Block, block, flow());
}

} // namespace camwright
