#include "core/family/koyo/koyoareas.h"
#include "core/language/lowering/koyoaccumulator.h"
#include "core/language/lowering/routinelowering.h"

#include <algorithm>

namespace camwright {

namespace {

constexpr std::uint32_t BcdEnd = 100'000'000; ///< first number without 8 digits

enum class Calculation : std::uint8_t { None, Add, Subtract, Multiply, Divide, And, Or, Xor, Compare };

struct Rule {
    Calculation calculation = Calculation::None;
    bool isBcd = false;
    bool isWide = false; ///< operand and accumulator with 32 bits; else 16
};

Rule bcdRule(InstructionId id)
{
    switch (id) {
    case InstructionId::KoyoAdd: return {Calculation::Add, true, false};
    case InstructionId::KoyoAddd: return {Calculation::Add, true, true};
    case InstructionId::KoyoSub: return {Calculation::Subtract, true, false};
    case InstructionId::KoyoSubd: return {Calculation::Subtract, true, true};
    case InstructionId::KoyoMul: return {Calculation::Multiply, true, false};
    case InstructionId::KoyoMuld: return {Calculation::Multiply, true, true};
    case InstructionId::KoyoDiv: return {Calculation::Divide, true, false};
    case InstructionId::KoyoDivd: return {Calculation::Divide, true, true};
    default: return {};
    }
}

Rule ruleOf(InstructionId id)
{
    switch (id) {
    case InstructionId::KoyoAddb: return {Calculation::Add, false, false};
    case InstructionId::KoyoAddbd: return {Calculation::Add, false, true};
    case InstructionId::KoyoSubb: return {Calculation::Subtract, false, false};
    case InstructionId::KoyoSubbd: return {Calculation::Subtract, false, true};
    case InstructionId::KoyoMulb: return {Calculation::Multiply, false, false};
    case InstructionId::KoyoDivb: return {Calculation::Divide, false, false};
    case InstructionId::KoyoAndw: return {Calculation::And, false, false};
    case InstructionId::KoyoAndd: return {Calculation::And, false, true};
    case InstructionId::KoyoOrw: return {Calculation::Or, false, false};
    case InstructionId::KoyoOrd: return {Calculation::Or, false, true};
    case InstructionId::KoyoXor: return {Calculation::Xor, false, false};
    case InstructionId::KoyoXord: return {Calculation::Xor, false, true};
    case InstructionId::KoyoCmp: return {Calculation::Compare, false, false};
    case InstructionId::KoyoCmpd: return {Calculation::Compare, false, true};
    default: return bcdRule(id);
    }
}

IrOp logicOp(Calculation calculation)
{
    return calculation == Calculation::And ? IrOp::And : calculation == Calculation::Or ? IrOp::Or : IrOp::Xor;
}

/// One calculation with the accumulator and an operand. Numbers are binary here; BCD is unpacked before and packed behind.
class Calculator {
public:
    Calculator(KoyoAccumulator& accumulator, IrWriter& ir, Rule rule) : m_acc(accumulator), m_ir(ir), m_rule(rule) {}

    void run(IrRegister operand)
    {
        const IrRegister accumulator = m_acc.value();
        switch (m_rule.calculation) {
        case Calculation::Compare: return compare(m_rule.isWide ? accumulator : m_acc.masked(accumulator, 0xFFFF), operand);
        case Calculation::And: return finish(m_acc.compute(IrOp::And, accumulator, m_rule.isWide ? operand : m_acc.computeWith(IrOp::Or, operand, 0xFFFF0000)));
        case Calculation::Or:
        case Calculation::Xor: return finish(m_acc.compute(logicOp(m_rule.calculation), accumulator, operand));
        default: break;
        }
        const bool isHalf = m_rule.calculation == Calculation::Multiply && !m_rule.isWide;
        const IrRegister left = number(isHalf ? m_acc.masked(accumulator, 0xFFFF) : accumulator);
        const IrRegister right = number(operand);
        if (m_rule.calculation == Calculation::Add)
            add(left, right);
        else if (m_rule.calculation == Calculation::Subtract)
            subtract(left, right);
        else if (m_rule.calculation == Calculation::Multiply)
            multiply(left, right);
        else
            divide(left, right);
    }

private:
    IrRegister number(IrRegister value) { return m_rule.isBcd ? m_acc.fromBcd(value) : value; }
    IrRegister packed(IrRegister value) { return m_rule.isBcd ? m_acc.toBcd(value) : value; }

