#include "editors/document/editcommands.h"
#include "programbench.h"

#include <QClipboard>
#include <QGuiApplication>
#include <QLabel>
#include <QLineEdit>
#include <QTableView>

using namespace camwright;

class ProgramEditorTest : public ProgramBench {
    Q_OBJECT
private slots:
    void cleanup()
    {
        m_panel.reset();
        close();
    }

    // Quick fixes

    void fixIsOneStepOfUndo()
    {
        const std::string before = "(* Network 0 *)\nLD Start\nMOEV %VW0, %VW2\n";
        open(before);
        putCursor(3, 2);
        choose(0);
        QCOMPARE(text(), std::string("(* Network 0 *)\nLD Start\nMOVE %VW0, %VW2\n"));
        QCOMPARE(m_view->source(), QByteArray::fromStdString(text()));
        QCOMPARE(m_document->undoStack().count(), 1);
        QCOMPARE(m_document->undoStack().undoText(), QString("Write MOVE in place of MOEV"));
        m_document->undo();
        QCOMPARE(text(), before);
    }

    void strictProjectRefusesGroupsInPlaceAndTheFixMendsIt() // C32
    {
        const std::string before = "(* Network 0 *)\nLD Start\nAND( %M1.0\nOR %M1.1\n)\nST Run\n(* Network 1 *)\nLD Run\nST %M1.2\n";
        open(before, true);
        QCOMPARE(m_document->errorCount(), 1);
        QCOMPARE(m_document->diagnostics().front().code, Code::GroupNotInFamily);
        putCursor(3, 1);
        choose(0);
        check();
        QCOMPARE(m_document->errorCount(), 0);
        QVERIFY(text().find("AND(") == std::string::npos);
        QVERIFY(text().find("(* Network 2 *)\nLD Run") != std::string::npos);
        m_document->undo();
        QCOMPARE(text(), before);
    }

    void declaringAVariableIsOneStepToo()
    {
        open("(* Network 0 *)\nLD Start\nST Ready\n");
        putCursor(3, 5);
        choose(0);
        const auto* table = m_document->content<VariableTable>({ObjectKind::VariableTable, "Globals"});
        QCOMPARE(table->rowCount(), std::size_t(4));
        QCOMPARE(table->row(3).name, std::string("Ready"));
        check();
        QCOMPARE(m_document->errorCount(), 0);
        m_document->undo();
        QCOMPARE(m_document->content<VariableTable>({ObjectKind::VariableTable, "Globals"})->rowCount(), std::size_t(3));
    }

    void fixIsOfferedOnlyWhereThereIsOne()
    {
        open("(* Network 0 *)\nLD Start\nMOEV %VW0, %VW2\n");
        putCursor(2, 2);
        QVERIFY(!m_editor->can("edit.quickFix"));
        QCOMPARE(m_view->fixLine(), -1);
        putCursor(3, 12); // the line of the problem is near enough
        QVERIFY(m_editor->can("edit.quickFix"));
        QTRY_COMPARE(m_view->fixLine(), 2); // the view tells of the cursor when it paints
    }

    void fixOfATextThatWentOnSaysSo()
    {
        open("(* Network 0 *)\nLD Start\nMOEV %VW0, %VW2\n");
        putCursor(3, 2);
        editText(*m_document, MainProgram, 25, 4, "SWAP"); // the check has not come yet
        QSignalSpy notices(m_context.get(), &Context::notified);
        m_editor->perform("edit.quickFix");
        QVERIFY(!menu());
        QCOMPARE(notices.size(), 1);
    }

    // References

    void referencesAreListedAndReached()
    {
        open("(* Network 0 *)\nLD Start\nMOVE %VD0, %VD8\n(* Network 1 *)\nLD %M0.0\nMOVE %VW2, %VW4\n");
        openPanel();
        putCursor(2, 5);
        m_editor->perform("go.references");
        QTRY_COMPARE(m_panel->model().rowCount(), 3);
        QCOMPARE(cells(0), QString("declares|Globals, row 1|Start"));
        QCOMPARE(cells(1), QString("reads|Main, network 0, line 2|LD Start"));
        QCOMPARE(cells(2), QString("reads|Main, network 1, line 5|LD %M0.0"));
        QSignalSpy revealed(m_context.get(), &Context::revealRequested);
        auto* table = m_panel->findChild<QTableView*>("referencesTable");
        table->selectRow(2);
        QTest::keyClick(table, Qt::Key_Return);
        QVERIFY(!revealed.isEmpty());
        QCOMPARE(revealed.last()[0].value<Place>().range, (TextRange{5, 4, 5, 9}));
        QTest::keyClick(table, Qt::Key_Escape);
        QCOMPARE(revealed.last()[0].value<Place>().range.line, 2u);
    }

