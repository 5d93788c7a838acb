#include "core/runtime/executor/executor.h"
#include "tests/core/runtime/executor/irbuilder.h"

#include <gtest/gtest.h>

using namespace camwright;
using namespace camwright::test;

namespace {

constexpr std::uint32_t VariableBytes = 64;

/// Main and a block of 16 bytes: INT at 0, eight bytes of INTs at 8.
class PlaceBench : public IrBuilder {
public:
    PlaceBench()
    {
        image().layout.areas.push_back({VariablesArea, "", VariableBytes, 0, 0});
    }

    void beginBlock()
    {
        routine("Block");
        image().program.routines[1].kind = RoutineKind::Block;
        image().program.routines[1].instanceBytes = 16;
    }

    IrInstruction& edit(std::size_t back = 1) { return code()[code().size() - back]; }

    /// Place, Reach, Bound, Element and the loads: what they have in common.
    IrRegister place(IrAddress address, std::uint32_t bytes)
    {
        const IrRegister out = op(IrOp::Place, Dword, 0);
        edit().a = NoRegister;
        edit().address = address;
        edit().constant = bytes;
        return out;
    }
    IrRegister guarded(IrOp guard, IrRegister a, std::uint64_t constant)
    {
        const IrRegister out = op(guard, guard == IrOp::Bound ? Dint : Dword, a);
        edit().constant = constant;
        return out;
    }
    IrRegister element(IrRegister pointer, IrRegister index, std::uint32_t stride, std::uint32_t bytes)
    {
        const IrRegister out = op(IrOp::Element, Dword, pointer, index);
        edit().constant = irConstant(stride, bytes);
        return out;
    }
    void storeElement(DataType type, IrAddress address, IrRegister value, IrRegister index, std::uint32_t stride)
    {
        control(IrOp::StoreElement, 0, value, index);
        edit().type = type;
        edit().address = address;
        edit().constant = stride;
    }
    void callOn(std::uint32_t routine, IrAddress address)
    {
        control(IrOp::CallOn, routine);
        edit().address = address;
    }

