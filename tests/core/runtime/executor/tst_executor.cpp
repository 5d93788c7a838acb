#include "core/runtime/executor/executor.h"
#include "tests/core/runtime/executor/irbuilder.h"

#include <gtest/gtest.h>

using namespace camwright;
using namespace camwright::test;


namespace {

Address at(std::uint32_t byte, DataType type, AreaId area = A) { return valueAddress(area, byte, type); }

ScanExecutor loaded(const IrBuilder& builder)
{
    Result<ScanExecutor> executor = ScanExecutor::load(builder.share());
    EXPECT_TRUE(executor.ok()) << (executor.ok() ? "" : englishText(executor.error()));
    return std::move(executor).value();
}

std::uint64_t resultOf(IrOp op, DataType type, std::uint64_t a, std::uint64_t b, ScanReport* report = nullptr)
{
    IrBuilder builder;
    const bool unary = !shapeOf(op).b;
    const IrRegister ra = builder.load(type, byteAt(0));
    const IrRegister rb = builder.load(secondOperandType(op, type), byteAt(8));
    const IrRegister rd = builder.op(op, type, ra, unary ? NoRegister : rb);
    builder.store(resultType(op, type), byteAt(16), rd);
    ScanExecutor executor = loaded(builder);
    executor.memory().write(at(0, Lword), {Lword, a});
    executor.memory().write(at(8, Lword), {Lword, b});
    const ScanReport done = executor.scan({});
    if (report)
        *report = done;
    return executor.memory().read(at(16, Lword)).bits;
}

struct Row {
    const char* what;
    IrOp op;
    DataType type;
    std::uint64_t a, b, expected;
};

std::uint64_t real(float value) { return Value::ofReal(value).bits; }

const Row Arithmetic[] = {
    {"INT wraps up", IrOp::Add, Int, 0x7FFF, 1, 0x8000},
    {"UINT wraps to zero", IrOp::Add, Uint, 0xFFFF, 1, 0},
    {"DINT wraps down", IrOp::Sub, Dint, 0x80000000, 1, 0x7FFFFFFF},
    {"WORD product wraps", IrOp::Mul, Word, 0xFFFF, 0xFFFF, 1},
    {"DINT product", IrOp::Mul, Dint, 0xFFFFFFFF, 7, 0xFFFFFFF9},
    {"INT division truncates", IrOp::Div, Int, 0xFFF9, 2, 0xFFFD},
    {"INT division by zero gives 0", IrOp::Div, Int, 5, 0, 0},
    {"smallest DINT by -1 wraps", IrOp::Div, Dint, 0x80000000, 0xFFFFFFFF, 0x80000000},
    {"INT remainder has the dividend's sign", IrOp::Mod, Int, 0xFFF9, 2, 0xFFFF},
    {"remainder by -1", IrOp::Mod, Dint, 0x80000000, 0xFFFFFFFF, 0},
    {"ABS of the smallest INT is itself", IrOp::Abs, Int, 0x8000, 0, 0x8000},
    {"NEG", IrOp::Neg, Dint, 5, 0, 0xFFFFFFFB},
    {"BYTE and", IrOp::And, Byte, 0xF0, 0x3C, 0x30},
    {"WORD xor", IrOp::Xor, Word, 0xFFFF, 0x0F0F, 0xF0F0},
    {"DWORD not", IrOp::Not, Dword, 0x0000FFFF, 0, 0xFFFF0000},
    {"shift by the width gives 0", IrOp::ShiftLeft, Word, 0xFFFF, 16, 0},
    {"shift right fills with 0", IrOp::ShiftRight, Int, 0x8000, 15, 1},
    {"rotate left", IrOp::RotateLeft, Byte, 0x81, 1, 0x03},
    {"rotate right by more than the width", IrOp::RotateRight, Word, 0x0001, 17, 0x8000},
    {"INT compares signed", IrOp::Less, Int, 0xFFFF, 0, 1},
    {"WORD compares unsigned", IrOp::Less, Word, 0xFFFF, 0, 0},
    {"REAL NaN equals nothing", IrOp::Equal, Real, 0x7FC00000, 0x7FC00000, 0},
    {"REAL NaN differs", IrOp::NotEqual, Real, 0x7FC00000, 0x7FC00000, 1},
    {"MIN", IrOp::Min, Int, 0xFFFE, 3, 0xFFFE},
    {"MAX", IrOp::Max, Int, 0xFFFE, 3, 3},
};

TEST(ExecutorTest, computesEachOperationAtItsEdges)
{
    for (const Row& row : Arithmetic)
        EXPECT_EQ(resultOf(row.op, row.type, row.a, row.b), row.expected) << row.what;
}

TEST(ExecutorTest, realsFollowIeeeWithOneNaN)
{
    EXPECT_EQ(resultOf(IrOp::Add, Real, real(1.5f), real(2.25f)), real(3.75f));
    EXPECT_EQ(resultOf(IrOp::Div, Real, real(1.0f), real(0.0f)), 0x7F800000u);
    EXPECT_EQ(resultOf(IrOp::Div, Real, real(0.0f), real(0.0f)), 0x7FC00000u);
    EXPECT_EQ(resultOf(IrOp::Sub, Real, 0x7F800000, 0x7F800000), 0x7FC00000u);
    EXPECT_EQ(resultOf(IrOp::Add, Real, 0xFFC12345, real(1.0f)), 0x7FC00000u) << "a foreign NaN does not get through";
    EXPECT_EQ(resultOf(IrOp::Sqrt, Real, real(2.25f), 0), real(1.5f));
}

TEST(ExecutorTest, divisionByZeroIsCountedWithItsPlace)
{
    ScanReport report;
    resultOf(IrOp::Div, Dint, 1, 0, &report);
    EXPECT_EQ(report.faults, 1u);
    EXPECT_EQ(report.instruction, 2u);
    EXPECT_EQ(report.end, ScanEnd::Completed);
    resultOf(IrOp::Div, Dint, 1, 1, &report);
    EXPECT_EQ(report.faults, 0u);
}

std::uint64_t converted(IrOp op, DataType from, DataType to, std::uint64_t bits)
{
    IrBuilder builder;
    builder.store(to, byteAt(16), builder.convert(op, from, to, builder.load(from, byteAt(0))));
    ScanExecutor executor = loaded(builder);
    executor.memory().write(at(0, Lword), {Lword, bits});
    executor.scan({});
    return executor.memory().read(at(16, Lword)).bits;
}

TEST(ExecutorTest, conversionsSaturateAndRoundToEven)
{
    EXPECT_EQ(converted(IrOp::Convert, Real, Dint, real(2.5f)), 2u);
    EXPECT_EQ(converted(IrOp::Convert, Real, Dint, real(3.5f)), 4u);
    EXPECT_EQ(converted(IrOp::Convert, Real, Dint, real(3e9f)), 0x7FFFFFFFu);
    EXPECT_EQ(converted(IrOp::Convert, Real, Dint, real(-3e9f)), 0x80000000u);
    EXPECT_EQ(converted(IrOp::Convert, Real, Uint, real(-1.0f)), 0u);
    EXPECT_EQ(converted(IrOp::Convert, Real, Int, 0x7FC00000), 0u);
    EXPECT_EQ(converted(IrOp::Truncate, Real, Dint, real(-2.9f)), 0xFFFFFFFEu);
    EXPECT_EQ(converted(IrOp::Convert, Dint, Int, 0x00018001), 0x8001u);
    EXPECT_EQ(converted(IrOp::Saturate, Dint, Int, 0x00018001), 0x7FFFu);
    EXPECT_EQ(converted(IrOp::Convert, Int, Dint, 0xFFFF), 0xFFFFFFFFu);
    EXPECT_EQ(converted(IrOp::Convert, Dint, Real, 0xFFFFFFFF), real(-1.0f));
    EXPECT_EQ(converted(IrOp::Convert, Lreal, Lint, Value::ofLreal(9.3e18).bits), 0x7FFFFFFFFFFFFFFFu);
}

TEST(ExecutorTest, aLoadKeepsItsValueWhenMemoryChangesBeforeItIsUsed)
{
    // V0 is read, V0.0 is written, and only then the value is used.
    IrBuilder builder;
    const IrRegister old = builder.load(Byte, byteAt(0));
    const IrRegister oldBit = builder.bit(bitAt(0, 1));
    builder.store(Byte, byteAt(0), builder.constant(Byte, 0));
    builder.store(Byte, byteAt(1), old);
    builder.store(Bool, bitAt(2, 7), oldBit);
    ScanExecutor executor = loaded(builder);
    executor.memory().write(at(0, Byte), {Byte, 0xAB});
    executor.scan({});
    EXPECT_EQ(executor.memory().read(at(0, Dword)).bits, 0x0080AB00u);
}

TEST(ExecutorTest, jumpsSkipAndLoopsEndWithTheBudget)
{
    IrBuilder builder;
    const std::size_t skip = builder.control(IrOp::JumpIfNot, 0, builder.bit(bitAt(0, 0)));
    builder.store(Byte, byteAt(1), builder.constant(Byte, 7));
    builder.land(skip);
    const std::uint32_t top = static_cast<std::uint32_t>(builder.code().size());
    const IrRegister counted = builder.op(IrOp::Add, Word, builder.load(Word, byteAt(2)), builder.constant(Word, 1));
    builder.store(Word, byteAt(2), counted);
    builder.control(IrOp::JumpIf, top, builder.bit(bitAt(0, 1)));
    ScanExecutor executor = loaded(builder);
    EXPECT_EQ(executor.scan({}).end, ScanEnd::Completed);
    EXPECT_EQ(executor.memory().read(at(1, Byte)).bits, 0u);
    EXPECT_EQ(executor.memory().read(at(2, Word)).bits, 1u);

    executor.memory().write(at(0, Byte), {Byte, 3});
    ScanInput input;
    input.operations = 600;
    const ScanReport report = executor.scan(input);
    EXPECT_EQ(report.end, ScanEnd::OutOfOperations);
    EXPECT_EQ(report.instruction, builder.code().size() - 1);
    EXPECT_EQ(executor.memory().read(at(1, Byte)).bits, 7u);
    EXPECT_EQ(executor.memory().read(at(2, Word)).bits, 101u);
}

TEST(ExecutorTest, callsRunTheRoutineAndReturnEndsIt)
{
    IrBuilder builder;
    builder.control(IrOp::Call, 1);
    const IrRegister kept = builder.op(IrOp::Add, Byte, builder.load(Byte, byteAt(0)), builder.constant(Byte, 1));
    builder.control(IrOp::Call, 1);
    builder.store(Byte, byteAt(4), kept);
    builder.routine("Sub");
    builder.store(Byte, byteAt(0), builder.op(IrOp::Add, Byte, builder.load(Byte, byteAt(0)), builder.constant(Byte, 5)));
    builder.control(IrOp::Return);
    builder.store(Byte, byteAt(0), builder.constant(Byte, 99));
    ScanExecutor executor = loaded(builder);
    const ScanReport report = executor.scan({});
    EXPECT_EQ(executor.memory().read(at(0, Byte)).bits, 10u);
    EXPECT_EQ(executor.memory().read(at(4, Byte)).bits, 6u);
    EXPECT_EQ(report.operations, 7u + 2 * 5u);
}

TEST(ExecutorTest, forcesHoldAtStartAndEndOfTheScan)
{
    IrBuilder builder;
    builder.store(Bool, bitAt(1, 0), builder.bit(bitAt(0, 0)));
    builder.store(Byte, byteAt(2), builder.constant(Byte, 1));
    ScanExecutor executor = loaded(builder);
    const Force forces[] = {{bitAddress(A, 0, 0), Value::ofBool(true)}, {at(2, Byte), {Byte, 9}}};
    ScanInput input;
    input.forces = forces;
    executor.scan(input);
    EXPECT_EQ(executor.memory().read(bitAddress(A, 1, 0)).bits, 1u);
    EXPECT_EQ(executor.memory().read(at(2, Byte)).bits, 9u);
}

TEST(ExecutorTest, aFailedInstructionSetsTheFamilysFlagUntilTheNextScan)
{
    IrBuilder builder;
    builder.image().layout.instructionErrorFlag = bitAddress(A, 100, 2);
    builder.store(Byte, byteAt(2), builder.op(IrOp::Div, Byte, builder.constant(Byte, 1), builder.load(Byte, byteAt(0))));
    ScanExecutor executor = loaded(builder);
    executor.scan({});
    EXPECT_TRUE(executor.memory().read(bitAddress(A, 100, 2)).asBool());
    executor.memory().write(at(0, Byte), {Byte, 1});
    executor.scan({});
    EXPECT_FALSE(executor.memory().read(bitAddress(A, 100, 2)).asBool());
}

struct RecordingHost : BlockHost {
    struct Call {
        InstructionId instruction;
        std::uint32_t instance;
        bool enabled;
        std::uint64_t first;
    };
    std::vector<Call> calls;

