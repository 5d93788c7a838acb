#include "editors/document/editcommands.h"
#include "editors/document/problemsmodel.h"
#include "editors/document/projecttreemodel.h"
#include "sampleproject.h"

#include <QAbstractItemModelTester>
#include <QSignalSpy>
#include <QtTest>

using namespace camwright;

namespace {

const ObjectKey Feed{ObjectKind::Axis, "Feed"};

QStringList namesUnder(const QAbstractItemModel& model, const QModelIndex& parent)
{
    QStringList out;
    for (int i = 0; i < model.rowCount(parent); ++i)
        out << model.index(i, 0, parent).data().toString();
    return out;
}

} // namespace

class DocumentModelsTest : public QObject {
    Q_OBJECT

private slots:
    void treeShowsSectionsAndObjects()
    {
        ProjectDocument document;
        ProjectTreeModel model(document);
        QAbstractItemModelTester tester(&model, QAbstractItemModelTester::FailureReportingMode::QtTest);
        document.adopt(sampleProject());
        QCOMPARE(namesUnder(model, {}), QStringList({"Controller", "Axes", "Networks", "Programs", "Variables", "Watch lists"}));
        QCOMPARE(namesUnder(model, model.index(1, 0)), QStringList({"Feed", "Turn"}));
        QCOMPARE(model.index(0, 0).data(ProjectTreeModel::DetailRole).toString(), QString("KS101M-04DX"));
        QCOMPARE(model.index(1, 0).data(ProjectTreeModel::DetailRole).toString(), QString("2"));
    }

    void treeFollowsAddRemoveRenameUndo()
    {
        ProjectDocument document;
        ProjectTreeModel model(document);
        QAbstractItemModelTester tester(&model, QAbstractItemModelTester::FailureReportingMode::QtTest);
        document.adopt(sampleProject());
        const QModelIndex axes = model.index(1, 0);
        const QPersistentModelIndex turn = model.indexOf({ObjectKind::Axis, "Turn"});
        duplicateObject(document, Feed);
        QCOMPARE(namesUnder(model, axes), QStringList({"Feed", "Turn", "Feed2"}));
        QVERIFY(renameObject(document, Feed, "Infeed").ok());
        QCOMPARE(namesUnder(model, axes), QStringList({"Infeed", "Turn", "Feed2"}));
        QVERIFY(turn.isValid());
        document.undo();
        document.undo();
        QCOMPARE(namesUnder(model, axes), QStringList({"Feed", "Turn"}));
        QCOMPARE(turn.data().toString(), QString("Turn"));
        document.close();
        QCOMPARE(model.rowCount(axes), 0);
    }

    void editingANameRenames()
    {
        ProjectDocument document;
        ProjectTreeModel model(document);
        document.adopt(sampleProject());
        QVERIFY(model.setData(model.indexOf(Feed), "Infeed"));
        QVERIFY(document.object({ObjectKind::Axis, "Infeed"}));
        int refused = 0;
        connect(&model, &ProjectTreeModel::renameRefused, this, [&] { ++refused; });
        QVERIFY(!model.setData(model.indexOf({ObjectKind::Axis, "Infeed"}), "Turn"));
        QCOMPARE(refused, 1);
    }

    void treeTellsTheWorstProblem()
    {
        ProjectDocument document;
        ProjectTreeModel model(document);
        document.adopt(sampleProject());
        QCOMPARE(model.indexOf(Feed).data(ProjectTreeModel::ProblemRole).toInt(), -1);
        document.setDiagnostics({diagnostic(Code::NameTwice, {"Feed"}, Place{Feed, {}, {}, {}}),
            diagnostic(Code::AddressShared, {"a", "b", "c"}, Place{Feed, {}, {}, {}})});
        QCOMPARE(model.indexOf(Feed).data(ProjectTreeModel::ProblemRole).toInt(), int(Severity::Error));
        QCOMPARE(model.indexOf(Feed).data(ProjectTreeModel::ProblemCountRole).toInt(), 2);
    }

    void problemsAreSortedErrorsFirst()
    {
        ProjectDocument document;
        ProblemsModel model(document);
        QAbstractItemModelTester tester(&model, QAbstractItemModelTester::FailureReportingMode::QtTest);
        document.adopt(sampleProject());
        document.setDiagnostics({diagnostic(Code::AddressShared, {"a", "b", "%M0.0"}, Place{Feed, {}, {}, {}}),
            diagnostic(Code::NameTwice, {"Feed"}, Place{Feed, "name", {}, {}})});
        QCOMPARE(model.rowCount(), 2);
        QCOMPARE(model.index(0, ProblemsModel::CodeColumn).data().toString(), QString("CW1112"));
        QVERIFY(model.index(0, 0).data().toString().contains("\"Feed\""));
        QCOMPARE(model.index(0, ProblemsModel::PlaceColumn).data().toString(), QString("Feed, name"));
    }
};

QTEST_GUILESS_MAIN(DocumentModelsTest)
#include "tst_documentmodels.moc"
