#include "editors/network/axislistmodel.h"
#include "editors/network/motionnetworkdraft.h"
#include "editors/network/networkeditor.h"
#include "editors/document/editcommands.h"
#include "editors/shell/actions.h"
#include "editors/shell/context.h"
#include "editors/shell/quantityfield.h"
#include "editors/shell/registry.h"
#include "editors/shell/theme.h"
#include "editors/words/words.h"
#include "tests/editors/fits.h"

#include <QAbstractItemModelTester>
#include <QComboBox>
#include <QLineEdit>
#include <QPushButton>
#include <QScrollBar>
#include <QTableView>
#include <QTest>
#include <QThreadPool>
#include <QTreeWidget>
#include <QUndoStack>

using namespace camwright;

namespace {

const ObjectKey NetworkKey{ObjectKind::Network, "CANopen"};

Project feederProject()
{
    const auto add = [](Project project, ObjectKey key, ObjectContent content) {
        return project.with(key, std::make_shared<const Object>(Object{key, 0, std::move(content), {}}));
    };
    ControllerSettings controller;
    controller.family = "kinco";
    controller.model = "KS101M-04DX";
    Axis turn;
    turn.number = 2;
    turn.type = AxisType::Rotary;
    turn.mechanicalEquivalent = 45.0;
    Project project = add(Project(), {ObjectKind::Controller, "controller"}, controller);
    project = add(project, NetworkKey, Network{});
    project = add(project, {ObjectKind::Axis, "Feed"}, Axis{});
    project = add(project, {ObjectKind::Axis, "Turn"}, turn);
    return add(project, {ObjectKind::Program, "Main"}, Program{});
}

/// A window's worth of surroundings for one editor.
struct Bench {
    ProjectDocument document;
    ActionCatalogue actions;
    Registry registry;
    QThreadPool pool;
    Context context{document, actions, registry, pool};
    Bench() { document.adopt(feederProject()); }
};

template <class W>
W* child(QWidget& parent, const char* name)
{
    W* found = parent.findChild<W*>(QString::fromLatin1(name));
    if (!found)
        qFatal("no widget %s", name);
    return found;
}

void click(NetworkEditor& editor, const char* button)
{
    QTest::mouseClick(child<QPushButton>(editor, button), Qt::LeftButton);
}

QTreeWidgetItem* root(NetworkEditor& editor)
{
    return child<QTreeWidget>(editor, "networkTree")->topLevelItem(0);
}

} // namespace

class NetworkEditorTest : public QObject {
    Q_OBJECT
private slots:
    void initTestCase() { theme().applyToApplication(); }

    void addGivesTheDefaultsOfTheManualAndTheNextNumber()
    {
        MotionNetworkDraft draft = MotionNetworkDraft::of(feederProject(), NetworkKey);
        const auto index = draft.addAxis();
        const Axis& axis = draft.axes()[index].axis();
        QCOMPARE(axis.number.value(), 3);
        QCOMPARE(draft.axes()[index].object.key.name, std::string("Axis 3 name")); // KS-MCN-03, -08
        QCOMPARE(axis.encoderResolution.value(), 10000);
        QCOMPARE(axis.guardTimeMs.value(), 1000);
        QCOMPARE(axis.lifeFactor.value(), 3);
        QCOMPARE(axis.inhibitTimeMs.value(), 10);
        QCOMPARE(axis.eventTimerMs.value(), 0);
    }

    void pasteIsEqualButForNumberAndName() // KS-MCN-04
    {
        MotionNetworkDraft draft = MotionNetworkDraft::of(feederProject(), NetworkKey);
        const auto index = draft.pasteAxis(draft.axes()[1].object);
        Axis copy = draft.axes()[index].axis();
        QCOMPARE(copy.number.value(), 3);
        copy.number = 2;
        QVERIFY(copy == draft.axes()[1].axis());
        QCOMPARE(draft.axes()[index].object.key.name, std::string("Turn 2"));
    }

