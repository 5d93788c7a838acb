#include "core/checks/checkproject.h"
#include "editors/axis/axiseditor.h"
#include "editors/axis/transmissionview.h"
#include "editors/document/editcommands.h"
#include "editors/shell/quantityfield.h"
#include "editors/shell/widgets.h"
#include "tests/editors/editorbench.h"

#include <QLabel>
#include <QLineEdit>
#include <QtTest>

using namespace camwright;

namespace {

const ObjectKey Feed{ObjectKind::Axis, "Feed"};

Project machine()
{
    ControllerSettings controller;
    controller.family = "kinco";
    controller.model = "KS101M-04DX";
    Axis feed;
    feed.mechanicalEquivalent = 100.0;
    Axis turn;
    turn.number = 2;
    turn.type = AxisType::Rotary;
    turn.mechanicalEquivalent = 45.0;
    return Project().withContent(controllerKey(), controller).withContent(Feed, feed).withContent({ObjectKind::Axis, "Turn"}, turn);
}

struct Bench : EditorBench {
    explicit Bench(const ObjectKey& key = Feed) : EditorBench(machine()), editor(context, key)
    {
        editor.resize(1000, 900);
        editor.show();
        editor.activateWindow();
    }
    AxisEditor editor;

    const Axis& axis(const ObjectKey& key = Feed) const { return *document.content<Axis>(key); }
    QuantityField* field(const char* name) { return part<QuantityField>(editor, name); }
    void type(const char* name, const QString& text)
    {
        QLineEdit* edit = field(name)->lineEdit();
        edit->setFocus();
        edit->selectAll();
        QTest::keyClicks(edit, text);
        QTest::keyClick(edit, Qt::Key_Return);
    }
    void typeName(const QString& text)
    {
        auto* name = part<QLineEdit>(editor, "axisName");
        name->setFocus();
        name->selectAll();
        QTest::keyClicks(name, text);
        QTest::keyClick(name, Qt::Key_Return);
    }
    void check() { document.setDiagnostics(checkProject(document.project())); }
    QStringList results()
    {
        QStringList out;
        for (const QLabel* label : part<QFrame>(editor, "results")->findChildren<QLabel*>()) {
            if (label->textInteractionFlags() & Qt::TextSelectableByMouse)
                out << label->text();
        }
        return out;
    }
};

} // namespace

class AxisEditorTest : public QObject {
    Q_OBJECT

private slots:
    void anEditIsOneStepAndUndoRestoresTheBytes()
    {
        Bench bench;
        const Project before = bench.document.project();
        bench.type("encoder_resolution", "2500");
        QCOMPARE(bench.axis().encoderResolution.value(), 2500);
        QCOMPARE(bench.document.undoStack().count(), 1);
        QVERIFY(undoesAndRedoes(bench.document, before));
        bench.document.undo();
        QCOMPARE(bench.field("encoder_resolution")->lineEdit()->text(), QString("10000"));
    }

    void entriesAreReadAsPeopleTypeThem_data()
    {
        QTest::addColumn<QByteArray>("field");
        QTest::addColumn<QString>("text");
        QTest::addColumn<double>("value");
        QTest::newRow("hexadecimal") << QByteArray("encoder_resolution") << "16#FF" << 255.0;
        QTest::newRow("thousands") << QByteArray("encoder_resolution") << "2.5k" << 2500.0;
        QTest::newRow("another unit") << QByteArray("mechanical_equivalent") << "1 in" << 25.4;
        QTest::newRow("decimal comma") << QByteArray("mechanical_equivalent") << "12,5" << 12.5;
        QTest::newRow("duration") << QByteArray("inhibit_time_ms") << "T#5s" << 5000.0;
        QTest::newRow("turns of the motor") << QByteArray("simulation.home_switch") << "0.5 turn" << 50.0;
    }

    void entriesAreReadAsPeopleTypeThem()
    {
        QFETCH(QByteArray, field);
        QFETCH(QString, text);
        Bench bench;
        bench.type(field.constData(), text);
        const Axis& axis = bench.axis();
        const std::map<QByteArray, double> now{{"encoder_resolution", double(axis.encoderResolution.valueOr(-1))},
            {"mechanical_equivalent", axis.mechanicalEquivalent.valueOr(-1)}, {"inhibit_time_ms", double(axis.inhibitTimeMs.valueOr(-1))},
            {"simulation.home_switch", axis.simulation.homeSwitch.valueOr(-1)}};
        QTEST(now.at(field), "value");
    }