    bool isSafe() { return verify(image()).ok(); }
};

IrAddress variable(std::uint32_t byte) { return byteAt(byte, VariablesArea); }
IrAddress member(std::uint32_t byte) { return byteAt(byte, InstanceArea); }

Value valueAt(const ScanExecutor& executor, std::uint32_t byte, DataType type)
{
    return executor.memory().read(valueAddress(VariablesArea, byte, type));
}

/// counts[index] := 7, for an index that lies at VariablesArea 0; the array of five has its lower end at -2.
PlaceBench arrayBench()
{
    PlaceBench b;
    const IrRegister index = b.guarded(IrOp::Bound, b.load(Dint, variable(0)), irConstant(static_cast<std::uint32_t>(-2), 5));
    const std::size_t guard = b.code().size() - 1;
    const IrRegister value = b.constant(Int, 7);
    b.storeElement(Int, variable(8), value, index, 2);
    b.land(guard);
    return b;
}

TEST(ComputedPlacesTest, anIndexInsideItsBoundsReachesItsElement)
{
    for (std::int64_t index = -2; index <= 2; ++index) {
        PlaceBench b = arrayBench();
        auto executor = ScanExecutor::load(b.share());
        ASSERT_TRUE(executor.ok()) << englishText(executor.error());
        executor->memory().write(valueAddress(VariablesArea, 0, Dint), Value::ofInteger(Dint, index));
        EXPECT_EQ(executor->scan({}).faults, 0u);
        EXPECT_EQ(valueAt(*executor, static_cast<std::uint32_t>(8 + 2 * (index + 2)), Int).asInteger(), 7);
    }
}

TEST(ComputedPlacesTest, anIndexOutsideIsAFaultAndChangesNothing)
{
    for (const std::int64_t index : {std::int64_t{-3}, std::int64_t{3}, std::int64_t{INT32_MAX}, std::int64_t{INT32_MIN}}) {
        PlaceBench b = arrayBench();
        auto executor = ScanExecutor::load(b.share());
        ASSERT_TRUE(executor.ok());
        executor->memory().write(valueAddress(VariablesArea, 0, Dint), Value::ofInteger(Dint, index));
        const ScanReport report = executor->scan({});
        EXPECT_EQ(report.faults, 1u);
        EXPECT_EQ(report.instruction, 1u);
        for (std::uint32_t byte = 4; byte < VariableBytes; byte += 4)
            EXPECT_EQ(valueAt(*executor, byte, Dint).asInteger(), 0) << byte;
    }
}

/// A block that counts up its INT and copies it into its array; Main calls it with two instances.
PlaceBench instanceBench()
{
    PlaceBench b;
    b.callOn(1, variable(16));
    b.callOn(1, variable(32));
    b.callOn(1, variable(32));
    b.beginBlock();
    const IrRegister old = b.load(Int, member(0));
    const IrRegister now = b.op(IrOp::Add, Int, old, b.constant(Int, 1));
    b.store(Int, member(0), now);
    const IrRegister index = b.guarded(IrOp::Bound, b.constant(Dint, 3), irConstant(0, 4));
    const std::size_t guard = b.code().size() - 1;
    b.storeElement(Int, member(8), now, index, 2);
    b.land(guard);
    return b;
}

TEST(ComputedPlacesTest, aBlockWorksOnTheInstanceItIsCalledWith)
{
    auto executor = ScanExecutor::load(instanceBench().share());
    ASSERT_TRUE(executor.ok()) << englishText(executor.error());
    EXPECT_EQ(executor->scan({}).faults, 0u);
    EXPECT_EQ(valueAt(*executor, 16, Int).asInteger(), 1);
    EXPECT_EQ(valueAt(*executor, 16 + 14, Int).asInteger(), 1);
    EXPECT_EQ(valueAt(*executor, 32, Int).asInteger(), 2);
    EXPECT_EQ(valueAt(*executor, 32 + 14, Int).asInteger(), 2);
}

/// Main stores a pointer, reads it back, and works through it: REAL at pointer + 4, a move, a call.
PlaceBench pointerBench(std::uint64_t storedPointer)
{
    PlaceBench b;
    b.store(Dword, variable(0), b.constant(Dword, storedPointer));
    const IrRegister pointer = b.guarded(IrOp::Reach, b.load(Dword, variable(0)), 16);
    const std::size_t guard = b.code().size() - 1;
    b.control(IrOp::StoreAt, 0, b.constant(Real, 0x3FC00000), pointer);
    b.edit(1).type = Real;
    b.edit(1).address = variable(4);
    const IrRegister loaded = b.op(IrOp::LoadAt, Real, pointer);
    b.edit().address = variable(4);
    b.store(Real, variable(8), loaded);
    const IrRegister from = b.place(variable(8), 4);
    b.control(IrOp::Move, 0, pointer, from);
    b.edit().type = Dword;
    b.edit().constant = 4;
    b.control(IrOp::CallAt, 1, pointer);
    b.land(guard);
    b.beginBlock();
    const IrRegister inside = b.place(member(0), 16);
    b.store(Dword, member(12), inside);
    return b;
}

TEST(ComputedPlacesTest, aPointerFromMemoryWorksAfterReach)
{
    auto executor = ScanExecutor::load(pointerBench(40).share());
    ASSERT_TRUE(executor.ok()) << englishText(executor.error());
    EXPECT_EQ(executor->scan({}).faults, 0u);
    EXPECT_EQ(valueAt(*executor, 44, Real).asDouble(), 1.5);
    EXPECT_EQ(valueAt(*executor, 40, Real).asDouble(), 1.5);
    EXPECT_EQ(valueAt(*executor, 52, Dword).bits, 40u);
}

TEST(ComputedPlacesTest, aPointerOutOfTheAreaIsAFaultAndSkips)
{
    for (const std::uint64_t bad : {std::uint64_t{49}, std::uint64_t{0xFFFFFFFF}, std::uint64_t{0xFFFFFFF0}}) {
        auto executor = ScanExecutor::load(pointerBench(bad).share());
        ASSERT_TRUE(executor.ok());
        EXPECT_EQ(executor->scan({}).faults, 1u);
        EXPECT_EQ(valueAt(*executor, 8, Real).asDouble(), 0.0);
    }
}

TEST(ComputedPlacesTest, elementsOfArraysOfArraysAreFoundByTwoIndices)
{
    PlaceBench b;
    const IrRegister whole = b.place(variable(16), 24);
    const IrRegister row = b.guarded(IrOp::Bound, b.constant(Dint, 2), irConstant(0, 3));
    const std::size_t first = b.code().size() - 1;
    const IrRegister column = b.guarded(IrOp::Bound, b.constant(Dint, 1), irConstant(0, 2));
    const std::size_t second = b.code().size() - 1;
    const IrRegister line = b.element(whole, row, 8, 8);
    const IrRegister cell = b.element(line, column, 4, 4);
    b.control(IrOp::StoreAt, 0, b.constant(Dint, 99), cell);
    b.edit().type = Dint;
    b.edit().address = variable(0);
    b.land(first);
    b.land(second);
    auto executor = ScanExecutor::load(b.share());
    ASSERT_TRUE(executor.ok()) << englishText(executor.error());
    EXPECT_EQ(executor->scan({}).faults, 0u);
    EXPECT_EQ(valueAt(*executor, 16 + 2 * 8 + 4, Dint).asInteger(), 99);
}

TEST(ComputedPlacesTest, selectTakesOneOfTwoAndNowIsTheTimeOfTheScan)
{
    PlaceBench b;
    const IrRegister condition = b.load(Bool, variable(0));
    const IrRegister yes = b.constant(Int, 5);
    b.store(Int, variable(2), b.indexed(IrOp::Select, Int, b.constant(Int, 6), condition, yes));
    b.op(IrOp::Now, Lint, 0);
    b.edit().a = NoRegister;
    b.store(Lint, variable(8), b.edit().dest);
    auto executor = ScanExecutor::load(b.share());
    ASSERT_TRUE(executor.ok()) << englishText(executor.error());
    ScanInput input;
    input.now = 7ms;
    executor->scan(input);
    EXPECT_EQ(valueAt(*executor, 2, Int).asInteger(), 6);
    EXPECT_EQ(valueAt(*executor, 8, Lint).asInteger(), 7'000'000);
    executor->memory().write(valueAddress(VariablesArea, 0, Byte), {Byte, 128});
    executor->scan({});
    EXPECT_EQ(valueAt(*executor, 2, Int).asInteger(), 5) << "every byte but 0 is TRUE";
}

TEST(ComputedPlacesTest, anImageCarriesThemUnchanged)
{
    for (PlaceBench b : {arrayBench(), instanceBench(), pointerBench(40)}) {
        const auto read = readImage(write(b.image()));
        ASSERT_TRUE(read.ok()) << englishText(read.error());
        EXPECT_EQ(*read, b.image());
    }
}

TEST(ComputedPlacesTest, theVerifierRefusesWhatCouldLeaveItsPlace)
{
    PlaceBench wideArray = arrayBench();
    wideArray.code()[1].constant = irConstant(0, 29);
    EXPECT_FALSE(wideArray.isSafe()) << "element 28 of INTs at 8 ends at 66";
    wideArray.code()[1].constant = irConstant(0, 28);
    EXPECT_TRUE(wideArray.isSafe());
    wideArray.code()[1].index = 0;
    EXPECT_FALSE(wideArray.isSafe()) << "a guard jumps back";

    PlaceBench noIndex;
    const IrRegister plain = noIndex.constant(Dword, 0);
    noIndex.storeElement(Int, variable(8), noIndex.constant(Int, 1), plain, 2);
    EXPECT_FALSE(noIndex.isSafe()) << "a number that nothing has bounded";

    PlaceBench instance = instanceBench();
    instance.image().program.routines[1].instanceBytes = 15;
    EXPECT_FALSE(instance.isSafe()) << "the array ends at 16";
    instance.image().program.routines[1].instanceBytes = 33;
    EXPECT_FALSE(instance.isSafe()) << "the second instance would end at 65";
    instance.image().program.routines[1].kind = RoutineKind::Subroutine;
    EXPECT_FALSE(instance.isSafe()) << "a subroutine has no instance";

    PlaceBench pointer = pointerBench(0);
    pointer.image().program.routines[0].code[3].constant = 7;
    EXPECT_FALSE(pointer.isSafe()) << "a REAL at pointer + 4 needs 8 bytes";
    PlaceBench raw;
    raw.op(IrOp::LoadAt, Int, raw.constant(Dword, 4));
    raw.edit().address = variable(0);
    EXPECT_FALSE(raw.isSafe()) << "a pointer that nothing has made";
    PlaceBench otherArea;
    otherArea.place(byteAt(0, A), 4);
    EXPECT_FALSE(otherArea.isSafe()) << "pointers lead into VariablesArea only";
}

TEST(ComputedPlacesTest, noAreaHasTheNumberOfTheInstances)
{
    PlaceBench b;
    b.image().layout.areas.insert(b.image().layout.areas.end() - 1, {InstanceArea, "", 16, 0, 0});
    EXPECT_FALSE(b.isSafe());
}

} // namespace
