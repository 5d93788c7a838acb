#include "core/family/family.h"
#include "editors/words/words.h"

#include <QtTest>

#include <set>

using namespace camwright;

namespace {

QCoreApplication& application()
{
    return *QCoreApplication::instance();
}

/// The place marks of a text: {"%1", "%2"}.
std::set<QString> marks(const QString& text)
{
    static const QRegularExpression mark("%[1-9]");
    std::set<QString> out;
    for (auto it = mark.globalMatch(text); it.hasNext();)
        out.insert(it.next().captured());
    return out;
}

bool hasLettersOf(const QString& language, const QString& text)
{
    static const QRegularExpression han("\\p{Han}"), cyrillic("\\p{Cyrillic}");
    return text.contains(language == "zh" ? han : cyrillic);
}

} // namespace

class WordsTest : public QObject {
    Q_OBJECT

private slots:
    void cleanup() { words::setLanguage(application(), "en"); }

    void everyDiagnosticIsTranslated_data() { translatedLanguages(); }
    void everyDiagnosticIsTranslated()
    {
        QFETCH(QString, language);
        QVERIFY(words::setLanguage(application(), language));
        for (const CodeInfo& info : allCodes()) {
            const QString english = QString::fromUtf8(info.text.data(), qsizetype(info.text.size()));
            const QString translated = QCoreApplication::translate("Diagnostics", english.toUtf8().constData());
            QVERIFY2(hasLettersOf(language, translated), info.id.data());
            QCOMPARE(marks(translated), marks(english));
        }
    }

    void helpOfEveryInstructionIsTranslated()
    {
        for (const Family* family : families()) {
            for (const Instruction& instruction : family->catalogue().instructions()) {
                QVERIFY2(hasLettersOf("zh", QString::fromStdString(instruction.help.zh)), instruction.mnemonic.c_str());
                QVERIFY2(hasLettersOf("ru", QString::fromStdString(instruction.help.ru)), instruction.mnemonic.c_str());
                for (const Pin& pin : instruction.pins)
                    QVERIFY2(pin.help.isComplete(), (instruction.mnemonic + " " + pin.name).c_str());
            }
        }
    }

    void sentencesComeInChineseAndRussian()
    {
        const Diagnostic value = diagnostic(Code::NotAValue, {"12x", "INT", "42"});
        QVERIFY(words::setLanguage(application(), "zh"));
        QCOMPARE(words::sentence(value), QString("“12x”不是 INT 类型的值。写法示例：42。"));
        QVERIFY(words::setLanguage(application(), "ru"));
        QCOMPARE(words::sentence(value), QString("«12x» не является значением типа INT. Пишите так: 42."));
        QCOMPARE(words::placeText({{ObjectKind::Program, "Main"}, "source", {4, 7, 4, 9}, {}}), QString("Main, строка 4, столбец 7"));
    }

    void phrasesAmongTheArgumentsAreTranslatedNamesAreNot()
    {
        QVERIFY(words::setLanguage(application(), "ru"));
        QVERIFY(words::sentence(diagnostic(Code::RetainedDropped, {"both stored sets are damaged"})).contains("оба сохранённых набора повреждены"));
        QVERIFY(words::sentence(diagnostic(Code::RetainedDropped, {"nothing came for 10 s"})).contains("ничего не приходило 10 с"));
        QVERIFY(words::sentence(diagnostic(Code::RetainedDropped, {"/home/anna/my data 7"})).contains("/home/anna/my data 7"));
    }

    void unitsAreWrittenAsTheLanguageDoes()
    {
        QVERIFY(words::setLanguage(application(), "ru"));
        QCOMPARE(words::unitWord("mm"), QString("мм"));
        QCOMPARE(words::unitWord("lamps"), QString("lamps"));
    }

    void plainNameHasNoAccessKeyAndNoDots()
    {
        QCOMPARE(words::plainName("&Download..."), QString("Download"));
        QCOMPARE(words::plainName("下载(&D)..."), QString("下载"));
        QCOMPARE(words::plainName("Ос&танов"), QString("Останов"));
    }

    void countsTakeTheFormsOfEachLanguage()
    {
        const auto ports = [](int count) { return QCoreApplication::translate("camwright::NewProjectDialog", "%n CAN ports", nullptr, count); };
        QVERIFY(words::setLanguage(application(), "en"));
        QCOMPARE(ports(1), QString("1 CAN port"));
        QCOMPARE(ports(2), QString("2 CAN ports"));
        QVERIFY(words::setLanguage(application(), "ru"));
        QCOMPARE(ports(1), QString("1 порт CAN"));
        QCOMPARE(ports(3), QString("3 порта CAN"));
        QCOMPARE(ports(11), QString("11 портов CAN"));
    }

    void englishComesBack()
    {
        QVERIFY(words::setLanguage(application(), "ru"));
        QVERIFY(words::setLanguage(application(), "en"));
        QCOMPARE(words::kindWord(ObjectKind::Axis), QString("axis"));
    }

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

private:
    static void translatedLanguages()
    {
        QTest::addColumn<QString>("language");
        QTest::newRow("Chinese") << "zh";
        QTest::newRow("Russian") << "ru";
    }
};

QTEST_GUILESS_MAIN(WordsTest)
#include "tst_words.moc"
