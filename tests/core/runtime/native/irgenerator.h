#pragma once

#include "tests/core/runtime/executor/irbuilder.h"

#include <map>

namespace camwright::test {

struct IrRandom {
    std::uint64_t state;
    std::uint32_t next(std::uint32_t below)
    {
        state = state * 6364136223846793005u + 1442695040888963407u;
        return static_cast<std::uint32_t>((state >> 33) % below);
    }
    template <class T, std::size_t N>
    T pick(const T (&list)[N]) { return list[next(N)]; }
    template <class T>
    T pick(const std::vector<T>& list) { return list[next(static_cast<std::uint32_t>(list.size()))]; }
};

inline constexpr DataType AllTypes[] = {Bool, Byte, Word, Dword, Sint, Int, Dint, Usint, Uint, Udint, Real, Lreal, DataType::Time, Lint, Ulint, Lword};

/// Values that lie at the ends of types, between them, and where floating point is odd.
inline std::uint64_t awkwardBits(IrRandom& random, DataType type)
{
    constexpr std::uint64_t Integers[] = {0, 1, 2, 7, 0x7F, 0x80, 0xFF, 0x7FFF, 0x8000, 0xFFFF, 0x7FFFFFFF, 0x80000000, 0xFFFFFFFF,
                                          0x7FFFFFFFFFFFFFFF, 0x8000000000000000, 0xFFFFFFFFFFFFFFFF, 0x123456789ABCDEF0, 31, 32, 33, 63, 64};
    constexpr std::uint32_t Reals[] = {0, 0x80000000, 0x3F800000, 0xBF800000, 0x3F000000, 0x40200000, 0x7F800000, 0xFF800000, 0x7FC00000,
                                       0xFFC00000, 0x7F800001, 0xFFFFFFFF, 1, 0x80000001, 0x00800000, 0x7F7FFFFF, 0xFF7FFFFF, 0x4F000000,
                                       0xCF000000, 0x5F000000, 0xDF000000, 0x4F800000, 0x5F800000, 0x46FFFF00, 0x477FFFC0, 0x42FF0000};
    constexpr std::uint64_t Lreals[] = {0, 0x8000000000000000, 0x3FF0000000000000, 0xBFF0000000000000, 0x3FE0000000000000, 0x4004000000000000,
                                        0x7FF0000000000000, 0xFFF0000000000000, 0x7FF8000000000000, 0xFFF8000000000000, 0x7FF0000000000001,
                                        0xFFFFFFFFFFFFFFFF, 1, 0x8000000000000001, 0x7FEFFFFFFFFFFFFF, 0x41DFFFFFFFC00000, 0x41E0000000000000,
                                        0xC1E0000000000000, 0xC1E0000000200000, 0x43E0000000000000, 0xC3E0000000000000, 0x43F0000000000000,
                                        0x3810000000000000, 0x47EFFFFFE0000000, 0x47EFFFFFF0000000};
    if (type == Real)
        return random.pick(Reals);
    if (type == Lreal)
        return random.pick(Lreals);
    return random.pick(Integers) & (~std::uint64_t{0} >> (64 - bitWidth(type)));
}

/// Writes programs that the verifier takes, of every operation and type: a few bytes of memory, so that everything overlaps
/// and nothing is aligned; registers read many times and much later; jumps forward over any stretch and back, so that some
/// scans end by their budget; subroutines, timers, counters, edges, blocks, a fault flag in the midst of it all; function
/// blocks with instances that overlap, indices in and out of their bounds, pointers.
class IrGenerator {
public:
    explicit IrGenerator(std::uint64_t seed) : m_random{seed * 2 + 1} {}

