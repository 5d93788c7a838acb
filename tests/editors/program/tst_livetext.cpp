// The controller's values inside the text of a program, against a link that pushes what the test says.
#include "editors/document/editcommands.h"
#include "editors/shell/theme.h"
#include "livelink.h"
#include "programbench.h"

#include <QDir>

using namespace camwright;

namespace {

const char* const Source = "(* Network 0 *)\nLD Start\nANDN %I0.1\nST Run\n(* Network 1 *)\nLD Run\nMOVE 12.5, Speed\nMC_POWER %M1.0, 1, %M1.1, %M1.2, %MB4\n";

} // namespace

class LiveTextTest : public ProgramBench {
    Q_OBJECT
private slots:
    void init()
    {
        open(Source);
        m_link = std::make_unique<LiveLink>();
        m_link->values = {{"Start", Value::ofBool(true)}, {"Run", Value::ofBool(false)}, {"%I0.1", Value::ofBool(true)}, {"Speed", Value::ofReal(12.5F)},
            {"%M1.0", Value::ofBool(true)}, {"%M1.1", Value::ofBool(true)}, {"%M1.2", Value::ofBool(false)}, {"%MB4", Value::ofInteger(DataType::Byte, 0)}};
        m_context->setLink(m_link.get());
    }

    void cleanup()
    {
        m_context->setLink(nullptr);
        m_link.reset();
        close();
    }

    void asksForTheLinesInView()
    {
        m_context->setProgramMatches(true);
        QCOMPARE(m_link->asked(), std::string("%I0.1 %M1.0 %M1.1 %M1.2 %MB4 Run Speed Start"));
    }

    void asksNothingWhileTheProgramDiffers()
    {
        QCOMPARE(m_link->asked(), std::string());
        QVERIFY(m_view->lineValues().empty());
    }

    void valuesStandBehindTheirLines()
    {
        live();
        QCOMPARE(lineText(2), QString("TRUE*"));
        QCOMPARE(lineText(4), QString("FALSE"));
        QCOMPARE(lineText(7), QString("12.5"));
        QCOMPARE(lineText(8), QString("EXEC TRUE*, DONE TRUE*, ERR FALSE, ERRID 0"));
        QVERIFY(!m_view->lineValuesAreStale());
    }

    void newValuesReplaceOldOnes()
    {
        live();
        m_link->values["Run"] = Value::ofBool(true);
        m_link->pushValues();
        QCOMPARE(lineText(4), QString("TRUE*"));
    }

    void forcedValuesSaySo()
    {
        m_link->forcedNames = {"Run"};
        live();
        QVERIFY(m_view->lineValues().at(3).front().forced);
        QVERIFY(!m_view->lineValues().at(1).front().forced);
    }

    void valuesAreNoText()
    {
        live();
        QCOMPARE(m_view->source(), QByteArray(Source));
        QCOMPARE(text(), std::string(Source));
        QVERIFY(!m_document->isModified());
    }

    void scrollingAsksForWhatIsSeen()
    {
        std::string source;
        for (int i = 0; i < 300; ++i)
            source += "LD %V" + std::to_string(i) + ".0\n";
        editText(*m_document, MainProgram, 0, text().size(), source);
        m_context->setProgramMatches(true);
        QTRY_VERIFY(m_link->asked().find("%V0.0") != std::string::npos);
        QVERIFY(m_link->asked().find("%V200.0") == std::string::npos);
        m_view->SendScintilla(QsciScintilla::SCI_SETFIRSTVISIBLELINE, 195UL);
        QTRY_VERIFY(m_link->asked().find("%V200.0") != std::string::npos);
        QVERIFY(m_link->asked().find("%V0.0 ") == std::string::npos);
        QCOMPARE(m_link->subscriptions.size(), std::size_t(1));
    }

