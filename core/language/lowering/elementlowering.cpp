#include "core/language/lowering/routinelowering.h"

namespace camwright {

bool RoutineLowering::lowerElement(const CheckedStatement& statement)
{
    switch (statement.instruction->id) {
    case InstructionId::KincoTon: lowerTimer(statement, TimerKind::Ton); return true;
    case InstructionId::KincoTof: lowerTimer(statement, TimerKind::Tof); return true;
    case InstructionId::KincoTp: lowerTimer(statement, TimerKind::Tp); return true;
    case InstructionId::InvtTon: lowerTimer(statement, TimerKind::T600Ton); return true;
    case InstructionId::InvtTonr: lowerTimer(statement, TimerKind::T600Tonr); return true;
    case InstructionId::InvtTof: lowerTimer(statement, TimerKind::T600Tof); return true;
    case InstructionId::InvtTmon: lowerTimer(statement, TimerKind::T600Tmon); return true;
    case InstructionId::KincoCtu: lowerCounter(statement, CounterKind::Up); return true;
    case InstructionId::KincoCtd: lowerCounter(statement, CounterKind::Down); return true;
    case InstructionId::KincoCtud: lowerCounter(statement, CounterKind::UpDown); return true;
    case InstructionId::InvtCtu: lowerCounter(statement, CounterKind::T600Up); return true;
    case InstructionId::InvtCtr: lowerCyclicCounter(statement); return true;
    case InstructionId::InvtCtud: lowerCounter(statement, CounterKind::T600UpDown); return true;
    default: return false;
    }
}

void RoutineLowering::lowerTimer(const CheckedStatement& statement, TimerKind kind)
{
    const Address* element = addressOf(statement.operands[0]);
    const std::uint32_t timer = m_context.elements.timer(kind, *element);
    const IrRegister preset = read(statement.operands[1], DataType::Int);
    const IrRegister output = m_ir.element(IrOp::Timer, DataType::Int, timer, flow(), preset);
    if (statement.instruction->crEffect == CrEffect::Replaces)
        m_flow = output;
}

void RoutineLowering::lowerCounter(const CheckedStatement& statement, CounterKind kind)
{
    const std::uint32_t counter = m_context.elements.counter(kind, *addressOf(statement.operands[0]));
    const DataType type = m_context.elements.counterAt(counter).type;
    const auto input = [&](std::string_view pin) {
        const CheckedOperand* operand = operandAt(statement, pin);
        return operand ? read(*operand, DataType::Bool) : m_ir.constant(DataType::Bool, 0);
    };
    const IrRegister reset = input(kind == CounterKind::Down ? "LD" : "R");
    const IrRegister down = input(kind == CounterKind::T600UpDown ? "DIR" : "CD");
    const bool isKinco = kind == CounterKind::Up || kind == CounterKind::Down || kind == CounterKind::UpDown;
    const IrRegister preset = read(*operandAt(statement, isKinco ? "PV" : "S"), type);
    const IrRegister countInput = flow();
    m_ir.control(IrOp::CounterArm, counter, reset, down);
    IrRegister output = m_ir.element(IrOp::Counter, type, counter, countInput, preset);
    if (kind == CounterKind::UpDown)
        output = lowerCounterExtras(statement, counter, input("LD"), preset);
    if (statement.instruction->crEffect == CrEffect::Replaces)
        m_flow = output;
}

/// CTR counts up like CTU; the edge after the one that reached the preset begins again with 1.
void RoutineLowering::lowerCyclicCounter(const CheckedStatement& statement)
{
    const std::uint32_t counter = m_context.elements.counter(CounterKind::T600Up, *addressOf(statement.operands[0]));
    const IrCounter& element = m_context.elements.counterAt(counter);
    const IrRegister edge = m_ir.element(IrOp::RisingEdge, DataType::Bool, m_context.elements.edge(), flow());
    const std::size_t skip = m_ir.jumpIf(false, edge);
    const IrRegister zero = m_ir.constant(DataType::Int, 0);
    const IrRegister value = m_ir.load(DataType::Int, element.value);
    const IrRegister wasFull = m_ir.load(DataType::Bool, element.bit);
    const IrRegister base = m_ir.select(DataType::Int, wasFull, zero, value);
    const IrRegister next = m_ir.compute(IrOp::Add, DataType::Int, base, m_ir.constant(DataType::Int, 1));
    m_ir.store(DataType::Int, element.value, next);
    const IrRegister preset = read(*operandAt(statement, "S"), DataType::Int);
    m_ir.store(DataType::Bool, element.bit, m_ir.compute(IrOp::GreaterEqual, DataType::Int, next, preset));
    m_ir.land(skip);
}

/// CTUD of Kinco: LD loads the preset, unless R resets; QD tells a value of 0 or less. Returns the counter bit.
IrRegister RoutineLowering::lowerCounterExtras(const CheckedStatement& statement, std::uint32_t counter, IrRegister load, IrRegister preset)
{
    const IrCounter& element = m_context.elements.counterAt(counter);
    const IrRegister isReset = read(*operandAt(statement, "R"), DataType::Bool);
    const IrRegister loads = m_ir.compute(IrOp::And, DataType::Bool, load, m_ir.compute(IrOp::Not, DataType::Bool, isReset));
    const std::size_t skip = m_ir.jumpIf(false, loads);
    m_ir.store(element.type, element.value, preset);
    m_ir.store(DataType::Bool, element.bit, m_ir.constant(DataType::Bool, 1));
    m_ir.land(skip);
    if (const CheckedOperand* below = operandAt(statement, "QD"); below && addressOf(*below)) {
        const IrRegister zero = m_ir.constant(element.type, 0);
        write(*below, DataType::Bool, m_ir.compute(IrOp::LessEqual, element.type, m_ir.load(element.type, element.value), zero));
    }
    return m_ir.load(DataType::Bool, element.bit);
}

} // namespace camwright