    const IrBuilder& generate()
    {
        m_places = 4 + m_random.next(28);
        m_b.image().layout.areas.push_back({VariablesArea, "", VariableBytes, 0, 0});
        makeTables();
        const std::uint32_t subroutines = m_random.next(3) == 0 ? 1 + m_random.next(2) : 0;
        m_block = m_random.next(2) ? subroutines + 1 : 0;
        body(subroutines == 0 ? 0 : 1, subroutines);
        for (std::uint32_t r = 1; r <= subroutines; ++r) {
            m_b.routine("Sub" + std::to_string(r));
            m_known.clear();
            body(r + 1, subroutines);
        }
        if (m_block > 0)
            functionBlock();
        return m_b;
    }

private:
    void makeTables()
    {
        IrProgram& program = m_b.image().program;
        std::uint32_t state = 8; // edges
        for (std::uint8_t kind = 1; kind <= 7; ++kind) {
            const IrAddress value = place(Int);
            program.timers.push_back({static_cast<TimerKind>(kind), value, place(Bool), state, 1000000 + 777 * std::int64_t{kind}});
            state += TimerStateBytes;
        }
        for (std::uint8_t kind = 1; kind <= 5; ++kind) {
            const DataType type = m_random.next(2) ? Int : Dint;
            const IrAddress value = place(type);
            program.counters.push_back({static_cast<CounterKind>(kind), type, value, place(Bool), state});
            state += CounterStateBytes;
        }
        program.stateBytes = state;
        for (std::uint32_t b = 0; b < 2; ++b) {
            IrBlock block;
            block.instance = b;
            block.instruction = static_cast<std::uint16_t>(100 + b);
            for (const DataType type : {Bool, Int, Real})
                block.pins.push_back({IrPin::Kind::Memory, type, 0, place(type)});
            program.blocks.push_back(block);
        }
        if (m_random.next(2))
            m_b.image().layout.instructionErrorFlag = bitAddress(A, m_random.next(m_places), 5);
    }

    void functionBlock()
    {
        m_b.routine("Block");
        IrRoutine& routine = m_b.image().program.routines.back();
        routine.kind = RoutineKind::Block;
        routine.instanceBytes = InstanceBytes;
        m_known.clear();
        m_isInBlock = true;
        m_block = 0;
        body(0, 0);
    }

    void callBlock()
    {
        const std::uint32_t offset = m_random.next(VariableBytes - InstanceBytes);
        if (m_random.next(2)) {
            m_b.control(IrOp::CallOn, m_block);
            m_b.code().back().address = byteAt(offset, VariablesArea);
        } else {
            const IrRegister pointer = placed(offset, InstanceBytes);
            m_b.control(IrOp::CallAt, m_block, pointer);
        }
    }

    IrRegister placed(std::uint32_t offset, std::uint32_t bytes)
    {
        const bool isOfInstance = m_isInBlock && bytes <= 8 && m_random.next(2);
        const IrRegister out = m_b.op(IrOp::Place, Dword, 0);
        IrInstruction& i = m_b.code().back();
        i.a = NoRegister;
        i.address = isOfInstance ? byteAt(m_random.next(InstanceBytes - 8), InstanceArea) : byteAt(offset, VariablesArea);
        i.constant = bytes;
        return out;
    }

    /// Something that may fail, and what is done when it does not.
    void guarded()
    {
        const bool isBound = m_random.next(2);
        const DataType from = isBound ? Dint : Dword;
        const IrRegister any = value(from);
        const IrRegister mask = m_b.constant(from, isBound ? 7 : 127);
        const IrRegister small = m_random.next(6) == 0 ? any : m_b.op(IrOp::And, from, any, mask);
        const auto lower = static_cast<std::uint32_t>(m_random.next(3)) - 1;
        const IrRegister dest = m_b.op(isBound ? IrOp::Bound : IrOp::Reach, from, small);
        const std::size_t guard = m_b.code().size() - 1;
        m_b.code().back().constant = isBound ? irConstant(lower, 6) : 16;
        const auto known = m_known;
        for (std::uint32_t k = 0, n = 1 + m_random.next(4); k < n; ++k) {
            if (m_random.next(3) == 0)
                statement();
            else if (isBound)
                useIndex(dest);
            else
                usePointer(dest);
        }
        m_known = known;
        m_b.land(guard);
    }

