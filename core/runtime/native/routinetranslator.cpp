#include "core/runtime/native/routinetranslator.h"

#include <algorithm>
#include <array>

namespace camwright::native {

struct RoutineTranslator::Row {
    IrOp op;
    Emit emit;
};

/// A new operation is one row here; one without a row leaves its program to the interpreter.
const RoutineTranslator::Row RoutineTranslator::Rows[] = {
    {IrOp::Nop, &RoutineTranslator::nop},
    {IrOp::Jump, &RoutineTranslator::jump},
    {IrOp::JumpIf, &RoutineTranslator::jumpIf},
    {IrOp::JumpIfNot, &RoutineTranslator::jumpIf},
    {IrOp::Call, &RoutineTranslator::callRoutine},
    {IrOp::Return, &RoutineTranslator::returnFromRoutine},
    {IrOp::Const, &RoutineTranslator::constant},
    {IrOp::Load, &RoutineTranslator::load},
    {IrOp::Store, &RoutineTranslator::store},
    {IrOp::Not, &RoutineTranslator::invert},
    {IrOp::And, &RoutineTranslator::arithmetic},
    {IrOp::Or, &RoutineTranslator::arithmetic},
    {IrOp::Xor, &RoutineTranslator::arithmetic},
    {IrOp::Add, &RoutineTranslator::arithmetic},
    {IrOp::Sub, &RoutineTranslator::arithmetic},
    {IrOp::Mul, &RoutineTranslator::multiply},
    {IrOp::Div, &RoutineTranslator::divide},
    {IrOp::Mod, &RoutineTranslator::divide},
    {IrOp::Neg, &RoutineTranslator::negate},
    {IrOp::Abs, &RoutineTranslator::absolute},
    {IrOp::Sqrt, &RoutineTranslator::squareRoot},
    {IrOp::Min, &RoutineTranslator::extreme},
    {IrOp::Max, &RoutineTranslator::extreme},
    {IrOp::ShiftLeft, &RoutineTranslator::shift},
    {IrOp::ShiftRight, &RoutineTranslator::shift},
    {IrOp::RotateLeft, &RoutineTranslator::shift},
    {IrOp::RotateRight, &RoutineTranslator::shift},
    {IrOp::Equal, &RoutineTranslator::compare},
    {IrOp::NotEqual, &RoutineTranslator::compare},
    {IrOp::Greater, &RoutineTranslator::compare},
    {IrOp::GreaterEqual, &RoutineTranslator::compare},
    {IrOp::Less, &RoutineTranslator::compare},
    {IrOp::LessEqual, &RoutineTranslator::compare},
    {IrOp::Convert, &RoutineTranslator::convert},
    {IrOp::Truncate, &RoutineTranslator::convert},
    {IrOp::Saturate, &RoutineTranslator::interpreted},
    {IrOp::RisingEdge, &RoutineTranslator::edge},
    {IrOp::FallingEdge, &RoutineTranslator::edge},
    {IrOp::Timer, &RoutineTranslator::element},
    {IrOp::TimerReset, &RoutineTranslator::element},
    {IrOp::Counter, &RoutineTranslator::element},
    {IrOp::CounterArm, &RoutineTranslator::element},
    {IrOp::CounterReset, &RoutineTranslator::element},
    {IrOp::Block, &RoutineTranslator::element},
    {IrOp::CallOn, &RoutineTranslator::callOn},
    {IrOp::CallAt, &RoutineTranslator::callAt},
    {IrOp::Select, &RoutineTranslator::select},
    {IrOp::Place, &RoutineTranslator::place},
    {IrOp::Reach, &RoutineTranslator::guard},
    {IrOp::Bound, &RoutineTranslator::guard},
    {IrOp::Element, &RoutineTranslator::locateElement},
    {IrOp::LoadAt, &RoutineTranslator::loadAt},
    {IrOp::StoreAt, &RoutineTranslator::storeAt},
    {IrOp::LoadElement, &RoutineTranslator::loadElement},
    {IrOp::StoreElement, &RoutineTranslator::storeElement},
    {IrOp::Move, &RoutineTranslator::move},
    {IrOp::Now, &RoutineTranslator::now},
    {IrOp::Sin, &RoutineTranslator::interpreted},
    {IrOp::Cos, &RoutineTranslator::interpreted},
    {IrOp::Tan, &RoutineTranslator::interpreted},
    {IrOp::Asin, &RoutineTranslator::interpreted},
    {IrOp::Acos, &RoutineTranslator::interpreted},
    {IrOp::Atan, &RoutineTranslator::interpreted},
    {IrOp::Atan2, &RoutineTranslator::interpreted},
    {IrOp::Exp, &RoutineTranslator::interpreted},
    {IrOp::Ln, &RoutineTranslator::interpreted},
    {IrOp::Log, &RoutineTranslator::interpreted},
    {IrOp::Power, &RoutineTranslator::interpreted},
};

RoutineTranslator::Emit RoutineTranslator::emitterOf(IrOp op)
{
    static const std::array<Emit, 256> table = [] {
        std::array<Emit, 256> out;
        out.fill(nullptr);
        for (const Row& row : Rows)
            out[static_cast<std::size_t>(row.op)] = row.emit;
        return out;
    }();
    return table[static_cast<std::size_t>(op)];
}

bool RoutineTranslator::canTranslate(const IrRoutine& routine)
{
    return std::ranges::all_of(routine.code, [](const IrInstruction& i) { return emitterOf(i.op) != nullptr; });
}

RoutineTranslator::RoutineTranslator(ProgramTranslation& program, const IrRoutine& routine, std::uint32_t index)
    : m_program(program), m_asm(program.assembler), m_routine(routine), m_index(index), m_outline(routine, program.memory),
      m_registers(program.assembler, program.slots, program.constants,
                  {program.memory.offsetOf(VariablesArea, 0), static_cast<std::uint32_t>(program.memory.area(VariablesArea).size())})
{
    m_labels.resize(m_outline.labelCount() + std::size_t{1});
    for (std::size_t k = 1; k < m_labels.size(); ++k)
        m_labels[k].label = m_asm.newLabel();
    program.slots.beginRoutine(!m_outline.hasLoops());
    m_registers.beginRoutine(routine);
}

void RoutineTranslator::run()
{
    m_asm.bind(m_program.entries[m_index]);
    m_asm.sub(x86::rsp, 8); // calls find the stack aligned to 16
    m_asm.mov(frameField(offsetof(Frame, routine), 4), m_index);
    const auto end = static_cast<std::uint32_t>(m_routine.code.size());
    for (m_at = 0; m_at < end; ++m_at) {
        if (m_outline.labelAt(m_at) != RoutineOutline::NoLabel)
            land(m_at);
        const IrInstruction& i = m_routine.code[m_at];
        (this->*emitterOf(i.op))(i);
        m_registers.endInstruction();
    }
    if (m_outline.labelAt(end) != RoutineOutline::NoLabel)
        land(end);
    leave(end);
    for (std::size_t k = 0; k < m_cold.size(); ++k) {
        const Cold c = m_cold[k];
        m_asm.bind(c.entry);
        (this->*c.write)(c);
    }
}

RoutineTranslator::Cold& RoutineTranslator::cold(void (RoutineTranslator::*write)(const Cold&), std::uint32_t extra)
{
    return m_cold.emplace_back(Cold{write, m_asm.newLabel(), {}, m_at, extra});
}

void RoutineTranslator::constant(const IrInstruction& i)
{
    m_registers.defineConstant(i.dest, i.type, i.constant);
}

void RoutineTranslator::load(const IrInstruction& i)
{
    const std::uint8_t bit = i.type == DataType::Bool ? i.address.bit : std::uint8_t{0};
    m_registers.defineLoad(i.dest, i.type, offsetOf(i.address), bit, m_outline.isLookedAtAgain(m_at));
}

void RoutineTranslator::store(const IrInstruction& i)
{
    if (i.type == DataType::Bool)
        return i.address.bit == IrAddress::WholeByte ? storeWholeByte(i) : storeBit(i);
    if (isFloat(i.type))
        return storeFloat(i);
    const unsigned bytes = byteWidth(i.type);
    const Range range{offsetOf(i.address), bytes};
    const x86::Mem place = m_registers.at(range.offset, bytes);
    if (m_registers[i.a].where == Value::Where::Constant) {
        const asmjit::Operand source = m_registers.source(i.a);
        m_registers.beforeStore(range);
        m_asm.emit(x86::Inst::kIdMov, place, source);
        return;
    }
    const x86::Gp source = m_registers.general(i.a);
    m_registers.beforeStore(range);
    m_asm.mov(place, generalRegister(source.id(), bytes));
    if (m_outline.isLookedAtAgain(m_at))
        m_registers.remember(source.id(), range);
}

/// The fault flag may be written: whoever reads or writes it around here sees it in order.
void RoutineTranslator::beforeFault()
{
    if (m_program.tables.hasErrorFlag)
        m_registers.beforeAccess({m_program.tables.errorFlag, 1});
}

} // namespace camwright::native
