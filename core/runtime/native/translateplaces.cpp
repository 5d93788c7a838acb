#include "core/runtime/executor/handlers.h"
#include "core/runtime/native/routinetranslator.h"

#include <bit>

namespace camwright::native {

// Computed places: instances, pointers, indices. The verifier has proved that what a guard lets through lies inside the
// variables, so the accesses themselves check nothing.

void RoutineTranslator::callInstance(const IrInstruction& i, const x86::Mem& instance)
{
    m_registers.forget();
    m_asm.sub(Budget, m_at + 1);
    m_asm.js(cold(&RoutineTranslator::coldOutOfOperations).entry);
    m_asm.push(Instance);
    m_asm.sub(x86::rsp, 8);
    m_asm.lea(Instance, instance);
    m_asm.call(m_program.entries[i.index]);
    m_asm.add(x86::rsp, 8);
    m_asm.pop(Instance);
    m_asm.mov(frameField(offsetof(Frame, routine), 4), m_index);
    m_asm.add(Budget, m_at + 1);
}

void RoutineTranslator::callOn(const IrInstruction& i)
{
    callInstance(i, m_registers.at(offsetOf(i.address), 0));
}

void RoutineTranslator::callAt(const IrInstruction& i)
{
    const x86::Gp pointer = m_registers.general(i.a);
    callInstance(i, x86::ptr(Base, pointer.r64(), 0, static_cast<std::int32_t>(variablesOffset()), 0));
}

void RoutineTranslator::select(const IrInstruction& i)
{
    if (isFloat(i.type)) {
        const x86::Xmm result = m_registers.ownFloating(i.index);
        const x86::Xmm other = m_registers.floating(i.b);
        const asmjit::Label done = m_asm.newLabel();
        m_asm.j(x86::negateCond(testBool(i.a, false)), done);
        m_asm.movaps(result, other);
        m_asm.bind(done);
        return m_registers.define(i.dest, i.type, result.id() + FirstFloat);
    }
    const bool isBool = i.type == DataType::Bool;
    const x86::Gp result = isBool ? ownZeroOrOne(i.index) : m_registers.ownGeneral(i.index);
    const x86::Gp other = isBool ? ownZeroOrOne(i.b) : m_registers.general(i.b);
    m_asm.cmov(testBool(i.a, false), result, other);
    if (isBool)
        m_registers.defineBool(i.dest, result.id(), 0, false, true);
    else
        m_registers.define(i.dest, i.type, result.id());
}

/// A pointer is an offset among the variables; that of a fixed place is known now.
void RoutineTranslator::place(const IrInstruction& i)
{
    if (i.address.area != InstanceArea)
        return m_registers.defineConstant(i.dest, DataType::Dword, i.address.byte);
    const x86::Gp result = m_registers.takeGeneral();
    m_asm.lea(result.r64(), x86::ptr(Instance, static_cast<std::int32_t>(i.address.byte) - static_cast<std::int32_t>(variablesOffset())));
    m_asm.sub(result.r64(), Base);
    m_registers.define(i.dest, DataType::Dword, result.id());
}

/// Reach and Bound: dest := a - lower if that is less than a count, else a fault, and on elsewhere.
void RoutineTranslator::guard(const IrInstruction& i)
{
    const bool isBound = i.op == IrOp::Bound;
    const std::uint32_t lower = isBound ? irFirst(i.constant) : 0;
    const auto bytes = static_cast<std::uint32_t>(m_program.memory.area(VariablesArea).size());
    const std::uint32_t count = isBound ? irSecond(i.constant) : bytes - static_cast<std::uint32_t>(i.constant) + 1;
    beforeFault();
    const x86::Gp result = m_registers.ownGeneral(i.a);
    m_registers.settle();
    if (lower != 0)
        m_asm.sub(result, static_cast<std::int32_t>(lower));
    m_asm.cmp(result, static_cast<std::int32_t>(count));
    FlowLabel& label = m_labels[m_outline.labelAt(i.index)];
    arrive(label, m_registers.snapshot());
    Cold& outside = cold(&RoutineTranslator::coldGuard, i.index);
    outside.back = label.label;
    m_asm.jae(outside.entry);
    m_registers.define(i.dest, DataType::Dword, result.id());
}

void RoutineTranslator::coldGuard(const Cold& c)
{
    callFault(c.at);
    countJump(c.at, c.extra);
    m_asm.jmp(c.back);
}

void RoutineTranslator::locateElement(const IrInstruction& i)
{
    const std::uint32_t stride = irFirst(i.constant);
    const x86::Gp result = m_registers.ownGeneral(i.b);
    if (stride != 1)
        m_asm.imul(result, result, static_cast<std::int32_t>(stride));
    m_asm.emit(x86::Inst::kIdAdd, result, m_registers.source(i.a));
    m_registers.define(i.dest, DataType::Dword, result.id());
}

x86::Mem RoutineTranslator::elementPlace(const IrInstruction& i)
{
    const bool isOfInstance = i.address.area == InstanceArea;
    const auto offset = static_cast<std::int32_t>(isOfInstance ? i.address.byte : offsetOf(i.address));
    const x86::Gp& base = isOfInstance ? Instance : Base;
    const auto stride = static_cast<std::uint32_t>(i.constant);
    if (std::has_single_bit(stride) && stride <= 8) {
        const x86::Gp index = m_registers.general(i.b);
        return x86::ptr(base, index.r64(), static_cast<std::uint32_t>(std::countr_zero(stride)), offset, byteWidth(i.type));
    }
    const x86::Gp index = m_registers.ownGeneral(i.b);
    m_asm.imul(index, index, static_cast<std::int32_t>(stride));
    return x86::ptr(base, index.r64(), 0, offset, byteWidth(i.type));
}

x86::Mem RoutineTranslator::pointedPlace(const IrInstruction& i, IrRegister pointer)
{
    const auto offset = static_cast<std::int32_t>(variablesOffset() + i.address.byte);
    return x86::ptr(Base, m_registers.general(pointer).r64(), 0, offset, byteWidth(i.type));
}

void RoutineTranslator::loadFrom(const IrInstruction& i, const x86::Mem& source)
{
    m_registers.beforeComputedLoad();
    const Unit unit = m_registers.take(bankOf(i.type));
    const bool isBool = i.type == DataType::Bool;
    const Value loaded = m_registers.loadInto(unit, i.type, source, isBool);
    if (isBool)
        m_registers.defineBool(i.dest, unit, loaded.bit, false, false);
    else
        m_registers.define(i.dest, i.type, unit, loaded.extended);
}

void RoutineTranslator::storeTo(const IrInstruction& i, const x86::Mem& place)
{
    const unsigned bytes = byteWidth(i.type);
    if (isFloat(i.type)) {
        const x86::Xmm value = m_registers.floating(i.a);
        m_registers.beforeComputedStore();
        m_asm.emit(i.type == DataType::Real ? x86::Inst::kIdUcomiss : x86::Inst::kIdUcomisd, value, value);
        Cold& nan = cold(&RoutineTranslator::coldNaNToStore, value.id());
        nan.back = m_asm.newLabel();
        m_asm.jp(nan.entry);
        m_asm.bind(nan.back);
        m_asm.emit(i.type == DataType::Real ? x86::Inst::kIdMovss : x86::Inst::kIdMovsd, place, value);
        return;
    }
    const x86::Gp value = i.type == DataType::Bool ? ownZeroOrOne(i.a) : m_registers.general(i.a);
    m_registers.beforeComputedStore();
    m_asm.mov(place, generalRegister(value.id(), bytes));
}

/// extra: the register. Which NaN it holds is nobody's business, so it may as well be the one that memory wants.
void RoutineTranslator::coldNaNToStore(const Cold& c)
{
    const bool isReal = m_routine.code[c.at].type == DataType::Real;
    m_asm.push(x86::rax);
    m_asm.mov(x86::rax, isReal ? std::uint64_t{0x7FC00000} : std::uint64_t{0x7FF8000000000000});
    m_asm.movq(x86::xmm(c.extra), x86::rax);
    m_asm.pop(x86::rax);
    m_asm.jmp(c.back);
}

void RoutineTranslator::loadAt(const IrInstruction& i)
{
    loadFrom(i, pointedPlace(i, i.a));
}

void RoutineTranslator::storeAt(const IrInstruction& i)
{
    const x86::Mem place = pointedPlace(i, i.b);
    storeTo(i, place);
}

void RoutineTranslator::loadElement(const IrInstruction& i)
{
    loadFrom(i, elementPlace(i));
}

void RoutineTranslator::storeElement(const IrInstruction& i)
{
    const x86::Mem place = elementPlace(i);
    storeTo(i, place);
}

void RoutineTranslator::move(const IrInstruction& i)
{
    putArgument(i.a, DataType::Dword, m_program.argumentA);
    putArgument(i.b, DataType::Dword, m_program.argumentB);
    Step& step = callHandler(moveBytes, variablesOffset());
    step.dest = m_program.argumentA;
    step.a = m_program.argumentB;
    step.b = static_cast<std::uint32_t>(i.constant);
}

void RoutineTranslator::now(const IrInstruction& i)
{
    const Unit unit = m_registers.take(Bank::General);
    m_asm.mov(x86::gpq(unit), frameField(offsetof(Frame, now), 8));
    m_registers.define(i.dest, DataType::Lint, unit);
}

} // namespace camwright::native
