#include "core/checks/checkproject.h"
#include "editors/document/editcommands.h"
#include "editors/variables/variablesmodel.h"
#include "tests/editors/editorbench.h"

#include <QAbstractItemModelTester>
#include <QPersistentModelIndex>
#include <QSignalSpy>
#include <QtTest>

using namespace camwright;

namespace {

const ObjectKey Globals{ObjectKind::VariableTable, "Globals"};

Project machine()
{
    ControllerSettings controller;
    controller.family = "kinco";
    controller.model = "KS101M-04DX";
    return Project().withContent(controllerKey(), controller).withContent(Globals,
        VariableTable::of({{"Start", DataType::Bool, "%I0.0", "", false, "Start button"}, {"Run", DataType::Bool, "%M0.0", "", false, ""},
            {"Target", DataType::Real, "%VR100", "250.0", true, "Where the next part goes"}}));
}

struct Bench {
    ProjectDocument document;
    std::unique_ptr<VariablesModel> model;
    std::unique_ptr<QAbstractItemModelTester> tester;
    explicit Bench(Project project = machine())
    {
        document.adopt(std::move(project));
        model = std::make_unique<VariablesModel>(document, Globals);
        tester = std::make_unique<QAbstractItemModelTester>(model.get(), QAbstractItemModelTester::FailureReportingMode::QtTest);
    }
    void check() { document.setDiagnostics(checkProject(document.project())); }
    QModelIndex at(int row, int column) const { return model->index(row, column); }
    QString cell(int row, int column) const { return at(row, column).data().toString(); }
    bool type(int row, int column, const QString& text) { return model->setData(at(row, column), text, Qt::EditRole); }
    QStringList names() const
    {
        QStringList out;
        for (int row = 0; row < model->rowCount(); ++row)
            out << cell(row, VariablesModel::Name);
        return out;
    }
    const Variable& stored(std::size_t row) const { return document.content<VariableTable>(Globals)->row(row); }
};

} // namespace

class VariablesModelTest : public QObject {
    Q_OBJECT

private slots:
    void showsTheTableAndAnEmptyRow()
    {
        Bench bench;
        QCOMPARE(bench.names(), QStringList({"Start", "Run", "Target", "new variable"}));
        QCOMPARE(bench.cell(2, VariablesModel::Type), QString("REAL"));
        QCOMPARE(bench.cell(2, VariablesModel::Initial), QString("250.0"));
        QCOMPARE(bench.at(2, VariablesModel::Retain).data(Qt::CheckStateRole).toInt(), int(Qt::Checked));
        QVERIFY(!(bench.model->flags(bench.at(3, VariablesModel::Retain)) & Qt::ItemIsUserCheckable));
    }

    void everyCellCanBeEditedAndTakenBack_data()
    {
        QTest::addColumn<int>("column");
        QTest::addColumn<QString>("text");
        QTest::newRow("name") << int(VariablesModel::Name) << "Begin";
        QTest::newRow("type") << int(VariablesModel::Type) << "DWORD";
        QTest::newRow("address") << int(VariablesModel::Address) << "%M3.1";
        QTest::newRow("initial") << int(VariablesModel::Initial) << "16#FF";
        QTest::newRow("duration as initial") << int(VariablesModel::Initial) << "T#5s";
        QTest::newRow("comment") << int(VariablesModel::Comment) << "Кнопка «Пуск», 启动";
    }

    void everyCellCanBeEditedAndTakenBack()
    {
        QFETCH(int, column);
        QFETCH(QString, text);
        Bench bench;
        const Project before = bench.document.project();
        QSignalSpy changes(bench.model.get(), &QAbstractItemModel::dataChanged);
        QVERIFY(bench.type(1, column, text));
        QCOMPARE(bench.cell(1, column), text);
        QCOMPARE(bench.document.undoStack().count(), 1);
        QCOMPARE(changes.size(), 1);
        QCOMPARE(changes[0][0].toModelIndex().row(), 1); // and no other row
        QCOMPARE(changes[0][1].toModelIndex().row(), 1);
        QVERIFY(undoesAndRedoes(bench.document, before));
    }