    void call(InstructionId instruction, const BlockInstance& instance, PinValues& pins) override
    {
        calls.push_back({instruction, instance.number, instance.enabled, pins.read(0).bits});
        pins.write(1, true);
        pins.write(0, {Int, 77}); // a constant: nothing happens
        EXPECT_TRUE(pins.isOpen(2));
        EXPECT_TRUE(pins.isOpen(9));
        EXPECT_FALSE(pins.element(3, 400).has_value());
        pins.write(3, {Dint, 0x01020304});
    }
};

TEST(ExecutorTest, blocksAreCalledOnEveryPassEnabledOrNot)
{
    IrBuilder builder;
    IrBlock block;
    block.instruction = 1203;
    block.pins = {{IrPin::Kind::Constant, Int, 5, {}}, {IrPin::Kind::Memory, Bool, 0, bitAt(7, 3)}, {},
                  {IrPin::Kind::Memory, Dint, 0, byteAt(21)}};
    builder.image().program.blocks.push_back(block);
    builder.control(IrOp::Block, 0, builder.bit(bitAt(0, 0)));
    ScanExecutor executor = loaded(builder);
    RecordingHost host;
    ScanInput input;
    input.host = &host;
    executor.scan(input);
    executor.memory().write(at(0, Byte), {Byte, 1});
    executor.scan(input);
    ASSERT_EQ(host.calls.size(), 2u);
    EXPECT_FALSE(host.calls[0].enabled);
    EXPECT_TRUE(host.calls[1].enabled);
    EXPECT_EQ(host.calls[1].instruction, InstructionId::KincoMcMabs);
    EXPECT_EQ(host.calls[1].first, 5u);
    EXPECT_EQ(executor.memory().read(at(7, Byte)).bits, 8u);
    EXPECT_EQ(executor.memory().read(at(21, Dint)).bits, 0x01020304u);
}

TEST(ExecutorTest, savedStateGoesOnByteForByte)
{
    IrBuilder builder;
    builder.image().program.stateBytes = 1;
    const IrRegister edge = builder.indexed(IrOp::RisingEdge, Bool, 0, builder.bit(bitAt(0, 0)));
    const IrRegister one = builder.convert(IrOp::Convert, Byte, Word, builder.constant(Byte, 1));
    const std::size_t skip = builder.control(IrOp::JumpIfNot, 0, edge);
    builder.store(Word, byteAt(2), builder.op(IrOp::Add, Word, builder.load(Word, byteAt(2)), one));
    builder.land(skip);
    ScanExecutor executor = loaded(builder);
    executor.memory().write(at(0, Byte), {Byte, 1});
    executor.scan({});
    EXPECT_EQ(executor.memory().read(at(2, Word)).bits, 1u);
    ByteWriter saved;
    executor.save(saved);

    ScanExecutor other = loaded(builder);
    ByteReader reader(saved.bytes());
    ASSERT_TRUE(other.restore(reader));
    other.scan({});
    EXPECT_EQ(other.memory().read(at(2, Word)).bits, 1u) << "the edge was seen before";
    ByteReader cut(ByteSpan(saved.bytes()).first(saved.bytes().size() - 1));
    EXPECT_FALSE(other.restore(cut));
}

} // namespace
