#include "core/language/lowering/routinelowering.h"

namespace camwright {

// Calls, jumps and loops. At a label, at FOR and at NEXT the flow begins anew: nothing computed before is used behind them,
// so wherever a jump comes from, every register is written on its way.

void RoutineLowering::beginFlowAnew()
{
    m_flow = NoRegister;
    m_loads.clear();
    m_pushed.clear();
    m_groups.clear();
}

bool RoutineLowering::lowerControl(const CheckedStatement& statement)
{
    switch (statement.instruction->id) {
    case InstructionId::KincoEnd:
    case InstructionId::InvtEnd:
    case InstructionId::KincoRet:
    case InstructionId::InvtCret: lowerReturn(statement); return true;
    case InstructionId::KincoCal:
    case InstructionId::InvtCall: lowerCall(statement); return true;
    case InstructionId::KincoJmp:
    case InstructionId::KincoJmpc:
    case InstructionId::KincoJmpcn:
    case InstructionId::InvtCj: lowerJump(statement); return true;
    case InstructionId::KincoLbl:
    case InstructionId::InvtLbl: lowerLabel(statement); return true;
    case InstructionId::KincoFor: lowerFor(statement); return true;
    case InstructionId::InvtFor: lowerCountedFor(statement); return true;
    case InstructionId::KincoNext:
    case InstructionId::InvtNext: lowerNext(); return true;
    default: return false;
    }
}

void RoutineLowering::lowerReturn(const CheckedStatement& statement)
{
    if (statement.instruction->executes == Executes::OnFlow)
        openGuard();
    m_ir.control(IrOp::Return);
}

void RoutineLowering::lowerCall(const CheckedStatement& statement)
{
    openGuard();
    const std::uint32_t callee = m_context.routineByName(std::get<ProgramOperand>(statement.operands[0].value).name);
    passArguments(statement, callee, true);
    m_ir.control(IrOp::Call, callee);
    passArguments(statement, callee, false);
}

/// TS-SBR-04: what goes in is written to the callee's own memory before it runs, what comes out is read from there after.
void RoutineLowering::passArguments(const CheckedStatement& statement, std::uint32_t callee, bool before)
{
    if (callee >= m_context.programs.size())
        return; // a routine in another language, which takes none
    const auto& table = m_context.programs[callee].parameters;
    std::size_t at = 1; // behind the name
    for (std::size_t i = 0; table && i < table->size() && at < statement.operands.size(); ++i) {
        const KnownParameter& parameter = (*table)[i];
        if (parameter.kind == ParameterKind::Temp)
            continue;
        const CheckedOperand& argument = statement.operands[at++];
        const DataType type = parameter.variable.type;
        const IrAddress inside = place(*parameter.variable.address, callee);
        if (before && parameter.kind != ParameterKind::Out)
            m_ir.store(type, inside, read(argument, type));
        if (!before && parameter.kind != ParameterKind::In)
            write(argument, type, m_ir.load(type, inside));
    }
}

void RoutineLowering::lowerJump(const CheckedStatement& statement)
{
    closeGuard();
    const InstructionId id = statement.instruction->id;
    std::size_t jump = 0;
    if (id == InstructionId::KincoJmp)
        jump = m_ir.jump();
    else
        jump = m_ir.jumpIf(id != InstructionId::KincoJmpcn, flow());
    m_jumps.emplace_back(jump, std::get<LabelOperand>(statement.operands[0].value).name);
}

void RoutineLowering::lowerLabel(const CheckedStatement& statement)
{
    closeGuard();
    m_labels.emplace(std::get<LabelOperand>(statement.operands[0].value).name, m_ir.here());
    beginFlowAnew();
}

void RoutineLowering::landJumps()
{
    for (const auto& [jump, label] : m_jumps)
        if (const auto found = m_labels.find(label); found != m_labels.end())
            m_ir.land(jump, found->second);
}

/// FOR INDX, INIT, FINAL: the number of the pass lies in the program's own memory, so a program may look at it and change it.
void RoutineLowering::lowerFor(const CheckedStatement& statement)
{
    closeGuard();
    const CheckedOperand& index = statement.operands[0];
    ForLoop loop;
    loop.statement = &statement;
    loop.skip = m_ir.jumpIf(false, flow());
    write(index, DataType::Int, read(statement.operands[1], DataType::Int));
    loop.head = m_ir.here();
    loop.exit = m_ir.jumpIf(true, m_ir.compute(IrOp::Greater, DataType::Int, read(index, DataType::Int), read(statement.operands[2], DataType::Int)));
    m_forLoops.push_back(loop);
    beginFlowAnew();
}

/// FOR S: the passes that are left lie where no text can reach them.
void RoutineLowering::lowerCountedFor(const CheckedStatement& statement)
{
    closeGuard();
    const IrAddress left = m_context.elements.work(DataType::Int);
    ForLoop loop;
    loop.skip = m_ir.jumpIf(false, flow());
    m_ir.store(DataType::Int, left, read(statement.operands[0], DataType::Int));
    loop.head = m_ir.here();
    const IrRegister passes = m_ir.load(DataType::Int, left);
    loop.exit = m_ir.jumpIf(true, m_ir.compute(IrOp::LessEqual, DataType::Int, passes, m_ir.constant(DataType::Int, 0)));
    m_ir.store(DataType::Int, left, m_ir.compute(IrOp::Sub, DataType::Int, passes, m_ir.constant(DataType::Int, 1)));
    m_forLoops.push_back(loop);
    beginFlowAnew();
}

void RoutineLowering::lowerNext()
{
    closeGuard();
    if (m_forLoops.empty())
        return;
    const ForLoop loop = m_forLoops.back();
    m_forLoops.pop_back();
    if (loop.statement) {
        // At the last number the loop ends before INDX could pass the end of its range.
        const CheckedOperand& index = loop.statement->operands[0];
        const IrRegister value = read(index, DataType::Int);
        const IrRegister isLast = m_ir.compute(IrOp::GreaterEqual, DataType::Int, value, read(loop.statement->operands[2], DataType::Int));
        const std::size_t end = m_ir.jumpIf(true, isLast);
        write(index, DataType::Int, m_ir.compute(IrOp::Add, DataType::Int, value, m_ir.constant(DataType::Int, 1)));
        m_ir.land(m_ir.jump(), loop.head);
        m_ir.land(end);
    } else {
        m_ir.land(m_ir.jump(), loop.head);
    }
    m_ir.land(loop.exit);
    m_ir.land(loop.skip);
    beginFlowAnew();
}

} // namespace camwright
