#include "editors/variables/variableseditor.h"
#include "editors/variables/variablesmodel.h"
#include "tests/editors/editorbench.h"

#include <QClipboard>
#include <QComboBox>
#include <QGuiApplication>
#include <QLineEdit>
#include <QSignalSpy>
#include <QTableView>
#include <QtTest>

using namespace camwright;

namespace {

const ObjectKey Globals{ObjectKind::VariableTable, "Globals"};

struct Bench : EditorBench {
    Bench() : EditorBench(Project().withContent(Globals, VariableTable::of({{"Start", DataType::Bool, "%I0.0", "", false, "Start button"},
                  {"Stop", DataType::Bool, "%I0.1", "", false, ""}, {"Run", DataType::Bool, "%M0.0", "", false, ""}})))
    {
        editor.resize(800, 300);
        editor.show();
    }
    VariablesEditor editor{context, Globals};
    QTableView* table = part<QTableView>(editor, "variablesTable");
    QLineEdit* filter = part<QLineEdit>(editor, "variablesFilter");

    void select(int row) { table->setCurrentIndex(table->model()->index(row, 0)); }
    QStringList stored() const
    {
        QStringList out;
        for (const Variable& variable : document.content<VariableTable>(Globals)->rows())
            out << QString::fromStdString(variable.name);
        return out;
    }
};

} // namespace

class VariablesEditorTest : public QObject {
    Q_OBJECT

private slots:
    void deletesTheRowsThatAreSeenWhileFiltered()
    {
        Bench bench;
        bench.filter->setText("st");
        QCOMPARE(bench.table->model()->rowCount(), 2);
        bench.select(1);
        bench.editor.perform("edit.delete");
        QCOMPARE(bench.stored(), QStringList({"Start", "Run"}));
    }

    void filterLooksIntoEveryColumn()
    {
        Bench bench;
        bench.filter->setText("BUTTON");
        QCOMPARE(bench.table->model()->rowCount(), 1);
        bench.filter->setText("%M0");
        QCOMPARE(bench.table->model()->index(0, 0).data().toString(), QString("Run"));
    }

    void cutAndPasteMoveRows()
    {
        Bench bench;
        const Project before = bench.document.project();
        bench.select(0);
        bench.editor.perform("edit.cut");
        QCOMPARE(bench.stored(), QStringList({"Stop", "Run"}));
        bench.select(0);
        bench.editor.perform("edit.paste");
        QCOMPARE(bench.stored(), QStringList({"Stop", "Start", "Run"}));
        bench.document.undo();
        bench.document.undo();
        QVERIFY(bench.document.project() == before);
    }

    void pasteWithoutASelectionAppends()
    {
        Bench bench;
        QGuiApplication::clipboard()->setText("Lamp\tBOOL\t%Q0.0");
        bench.select(3); // the empty row
        QVERIFY(!bench.editor.can("edit.copy"));
        bench.editor.perform("edit.paste");
        QCOMPARE(bench.stored().last(), QString("Lamp"));
    }

    void aProblemIsShownInItsCellEvenBehindTheFilter()
    {
        Bench bench;
        bench.filter->setText("Start");
        bench.editor.reveal(Place{Globals, "rows[2].address", {}, {}});
        QVERIFY(bench.filter->text().isEmpty());
        QCOMPARE(bench.table->currentIndex(), bench.table->model()->index(2, VariablesModel::Address));
        bench.editor.reveal(Place{Globals, "rows[0]", {}, {}});
        QCOMPARE(bench.table->currentIndex(), bench.table->model()->index(0, VariablesModel::Name));
        bench.editor.reveal(Place{Globals, "comment", {}, {}}); // no row: stays
        QCOMPARE(bench.table->currentIndex().row(), 0);
    }

    void theTypeFieldOffersTypesAndKeepsAnythingTyped()
    {
        Bench bench;
        const QModelIndex cell = bench.table->model()->index(0, VariablesModel::Type);
        bench.table->edit(cell);
        auto* box = bench.table->findChild<QComboBox*>();
        QVERIFY(box);
        QCOMPARE(box->currentText(), QString("BOOL"));
        QVERIFY(box->findText("REAL") >= 0);
        box->setCurrentText("ARRAY OF WISHES");
        QTest::keyClick(box, Qt::Key_Return);
        QTRY_COMPARE(cell.data().toString(), QString("ARRAY OF WISHES"));
        QCOMPARE(bench.document.content<VariableTable>(Globals)->row(0).type.text(), std::string("ARRAY OF WISHES"));
    }

    void closesWhileACellIsEdited()
    {
        EditorBench bench(Project().withContent(Globals, VariableTable::of({{"Start", DataType::Bool, "%I0.0", "", false, ""}})));
        auto editor = std::make_unique<VariablesEditor>(bench.context, Globals);
        editor->show();
        editor->activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(editor.get()));
        auto* table = part<QTableView>(*editor, "variablesTable");
        table->setFocus();
        table->setCurrentIndex(table->model()->index(0, VariablesModel::Comment));
        QTest::keyClicks(table, "x");
        editor.reset();
    }

    void theCountInTheStatusBarFollows()
    {
        Bench bench;
        QSignalSpy moved(&bench.editor, &Editor::positionChanged);
        bench.select(0);
        const auto before = moved.size();
        bench.editor.perform("edit.delete");
        QVERIFY(moved.size() > before);
        QVERIFY(bench.editor.positionText().startsWith("2 "));
    }
};

QTEST_MAIN(VariablesEditorTest)
#include "tst_variableseditor.moc"