    void anIllegalEntryIsKeptInTheProject() // CONTRACTS 3
    {
        Bench bench;
        const Project before = bench.document.project();
        bench.type("mechanical_equivalent", "a lot");
        QCOMPARE(bench.axis().mechanicalEquivalent.text(), std::string("a lot"));
        QCOMPARE(bench.field("mechanical_equivalent")->lineEdit()->text(), QString("a lot"));
        QVERIFY(!bench.field("mechanical_equivalent")->problem().isEmpty());
        QCOMPARE(bench.results(), QStringList({"–", "–", "–", "–", "–"}));
        QVERIFY(undoesAndRedoes(bench.document, before));
    }

    void whatTheChecksFindStandsAtItsField()
    {
        Bench bench;
        bench.type("number", "2"); // Turn has it
        bench.check();
        QVERIFY(!bench.field("number")->problem().isEmpty());
        QVERIFY(bench.field("encoder_resolution")->problem().isEmpty());
        bench.document.undo();
        bench.check();
        QVERIFY(bench.field("number")->problem().isEmpty());
    }

    void resultsAreWhatTheNumbersMean()
    {
        Bench bench; // 10000 pulses and 100 mm a turn, at 3000 turns a minute
        QCOMPARE(bench.results(), QStringList({"0.01 mm per pulse", "5000.000 mm/s", "300000.000 mm/min", "500000.000 pulses/s", "±21474836.480 mm"}));
        bench.type("resultSpeed", "60");
        QCOMPARE(bench.results()[1], QString("100.000 mm/s"));
        QCOMPARE(bench.document.undoStack().count(), 0); // a question, not an edit
    }

    void aRotaryAxisSpeaksInDegrees()
    {
        Bench bench({ObjectKind::Axis, "Turn"});
        QCOMPARE(bench.results()[0], QString("0.0045 ° per pulse"));
        QCOMPARE(bench.results()[1], QString("2250.000 °/s"));
        QCOMPARE(bench.field("simulation.home_switch")->spec().unit, QString("°"));
        QCOMPARE(bench.field("simulation.inertia_ratio")->spec().unit, QString());
        QCOMPARE(bench.editor.iconName(), QString("axis-rotary"));
    }

    void theDrawingTellsTheFormulaOfTheAxisShown()
    {
        Bench bench;
        auto* drawing = part<TransmissionView>(bench.editor, "transmissionView");
        const QString before = drawing->accessibleDescription();
        QVERIFY2(before.contains("10000") && before.contains("100"), qPrintable(before));
        bench.type("encoder_resolution", "4096");
        QVERIFY2(drawing->accessibleDescription().contains("4096"), qPrintable(drawing->accessibleDescription()));
    }

    void aRenamedAxisShowsItsNewName()
    {
        Bench bench;
        bench.typeName("Infeed");
        const ObjectKey infeed{ObjectKind::Axis, "Infeed"};
        QVERIFY(bench.document.object(infeed));
        bench.editor.setKey(infeed); // as the window does
        QCOMPARE(part<QLabel>(bench.editor, "axisTitle")->text(), QString("Infeed"));
        QCOMPARE(part<QLineEdit>(bench.editor, "axisName")->text(), QString("Infeed"));
        bench.type("encoder_resolution", "2500");
        QCOMPARE(bench.axis(infeed).encoderResolution.value(), 2500);
    }

    void aNameThatIsTakenIsRefusedAndTold()
    {
        Bench bench;
        bench.typeName("Turn");
        QCOMPARE(bench.notices.size(), 1);
        QCOMPARE(bench.document.undoStack().count(), 0);
        QCOMPARE(part<QLineEdit>(bench.editor, "axisName")->text(), QString("Feed"));
    }

    void aChangeFromElsewhereArrives()
    {
        Bench bench;
        editObject<Axis>(bench.document, Feed, "other view", "guard_time_ms", [](Axis& axis) {
            axis.guardTimeMs = 200;
            axis.simulation.upperLimitSwitch = 777.5;
        });
        QCOMPARE(bench.field("guard_time_ms")->lineEdit()->text(), QString("200"));
        QVERIFY(bench.field("guard_time_ms")->isVisibleTo(&bench.editor)); // no longer the default
        QCOMPARE(bench.field("simulation.upper_limit_switch")->lineEdit()->text(), QString("777.5"));
    }

    void aProblemIsShownAtItsField()
    {
        Bench bench;
        QVERIFY(QTest::qWaitForWindowActive(&bench.editor));
        bench.editor.reveal(Place{Feed, "guard_time_ms", {}, {}});
        QVERIFY(bench.field("guard_time_ms")->lineEdit()->hasFocus());
        bench.editor.reveal(Place{Feed, "simulation.start_position", {}, {}});
        QVERIFY(bench.field("simulation.start_position")->lineEdit()->hasFocus());
    }
};

QTEST_MAIN(AxisEditorTest)
#include "tst_axiseditor.moc"
