#include "editors/watch/watchmodel.h"
#include "tests/editors/editorbench.h"

#include <QAbstractItemModelTester>
#include <QPersistentModelIndex>
#include <QSignalSpy>
#include <QtTest>

using namespace camwright;

namespace {

const ObjectKey List{ObjectKind::WatchTable, "List"};

Project watching()
{
    return Project().withContent(List, WatchTable{{{"Start", "", {}}, {"axis.Feed.position", "", {}}, {"Speed", "hex", {{"colour", "\"red\""}}}}})
        .withContent({ObjectKind::VariableTable, "Globals"}, VariableTable::of({{"Start", DataType::Bool, "%I0.0", "", false, "Start button"}}));
}

/// A document with a watch list and its model under Qt's model tester.
struct Bench {
    ProjectDocument document;
    std::unique_ptr<WatchModel> model;
    std::unique_ptr<QAbstractItemModelTester> tester;
    Bench()
    {
        document.adopt(watching());
        model = std::make_unique<WatchModel>(document, List);
        tester = std::make_unique<QAbstractItemModelTester>(model.get(), QAbstractItemModelTester::FailureReportingMode::QtTest);
    }
    QString cell(int row, int column) const { return model->index(row, column).data().toString(); }
    QStringList names() const
    {
        QStringList out;
        for (int row = 0; row < model->rowCount(); ++row)
            out << cell(row, WatchModel::Name);
        return out;
    }
    bool type(int row, int column, const QString& text) { return model->setData(model->index(row, column), text, Qt::EditRole); }
    void know(const std::string& name, DataType type) { model->setType(name, type); }
    void receive(const std::string& name, const Value& value, bool forced = false) { model->update({{name, value, forced}}); }
};

using Written = std::vector<std::pair<QString, Value>>;

} // namespace

class WatchModelTest : public QObject {
    Q_OBJECT

private slots:
    void showsTheListAndAnEmptyRowToTypeInto()
    {
        Bench bench;
        QCOMPARE(bench.names(), QStringList({"Start", "axis.Feed.position", "Speed", "name or address"}));
        QCOMPARE(bench.cell(0, WatchModel::Comment), QString("Start button"));
        QVERIFY(bench.model->flags(bench.model->index(3, WatchModel::Name)) & Qt::ItemIsEditable);
        QVERIFY(!(bench.model->flags(bench.model->index(3, WatchModel::NewValue)) & Qt::ItemIsEditable));
    }

    void typingIntoTheEmptyRowAddsAndUndoTakesItBack()
    {
        Bench bench;
        const Project before = bench.document.project();
        const QPersistentModelIndex typedInto = bench.model->index(3, WatchModel::Name);
        QVERIFY(bench.type(3, WatchModel::Name, "  Stop "));
        QCOMPARE(bench.names(), QStringList({"Start", "axis.Feed.position", "Speed", "Stop", "name or address"}));
        QCOMPARE(typedInto.row(), 3); // the cursor stays on what was typed
        QVERIFY(undoesAndRedoes(bench.document, before));
    }

    void nothingTypedIntoTheEmptyRowAddsNothing()
    {
        Bench bench;
        QVERIFY(!bench.type(3, WatchModel::Name, "   "));
        QCOMPARE(bench.document.undoStack().count(), 0);
    }

    void changingANameKeepsFormatAndUnknownKeys()
    {
        Bench bench;
        const Project before = bench.document.project();
        QVERIFY(bench.type(2, WatchModel::Name, "Count"));
        const WatchRow& row = bench.model->rows()[2];
        QCOMPARE(row.expression, std::string("Count"));
        QCOMPARE(row.format, std::string("hex"));
        QCOMPARE(row.unknown.size(), std::size_t(1));
        QVERIFY(undoesAndRedoes(bench.document, before));
    }

    void aNameErasedRemovesItsRow()
    {
        Bench bench;
        const Project before = bench.document.project();
        QVERIFY(bench.type(1, WatchModel::Name, ""));
        QCOMPARE(bench.names(), QStringList({"Start", "Speed", "name or address"}));
        QVERIFY(undoesAndRedoes(bench.document, before));
    }

    void rowsStayWhereTheCursorIsWhenOthersComeAndGo()
    {
        Bench bench;
        const QPersistentModelIndex speed = bench.model->index(2, WatchModel::Name);
        bench.model->add(1, {{"A", "", {}}, {"B", "", {}}});
        QCOMPARE(bench.names(), QStringList({"Start", "A", "B", "axis.Feed.position", "Speed", "name or address"}));
        QCOMPARE(speed.row(), 4);
        bench.model->remove({0, 2});
        QCOMPARE(bench.names(), QStringList({"A", "axis.Feed.position", "Speed", "name or address"}));
        QVERIFY(speed.isValid());
        QCOMPARE(speed.data().toString(), QString("Speed"));
        bench.document.undo();
        bench.document.undo();
        QCOMPARE(bench.names(), QStringList({"Start", "axis.Feed.position", "Speed", "name or address"}));
        QCOMPARE(speed.row(), 2);
    }