    void finish(IrRegister value)
    {
        m_acc.store(value);
        m_acc.flagResult(value);
    }

    void compare(IrRegister left, IrRegister right)
    {
        m_acc.flag(koyo::IsLess, m_ir.compute(IrOp::Less, DataType::Udint, left, right));
        m_acc.flag(koyo::IsEqual, m_ir.compute(IrOp::Equal, DataType::Udint, left, right));
        m_acc.flag(koyo::IsGreater, m_ir.compute(IrOp::Greater, DataType::Udint, left, right));
    }

    /// BCD keeps the last 8 digits, binary the last 32 bits; SP67 tells what was lost.
    void add(IrRegister left, IrRegister right)
    {
        IrRegister sum = m_acc.compute(IrOp::Add, left, right);
        if (m_rule.isBcd) {
            const IrRegister end = m_acc.constant(BcdEnd);
            m_acc.flag(koyo::Carry, m_ir.compute(IrOp::GreaterEqual, DataType::Udint, sum, end));
            sum = m_acc.compute(IrOp::Mod, sum, end);
        } else {
            m_acc.flag(koyo::Carry, m_acc.isBelow(sum, left));
        }
        finish(packed(sum));
    }

    void subtract(IrRegister left, IrRegister right)
    {
        m_acc.flag(koyo::Borrow, m_acc.isBelow(left, right));
        IrRegister difference = m_acc.compute(IrOp::Sub, left, right);
        if (m_rule.isBcd) {
            const IrRegister end = m_acc.constant(BcdEnd);
            difference = m_acc.compute(IrOp::Mod, m_acc.compute(IrOp::Add, m_acc.compute(IrOp::Sub, left, right), end), end);
        }
        finish(packed(difference));
    }

    void multiply(IrRegister left, IrRegister right)
    {
        if (!m_rule.isBcd || !m_rule.isWide)
            return finish(packed(m_acc.compute(IrOp::Mul, left, right)));
        const IrRegister a = m_ir.convert(IrOp::Convert, DataType::Udint, DataType::Ulint, left);
        const IrRegister b = m_ir.convert(IrOp::Convert, DataType::Udint, DataType::Ulint, right);
        const IrRegister product = m_ir.compute(IrOp::Mul, DataType::Ulint, a, b);
        const IrRegister end = m_ir.constant(DataType::Ulint, BcdEnd);
        const IrRegister upper = m_ir.compute(IrOp::Div, DataType::Ulint, product, end);
        const IrRegister lower = m_ir.compute(IrOp::Mod, DataType::Ulint, product, end);
        m_acc.push(packed(m_ir.convert(IrOp::Convert, DataType::Ulint, DataType::Udint, upper)));
        finish(packed(m_ir.convert(IrOp::Convert, DataType::Ulint, DataType::Udint, lower)));
    }

    /// By zero the accumulator and the stack stay as they are.
    void divide(IrRegister left, IrRegister right)
    {
        const IrRegister quotient = m_acc.compute(IrOp::Div, left, right);
        const IrRegister rest = m_acc.compute(IrOp::Mod, left, right);
        const std::size_t skip = m_ir.jumpIf(false, m_acc.isNotZero(right));
        m_acc.push(packed(rest));
        finish(packed(quotient));
        m_ir.land(skip);
    }