    void useIndex(IrRegister index)
    {
        constexpr std::uint32_t Strides[] = {1, 2, 3, 4, 8, 12};
        const std::uint32_t stride = m_random.pick(Strides);
        const DataType type = m_random.pick(AllTypes);
        const bool isOfInstance = m_isInBlock && stride <= 2 && m_random.next(2);
        const IrAddress address = isOfInstance ? byteAt(m_random.next(InstanceBytes - 5 * stride - 8), InstanceArea) : byteAt(m_random.next(20), VariablesArea);
        const std::uint32_t kind = m_random.next(3);
        if (kind == 0) {
            const IrRegister pointer = placed(m_random.next(20), 5 * 12 + 16);
            const IrRegister element = m_b.op(IrOp::Element, Dword, pointer, index);
            m_b.code().back().constant = irConstant(m_random.pick(Strides), 16);
            const bool reaches = m_b.code()[m_b.code().size() - 2].address.area == VariablesArea;
            if (reaches)
                usePointer(element);
            return;
        }
        if (kind == 1)
            know(type, m_b.op(IrOp::LoadElement, type, NoRegister, index));
        else
            m_b.control(IrOp::StoreElement, 0, value(type), index);
        IrInstruction& i = m_b.code().back();
        i.type = type;
        i.address = address;
        i.constant = stride;
    }

    /// Sixteen bytes from the pointer.
    void usePointer(IrRegister pointer)
    {
        const DataType type = m_random.pick(AllTypes);
        const IrAddress address = byteAt(m_random.next(9), VariablesArea);
        switch (m_random.next(4)) {
        case 0: {
            const std::uint32_t bytes = m_random.next(17);
            const IrRegister other = placed(m_random.next(VariableBytes - 16), 16);
            const bool swaps = m_random.next(2);
            m_b.control(IrOp::Move, 0, swaps ? other : pointer, swaps ? pointer : other);
            m_b.code().back().type = Dword;
            m_b.code().back().constant = bytes;
            return;
        }
        case 1:
            know(type, m_b.op(IrOp::LoadAt, type, pointer));
            break;
        default:
            m_b.control(IrOp::StoreAt, 0, value(type), pointer);
            break;
        }
        m_b.code().back().type = type;
        m_b.code().back().address = address;
    }

    void selectSome()
    {
        const DataType type = m_random.pick(AllTypes);
        const IrRegister condition = value(Bool);
        const IrRegister first = value(type);
        const IrRegister second = value(type);
        know(type, m_b.indexed(IrOp::Select, type, second, condition, first));
    }

    void clock()
    {
        m_b.op(IrOp::Now, Lint, NoRegister);
        know(Lint, m_b.code().back().dest);
    }

    /// A routine that may call those from `firstCallee` on.
    void body(std::uint32_t firstCallee, std::uint32_t lastCallee)
    {
        const std::uint32_t statements = 4 + m_random.next(m_random.next(8) == 0 ? 400 : 60);
        for (std::uint32_t k = 0; k < statements; ++k) {
            const std::uint32_t kind = m_random.next(24);
            if (kind < 3)
                jumpOver();
            else if (kind == 3 && m_random.next(4) == 0)
                loop();
            else if (kind == 4 && firstCallee > 0 && firstCallee <= lastCallee)
                m_b.control(IrOp::Call, firstCallee + m_random.next(lastCallee - firstCallee + 1));
            else if (kind == 5 && m_random.next(20) == 0)
                leaveSometimes();
            else if (kind == 6 && m_block > 0)
                callBlock();
            else if (kind == 7 || kind == 8)
                guarded();
            else
                statement();
        }
    }

    void jumpOver()
    {
        const bool always = m_random.next(8) == 0;
        const IrOp op = always ? IrOp::Jump : m_random.next(2) ? IrOp::JumpIf : IrOp::JumpIfNot;
        const std::size_t skip = m_b.control(op, 0, always ? NoRegister : value(Bool));
        const auto known = m_known;
        for (std::uint32_t k = 0, n = m_random.next(7); k < n; ++k)
            m_random.next(5) == 0 ? jumpOver() : statement();
        m_known = known;
        m_b.land(skip);
    }

