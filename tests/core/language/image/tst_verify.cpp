#include "core/language/image/controllerimage.h"
#include "tests/core/language/image/sampleimage.h"

#include <gtest/gtest.h>

using namespace camwright;
using namespace camwright::test;

namespace {

bool isSafe(IrBuilder& builder) { return verify(builder.image()).ok(); }

TEST(VerifyTest, acceptsTheSample) { EXPECT_TRUE(verify(sampleImage()).ok()); }

TEST(VerifyTest, aRegisterIsReadOnlyAfterItWasWritten)
{
    IrBuilder b;
    b.store(Byte, byteAt(0), 0);
    b.constant(Byte, 1);
    EXPECT_FALSE(isSafe(b));
}

TEST(VerifyTest, aRegisterSkippedByAJumpIsNotReadBehindIt)
{
    IrBuilder b;
    const std::size_t skip = b.control(IrOp::JumpIf, 0, b.bit(bitAt(0, 0)));
    const IrRegister value = b.constant(Byte, 1);
    b.store(Byte, byteAt(1), value);
    b.land(skip);
    EXPECT_TRUE(isSafe(b));
    b.store(Byte, byteAt(2), value);
    EXPECT_FALSE(isSafe(b));
}

TEST(VerifyTest, aRegisterIsWrittenOnceAndOfOneType)
{
    IrBuilder b;
    const IrRegister value = b.constant(Byte, 1);
    b.store(Word, byteAt(1), value);
    EXPECT_FALSE(isSafe(b));
    IrBuilder twice;
    twice.constant(Byte, 1);
    twice.constant(Byte, 2);
    twice.code()[1].dest = 0;
    EXPECT_FALSE(isSafe(twice));
}

TEST(VerifyTest, addressesEndInsideTheirArea)
{
    for (const auto& [byte, safe] : {std::pair{1020u, true}, {1021u, false}, {0xFFFFFFFFu, false}}) {
        IrBuilder b;
        b.load(Dint, byteAt(byte));
        EXPECT_EQ(isSafe(b), safe) << byte;
    }
    IrBuilder noArea;
    noArea.load(Byte, byteAt(0, 77));
    EXPECT_FALSE(isSafe(noArea));
    IrBuilder bitOfWord;
    bitOfWord.load(Word, bitAt(0, 3));
    EXPECT_FALSE(isSafe(bitOfWord));
    IrBuilder ninthBit;
    ninthBit.load(Bool, bitAt(0, 8));
    EXPECT_FALSE(isSafe(ninthBit));
}

TEST(VerifyTest, callsFormNoCycleAndEnd)
{
    IrBuilder b;
    b.control(IrOp::Call, 1);
    b.routine("A");
    b.control(IrOp::Call, 2);
    b.routine("B");
    EXPECT_TRUE(isSafe(b));
    b.control(IrOp::Call, 1);
    EXPECT_FALSE(isSafe(b));
    IrBuilder deep;
    for (unsigned level = 1; level <= MaximumCallDepth + 1; ++level) {
        deep.control(IrOp::Call, level);
        deep.routine("R" + std::to_string(level));
    }
    EXPECT_FALSE(isSafe(deep));
}

TEST(VerifyTest, jumpsStayInTheRoutine)
{
    IrBuilder b;
    b.control(IrOp::Jump, 1);
    EXPECT_TRUE(isSafe(b));
    b.control(IrOp::Jump, 3);
    EXPECT_FALSE(isSafe(b));
}

TEST(VerifyTest, operationsExistForTheirTypes)
{
    const auto safe = [](IrOp op, DataType type) {
        IrBuilder b;
        const IrRegister a = b.load(type, byteAt(0));
        b.op(op, type, a, shapeOf(op).b ? b.load(secondOperandType(op, type), byteAt(8)) : NoRegister);
        return isSafe(b);
    };
    EXPECT_TRUE(safe(IrOp::Add, Real));
    EXPECT_FALSE(safe(IrOp::Add, Bool));
    EXPECT_FALSE(safe(IrOp::Mod, Real));
    EXPECT_FALSE(safe(IrOp::And, Lreal));
    EXPECT_TRUE(safe(IrOp::ShiftLeft, Byte));
    EXPECT_FALSE(safe(static_cast<IrOp>(200), Int));
}

TEST(VerifyTest, tablesPointInside)
{
    const auto broken = [](auto change) {
        ControllerImage image = sampleImage();
        change(image);
        return !verify(image).ok();
    };
    EXPECT_TRUE(broken([](auto& i) { i.program.timers[0].baseNs = 0; }));
    EXPECT_TRUE(broken([](auto& i) { i.program.timers[1].state = 41; }));
    EXPECT_TRUE(broken([](auto& i) { i.program.timers[0].kind = static_cast<TimerKind>(255); }));
    EXPECT_TRUE(broken([](auto& i) { i.program.counters[1].value.byte = 1021; }));
    EXPECT_TRUE(broken([](auto& i) { i.program.blocks[0].pins[0].address.byte = 5000; }));
    EXPECT_TRUE(broken([](auto& i) { i.program.blocks[0].pins[1].constant = 0x10000; }));
    EXPECT_TRUE(broken([](auto& i) { i.program.blocks[0].instance = 1; }));
    EXPECT_TRUE(broken([](auto& i) { i.layout.areas[1].id = A; }));
    EXPECT_TRUE(broken([](auto& i) { i.layout.areas[0].retainedTo = 1025; }));
    EXPECT_TRUE(broken([](auto& i) { i.layout.areas[0].bytes = 0xFFFFFFFF; }));
    EXPECT_TRUE(broken([](auto& i) { i.layout.initialValues[0].address.byte = 1022; }));
    EXPECT_TRUE(broken([](auto& i) { std::swap(i.symbols[0], i.symbols[1]); }));
    EXPECT_TRUE(broken([](auto& i) { i.configuration.axes[1].number = 1; }));
    EXPECT_TRUE(broken([](auto& i) { i.configuration.axes[1].name = "Feed"; }));
    EXPECT_TRUE(broken([](auto& i) { i.configuration.axes[0].mechanicalEquivalent = 0; }));
    EXPECT_TRUE(broken([](auto& i) { i.configuration.watchdog = camwright::Time(-1); }));
    EXPECT_TRUE(broken([](auto& i) { i.program.routines[1].kind = RoutineKind::Main; }));
    EXPECT_TRUE(broken([](auto& i) { i.program.routines[1].name = "Main"; }));
}

TEST(IrOpTest, everyOperationHasAShapeAndItsPermanentNumber)
{
    for (const auto& [op, number] : {std::pair{IrOp::Jump, 1}, {IrOp::Load, 9}, {IrOp::And, 17}, {IrOp::Div, 27}, {IrOp::Equal, 48},
                                     {IrOp::Convert, 64}, {IrOp::RisingEdge, 72}, {IrOp::Timer, 80}, {IrOp::Block, 90}}) {
        EXPECT_EQ(static_cast<int>(op), number) << name(op);
        EXPECT_TRUE(shapeOf(op).known);
    }
}

} // namespace