    void aGapIsRefusedAndRenumberingMendsIt() // KS-MCN-06
    {
        MotionNetworkDraft draft = MotionNetworkDraft::of(feederProject(), NetworkKey);
        draft.removeAxis(0);
        QVERIFY(hasErrors(draft.problems(feederProject())));
        draft.renumber();
        QVERIFY(!hasErrors(draft.problems(feederProject())));
    }

    void applyIsOneStepAndUndoRestoresTheBytes() // KS-MCN-07
    {
        Bench bench;
        const Project before = bench.document.project();
        MotionNetworkDraft draft = MotionNetworkDraft::of(before, NetworkKey);
        draft.addAxis();
        draft.setName(0, "Strip");
        QVERIFY(draft.apply(bench.document, QStringLiteral("change")));
        const Project after = bench.document.project();
        QCOMPARE(after.objects(ObjectKind::Axis).size(), std::size_t(3));
        QVERIFY(!after.find({ObjectKind::Axis, "Feed"}));
        bench.document.undo();
        QVERIFY(bench.document.project() == before);
        bench.document.redo();
        QVERIFY(bench.document.project() == after);
    }

    void applyingNothingLeavesNoStep()
    {
        Bench bench;
        QVERIFY(!MotionNetworkDraft::of(bench.document.project(), NetworkKey).apply(bench.document, QStringLiteral("change")));
        QCOMPARE(bench.document.undoStack().count(), 0);
    }

    void theListModelIsAProperModel()
    {
        AxisListModel model;
        QAbstractItemModelTester tester(&model, QAbstractItemModelTester::FailureReportingMode::QtTest);
        MotionNetworkDraft draft = MotionNetworkDraft::of(feederProject(), NetworkKey);
        model.setDraft(draft);
        QCOMPARE(model.rowCount(), 2);
        QCOMPARE(model.data(model.index(1, AxisListModel::Travel), Qt::DisplayRole).toString(), QStringLiteral("45°"));
        draft.addAxis();
        model.setDraft(draft);
        QCOMPARE(model.rowCount(), 3);
    }

    void keysAddCopyPasteAndDelete() // KS-MCN-03 to -05
    {
        Bench bench;
        NetworkEditor editor(bench.context, NetworkKey);
        editor.show();
        QVERIFY(QTest::qWaitForWindowActive(&editor));
        child<QTreeWidget>(editor, "networkTree")->setFocus();
        QTest::keyClick(child<QTreeWidget>(editor, "networkTree"), Qt::Key_N, Qt::AltModifier);
        QCOMPARE(root(editor)->childCount(), 3);
        QTest::keyClick(child<QTreeWidget>(editor, "networkTree"), Qt::Key_A, Qt::AltModifier);
        QCOMPARE(root(editor)->childCount(), 4);
        editor.perform(QStringLiteral("edit.copy"));
        editor.perform(QStringLiteral("edit.paste"));
        QCOMPARE(root(editor)->childCount(), 5);
        editor.perform(QStringLiteral("edit.delete"));
        QCOMPARE(root(editor)->childCount(), 4);
        QCOMPARE(bench.document.project().objects(ObjectKind::Axis).size(), std::size_t(2)); // nothing applied yet
    }

    void masterFieldsAreGoneWhileAnAxisIsSelected() // KS-MCN-01
    {
        Bench bench;
        NetworkEditor editor(bench.context, NetworkKey);
        editor.show();
        QVERIFY(child<QComboBox>(editor, "baudrate")->isVisibleTo(&editor));
        child<QTreeWidget>(editor, "networkTree")->setCurrentItem(root(editor)->child(0));
        QVERIFY(!child<QComboBox>(editor, "baudrate")->isVisibleTo(&editor));
        QVERIFY(child<QLineEdit>(editor, "axisName")->isVisibleTo(&editor));
    }