    /// Back to a place before, by a condition that may hold forever.
    void loop()
    {
        const auto head = static_cast<std::uint32_t>(m_b.code().size());
        for (std::uint32_t k = 0, n = 1 + m_random.next(6); k < n; ++k)
            statement();
        const bool always = m_random.next(20) == 0;
        const IrOp op = always ? IrOp::Jump : m_random.next(2) ? IrOp::JumpIf : IrOp::JumpIfNot;
        m_b.control(op, head, always ? NoRegister : value(Bool));
    }

    void leaveSometimes()
    {
        const std::size_t skip = m_b.control(IrOp::JumpIfNot, 0, value(Bool));
        m_b.control(IrOp::Return);
        m_b.land(skip);
    }

    void statement()
    {
        switch (m_random.next(18)) {
        case 0:
        case 1:
        case 2: return logic();
        case 3:
        case 4: return store(Bool);
        case 5:
        case 6: return store(m_random.pick(AllTypes));
        case 7:
        case 8:
        case 9: return compute(m_random.pick(AllTypes));
        case 10: return compareSome(m_random.pick(AllTypes));
        case 11: return convertSome();
        case 12: return chain();
        case 13: return m_random.next(3) == 0 ? element() : logic();
        case 14: return shiftSome();
        case 15: return selectSome();
        case 16: return m_random.next(4) == 0 ? clock() : selectSome();
        default: return edge();
        }
    }

    void edge()
    {
        const IrOp op = m_random.next(2) ? IrOp::RisingEdge : IrOp::FallingEdge;
        const std::uint32_t state = m_random.next(8);
        know(Bool, m_b.indexed(op, Bool, state, value(Bool)));
    }

    void logic()
    {
        constexpr IrOp Ops[] = {IrOp::And, IrOp::Or, IrOp::Xor, IrOp::Not, IrOp::Equal, IrOp::NotEqual};
        const IrOp op = m_random.pick(Ops);
        const IrRegister a = value(Bool);
        know(Bool, op == IrOp::Not ? m_b.op(op, Bool, a) : m_b.op(op, Bool, a, value(Bool)));
    }

    /// Contacts and a coil, as ladder is.
    void chain()
    {
        IrRegister flow = value(Bool);
        for (std::uint32_t k = 0, n = 1 + m_random.next(6); k < n; ++k) {
            IrRegister contact = m_b.bit(place(Bool));
            if (m_random.next(2))
                contact = m_b.op(IrOp::Not, Bool, contact);
            flow = m_b.op(m_random.next(2) != 0 ? IrOp::And : IrOp::Or, Bool, flow, contact);
        }
        if (m_random.next(4) == 0)
            flow = m_b.op(IrOp::Not, Bool, flow);
        m_b.store(Bool, place(Bool), flow);
    }

    void compute(DataType type)
    {
        constexpr IrOp Unary[] = {IrOp::Neg, IrOp::Abs, IrOp::Not, IrOp::Sqrt, IrOp::Sin, IrOp::Cos, IrOp::Tan, IrOp::Asin, IrOp::Acos,
            IrOp::Atan, IrOp::Exp, IrOp::Ln, IrOp::Log};
        constexpr IrOp Binary[] = {IrOp::Add, IrOp::Sub, IrOp::Mul, IrOp::Div, IrOp::Mod, IrOp::Min, IrOp::Max, IrOp::And, IrOp::Or, IrOp::Xor,
            IrOp::Atan2, IrOp::Power};
        const bool isUnary = m_random.next(4) == 0;
        const IrOp op = isUnary ? m_random.pick(Unary) : m_random.pick(Binary);
        if (!isAllowed(op, type, type))
            return;
        const IrRegister a = value(type);
        know(type, isUnary ? m_b.op(op, type, a) : m_b.op(op, type, a, value(type)));
        if (m_random.next(3) == 0)
            m_b.store(type, place(type), m_known[type].back());
    }

    void shiftSome()
    {
        constexpr IrOp Ops[] = {IrOp::ShiftLeft, IrOp::ShiftRight, IrOp::RotateLeft, IrOp::RotateRight};
        const DataType type = m_random.pick(AllTypes);
        const IrOp op = m_random.pick(Ops);
        if (!isAllowed(op, type, type))
            return;
        const IrRegister a = value(type);
        const IrRegister count = m_random.next(2) ? m_b.constant(Dword, m_random.next(70)) : value(Dword);
        know(type, m_b.op(op, type, a, count));
    }