    void anIllegalTypeStaysAsTyped() // CONTRACTS 3
    {
        Bench bench;
        const Project before = bench.document.project();
        QVERIFY(bench.type(0, VariablesModel::Type, " INTT "));
        QCOMPARE(bench.cell(0, VariablesModel::Type), QString("INTT"));
        QVERIFY(!bench.stored(0).type.isValid());
        bench.check();
        const QModelIndex wrong = bench.at(0, VariablesModel::Type);
        QVERIFY(wrong.data(Qt::ToolTipRole).toString().contains("INTT"));
        QCOMPARE(wrong.data(Qt::ForegroundRole).value<QColor>(), theme().color(Role::Error));
        QVERIFY(undoesAndRedoes(bench.document, before));
        QVERIFY(bench.type(0, VariablesModel::Type, "int"));
        QCOMPARE(bench.cell(0, VariablesModel::Type), QString("INT"));
        bench.check();
        QVERIFY(!bench.at(0, VariablesModel::Type).data(Qt::ToolTipRole).isValid());
    }

    void anIllegalAddressStaysAsTypedAndIsMarkedInItsCell()
    {
        Bench bench;
        QVERIFY(bench.type(1, VariablesModel::Address, "%Q99.9"));
        bench.check();
        QCOMPARE(bench.cell(1, VariablesModel::Address), QString("%Q99.9"));
        QCOMPARE(bench.at(1, VariablesModel::Address).data(Qt::BackgroundRole).value<QColor>(), theme().color(Role::ErrorSoft));
        QVERIFY(!bench.at(1, VariablesModel::Name).data(Qt::ToolTipRole).isValid());
        QVERIFY(!bench.at(0, VariablesModel::Address).data(Qt::ToolTipRole).isValid());
    }

    void retainIsACheckMark()
    {
        Bench bench;
        const Project before = bench.document.project();
        QVERIFY(bench.model->setData(bench.at(0, VariablesModel::Retain), Qt::Checked, Qt::CheckStateRole));
        QVERIFY(bench.stored(0).retain);
        QVERIFY(undoesAndRedoes(bench.document, before));
        QVERIFY(!bench.model->setData(bench.at(0, VariablesModel::Name), Qt::Checked, Qt::CheckStateRole));
    }

    void typingIntoTheEmptyRowAddsAndKeepsTheCursor()
    {
        Bench bench;
        const Project before = bench.document.project();
        const QPersistentModelIndex typedInto = bench.at(3, VariablesModel::Name);
        QVERIFY(bench.type(3, VariablesModel::Name, "Stop"));
        QCOMPARE(bench.names(), QStringList({"Start", "Run", "Target", "Stop", "new variable"}));
        QCOMPARE(typedInto.row(), 3);
        QVERIFY(undoesAndRedoes(bench.document, before));
        QVERIFY(!bench.type(4, VariablesModel::Name, ""));
        QCOMPARE(bench.document.undoStack().count(), 1);
    }

    void pastedRowsAreOneStepAndTheOthersStayWhereTheyAre()
    {
        Bench bench;
        const Project before = bench.document.project();
        const QPersistentModelIndex target = bench.at(2, VariablesModel::Name);
        bench.model->insert(1, VariablesModel::fromText("A\tINT\t%VW2\t5\tRETAIN\tfirst\nB\tBOOL\n"));
        QCOMPARE(bench.names(), QStringList({"Start", "A", "B", "Run", "Target", "new variable"}));
        QCOMPARE(target.row(), 4);
        QCOMPARE(bench.document.undoStack().count(), 1);
        QVERIFY(undoesAndRedoes(bench.document, before));
        QCOMPARE(bench.stored(1), (Variable{"A", DataType::Int, "%VW2", "5", true, "first"}));
    }