    KoyoAccumulator& m_acc;
    IrWriter& m_ir;
    Rule m_rule;
};

bool isBetween(InstructionId id, InstructionId first, InstructionId last)
{
    return id >= first && id <= last;
}

} // namespace

/// True if the statement was one of Koyo's own that this file lowers.
bool RoutineLowering::lowerKoyo(const CheckedStatement& statement)
{
    const InstructionId id = statement.instruction->id;
    if (isBetween(id, InstructionId::KoyoTmr, InstructionId::KoyoUdc))
        lowerKoyoElement(statement);
    else if (isBetween(id, InstructionId::KoyoLd, InstructionId::KoyoPop) || isBetween(id, InstructionId::KoyoAdd, InstructionId::KoyoRotr))
        lowerKoyoData(statement);
    else if (isBetween(id, InstructionId::KoyoGts, InstructionId::KoyoEndc))
        lowerKoyoControl(statement);
    else
        return false;
    return true;
}

IrRegister RoutineLowering::koyoOperand(const CheckedStatement& statement)
{
    const CheckedOperand& operand = statement.operands.front();
    const DataType type = operand.pin->mainType == DataType::Word ? DataType::Word : DataType::Dword;
    const IrRegister value = read(operand, type);
    return m_ir.convert(IrOp::Convert, type, DataType::Udint, value);
}

void RoutineLowering::lowerKoyoData(const CheckedStatement& statement)
{
    openGuard();
    KoyoAccumulator accumulator(m_ir);
    if (const Rule rule = ruleOf(statement.instruction->id); rule.calculation != Calculation::None)
        return Calculator(accumulator, m_ir, rule).run(koyoOperand(statement));
    switch (statement.instruction->id) {
    case InstructionId::KoyoLd:
    case InstructionId::KoyoLdd:
    case InstructionId::KoyoLds:
    case InstructionId::KoyoLda: return accumulator.load(koyoOperand(statement), m_context.usesStack);
    case InstructionId::KoyoLdf: return accumulator.load(koyoBits(statement), m_context.usesStack);
    case InstructionId::KoyoOutw:
    case InstructionId::KoyoOutd: {
        const DataType type = statement.instruction->id == InstructionId::KoyoOutw ? DataType::Word : DataType::Dword;
        write(statement.operands.front(), type, m_ir.convert(IrOp::Convert, DataType::Udint, type, accumulator.value()));
        return accumulator.release();
    }
    case InstructionId::KoyoOutf: storeKoyoBits(statement); return accumulator.release();
    case InstructionId::KoyoPop: return accumulator.pop();
    case InstructionId::KoyoBin: {
        const IrRegister number = accumulator.fromBcd(accumulator.value());
        accumulator.store(number);
        return accumulator.flagResult(number);
    }
    case InstructionId::KoyoBcd: {
        const IrRegister digits = accumulator.toBcd(accumulator.computeWith(IrOp::Mod, accumulator.value(), BcdEnd));
        accumulator.store(digits);
        return accumulator.flagResult(digits);
    }
    case InstructionId::KoyoInv: return accumulator.store(m_ir.compute(IrOp::Not, DataType::Udint, accumulator.value()));
    default: return lowerKoyoInPlace(statement);
    }
}

/// INC and its like, shifts.
void RoutineLowering::lowerKoyoInPlace(const CheckedStatement& statement)
{
    const InstructionId id = statement.instruction->id;
    KoyoAccumulator accumulator(m_ir);
    if (isBetween(id, InstructionId::KoyoShfl, InstructionId::KoyoRotr)) {
        const IrOp op = id == InstructionId::KoyoShfl ? IrOp::ShiftLeft : id == InstructionId::KoyoShfr ? IrOp::ShiftRight
            : id == InstructionId::KoyoRotl ? IrOp::RotateLeft : IrOp::RotateRight;
        const IrRegister places = m_ir.convert(IrOp::Convert, DataType::Udint, DataType::Dword, accumulator.fromBcd(koyoOperand(statement)));
        return accumulator.store(m_ir.compute(op, DataType::Udint, accumulator.value(), places));
    }
    const bool isBcd = id == InstructionId::KoyoInc || id == InstructionId::KoyoDec;
    const bool isUp = id == InstructionId::KoyoInc || id == InstructionId::KoyoIncb;
    constexpr std::uint32_t WordEnd = 0x10000, DigitsEnd = 10000;
    const IrRegister word = koyoOperand(statement);
    const IrRegister end = accumulator.constant(isBcd ? DigitsEnd : WordEnd);
    const IrRegister step = accumulator.constant(isUp ? 1 : (isBcd ? DigitsEnd : WordEnd) - 1);
    const IrRegister number = accumulator.compute(IrOp::Mod, accumulator.compute(IrOp::Add, isBcd ? accumulator.fromBcd(word) : word, step), end);
    const IrRegister result = isBcd ? accumulator.toBcd(number) : number;
    accumulator.flag(koyo::IsZero, accumulator.isZero(result));
    write(statement.operands.front(), DataType::Word, m_ir.convert(IrOp::Convert, DataType::Udint, DataType::Word, result));
}

/// LDF: bits in a row as a number, the first one lowest. Their count is a constant.
IrRegister RoutineLowering::koyoBits(const CheckedStatement& statement)
{
    KoyoAccumulator accumulator(m_ir);
    IrRegister out = accumulator.constant(0);
    for (unsigned i = 0; i < koyoBitCount(statement); ++i) {
        const IrRegister bit = m_ir.load(DataType::Bool, koyoBitAt(statement, i));
        const IrRegister with = accumulator.computeWith(IrOp::Or, out, 1u << i);
        out = m_ir.select(DataType::Udint, bit, with, out);
    }
    return out;
}

void RoutineLowering::storeKoyoBits(const CheckedStatement& statement)
{
    KoyoAccumulator accumulator(m_ir);
    const IrRegister value = accumulator.value();
    for (unsigned i = 0; i < koyoBitCount(statement); ++i) {
        const IrRegister bit = accumulator.isNotZero(accumulator.masked(value, 1u << i));
        m_ir.store(DataType::Bool, koyoBitAt(statement, i), bit);
    }
}

/// How many bits LDF and OUTF move: their K is BCD. Bits behind the end of the area are left out.
unsigned RoutineLowering::koyoBitCount(const CheckedStatement& statement) const
{
    const auto* count = std::get_if<ConstantOperand>(&statement.operands.back().value);
    const Address* first = addressOf(statement.operands.front());
    if (!count || !first)
        return 0;
    const auto digits = static_cast<unsigned>(count->value.bits);
    const unsigned left = m_context.model.area(first->area).bytes * 8 - (first->byte * 8 + first->bit);
    return std::min(digits / 16 * 10 + digits % 16, left);
}

IrAddress RoutineLowering::koyoBitAt(const CheckedStatement& statement, unsigned index) const
{
    Address address = *addressOf(statement.operands.front());
    const std::uint32_t number = address.byte * 8 + address.bit + index;
    address.byte = number / 8;
    address.bit = static_cast<std::uint8_t>(number % 8);
    return place(address);
}

/// The flow that waits below the present one; on where there is none.
IrRegister RoutineLowering::takeKoyoFlow()
{
    if (m_loads.empty())
        return m_ir.constant(DataType::Bool, 1);
    const IrRegister out = m_loads.back();
    m_loads.pop_back();
    return out;
}

void RoutineLowering::lowerKoyoElement(const CheckedStatement& statement)
{
    const InstructionId id = statement.instruction->id;
    const Address& element = *addressOf(statement.operands.front());
    const bool isWide = statement.operands.front().pin->mainType == DataType::Dword;
    const DataType type = isWide ? DataType::Dint : DataType::Int;
    const IrRegister preset = read(statement.operands[1], type);
    if (isBetween(id, InstructionId::KoyoTmr, InstructionId::KoyoTmraf)) {
        const TimerKind kind = id == InstructionId::KoyoTmr ? TimerKind::KoyoTmr : id == InstructionId::KoyoTmrf ? TimerKind::KoyoTmrf
            : id == InstructionId::KoyoTmra ? TimerKind::KoyoTmra : TimerKind::KoyoTmraf;
        const std::uint32_t timer = m_context.elements.timer(kind, element);
        IrRegister runs = flow();
        if (isWide) {
            const IrRegister resets = runs;
            runs = takeKoyoFlow();
            m_ir.control(IrOp::TimerReset, timer, resets);
            runs = m_ir.compute(IrOp::And, DataType::Bool, runs, m_ir.compute(IrOp::Not, DataType::Bool, resets));
        }
        m_ir.element(IrOp::Timer, type, timer, runs, preset);
        return;
    }
    const std::uint32_t counter = m_context.elements.counter(isWide ? CounterKind::KoyoUdc : CounterKind::KoyoCnt, element);
    const IrRegister off = m_ir.constant(DataType::Bool, 0);
    const bool hasReset = id != InstructionId::KoyoSgcnt;
    const IrRegister reset = hasReset ? flow() : off;
    const IrRegister down = isWide ? takeKoyoFlow() : off;
    const IrRegister up = hasReset ? takeKoyoFlow() : flow();
    m_ir.control(IrOp::CounterArm, counter, reset, down);
    m_ir.element(IrOp::Counter, type, counter, up, preset);
}

void RoutineLowering::lowerKoyoControl(const CheckedStatement& statement)
{
    switch (statement.instruction->id) {
    case InstructionId::KoyoGts:
        openGuard();
        return m_ir.control(IrOp::Call, m_context.routineByName(std::get<ProgramOperand>(statement.operands[0].value).name));
    case InstructionId::KoyoRtc:
    case InstructionId::KoyoEndc:
        openGuard();
        return m_ir.control(IrOp::Return);
    case InstructionId::KoyoRt:
    case InstructionId::KoyoEnd: return m_ir.control(IrOp::Return);
    case InstructionId::KoyoFor: return openLoop(statement);
    case InstructionId::KoyoNext: return closeLoop();
    default: return; // SBR, NOP
    }
}

/// The count lies in memory, because a register is written once.
void RoutineLowering::openLoop(const CheckedStatement& statement)
{
    KoyoAccumulator accumulator(m_ir);
    Loop loop;
    loop.counter = {koyo::Accumulator, IrAddress::WholeByte, koyo::LoopsByte + 4 * m_context.elements.loop()};
    const IrRegister skips = m_ir.compute(IrOp::Not, DataType::Bool, flow());
    m_ir.store(DataType::Udint, loop.counter, accumulator.fromBcd(koyoOperand(statement)));
    const std::size_t run = m_ir.jumpIf(false, skips);
    m_ir.store(DataType::Udint, loop.counter, accumulator.constant(0));
    m_ir.land(run);
    loop.begin = static_cast<std::uint32_t>(m_ir.here());
    const IrRegister isOver = accumulator.isZero(m_ir.load(DataType::Udint, loop.counter));
    loop.exit = m_ir.jumpIf(true, isOver);
    m_loops.push_back(loop);
}

void RoutineLowering::closeLoop()
{
    if (m_loops.empty())
        return;
    const Loop loop = m_loops.back();
    m_loops.pop_back();
    KoyoAccumulator accumulator(m_ir);
    const IrRegister left = accumulator.computeWith(IrOp::Sub, m_ir.load(DataType::Udint, loop.counter), 1);
    m_ir.store(DataType::Udint, loop.counter, left);
    m_ir.control(IrOp::Jump, loop.begin);
    m_ir.land(loop.exit);
    m_flow = NoRegister;
}

} // namespace camwright
