#include "core/runtime/native/routinetranslator.h"

namespace camwright::native {

// Jumps, calls, and the count of operations. `Budget` holds what is left less the number of the instruction where the
// running segment began, so straight lines count nothing: a jump adds the distance it skips, and before instruction `at`
// ends the segment, at + 1 more have been done.

namespace {

constexpr bool isBackward(std::uint32_t at, std::uint32_t target)
{
    return target <= at;
}

} // namespace

bool RoutineTranslator::isJumpOn(IrRegister number) const
{
    const std::size_t next = std::size_t{m_at} + 1;
    if (next >= m_routine.code.size() || m_outline.labelAt(m_at + 1) != RoutineOutline::NoLabel || !m_registers.isLastUse(number))
        return false;
    const IrInstruction& i = m_routine.code[next];
    return (i.op == IrOp::JumpIf || i.op == IrOp::JumpIfNot) && i.a == number;
}

void RoutineTranslator::arrive(FlowLabel& label, const Snapshot& snapshot)
{
    if (!label.isReached) {
        label.isReached = true;
        label.snapshot = snapshot;
        return;
    }
    for (std::size_t unit = 0; unit < snapshot.memory.size(); ++unit) {
        if (label.snapshot.memory[unit] != snapshot.memory[unit])
            label.snapshot.memory[unit] = {};
    }
}

/// At a label registers hold what they hold on every way there; at the head of a loop nothing.
void RoutineTranslator::land(std::uint32_t at)
{
    FlowLabel& label = m_labels[m_outline.labelAt(at)];
    if (m_outline.isLoop(m_outline.labelAt(at))) {
        m_registers.forget();
    } else {
        if (m_isReachable) {
            m_registers.settle();
            arrive(label, m_registers.snapshot());
        }
        m_registers.restrictTo(label.snapshot);
        if (!m_isReachable && label.isReached)
            m_registers.restore(label.snapshot);
    }
    m_isReachable = true;
    m_asm.bind(label.label);
}

void RoutineTranslator::countJump(std::uint32_t at, std::uint32_t target)
{
    const std::int64_t distance = std::int64_t{target} - (std::int64_t{at} + 1);
    if (distance != 0)
        m_asm.add(Budget, static_cast<std::int32_t>(distance));
}

void RoutineTranslator::jump(const IrInstruction& i)
{
    m_registers.settle();
    FlowLabel& target = m_labels[m_outline.labelAt(i.index)];
    if (isBackward(m_at, i.index)) {
        m_asm.cmp(Budget, m_at + 1);
        m_asm.jl(cold(&RoutineTranslator::coldBudget).entry);
    } else {
        arrive(target, m_registers.snapshot());
    }
    countJump(m_at, i.index);
    m_asm.jmp(target.label);
    m_registers.forget();
    m_isReachable = false;
}

void RoutineTranslator::jumpIf(const IrInstruction& i)
{
    const bool whenTrue = i.op == IrOp::JumpIf;
    if (m_registers[i.a].where == Value::Where::Constant) {
        const bool isTaken = (m_registers[i.a].content != 0) == whenTrue;
        m_registers.use(i.a);
        m_registers.settle();
        if (isTaken) { // without an end of the line, for what follows is still translated
            m_asm.cmp(x86::eax, x86::eax);
            jumpWhen(x86::CondCode::kEqual, m_at, i.index);
        }
        return;
    }
    const x86::CondCode condition = testBool(i.a, true);
    jumpWhen(whenTrue ? condition : x86::negateCond(condition), m_at, i.index);
}

/// The registers are settled.
void RoutineTranslator::jumpWhen(x86::CondCode condition, std::uint32_t at, std::uint32_t target)
{
    FlowLabel& label = m_labels[m_outline.labelAt(target)];
    if (!isBackward(at, target))
        arrive(label, m_registers.snapshot());
    if (target == at + 1) {
        m_asm.j(condition, label.label);
        return;
    }
    Cold& taken = cold(isBackward(at, target) ? &RoutineTranslator::coldLoop : &RoutineTranslator::coldJump, target);
    taken.at = at;
    taken.back = label.label;
    m_asm.j(condition, taken.entry);
}

/// extra: the target
void RoutineTranslator::coldJump(const Cold& c)
{
    countJump(c.at, c.extra);
    m_asm.jmp(c.back);
}

void RoutineTranslator::coldLoop(const Cold& c)
{
    m_at = c.at;
    m_asm.cmp(Budget, c.at + 1);
    m_asm.jl(cold(&RoutineTranslator::coldBudget).entry);
    countJump(c.at, c.extra);
    m_asm.jmp(c.back);
}

void RoutineTranslator::coldBudget(const Cold& c)
{
    m_asm.sub(Budget, c.at + 1);
    coldOutOfOperations(c);
}

/// What was done is already counted.
void RoutineTranslator::coldOutOfOperations(const Cold& c)
{
    m_asm.mov(x86::eax, c.at);
    m_asm.jmp(m_program.outOfOperations);
}

void RoutineTranslator::callRoutine(const IrInstruction& i)
{
    m_registers.forget();
    m_asm.sub(Budget, m_at + 1);
    m_asm.js(cold(&RoutineTranslator::coldOutOfOperations).entry);
    m_asm.call(m_program.entries[i.index]);
    m_asm.mov(frameField(offsetof(Frame, routine), 4), m_index);
    m_asm.add(Budget, m_at + 1);
}

void RoutineTranslator::returnFromRoutine(const IrInstruction&)
{
    leave(m_at);
    m_isReachable = false;
}

void RoutineTranslator::leave(std::uint32_t at)
{
    m_at = at;
    m_registers.forget();
    m_asm.sub(Budget, at + 1);
    m_asm.js(cold(&RoutineTranslator::coldOutOfOperations).entry);
    m_asm.add(x86::rsp, 8);
    m_asm.ret();
}

void RoutineTranslator::callFault(std::uint32_t at)
{
    m_asm.push(at);
    m_asm.call(m_program.fault);
    m_asm.lea(x86::rsp, x86::ptr(x86::rsp, 8));
}

} // namespace camwright::native
