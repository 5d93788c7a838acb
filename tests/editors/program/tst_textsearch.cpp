#include "editors/program/textsearch.h"

#include <QtTest>

using namespace camwright;

class TextSearchTest : public QObject {
    Q_OBJECT
private slots:
    void findsInBytesOfUtf8()
    {
        const QByteArray text = "(* 电机 *)\nLD %M0.0\n";
        QCOMPARE(find({"ld", false, false, false}, text), (std::vector<SearchHit>{{13, 2}}));
        QCOMPARE(find({"电机", false, false, false}, text), (std::vector<SearchHit>{{3, 6}}));
        QCOMPARE(find({"电", false, false, false}, text), (std::vector<SearchHit>{{3, 3}}));
    }

    void matchesCaseWhenAsked()
    {
        QCOMPARE(find({"ld", true, false, false}, "LD ld Ld").size(), std::size_t(1));
        QCOMPARE(find({"ld", false, false, false}, "LD ld Ld").size(), std::size_t(3));
    }

    void aWordIsWhatInstructionListCallsOne()
    {
        QCOMPARE(find({"%M0.1", false, true, false}, "LD %M0.1\nST %M0.10\nST %M0.1\n"), (std::vector<SearchHit>{{3, 5}, {22, 5}}));
        QCOMPARE(find({"M0", false, true, false}, "LD %M0.1\n").size(), std::size_t(0));
        QCOMPARE(find({"Run", false, true, false}, "LD Run2\nLD Run\n_Run\n"), (std::vector<SearchHit>{{11, 3}}));
    }

    void specialCharactersAreTextUnlessAnExpressionIsAsked()
    {
        QCOMPARE(find({"M0.1", false, false, false}, "M0x1 M0.1"), (std::vector<SearchHit>{{5, 4}}));
        QCOMPARE(find({"M0.1", false, false, true}, "M0x1 M0.1").size(), std::size_t(2));
        QCOMPARE(find({"(*", false, false, false}, "(* a *)"), (std::vector<SearchHit>{{0, 2}}));
    }

    void linesBeginAndEndWhereTheyDo()
    {
        QCOMPARE(find({"^ST .*$", false, false, true}, "LD %M0.0\nST %M0.1\nST %M0.2"), (std::vector<SearchHit>{{9, 8}, {18, 8}}));
    }

    void aWrongExpressionSaysWhy()
    {
        const TextSearch search({"(", false, false, true});
        QVERIFY(!search.error().isEmpty());
        QVERIFY(search.findAll("((").empty());
        QVERIFY(TextSearch({"(", false, false, false}).error().isEmpty());
    }

    void nothingIsFoundByNothing()
    {
        QVERIFY(TextSearch({}).isEmpty());
        QVERIFY(find({"", false, false, false}, "LD %M0.0").empty());
        QVERIFY(find({"x*", false, false, true}, "LD").empty()); // hits without length would never end
    }

    void replacesEveryHit()
    {
        int count = 0;
        QCOMPARE(TextSearch({"%M0", false, false, false}).replaceAll("LD %M0.0\nST %M0.1\n", "%M9", count), QByteArray("LD %M9.0\nST %M9.1\n"));
        QCOMPARE(count, 2);
        QCOMPARE(TextSearch({"nowhere", false, false, false}).replaceAll("LD %M0.0\n", "x", count), QByteArray("LD %M0.0\n"));
        QCOMPARE(count, 0);
    }

    void aReplacementMayHoldWhatIsSought()
    {
        int count = 0;
        QCOMPARE(TextSearch({"M", true, false, false}).replaceAll("MM", "MM", count), QByteArray("MMMM"));
        QCOMPARE(count, 2);
    }

    void groupsComeBackInExpressionsOnly()
    {
        int count = 0;
        QCOMPARE(TextSearch({"%M(\\d+)\\.(\\d)", false, false, true}).replaceAll("LD %M3.5", "%V\\1.\\2", count), QByteArray("LD %V3.5"));
        QCOMPARE(TextSearch({"%M3.5", false, false, false}).replaceAll("LD %M3.5", "\\1", count), QByteArray("LD \\1"));
    }

private:
    static std::vector<SearchHit> find(const SearchQuery& query, const QByteArray& text) { return TextSearch(query).findAll(text); }
};

QTEST_GUILESS_MAIN(TextSearchTest)
#include "tst_textsearch.moc"
