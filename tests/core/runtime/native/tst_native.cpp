#include "core/runtime/native/nativeprogram.h"
#include "tests/core/runtime/native/comparison.h"
#include "tests/core/runtime/native/irgenerator.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <set>

using namespace camwright;
using namespace camwright::test;

namespace {

/// More than the default for a long run: CAMWRIGHT_PROGRAMS=1000000 tst_native
std::uint64_t programs(std::uint64_t usual)
{
    const char* wanted = std::getenv("CAMWRIGHT_PROGRAMS");
    return wanted ? std::strtoull(wanted, nullptr, 10) : usual;
}

std::uint64_t firstSeed()
{
    const char* wanted = std::getenv("CAMWRIGHT_SEED");
    return wanted ? std::strtoull(wanted, nullptr, 10) : 1;
}

void scramble(Memory& memory, std::uint64_t seed)
{
    IrRandom random{seed};
    for (const AreaId id : {A, B, VariablesArea}) {
        for (std::size_t k = 0; k < 48;) {
            const DataType type = random.pick(AllTypes);
            const std::uint64_t bits = random.next(3) ? awkwardBits(random, type) : random.next(256);
            for (unsigned n = 0; n < byteWidth(type); ++n)
                memory.area(id)[k++] = static_cast<std::uint8_t>(bits >> (8 * n));
        }
    }
}

/// The first difference between the two in a few scans of one generated program.
std::optional<std::string> differenceOf(std::uint64_t seed, std::set<IrOp>& seen, unsigned& ended)
{
    IrGenerator generator(seed);
    const auto image = generator.generate().share();
    for (const IrRoutine& routine : image->program.routines) {
        for (const IrInstruction& i : routine.code)
            seen.insert(i.op);
    }
    BothExecutors both(image);
    if (!both.isNative())
        return "not translated";
    IrRandom random{seed + 99};
    for (unsigned scan = 0; scan < 5; ++scan) {
        if (scan != 3)
            both.change([&](Memory& memory) { scramble(memory, seed * 7 + scan); });
        ScanInput input;
        input.now = scan * 1700us;
        input.operations = scan == 2 ? random.next(300) : 3000;
        const Force force{bitAddress(A, 1, 3), Value::ofBool(scan % 2 == 0)};
        if (scan > 0)
            input.forces = {&force, 1};
        if (const auto different = both.scan(input))
            return "scan " + std::to_string(scan) + ": " + *different;
        ended += both.report().end == ScanEnd::OutOfOperations;
    }
    return std::nullopt;
}

class NativeTest : public testing::Test {
protected:
    void SetUp() override
    {
        if (!hasNativeTranslation())
            GTEST_SKIP() << "no machine code for this processor";
    }
};

TEST_F(NativeTest, generatedProgramsDoTheSameInBothExecutorsToTheLastByte)
{
    std::set<IrOp> seen;
    unsigned ended = 0;
    for (std::uint64_t seed = firstSeed(), end = seed + programs(3000); seed < end; ++seed) {
        const auto different = differenceOf(seed, seen, ended);
        ASSERT_FALSE(different) << "seed " << seed << ", " << *different;
    }
    if (programs(0) != 0)
        return;
    EXPECT_GT(ended, 50u) << "scans that their budget ended";
    for (unsigned op = 0; op < 256; ++op) {
        const auto operation = static_cast<IrOp>(op);
        EXPECT_TRUE(!shapeOf(operation).known || operation == IrOp::Nop || seen.contains(operation)) << name(operation) << " is never generated";
    }
}

} // namespace