    void severalRowsAreOneStep()
    {
        Bench bench;
        const Project before = bench.document.project();
        bench.model->add(100, {{"A", "", {}}, {"B", "", {}}, {"C", "", {}}});
        QCOMPARE(bench.names().mid(3), QStringList({"A", "B", "C", "name or address"}));
        QCOMPARE(bench.document.undoStack().count(), 1);
        QVERIFY(undoesAndRedoes(bench.document, before));
        bench.model->remove({0, 1, 2, 3, 4, 5});
        QCOMPARE(bench.names(), QStringList({"name or address"}));
        bench.document.undo();
        QCOMPARE(bench.model->rowCount(), 7);
    }

    void formatIsPartOfTheProjectAndOfTheValueShown()
    {
        Bench bench;
        const Project before = bench.document.project();
        bench.know("Start", DataType::Word);
        bench.receive("Start", Value::ofInteger(DataType::Word, 255));
        QCOMPARE(bench.cell(0, WatchModel::CurrentValue), QString("255"));
        QSignalSpy expressions(bench.model.get(), &WatchModel::expressionsChanged);
        bench.model->setFormat({0}, "hex");
        QCOMPARE(bench.cell(0, WatchModel::CurrentValue), QString("16#FF"));
        QCOMPARE(expressions.size(), 0); // nothing to ask the controller for
        bench.model->setFormat({0}, "bin");
        QCOMPARE(bench.cell(0, WatchModel::CurrentValue), QString("2#11111111"));
        bench.document.undo();
        QVERIFY(undoesAndRedoes(bench.document, before));
    }

    void theSameFormatAgainIsNoStep()
    {
        Bench bench;
        bench.model->setFormat({2}, "hex");
        QCOMPARE(bench.document.undoStack().count(), 0);
    }

    void anotherListShowsItsRows()
    {
        Bench bench;
        bench.document.push({"add", {ObjectDelta{{ObjectKind::WatchTable, "Other"}, nullptr,
            std::make_shared<const Object>(Object{{ObjectKind::WatchTable, "Other"}, 2, WatchTable{{{"X", "", {}}}}, {}})}}, {}, {}, {}});
        QCOMPARE(bench.model->rowCount(), 4);
        bench.model->setKey({ObjectKind::WatchTable, "Other"});
        QCOMPARE(bench.names(), QStringList({"X", "name or address"}));
        bench.document.undo(); // the list is gone
        QCOMPARE(bench.names(), QStringList({"name or address"}));
    }

    void typedValuesAreReadAsTheirType_data()
    {
        QTest::addColumn<int>("type");
        QTest::addColumn<QString>("text");
        QTest::addColumn<QString>("value"); // empty: refused
        QTest::newRow("hexadecimal") << int(DataType::Byte) << "16#FF" << "255";
        QTest::newRow("binary") << int(DataType::Byte) << "2#1010" << "10";
        QTest::newRow("too large") << int(DataType::Byte) << "256" << "";
        QTest::newRow("negative") << int(DataType::Int) << "-32768" << "-32768";
        QTest::newRow("duration") << int(DataType::Time) << "T#5s" << "T#5s";
        QTest::newRow("duration in parts") << int(DataType::Time) << "t#1m5s250ms" << "T#1m5s250ms";
        QTest::newRow("decimal comma") << int(DataType::Real) << "1,5" << "1.5";
        QTest::newRow("word for on") << int(DataType::Bool) << "true" << "TRUE";
        QTest::newRow("no truth value") << int(DataType::Bool) << "2" << "";
        QTest::newRow("not a number") << int(DataType::Dint) << "12x" << "";
    }

    void typedValuesAreReadAsTheirType()
    {
        QFETCH(int, type);
        QFETCH(QString, text);
        QFETCH(QString, value);
        Bench bench;
        bench.know("Start", DataType(type));
        Written written;
        connect(bench.model.get(), &WatchModel::writeRequested, this, [&](const QString& name, const Value& v) { written.push_back({name, v}); });
        QVERIFY(bench.type(0, WatchModel::NewValue, text));
        QCOMPARE(bench.cell(0, WatchModel::NewValue), text);
        QCOMPARE(written.size(), value.isEmpty() ? std::size_t(0) : std::size_t(1));
        if (!value.isEmpty()) {
            QCOMPARE(written[0].first, QString("Start"));
            QCOMPARE(QString::fromStdString(formatValue(written[0].second)), value);
        }
        const QModelIndex cell = bench.model->index(0, WatchModel::NewValue);
        QCOMPARE(cell.data(Qt::ToolTipRole).toString().isEmpty(), !value.isEmpty());
        QCOMPARE(cell.data(Qt::ForegroundRole).isValid(), value.isEmpty());
        QCOMPARE(bench.document.undoStack().count(), 0); // a value is not part of the project
    }

