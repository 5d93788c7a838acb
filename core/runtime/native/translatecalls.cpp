#include "core/runtime/executor/handlers.h"
#include "core/runtime/native/routinetranslator.h"

namespace camwright::native {

// What is done by the interpreter's own functions: timers, counters, blocks, and operations without code of their own. They
// find their operands in memory, at offsets that a Step tells them.

void RoutineTranslator::putArgument(IrRegister number, DataType type, std::uint32_t offset)
{
    const unsigned bytes = byteWidth(type);
    const x86::Mem place = m_registers.at(offset, bytes);
    if (type == DataType::Bool) {
        m_asm.mov(place, ownZeroOrOne(number).r8());
    } else if (isFloat(type)) {
        m_asm.emit(type == DataType::Real ? x86::Inst::kIdMovss : x86::Inst::kIdMovsd, place, m_registers.floating(number));
    } else {
        m_asm.mov(place, generalRegister(m_registers.general(number).id(), bytes));
    }
}

/// Nothing survives in registers, and memory is up to date before and after.
Step& RoutineTranslator::callHandler(Handler handler, std::uint32_t extra)
{
    m_registers.forget();
    Step& step = m_program.steps.emplace_back();
    step.run = handler;
    step.dest = m_program.result;
    step.a = m_program.argumentA;
    step.b = m_program.argumentB;
    step.extra = extra;
    m_asm.mov(x86::rdi, FramePointer);
    m_asm.mov(x86::rsi, reinterpret_cast<std::uintptr_t>(&step));
    m_asm.call(x86::ptr(x86::rsi, static_cast<std::int32_t>(offsetof(Step, run)), 8));
    return step;
}

void RoutineTranslator::takeResult(const IrInstruction& i)
{
    if (!m_registers.isUsed(i.dest))
        return;
    const DataType type = resultType(i.op, i.type);
    const unsigned bytes = byteWidth(type);
    const x86::Mem place = m_registers.at(m_program.result, bytes);
    const Unit unit = m_registers.take(bankOf(type));
    if (isFloat(type))
        m_asm.emit(type == DataType::Real ? x86::Inst::kIdMovss : x86::Inst::kIdMovsd, floatRegister(unit), place);
    else if (bytes < 4)
        m_asm.emit(isSigned(type) ? x86::Inst::kIdMovsx : x86::Inst::kIdMovzx, x86::gpd(unit), place);
    else
        m_asm.mov(generalRegister(unit, bytes), place);
    if (type == DataType::Bool)
        m_registers.defineBool(i.dest, unit, 0, false, true);
    else
        m_registers.define(i.dest, type, unit, true);
}

void RoutineTranslator::interpreted(const IrInstruction& i)
{
    const IrShape& shape = shapeOf(i.op);
    putArgument(i.a, shape.from ? i.from : i.type, m_program.argumentA);
    if (shape.b)
        putArgument(i.b, secondOperandType(i.op, i.type), m_program.argumentB);
    callHandler(computingHandler(i.op, i.type, i.from), m_at);
    takeResult(i);
}

void RoutineTranslator::element(const IrInstruction& i)
{
    const IrShape& shape = shapeOf(i.op);
    putArgument(i.a, DataType::Bool, m_program.argumentA);
    if (shape.b)
        putArgument(i.b, i.op == IrOp::CounterArm ? DataType::Bool : i.type, m_program.argumentB);
    switch (i.op) {
    case IrOp::Timer: callHandler(timerHandler(m_program.tables.timers[i.index].kind), i.index); break;
    case IrOp::TimerReset: callHandler(resetTimer, i.index); break;
    case IrOp::Counter: callHandler(counterHandler(m_program.tables.counters[i.index].isWide), i.index); break;
    case IrOp::CounterArm: callHandler(armCounter, i.index); break;
    case IrOp::CounterReset: callHandler(resetCounter, i.index); break;
    default: callHandler(callBlock, i.index); break;
    }
    if (shape.dest)
        takeResult(i);
}

} // namespace camwright::native
