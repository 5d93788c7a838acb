#include "editors/program/ilcodeview.h"

#include <QtTest>

using namespace camwright;

class IlCodeViewTest : public QObject {
    Q_OBJECT
private slots:
    void init()
    {
        m_view = std::make_unique<IlCodeView>(kincoIl());
        m_view->resize(600, 300);
        m_view->show();
    }
    void cleanup() { m_view.reset(); }

    void keepsTextByteForByte()
    {
        for (const QByteArray& text : {QByteArray(), QByteArray("LD %M0.0"), QByteArray("(* 电机 *)\r\nLD\t%M0.0\r\n\n"), QByteArray("\n")}) {
            m_view->setSource(text);
            QCOMPARE(m_view->source(), text);
        }
    }

    void settingTextAnnouncesNothing()
    {
        QSignalSpy edits(m_view.get(), &IlCodeView::edited);
        m_view->setSource("LD %M0.0\n");
        m_view->setSource("LD %M0.1\n");
        QCOMPARE(edits.size(), 0);
    }

    void typingAnnouncesWhatChanged()
    {
        m_view->setSource("LD %M0.0\n");
        QSignalSpy edits(m_view.get(), &IlCodeView::edited);
        m_view->setCursorPosition(0, 2);
        QTest::keyClicks(m_view.get(), "N");
        QCOMPARE(edits.size(), 1);
        QCOMPARE(edits[0][0].value<std::size_t>(), std::size_t(2));
        QCOMPARE(edits[0][1].value<std::size_t>(), std::size_t(0));
        QCOMPARE(edits[0][2].toByteArray(), QByteArray("N"));
        QTest::keyClick(m_view.get(), Qt::Key_Backspace);
        QCOMPARE(edits[1][1].value<std::size_t>(), std::size_t(1));
        QCOMPARE(m_view->source(), QByteArray("LD %M0.0\n"));
    }

    void aNewLineTakesTheIndentOfTheOneBefore()
    {
        m_view->setSource("    LD %M0.0");
        m_view->setCursorPosition(0, 12);
        QTest::keyClick(m_view.get(), Qt::Key_Return);
        QTest::keyClicks(m_view.get(), "X");
        QCOMPARE(m_view->source(), QByteArray("    LD %M0.0\n    X"));
    }

    void tabIndentsWithBlanks()
    {
        m_view->setSource("LD %M0.0\nST %M0.1\n");
        m_view->setSelection(0, 0, 2, 0);
        QTest::keyClick(m_view.get(), Qt::Key_Tab);
        QCOMPARE(m_view->source(), QByteArray("        LD %M0.0\n        ST %M0.1\n"));
        QTest::keyClick(m_view.get(), Qt::Key_Backtab, Qt::ShiftModifier);
        QCOMPARE(m_view->source(), QByteArray("LD %M0.0\nST %M0.1\n"));
    }

    void undoIsTheProjects()
    {
        m_view->setSource("LD %M0.0");
        QTest::keyClicks(m_view.get(), "x");
        QTest::keyClick(m_view.get(), Qt::Key_Z, Qt::ControlModifier);
        QCOMPARE(m_view->source(), QByteArray("xLD %M0.0"));
    }

    void theCursorStaysWhereTheRestChanges()
    {
        m_view->setSource("LD %M0.0\nST %M0.1\nLD %M0.2\n");
        m_view->setCursorPosition(2, 3);
        m_view->setSource("LD %M0.0\nST %M0.1\nLD %M0.2\nST %M0.3\n");
        int line = 0, column = 0;
        m_view->getCursorPosition(&line, &column);
        QCOMPARE(line, 2);
        QCOMPARE(column, 3);
    }

    void wordsAreThoseOfInstructionList()
    {
        m_view->setSource("MOVE %VW0, DI#12\n");
        QCOMPARE(m_view->wordAt(7), QByteArray("%VW0"));
        QCOMPARE(m_view->wordAt(9), QByteArray("%VW0"));
        QCOMPARE(m_view->wordAt(13), QByteArray("DI#12"));
        QCOMPARE(m_view->wordAt(-1), QByteArray());
        QCOMPARE(m_view->wordAt(99), QByteArray());
    }

    void placesCountBytesFromOne()
    {
        m_view->setSource("(* 电 *)\nLD %M0.0\n");
        QCOMPARE(m_view->positionOf(1, 7), 6);
        QCOMPARE(m_view->positionOf(2, 4), 13);
        QCOMPARE(m_view->positionOf(99, 1), int(m_view->source().size()));
        m_view->selectRange({2, 4, 2, 9});
        QCOMPARE(m_view->selectedRange(), (TextRange{2, 4, 2, 9}));
        QCOMPARE(m_view->selectedText(), QString("%M0.0"));
    }

    void diagnosticsAreFoundAtTheirPlaceWorstFirst()
    {
        m_view->setSource("LD %M0.0\nST %M0.1\n");
        const Place place{{ObjectKind::Program, "Main"}, "source", {2, 4, 2, 9}, {}};
        m_view->showDiagnostics({diagnostic(Code::OutputWrittenTwice, {"%M0.1"}, place), diagnostic(Code::UnknownName, {"x"}, place)});
        QVERIFY(m_view->diagnosticsAt(2).empty());
        const auto found = m_view->diagnosticsAt(13);
        QCOMPARE(found.size(), std::size_t(2));
        QCOMPARE(found[0]->code, Code::UnknownName);
    }

    void theLampStandsOnOneLine()
    {
        m_view->setSource("LD %M0.0\nST %M0.1\n");
        m_view->setFixLine(1);
        QCOMPARE(m_view->markerFindNext(0, 1 << 3), 1);
        m_view->setFixLine(0);
        QCOMPARE(m_view->markerFindNext(0, 1 << 3), 0);
        QCOMPARE(m_view->markerFindNext(1, 1 << 3), -1);
        m_view->setFixLine(-1);
        QCOMPARE(m_view->markerFindNext(0, 1 << 3), -1);
    }

    void clickOnTheLampAsksForFixes()
    {
        m_view->setSource("LD %M0.0\nST %M0.1\n");
        m_view->setFixLine(1);
        QSignalSpy asked(m_view.get(), &IlCodeView::fixesRequested);
        const int height = static_cast<int>(m_view->SendScintilla(QsciScintilla::SCI_TEXTHEIGHT, 0UL));
        const int x = m_view->marginWidth(0) + m_view->marginWidth(1) + m_view->marginWidth(2) / 2;
        QTest::mouseClick(m_view->viewport(), Qt::LeftButton, Qt::NoModifier, QPoint(x, height / 2));
        QCOMPARE(asked.size(), 0); // no lamp in that line
        QTest::mouseClick(m_view->viewport(), Qt::LeftButton, Qt::NoModifier, QPoint(x, height + height / 2));
        QCOMPARE(asked.size(), 1);
    }

private:
    std::unique_ptr<IlCodeView> m_view;
};

QTEST_MAIN(IlCodeViewTest)
#include "tst_ilcodeview.moc"
