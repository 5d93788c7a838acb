#include "core/language/check/checksources.h"
#include "core/language/lowering/lowerprograms.h"
#include "core/language/lowering/memorylayout.h"
#include "core/runtime/native/nativeprogram.h"
#include "tests/bench/ilgenerator.h"
#include "tests/core/runtime/native/comparison.h"
#include "tests/core/runtime/native/irgenerator.h"

#include <gtest/gtest.h>

using namespace camwright;

namespace {

/// An image of one program in a family's own language.
std::shared_ptr<const ControllerImage> compiled(std::string_view familyName, std::string_view modelName, const std::string& text)
{
    LanguageContext context;
    context.family = findFamily(familyName);
    ControllerModel model = *context.family->findModel(modelName);
    model.programInstructionsMax = 0;
    context.model = &model;
    context.dialect = dialectOfFamily(familyName);
    context.programs.push_back({"Main", ProgramRole::Main});
    context.index();
    const ProgramSource source{{ObjectKind::Program, "Main"}, ProgramRole::Main, text};
    const CheckedSources checked = checkSources({&source, 1}, context);
    if (!checked.programs) {
        for (const Diagnostic& diagnostic : checked.diagnostics)
            ADD_FAILURE() << englishLine(diagnostic);
        return nullptr;
    }
    auto image = std::make_shared<ControllerImage>();
    image->target = {std::string(familyName), std::string(modelName), {}};
    image->layout = memoryLayout(*context.family, model, 0, 1);
    image->program = lowerPrograms(*context.family, model, *checked.programs, Job()).program;
    return image;
}

/// TS600 networks of contacts, timers, counters, words and their arithmetic.
std::string generateTs600(std::uint64_t seed, unsigned networks)
{
    test::IrRandom random{seed};
    const auto number = [&](std::uint32_t below) { return std::to_string(random.next(below)); };
    const auto contact = [&] { return (random.next(3) ? "M" : "X") + number(8); };
    std::string out;
    for (unsigned n = 0; n < networks; ++n) {
        static const char* const Begins[] = {"LD ", "LDI ", "LDP ", "LDF "};
        out += random.next(5) == 0 ? "LD>= D" + number(40) + " " + number(100) + "\n" : Begins[random.next(4)] + contact() + "\n";
        static const char* const Joins[] = {"AND ", "ANI ", "OR ", "ORI "};
        for (std::uint32_t k = 0, count = random.next(5); k < count; ++k)
            out += Joins[random.next(4)] + contact() + "\n";
        const std::string words = " D" + number(40) + " D" + number(40);
        switch (random.next(8)) {
        case 0: out += "TON T" + number(8) + " " + number(9) + "\n"; break;
        case 1: out += "ADD" + words + " D" + number(40) + "\n"; break;
        case 2: out += "DADD" + words + " D" + number(40) + "\n"; break;
        case 3: out += "RMUL" + words + " D" + number(40) + "\n"; break;
        case 4: out += "DIV" + words + " D" + number(40) + "\n"; break;
        case 5: out += "SET M" + number(8) + "\n"; break;
        case 6: out += "RST M" + number(8) + "\n"; break;
        default: out += (random.next(3) ? "OUT M" : "OUT Y") + number(8) + "\n"; break;
        }
    }
    return out;
}

void runsAlike(const std::shared_ptr<const ControllerImage>& image, std::uint64_t seed)
{
    ASSERT_TRUE(image);
    test::BothExecutors both(image);
    ASSERT_TRUE(both.isNative());
    for (unsigned scan = 0; scan < 12; ++scan) {
        both.change([&](Memory& memory) {
            test::IrRandom random{seed * 31 + scan};
            for (const ImageArea& area : image->layout.areas) {
                for (std::uint8_t& byte : memory.area(area.id))
                    byte = random.next(4) ? byte : static_cast<std::uint8_t>(random.next(256));
            }
        });
        ScanInput input;
        input.now = scan * 70ms;
        const auto different = both.scan(input);
        ASSERT_FALSE(different) << "seed " << seed << ", scan " << scan << ": " << *different;
    }
}

class NativeProgramsTest : public testing::Test {
protected:
    void SetUp() override
    {
        if (!hasNativeTranslation())
            GTEST_SKIP() << "no machine code for this processor";
    }
};

TEST_F(NativeProgramsTest, kincoNetworksRunAlikeInBothExecutors)
{
    for (const unsigned networks : {1u, 10u, 200u, 3000u})
        runsAlike(compiled("kinco", "KS101M-04DX", bench::generateIl(networks)), networks);
}

TEST_F(NativeProgramsTest, ts600NetworksRunAlikeInBothExecutors)
{
    for (std::uint64_t seed = 1; seed <= 20; ++seed)
        runsAlike(compiled("invt", findFamily("invt")->defaultModel().name, generateTs600(seed, 10 + 4 * static_cast<unsigned>(seed))), seed);
}

} // namespace
