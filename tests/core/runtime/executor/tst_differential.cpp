#include "core/runtime/executor/executor.h"
#include "tests/core/runtime/executor/irbuilder.h"
#include "tests/core/runtime/executor/naiveevaluator.h"

#include <gtest/gtest.h>

using namespace camwright;
using namespace camwright::test;

namespace {

struct Random {
    std::uint64_t state;
    std::uint32_t next(std::uint32_t below)
    {
        state = state * 6364136223846793005u + 1442695040888963407u;
        return static_cast<std::uint32_t>((state >> 33) % below);
    }
    template <class T, std::size_t N>
    T pick(const T (&list)[N]) { return list[next(N)]; }
};

constexpr DataType Numbers[] = {Byte, Word, Int, Dint, Dword, Real};
constexpr IrOp Arithmetic[] = {IrOp::Add, IrOp::Sub, IrOp::Mul, IrOp::Div};
constexpr IrOp Bitwise[] = {IrOp::And, IrOp::Or, IrOp::Xor};
constexpr IrOp Comparing[] = {IrOp::Equal, IrOp::NotEqual, IrOp::Greater, IrOp::GreaterEqual, IrOp::Less, IrOp::LessEqual};

/// Writes random programs that the verifier takes: few bytes of memory, so that everything overlaps, registers used many
/// times and across other stores, jumps over any stretch, a subroutine.
class ProgramGenerator {
public:
    explicit ProgramGenerator(std::uint64_t seed) : m_random{seed} { m_b.image().program.stateBytes = 8; }

    const IrBuilder& generate()
    {
        const bool hasSubroutine = m_random.next(3) == 0;
        body(hasSubroutine);
        if (hasSubroutine) {
            m_b.routine("Sub");
            m_known.clear();
            body(false);
        }
        return m_b;
    }

private:
    void body(bool mayCall)
    {
        for (std::uint32_t i = 0, n = 5 + m_random.next(60); i < n; ++i) {
            if (m_random.next(8) == 0)
                jump();
            else if (mayCall && m_random.next(12) == 0)
                m_b.control(IrOp::Call, 1);
            else
                statement();
        }
    }

    void jump()
    {
        const std::size_t skip = m_b.control(m_random.next(2) ? IrOp::JumpIf : IrOp::JumpIfNot, 0, value(Bool));
        const auto known = m_known;
        for (std::uint32_t i = 0, n = m_random.next(6); i < n; ++i)
            statement();
        m_known = known;
        m_b.land(skip);
    }

    void statement()
    {
        switch (m_random.next(9)) {
        case 0: know(Bool, m_b.op(IrOp::Not, Bool, value(Bool))); return;
        case 1:
        case 2: know(Bool, m_b.op(m_random.pick(Bitwise), Bool, value(Bool), value(Bool))); return;
        case 3: know(Bool, m_b.indexed(m_random.next(2) ? IrOp::RisingEdge : IrOp::FallingEdge, Bool, m_random.next(8), value(Bool))); return;
        case 4:
        case 5: return store(Bool);
        case 6: return compute();
        case 7: return store(m_random.pick(Numbers));
        default: {
            const DataType type = m_random.pick(Numbers);
            know(Bool, m_b.op(m_random.pick(Comparing), type, value(type), value(type)));
        }
        }
    }

    void compute()
    {
        const DataType type = m_random.pick(Numbers);
        const std::uint32_t kind = m_random.next(4);
        if (kind == 0) {
            const DataType from = m_random.pick(Numbers);
            know(type, m_b.convert(IrOp::Convert, from, type, value(from)));
        } else if (kind == 1 && type != Real) {
            know(type, m_b.op(m_random.pick(Bitwise), type, value(type), value(type)));
        } else {
            know(type, m_b.op(m_random.pick(Arithmetic), type, value(type), value(type)));
        }
    }

    IrAddress place(DataType type)
    {
        const AreaId area = m_random.next(2) ? A : B;
        if (type == Bool && m_random.next(4) != 0)
            return bitAt(m_random.next(4), static_cast<std::uint8_t>(m_random.next(8)), area);
        return byteAt(m_random.next(8), area);
    }

    void store(DataType type) { m_b.store(type, place(type), value(type)); }

    IrRegister value(DataType type)
    {
        const auto known = m_known.find(type);
        const bool hasKnown = known != m_known.end() && !known->second.empty();
        const std::uint32_t kind = m_random.next(8);
        if (hasKnown && kind < 5)
            return known->second[m_random.next(static_cast<std::uint32_t>(known->second.size()))];
        if (kind == 5)
            return know(type, m_b.constant(type, bits(type)));
        return know(type, m_b.load(type, place(type)));
    }

    std::uint64_t bits(DataType type)
    {
        constexpr std::uint64_t Special[] = {0, 1, 0x7F, 0x80, 0x7FFF, 0x8000, 0xFFFF, 0x7FFFFFFF, 0x80000000, 0x3FC00000, 0x7F800000};
        const unsigned width = bitWidth(type);
        return m_random.pick(Special) & ((std::uint64_t{1} << width) - 1);
    }

    IrRegister know(DataType type, IrRegister number)
    {
        m_known[type].push_back(number);
        return number;
    }

    Random m_random;
    IrBuilder m_b;
    std::map<DataType, std::vector<IrRegister>> m_known;
};

TEST(DifferentialTest, fusedProgramsDoWhatTheirInstructionsSay)
{
    for (std::uint64_t seed = 1; seed <= 4000; ++seed) {
        ProgramGenerator generator(seed);
        const IrBuilder& program = generator.generate();
        const auto image = program.share();
        Result<ScanExecutor> executor = ScanExecutor::load(image);
        ASSERT_TRUE(executor.ok()) << "seed " << seed << ": " << englishText(executor.error());
        NaiveEvaluator naive(*image);
        Random memory{seed * 77};
        for (int scan = 0; scan < 4; ++scan) {
            for (const AreaId id : {A, B}) {
                for (std::size_t k = 0; k < 16; ++k) {
                    const auto byte = static_cast<std::uint8_t>(memory.next(4) ? memory.next(256) : 0);
                    executor->memory().area(id)[k] = byte;
                    naive.area(id)[k] = byte;
                }
            }
            executor->scan({});
            naive.scan();
            for (const AreaId id : {A, B})
                ASSERT_TRUE(std::ranges::equal(executor->memory().area(id), naive.area(id))) << "seed " << seed << ", scan " << scan;
        }
    }
}

TEST(DifferentialTest, twoExecutorsGiveEqualBytes)
{
    for (std::uint64_t seed = 1; seed <= 200; ++seed) {
        ProgramGenerator generator(seed);
        const auto image = generator.generate().share();
        ScanExecutor one = ScanExecutor::load(image).value();
        ScanExecutor two = ScanExecutor::load(std::make_shared<const ControllerImage>(readImage(write(*image)).value())).value();
        ByteWriter first, second;
        EXPECT_EQ(one.scan({}).operations, two.scan({}).operations);
        one.save(first);
        two.save(second);
        ASSERT_EQ(first.bytes(), second.bytes()) << seed;
    }
}

} // namespace