    void rowsFarApartAreDeletedInOneStep()
    {
        Bench bench;
        bench.model->insert(3, VariablesModel::fromText("A\nB\nC"));
        const Project before = bench.document.project();
        const QPersistentModelIndex run = bench.at(1, 0), b = bench.at(4, 0);
        bench.model->removeVariables({5, 0, 3, 99, -1});
        QCOMPARE(bench.names(), QStringList({"Run", "Target", "B", "new variable"}));
        QVERIFY(undoesAndRedoes(bench.document, before));
        QVERIFY(run.isValid() || b.isValid());
        bench.model->removeVariables({17});
        QCOMPARE(bench.document.undoStack().count(), 2);
    }

    void deletingOneRowOfALargeTableSharesTheRest() // CONTRACTS 1
    {
        std::vector<Variable> many;
        for (int i = 0; i < 5000; ++i)
            many.push_back({"V" + std::to_string(i), DataType::Bool, "", "", false, ""});
        Bench bench(machine().withContent(Globals, VariableTable::of(many)));
        const auto first = bench.document.content<VariableTable>(Globals)->chunks.front();
        bench.tester.reset(); // looks at every row at every change
        bench.model->removeVariables({4990});
        const auto& chunks = bench.document.content<VariableTable>(Globals)->chunks;
        QVERIFY(chunks.size() > 1);
        QVERIFY(chunks.front() == first);
        QCOMPARE(bench.cell(4990, VariablesModel::Name), QString("V4991"));
    }

    void textOfRowsReadsBackTheSame()
    {
        Bench bench;
        const QString text = bench.model->toText({0, 2, 3, 99});
        QCOMPARE(text, QString("Start\tBOOL\t%I0.0\t\t\tStart button\nTarget\tREAL\t%VR100\t250.0\tRETAIN\tWhere the next part goes"));
        const std::vector<Variable> back = VariablesModel::fromText(text);
        QCOMPARE(back.size(), std::size_t(2));
        QVERIFY(back[0] == bench.stored(0));
        QVERIFY(back[1] == bench.stored(2));
    }

    void spreadsheetTextIsUnderstood_data()
    {
        QTest::addColumn<QString>("text");
        QTest::addColumn<bool>("retain");
        QTest::newRow("Windows line ends") << "A\tINT\t%VW0\t1\tTRUE\tc\r\n\r\n" << true;
        QTest::newRow("small letters") << "A\tint\t%VW0\t1\tretain\tc" << true;
        QTest::newRow("number") << "A\tINT\t%VW0\t1\t1\tc" << true;
        QTest::newRow("no") << " A \tINT\t%VW0\t1\tFALSE\tc\tone column too many" << false;
    }

    void spreadsheetTextIsUnderstood()
    {
        QFETCH(QString, text);
        QFETCH(bool, retain);
        const std::vector<Variable> rows = VariablesModel::fromText(text);
        QCOMPARE(rows.size(), std::size_t(1));
        QCOMPARE(rows[0], (Variable{"A", DataType::Int, "%VW0", "1", retain, "c"}));
    }

    void nothingPastedIsNoStep()
    {
        Bench bench;
        bench.model->insert(0, VariablesModel::fromText(" \n\r\n"));
        QCOMPARE(bench.document.undoStack().count(), 0);
    }

    void changesFromElsewhereArrive()
    {
        Bench bench;
        editObject<VariableTable>(bench.document, Globals, "other view", "rows", [](VariableTable& table) {
            table = VariableTable::of({{"X", DataType::Bool, "", "", false, ""}});
        });
        QCOMPARE(bench.names(), QStringList({"X", "new variable"}));
        bench.document.undo();
        QCOMPARE(bench.names(), QStringList({"Start", "Run", "Target", "new variable"}));
    }

    void aRenamedTableKeepsItsRows()
    {
        Bench bench;
        const ObjectKey io{ObjectKind::VariableTable, "Io"};
        QVERIFY(renameObject(bench.document, Globals, "Io").ok());
        bench.model->setKey(io);
        QCOMPARE(bench.names(), QStringList({"Start", "Run", "Target", "new variable"}));
        QVERIFY(bench.type(0, VariablesModel::Name, "Begin"));
        QCOMPARE(bench.document.content<VariableTable>(io)->row(0).name, std::string("Begin"));
    }
};

QTEST_MAIN(VariablesModelTest)
#include "tst_variablesmodel.moc"