    void aProgramOutOfSightAsksNothing()
    {
        live();
        m_editor->hide();
        QCOMPARE(m_link->asked(), std::string());
        m_editor->show();
        QTRY_VERIFY(!m_link->asked().empty());
    }

    void anEditMakesTheValuesOld()
    {
        live();
        putCursor(2, 1);
        QTest::keyClicks(m_view, "(");
        m_context->setProgramMatches(false); // the window's, when the project is no longer what runs
        QVERIFY(m_view->lineValuesAreStale());
        QCOMPARE(m_link->asked(), std::string());
        QCOMPARE(lineText(4), QString("FALSE"));
        auto* notice = m_editor->findChild<QWidget*>("liveNotice");
        QVERIFY(notice->isVisible());
        m_context->setProgramMatches(true);
        QVERIFY(!notice->isVisible());
        QVERIFY(!m_view->lineValuesAreStale());
    }

    void aLostConnectionMakesThemOldAndItsReturnLive()
    {
        live();
        m_link->setState(LinkState::Lost);
        QVERIFY(m_view->lineValuesAreStale());
        QVERIFY(m_editor->findChild<QWidget*>("liveNotice")->isVisible());
        m_link->setState(LinkState::Online);
        QVERIFY(!m_view->lineValuesAreStale());
        QVERIFY(!m_link->asked().empty());
    }

    void goingOfflineTakesThemAway()
    {
        live();
        m_context->setLink(nullptr);
        QVERIFY(m_view->lineValues().empty());
        QVERIFY(m_link->subscriptions.empty());
        QVERIFY(!m_editor->findChild<QWidget*>("liveNotice")->isVisible());
    }

    void anUpdateOnItsWayIsDropped()
    {
        live();
        const auto late = m_link->subscriptions.begin()->second;
        m_context->setProgramMatches(false);
        MonitorUpdate update;
        update.values.push_back({"Run", Value::ofBool(true), false});
        late.update(update);
        QCOMPARE(lineText(4), QString("FALSE"));
    }

    void closingTheEditorEndsItsSubscription()
    {
        live();
        m_editor.reset();
        QVERIFY(m_link->subscriptions.empty());
    }

    void looksTheSameInLightAndDark()
    {
        m_link->forcedNames = {"%M1.0"};
        live();
        for (const auto kind : {Theme::Kind::Light, Theme::Kind::Dark}) {
            theme().setKind(kind);
            theme().applyToApplication();
            const QString name = kind == Theme::Kind::Dark ? "dark" : "light";
            const QImage picture = grab("live-" + name);
            m_view->setLineValues({}, false);
            QVERIFY2(m_editor->grab().toImage() != picture, "nothing was painted");
            m_link->pushValues();
        }
        theme().setKind(Theme::Kind::Dark);
        m_link->setState(LinkState::Lost);
        grab("stale-dark");
        theme().setKind(Theme::Kind::Light);
        theme().applyToApplication();
        grab("stale-light");
    }

private:
    void live()
    {
        m_context->setProgramMatches(true);
        m_link->pushValues();
    }

    /// The values of a line (from 1) as text; a star stands for the colour of power.
    QString lineText(int line) const
    {
        QStringList out;
        const auto found = m_view->lineValues().find(line - 1);
        if (found == m_view->lineValues().end())
            return {};
        for (const LineValue& value : found->second)
            out << (value.label.isEmpty() ? QString() : value.label + ' ') + value.text + (value.energised ? "*" : "");
        return out.join(", ");
    }

    QImage grab(const QString& name)
    {
        QCoreApplication::processEvents();
        const QImage picture = m_editor->grab().toImage();
        const QDir folder(QStringLiteral(CAMWRIGHT_BIN_DIR "/../screenshots"));
        folder.mkpath(".");
        picture.save(folder.filePath("program-" + name + ".png"));
        return picture;
    }

    std::unique_ptr<LiveLink> m_link;
};

QTEST_MAIN(LiveTextTest)
#include "tst_livetext.moc"
