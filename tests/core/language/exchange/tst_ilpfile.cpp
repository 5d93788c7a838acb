#include "core/language/exchange/ilpfile.h"

#include <gtest/gtest.h>

using namespace camwright;

namespace {

const char* const Networks = "(* Network 0 *)\n(* first *)\nLD %M0.0\nST %M0.1\n(* Network 1 *)\nLD %M0.2\nST %M0.3\n";

std::string dos(std::string text)
{
    for (std::size_t at = 0; (at = text.find('\n', at)) != std::string::npos; at += 2)
        text.replace(at, 1, "\r\n");
    return text;
}

TEST(IlpFileTest, importsTheNetworks)
{
    const IlpImport imported = importIlp(dos("(*2*)\n" + std::string(Networks) + "END\n"));
    EXPECT_TRUE(imported.diagnostics.empty());
    EXPECT_EQ(imported.source, Networks);
}

TEST(IlpFileTest, exportsWhatItImports)
{
    const std::string file = dos("(*2*)\n" + std::string(Networks) + "END\n");
    EXPECT_EQ(exportIlp(Networks), file);
    EXPECT_EQ(exportIlp(importIlp(file).source), file);
    EXPECT_EQ(exportIlp(file), file);
}

TEST(IlpFileTest, takesEveryTextAndSaysWhatIsOdd)
{
    const IlpImport bare = importIlp(Networks, "a.ilp");
    EXPECT_EQ(bare.source, Networks);
    ASSERT_EQ(bare.diagnostics.size(), 2u);
    EXPECT_EQ(englishLine(bare.diagnostics[0]), "a.ilp:1:1: warning CW3601: The first line of the file is not the number of networks, like (*5*). The whole text was taken.");
    EXPECT_EQ(bare.diagnostics[1].code, Code::IlpWithoutEnd);
    const IlpImport cut = importIlp("(*5*)\n" + std::string(Networks) + "END\n");
    ASSERT_EQ(cut.diagnostics.size(), 1u);
    EXPECT_EQ(cut.diagnostics[0].arguments, (std::vector<std::string>{"5", "2"}));
    EXPECT_EQ(importIlp("").source, "");
    EXPECT_EQ(importIlp("(*0*)").source, "");
    EXPECT_EQ(importIlp("END\nmore").source, "more");
}

} // namespace