    void aWrongEntryStaysUntilItIsMended()
    {
        Bench bench;
        bench.know("Start", DataType::Byte);
        bench.type(0, WatchModel::NewValue, "300");
        bench.receive("Start", Value::ofInteger(DataType::Byte, 7));
        bench.model->add(0, {{"First", "", {}}});
        QCOMPARE(bench.cell(1, WatchModel::NewValue), QString("300")); // it belongs to the value, not to the line
        QVERIFY(!bench.model->index(1, WatchModel::NewValue).data(Qt::ToolTipRole).toString().isEmpty());
        bench.type(1, WatchModel::NewValue, "30");
        QVERIFY(bench.model->index(1, WatchModel::NewValue).data(Qt::ToolTipRole).toString().isEmpty());
        bench.type(1, WatchModel::NewValue, "");
        QCOMPARE(bench.cell(1, WatchModel::NewValue), QString());
    }

    void whatIsTypedOfflineIsKeptAndJudgedOnceTheTypeIsKnown()
    {
        Bench bench;
        QSignalSpy writes(bench.model.get(), &WatchModel::writeRequested);
        bench.type(0, WatchModel::NewValue, "16#FF");
        QCOMPARE(bench.cell(0, WatchModel::NewValue), QString("16#FF"));
        QVERIFY(!bench.model->index(0, WatchModel::NewValue).data(Qt::ToolTipRole).toString().isEmpty());
        bench.know("Start", DataType::Byte);
        QVERIFY(bench.model->index(0, WatchModel::NewValue).data(Qt::ToolTipRole).toString().isEmpty());
        QCOMPARE(writes.size(), 0); // nothing is written because a controller appears
    }

    void anUnknownNameSaysSoAndHidesNothingElse()
    {
        Bench bench;
        bench.know("Start", DataType::Bool);
        bench.model->setType("Speed", diagnostic(Code::NameUnknown, {"Speed"}));
        bench.receive("Start", Value::ofBool(true));
        QCOMPARE(bench.cell(2, WatchModel::CurrentValue), QString("not known"));
        QVERIFY(bench.model->index(2, WatchModel::CurrentValue).data(Qt::ToolTipRole).toString().contains("Speed"));
        QCOMPARE(bench.cell(0, WatchModel::CurrentValue), QString("TRUE"));
        QCOMPARE(bench.cell(0, WatchModel::Type), QString("BOOL"));
    }

    void forcedValuesAreMarkedByALetterToo()
    {
        Bench bench;
        bench.know("Start", DataType::Bool);
        bench.receive("Start", Value::ofBool(true), true);
        QCOMPARE(bench.cell(0, WatchModel::CurrentValue), QString("F  TRUE"));
        QCOMPARE(bench.model->index(0, 0).data(Qt::BackgroundRole).value<QColor>(), theme().color(Role::ForcedSoft));
        bench.receive("Start", Value::ofBool(true), false);
        QCOMPARE(bench.cell(0, WatchModel::CurrentValue), QString("TRUE"));
        QVERIFY(!bench.model->index(0, 0).data(Qt::BackgroundRole).isValid());
    }

    void staleValuesStayDimmed()
    {
        Bench bench;
        bench.know("Start", DataType::Bool);
        bench.receive("Start", Value::ofBool(true));
        const QModelIndex value = bench.model->index(0, WatchModel::CurrentValue);
        QVERIFY(!value.data(Qt::ForegroundRole).isValid());
        bench.model->setStale(true);
        QCOMPARE(value.data().toString(), QString("TRUE"));
        QCOMPARE(value.data(Qt::ForegroundRole).value<QColor>(), theme().color(Role::Faint));
        bench.model->forgetValues();
        QCOMPARE(value.data().toString(), QString());
    }

    void historyKeepsTheLastHundredValues()
    {
        Bench bench;
        for (int i = 0; i < 250; ++i)
            bench.receive("Start", Value::ofInteger(DataType::Int, i));
        const auto& history = bench.model->watched(0)->history;
        QCOMPARE(history.size(), WatchModel::HistoryLength);
        QCOMPARE(history.front(), 150.0);
        QCOMPARE(history.back(), 249.0);
    }

    void valuesOfNamesThatAreNotShownDoNoHarm()
    {
        Bench bench;
        bench.receive("Elsewhere", Value::ofBool(true));
        bench.model->setType("Elsewhere", DataType::Bool);
        QCOMPARE(bench.model->watched(-1), nullptr);
        QCOMPARE(bench.model->watched(3), nullptr);
        QCOMPARE(bench.cell(0, WatchModel::CurrentValue), QString());
    }
};

QTEST_MAIN(WatchModelTest)
#include "tst_watchmodel.moc"