    void cancelDropsWhatCameSinceTheLastApply() // KS-MCN-07
    {
        Bench bench;
        NetworkEditor editor(bench.context, NetworkKey);
        editor.show();
        click(editor, "addAxis");
        click(editor, "applyNetwork");
        QCOMPARE(bench.document.project().objects(ObjectKind::Axis).size(), std::size_t(3));
        click(editor, "addAxis");
        QVERIFY(editor.hasUnapplied());
        click(editor, "cancelNetwork");
        QVERIFY(!editor.hasUnapplied());
        QCOMPARE(bench.document.project().objects(ObjectKind::Axis).size(), std::size_t(3));
    }

    void applyRefusesAGapAndSaysWhy() // KS-MCN-06
    {
        Bench bench;
        NetworkEditor editor(bench.context, NetworkKey);
        editor.show();
        child<QTreeWidget>(editor, "networkTree")->setCurrentItem(root(editor)->child(0));
        click(editor, "deleteAxis");
        click(editor, "applyNetwork");
        QCOMPARE(bench.document.project().objects(ObjectKind::Axis).size(), std::size_t(2));
        QVERIFY(!child<QLabel>(editor, "networkMessage")->text().isEmpty());
        click(editor, "renumberAxes");
        click(editor, "applyNetwork");
        QCOMPARE(bench.document.project().objects(ObjectKind::Axis).size(), std::size_t(1));
    }

    void cancelLeavesNothingThatWantsToBeSaved()
    {
        Bench bench;
        NetworkEditor editor(bench.context, NetworkKey);
        editor.show();
        click(editor, "addAxis");
        QVERIFY(bench.document.isModified());
        QVERIFY(bench.document.draft({ObjectKind::Axis, "Axis 3 name"}));
        click(editor, "cancelNetwork");
        QVERIFY(!bench.document.draft({ObjectKind::Axis, "Axis 3 name"}));
        QVERIFY(!bench.document.isModified());
    }

    void anAxisAddedAndDeletedLeavesNothingThatWantsToBeSaved()
    {
        Bench bench;
        NetworkEditor editor(bench.context, NetworkKey);
        editor.show();
        click(editor, "addAxis");
        click(editor, "deleteAxis");
        QVERIFY(!editor.hasUnapplied());
        QVERIFY(!bench.document.isModified());
    }

    void anAxisRenamedAndAppliedLeavesNoDraft()
    {
        Bench bench;
        NetworkEditor editor(bench.context, NetworkKey);
        editor.show();
        child<QTreeWidget>(editor, "networkTree")->setCurrentItem(root(editor)->child(0));
        auto* name = child<QLineEdit>(editor, "axisName");
        name->setFocus();
        name->selectAll();
        QTest::keyClicks(name, "Strip");
        QTest::keyClick(name, Qt::Key_Return);
        QVERIFY(bench.document.draft({ObjectKind::Axis, "Strip"}));
        click(editor, "applyNetwork");
        for (const char* axis : {"Feed", "Strip", "Turn"})
            QVERIFY(!bench.document.draft({ObjectKind::Axis, axis}));
        QVERIFY(bench.document.object({ObjectKind::Axis, "Strip"}));
        QCOMPARE(bench.document.undoStack().count(), 1);
    }

    void whatAnInterruptedSessionHadNotAppliedStandsInTheWindow() // CONTRACTS 5
    {
        Bench bench;
        Object network = *bench.document.object(NetworkKey), feed = *bench.document.object({ObjectKind::Axis, "Feed"});
        std::get<Network>(network.content).sdoTimeoutMs = Field<std::int64_t>::typed("soon");
        std::get<Axis>(feed.content).guardTimeMs = 77;
        bench.document.setDraft(feed.key, std::make_shared<const Object>(feed));
        bench.document.setDraft(NetworkKey, std::make_shared<const Object>(network));
        NetworkEditor editor(bench.context, NetworkKey);
        QVERIFY(editor.hasUnapplied());
        QCOMPARE(editor.draft().network().sdoTimeoutMs.text(), std::string("soon"));
        QCOMPARE(editor.draft().axes()[0].axis().guardTimeMs.value(), 77);
        QCOMPARE(bench.document.undoStack().count(), 0);
    }

