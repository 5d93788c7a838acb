#include "editors/words/words.h"

#include <QtTest>

using namespace camwright;

class WordsTest : public QObject {
    Q_OBJECT

private slots:
    void sentenceFillsTheArguments()
    {
        const Diagnostic value = diagnostic(Code::NotAValue, {"12x", "INT", "42"});
        QCOMPARE(words::sentence(value), QString("\"12x\" is not a value of type INT. Write it like 42."));
    }

    void argumentWithPercentIsNotFilledAgain()
    {
        QVERIFY(words::sentence(diagnostic(Code::NotAValue, {"%2", "INT", "42"})).startsWith("\"%2\""));
    }

    void everyCodeHasASentenceAndAnId()
    {
        for (const CodeInfo& info : allCodes()) {
            QVERIFY(!words::sentence(diagnostic(info.code, {"a", "b", "c", "d", "e", "f", "g", "h", "i"})).contains(QRegularExpression("%[1-9]")));
            QVERIFY(words::codeId(info.code).startsWith("CW"));
        }
    }

    void placeNamesObjectAndLineOrField()
    {
        QCOMPARE(words::placeText({{ObjectKind::Program, "Main"}, "source", {4, 7, 4, 9}, {}}), QString("Main, line 4, column 7"));
        QCOMPARE(words::placeText({{ObjectKind::Axis, "Feed"}, "guard_time_ms", {}, {}}), QString("Feed, guard time"));
        QCOMPARE(words::placeText({{ObjectKind::Controller, ""}, "model", {}, {}}), QString("controller, model"));
    }

    void unknownLanguageKeepsTheCurrentOne()
    {
        QVERIFY(!words::setLanguage(*QCoreApplication::instance(), "zh", "/nowhere"));
        QCOMPARE(words::currentLanguage(), QString("en"));
    }

    void emptyTranslationFallsBackToEnglish()
    {
        QCOMPARE(words::pick("axis", "", ""), QString("axis"));
    }
};

QTEST_GUILESS_MAIN(WordsTest)
#include "tst_words.moc"