    void compareSome(DataType type)
    {
        constexpr IrOp Ops[] = {IrOp::Equal, IrOp::NotEqual, IrOp::Greater, IrOp::GreaterEqual, IrOp::Less, IrOp::LessEqual};
        const IrOp op = m_random.pick(Ops);
        if (!isAllowed(op, type, type))
            return;
        const IrRegister a = value(type);
        const IrRegister result = m_b.op(op, type, a, value(type));
        if (m_random.next(3) == 0) { // used at once and never again
            const std::size_t skip = m_b.control(m_random.next(2) ? IrOp::JumpIf : IrOp::JumpIfNot, 0, result);
            const auto known = m_known;
            statement();
            m_known = known;
            m_b.land(skip);
        } else {
            know(Bool, result);
        }
    }

    void convertSome()
    {
        constexpr IrOp Ops[] = {IrOp::Convert, IrOp::Truncate, IrOp::Saturate};
        const IrOp op = m_random.pick(Ops);
        const DataType from = m_random.pick(AllTypes);
        const DataType type = m_random.pick(AllTypes);
        if (isAllowed(op, type, from))
            know(type, m_b.convert(op, from, type, value(from)));
    }

    void element()
    {
        const IrProgram& program = m_b.image().program;
        const std::uint32_t kind = m_random.next(6);
        const auto counter = m_random.next(static_cast<std::uint32_t>(program.counters.size()));
        const auto timer = m_random.next(static_cast<std::uint32_t>(program.timers.size()));
        const IrRegister a = value(Bool);
        switch (kind) {
        case 0: know(Bool, m_b.indexed(IrOp::Timer, Int, timer, a, value(Int))); return;
        case 1: m_b.control(IrOp::TimerReset, timer, a); return;
        case 2: {
            const DataType type = program.counters[counter].type;
            know(Bool, m_b.indexed(IrOp::Counter, type, counter, a, value(type)));
            return;
        }
        case 3: {
            const IrRegister b = value(Bool);
            m_b.control(IrOp::CounterArm, counter, a, b);
            return;
        }
        case 4: m_b.control(IrOp::CounterReset, counter, a); return;
        default: m_b.control(IrOp::Block, m_random.next(2), a); return;
        }
    }

    IrAddress place(DataType type)
    {
        constexpr AreaId Areas[] = {A, A, B, VariablesArea};
        if (m_isInBlock && m_random.next(2))
            return byteAt(m_random.next(InstanceBytes - 8), InstanceArea);
        const AreaId area = m_random.pick(Areas);
        const std::uint32_t byte = m_random.next(m_places);
        if (type == Bool && m_random.next(4) != 0)
            return bitAt(byte, static_cast<std::uint8_t>(m_random.next(8)), area);
        return byteAt(byte, area);
    }

    void store(DataType type)
    {
        const IrAddress address = place(type);
        m_b.store(type, address, value(type));
    }

    IrRegister value(DataType type)
    {
        const auto known = m_known.find(type);
        const std::uint32_t kind = m_random.next(8);
        if (known != m_known.end() && !known->second.empty() && kind < 4) {
            const auto size = static_cast<std::uint32_t>(known->second.size());
            const std::uint32_t recent = m_random.next(2) && size > 4 ? size - 4 : 0;
            return known->second[recent + m_random.next(size - recent)];
        }
        if (kind == 5)
            return know(type, m_b.constant(type, awkwardBits(m_random, type)));
        return know(type, m_b.load(type, place(type)));
    }

    IrRegister know(DataType type, IrRegister number)
    {
        m_known[type].push_back(number);
        return number;
    }

    static constexpr std::uint32_t VariableBytes = 128;
    static constexpr std::uint32_t InstanceBytes = 24;

    IrRandom m_random;
    IrBuilder m_b;
    std::uint32_t m_block = 0; ///< number of the routine of the function block, 0: none to call
    bool m_isInBlock = false;
    std::uint32_t m_places = 8;
    std::map<DataType, std::vector<IrRegister>> m_known;
};

} // namespace camwright::test