    void aRenamedNetworkStaysTheSame()
    {
        Bench bench;
        NetworkEditor editor(bench.context, NetworkKey);
        editor.show();
        MotionNetworkDraft slow = editor.draft();
        slow.setNetwork(Network{500000, 250});
        slow.apply(bench.document, QStringLiteral("slow"));
        const ObjectKey bus{ObjectKind::Network, "Bus"};
        QVERIFY(renameObject(bench.document, NetworkKey, "Bus").ok());
        editor.setKey(bus);
        QVERIFY(!editor.hasUnapplied());
        QCOMPARE(editor.draft().network().baudrate.value(), 500000);
        click(editor, "addAxis");
        click(editor, "applyNetwork");
        QCOMPARE(bench.document.project().objects(ObjectKind::Network).size(), std::size_t(1));
        QCOMPARE(bench.document.content<Network>(bus)->baudrate.value(), 500000);
    }

    void anIllegalEntryIsKeptAndKeepsApplyBack() // CONTRACTS 3
    {
        Bench bench;
        NetworkEditor editor(bench.context, NetworkKey);
        editor.show();
        QLineEdit* field = child<QuantityField>(editor, "sdo_timeout_ms")->lineEdit();
        field->setFocus();
        field->selectAll();
        QTest::keyClicks(field, "12x");
        QTest::keyClick(field, Qt::Key_Return);
        QCOMPARE(editor.draft().network().sdoTimeoutMs.text(), std::string("12x"));
        click(editor, "applyNetwork");
        QVERIFY(editor.hasUnapplied());
        QCOMPARE(field->text(), QString("12x"));
        QVERIFY(!child<QLabel>(editor, "networkMessage")->text().isEmpty());
        field->setFocus();
        field->selectAll();
        QTest::keyClicks(field, "16#FF");
        QTest::keyClick(field, Qt::Key_Return);
        click(editor, "applyNetwork");
        QCOMPARE(bench.document.content<Network>(NetworkKey)->sdoTimeoutMs.value(), 255);
    }

    void threeAxesAreSeenInALowWindowAndAllColumnsInAUsualOne_data()
    {
        QTest::addColumn<QString>("language");
        for (const QString& language : words::languages())
            QTest::newRow(qPrintable(language)) << language;
    }

    void threeAxesAreSeenInALowWindowAndAllColumnsInAUsualOne()
    {
        QFETCH(QString, language);
        QVERIFY(words::setLanguage(*qApp, language));
        Bench bench;
        NetworkEditor editor(bench.context, NetworkKey);
        editor.show();
        click(editor, "addAxis");
        editor.resize(1204, 480); // with the bottom panel open
        QTest::qWait(1);
        auto* list = child<QTableView>(editor, "axisList");
        QVERIFY(list->viewport()->rect().contains(list->visualRect(list->model()->index(2, 0))));
        QVERIFY(!list->horizontalScrollBar()->isVisible());
        QVERIFY(!list->verticalScrollBar()->isVisible());
        QVERIFY(savePicture(editor, QStringLiteral("network-low-") + language));
        QVERIFY(words::setLanguage(*qApp, QStringLiteral("en")));
        QCOMPARE(list->model()->headerData(AxisListModel::InhibitTime, Qt::Horizontal).toString().count('\n'), 1);
    }

    void aNewBaudRateProposesASdoTimeout()
    {
        Bench bench;
        NetworkEditor editor(bench.context, NetworkKey);
        editor.show();
        auto* rates = child<QComboBox>(editor, "baudrate");
        QTest::keyClick(rates, Qt::Key_Home);
        QVERIFY(editor.draft().network().baudrate.value() < 1000000);
        QVERIFY(editor.draft().network().sdoTimeoutMs.value() >= Network{}.sdoTimeoutMs.value());
    }
};

QTEST_MAIN(NetworkEditorTest)
#include "tst_networkeditor.moc"
