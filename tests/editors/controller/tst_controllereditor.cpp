#include "core/family/family.h"
#include "editors/controller/controllereditor.h"
#include "editors/document/editcommands.h"
#include "editors/shell/quantityfield.h"
#include "tests/editors/editorbench.h"

#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QTableWidget>
#include <QtTest>

using namespace camwright;

namespace {

Project controllerOf(const char* family, const char* model)
{
    ControllerSettings settings;
    settings.family = family;
    settings.model = model;
    return Project().withContent(controllerKey(), settings);
}

struct Bench : EditorBench {
    explicit Bench(const char* model = "KS101M-04DX", const char* family = "kinco")
        : EditorBench(controllerOf(family, model)), editor(context, controllerKey())
    {
        editor.resize(900, 600);
        editor.show();
    }
    ControllerEditor editor;
    QComboBox* models = part<QComboBox>(editor, "controllerModel");
    QTableWidget* limits = part<QTableWidget>(editor, "controllerLimits");

    void type(const char* name, const QString& text)
    {
        QLineEdit* edit = part<QuantityField>(editor, name)->lineEdit();
        edit->setFocus();
        edit->selectAll();
        QTest::keyClicks(edit, text);
        QTest::keyClick(edit, Qt::Key_Return);
    }
    QString limit(const QString& label) const
    {
        for (int row = 0; row < limits->rowCount(); ++row) {
            if (limits->item(row, 0)->text() == label)
                return limits->item(row, 1)->text();
        }
        return {};
    }
    bool saysVisibly(const QString& words) const
    {
        const auto labels = editor.findChildren<QLabel*>();
        return std::ranges::any_of(labels, [&](const QLabel* label) { return label->isVisible() && label->text().contains(words); });
    }
};

} // namespace

class ControllerEditorTest : public QObject {
    Q_OBJECT

private slots:
    void offersTheModelsThatCanBeChosen()
    {
        Bench bench;
        QStringList offered, selectable;
        for (int i = 0; i < bench.models->count(); ++i)
            offered << bench.models->itemText(i);
        for (const ControllerModel& model : findFamily("kinco")->models()) {
            if (model.selectable)
                selectable << QString::fromStdString(model.name);
        }
        QVERIFY(selectable.size() > 1);
        QCOMPARE(offered, selectable);
        QCOMPARE(bench.models->currentText(), QString("KS101M-04DX"));
    }

    void choosingAModelIsOneStepAndShowsItsLimits()
    {
        Bench bench;
        const Project before = bench.document.project();
        const int other = bench.models->currentIndex() == 0 ? 1 : 0;
        const std::string name = bench.models->itemText(other).toStdString();
        bench.models->setCurrentIndex(other);
        emit bench.models->activated(other);
        QCOMPARE(bench.document.project().controller().model, name);
        const ControllerModel* model = findFamily("kinco")->findModel(name);
        QCOMPARE(bench.limit("Digital inputs on the unit"), model->digitalInputs == 0 ? QString("none") : QString::number(model->digitalInputs));
        QCOMPARE(bench.limit("Axes on the motion network"), model->axesMax == 0 ? QString("none") : QString::number(model->axesMax));
        QCOMPARE(bench.document.undoStack().count(), 1);
        QVERIFY(undoesAndRedoes(bench.document, before));
        bench.document.undo();
        QCOMPARE(bench.models->currentText(), QString("KS101M-04DX"));
    }

    void anUnknownModelIsKeptAndHasNoLimits() // CONTRACTS 3
    {
        Bench bench("KS999");
        QCOMPARE(bench.models->currentText(), QString("KS999"));
        QCOMPARE(bench.limits->rowCount(), 0);
        QCOMPARE(bench.document.project().controller().model, std::string("KS999"));
    }

    void anUnknownFamilyIsShownAsItStands()
    {
        Bench bench("X1", "acme");
        QCOMPARE(part<QLabel>(bench.editor, "controllerFamily")->text(), QString("acme"));
        QCOMPARE(bench.models->currentText(), QString("X1"));
        QCOMPARE(bench.models->count(), 1);
    }

    void timesAreReadAsPeopleTypeThem_data()
    {
        QTest::addColumn<QByteArray>("field");
        QTest::addColumn<QString>("text");
        QTest::addColumn<qint64>("value");
        QTest::newRow("plain") << QByteArray("watchdog_ms") << "250" << qint64(250);
        QTest::newRow("hexadecimal") << QByteArray("watchdog_ms") << "16#FF" << qint64(255);
        QTest::newRow("another unit") << QByteArray("watchdog_ms") << "1 s" << qint64(1000);
        QTest::newRow("literal") << QByteArray("scan_period_us") << "T#5ms" << qint64(5000);
    }

    void timesAreReadAsPeopleTypeThem()
    {
        QFETCH(QByteArray, field);
        QFETCH(QString, text);
        Bench bench;
        const Project before = bench.document.project();
        bench.type(field.constData(), text);
        const ControllerSettings& settings = bench.document.project().controller();
        QTEST(qint64(field == "watchdog_ms" ? settings.watchdogMs.valueOr(-1) : settings.scanPeriodUs.valueOr(-1)), "value");
        QVERIFY(undoesAndRedoes(bench.document, before));
    }

    void anIllegalTimeIsKeptInTheProject() // CONTRACTS 3
    {
        Bench bench;
        const Project before = bench.document.project();
        bench.type("watchdog_ms", "never");
        QCOMPARE(bench.document.project().controller().watchdogMs.text(), std::string("never"));
        QVERIFY(!part<QuantityField>(bench.editor, "watchdog_ms")->problem().isEmpty());
        QVERIFY(undoesAndRedoes(bench.document, before));
    }

    void problemsStandAtTheirFields()
    {
        Bench bench;
        bench.document.setDiagnostics({diagnostic(Code::NameUnknown, {"first"}, Place{controllerKey(), "model", {}, {}}),
            diagnostic(Code::NameUnknown, {"second"}, Place{controllerKey(), "model", {}, {}}),
            diagnostic(Code::NameUnknown, {"dog"}, Place{controllerKey(), "watchdog_ms", {}, {}})});
        QVERIFY(bench.saysVisibly("first"));
        QVERIFY(part<QuantityField>(bench.editor, "watchdog_ms")->problem().contains("dog"));
        QVERIFY(part<QuantityField>(bench.editor, "scan_period_us")->problem().isEmpty());
        bench.document.setDiagnostics({});
        QVERIFY(!bench.saysVisibly("first"));
    }

    void aChangeFromElsewhereArrives()
    {
        Bench bench;
        editObject<ControllerSettings>(bench.document, controllerKey(), "other view", "watchdog_ms", [](ControllerSettings& settings) { settings.watchdogMs = 77; });
        QCOMPARE(part<QuantityField>(bench.editor, "watchdog_ms")->lineEdit()->text(), QString("77"));
    }
};

QTEST_MAIN(ControllerEditorTest)
#include "tst_controllereditor.moc"