    void overlapsSayWhatTheyAre()
    {
        open("(* Network 0 *)\nLD Start\nMOVE %VD0, %VD8\nMOVE %VW2, %VW4\n");
        openPanel();
        putCursor(4, 7);
        m_editor->perform("go.references");
        QTRY_COMPARE(m_panel->model().rowCount(), 2);
        QVERIFY(cells(0).startsWith("reads, overlaps as %VD0|"));
        QVERIFY(cells(1).startsWith("reads|"));
        QCOMPARE(m_panel->findChild<QLabel*>("referencesSummary")->text(), QString("%VW2: read 1, written 0, overlaps 1"));
    }

    void theListFollowsTheProject()
    {
        open("(* Network 0 *)\nLD Start\nST Run\n");
        openPanel();
        putCursor(3, 4);
        m_editor->perform("go.references");
        QTRY_COMPARE(m_panel->model().rowCount(), 2);
        editText(*m_document, MainProgram, text().size(), 0, "(* Network 1 *)\nLD Run\nST %M5.0\n");
        QTRY_COMPARE(m_panel->model().rowCount(), 3);
    }

    void whatIsNothingIsSaid()
    {
        open("(* Network 0 *)\nLD Start\n");
        openPanel();
        QSignalSpy listed(m_panel.get(), &ReferencesPanel::listed);
        m_context->findReferences({Place(), "nonsense"});
        QVERIFY(listed.wait());
        QCOMPARE(m_panel->model().rowCount(), 0);
        QVERIFY(m_panel->findChild<QTableView*>("referencesTable")->isHidden());
    }

    void namesAreFoundFromOutsidePrograms()
    {
        open("(* Network 0 *)\nLD Start\n");
        m_context->findReferences({Place(), "Start"}); // before the panel is there
        openPanel();
        QTRY_COMPARE(m_panel->model().rowCount(), 2);
    }

    // Text

    void commentKeyActsOnTheSelectedLines()
    {
        open("(* Network 0 *)\nLD Start\nST Run\n");
        m_view->setSelection(1, 0, 3, 0);
        m_editor->perform("edit.comment");
        QCOMPARE(text(), std::string("(* Network 0 *)\n(* LD Start *)\n(* ST Run *)\n"));
        QCOMPARE(m_document->undoStack().count(), 1);
    }

    void findGoesRoundAndReplaceIsOneStep()
    {
        open("LD %M0.0\nST %M0.1\nLD %M0.0\n");
        m_editor->perform("edit.find");
        auto* line = m_editor->findChild<QLineEdit*>("findText");
        QVERIFY(line);
        line->setText("%M0.0");
        m_editor->perform("edit.findNext");
        QCOMPARE(m_view->selectedRange().line, 1u);
        m_editor->perform("edit.findNext");
        QCOMPARE(m_view->selectedRange().line, 3u);
        m_editor->perform("edit.findNext");
        QCOMPARE(m_view->selectedRange().line, 1u);
        m_editor->perform("edit.findPrevious");
        QCOMPARE(m_view->selectedRange().line, 3u);
    }

    void typingGoesIntoTheProjectAndBack()
    {
        open("LD Start\n");
        putCursor(1, 3);
        QTest::keyClicks(m_view, "N");
        QCOMPARE(text(), std::string("LDN Start\n"));
        m_document->undo();
        QCOMPARE(text(), std::string("LD Start\n"));
        QCOMPARE(m_view->source(), QByteArray("LD Start\n"));
    }

    void definitionIsRevealed()
    {
        open("LD Start\n");
        QSignalSpy revealed(m_context.get(), &Context::revealRequested);
        putCursor(1, 5);
        m_editor->perform("go.definition");
        QCOMPARE(revealed.size(), 1);
        QCOMPARE(revealed[0][0].value<Place>().field, std::string("rows[0]"));
    }

    void pastedTextIsCleanedWhenAsked()
    {
        open("");
        QGuiApplication::clipboard()->setText("LD M0\\.0\n");
        m_editor->perform("edit.paste");
        QCOMPARE(text(), std::string("LD M0\\.0\n"));
    }

private:
    void openPanel()
    {
        m_panel = std::make_unique<ReferencesPanel>(*m_context);
        m_panel->resize(800, 200);
        m_panel->show();
    }

    QString cells(int row) const
    {
        QStringList out;
        for (int column = 0; column < ReferencesModel::ColumnCount; ++column)
            out << m_panel->model().index(row, column).data().toString();
        return out.join('|');
    }

    QMenu* menu() const { return m_editor->findChild<QMenu*>("quickFixes"); }

    /// Opens the menu of fixes as the key does, and takes one.
    void choose(int index)
    {
        QVERIFY(m_editor->can("edit.quickFix"));
        m_editor->perform("edit.quickFix");
        QVERIFY(menu());
        QVERIFY(index < menu()->actions().size());
        menu()->actions()[index]->trigger();
        menu()->close();
        QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
    }

    std::unique_ptr<ReferencesPanel> m_panel;
};

QTEST_MAIN(ProgramEditorTest)
#include "tst_programeditor.moc"
