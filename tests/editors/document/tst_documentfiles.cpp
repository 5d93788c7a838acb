#include "editors/document/editcommands.h"
#include "sampleproject.h"

#include <QSignalSpy>
#include <QTemporaryDir>
#include <QUndoStack>
#include <QtTest>

using namespace camwright;

namespace {

const ObjectKey Feed{ObjectKind::Axis, "Feed"};

QMap<QString, QByteArray> filesIn(const QString& folder)
{
    QMap<QString, QByteArray> out;
    QDirIterator it(folder, QDir::Files, QDirIterator::Subdirectories);
    while (it.hasNext()) {
        QFile file(it.next());
        if (file.open(QIODevice::ReadOnly))
            out.insert(QDir(folder).relativeFilePath(file.fileName()), file.readAll());
    }
    return out;
}

void setGuardTime(ProjectDocument& document, std::int64_t milliseconds)
{
    editObject<Axis>(document, Feed, "Change guard time", "guard_time_ms", [=](Axis& axis) { axis.guardTimeMs = milliseconds; });
}

} // namespace

class DocumentFilesTest : public QObject {
    Q_OBJECT

private slots:
    void savedProjectOpensEqual()
    {
        QTemporaryDir dir;
        ProjectDocument document;
        QVERIFY(document.create(sampleProject(), dir.filePath("p")).ok());
        setGuardTime(document, 250);
        QVERIFY(document.isModified());
        QVERIFY(document.save().ok());
        QVERIFY(!document.isModified());
        const Project kept = document.project();
        document.close();
        QVERIFY(document.open(dir.filePath("p")).ok());
        QVERIFY(document.project() == kept);
        QVERIFY(!document.hasRecovery());
    }

    void undoAcrossASaveIsPossible()
    {
        QTemporaryDir dir;
        ProjectDocument document;
        QVERIFY(document.create(sampleProject(), dir.filePath("p")).ok());
        setGuardTime(document, 250);
        QVERIFY(document.save().ok());
        document.undo();
        QVERIFY(document.isModified());
        QCOMPARE(document.content<Axis>(Feed)->guardTimeMs.value(), 1000);
    }

    void unsavedEditsAreOfferedAfterACrash()
    {
        QTemporaryDir dir;
        {
            ProjectDocument crashed;
            QVERIFY(crashed.create(sampleProject(), dir.filePath("p")).ok());
            setGuardTime(crashed, 250);
            editText(crashed, {ObjectKind::Program, "Main"}, 0, 0, "LDN");
            Object draft = *crashed.object(Feed);
            std::get<Axis>(draft.content).lifeFactor = 9;
            crashed.setDraft(Feed, std::make_shared<const Object>(draft));
        } // no close(), no save()
        ProjectDocument document;
        QVERIFY(document.open(dir.filePath("p")).ok());
        QVERIFY(document.hasRecovery());
        QCOMPARE(document.content<Axis>(Feed)->guardTimeMs.value(), 1000);
        document.acceptRecovery();
        QCOMPARE(document.content<Axis>(Feed)->guardTimeMs.value(), 250);
        QVERIFY(document.content<Program>({ObjectKind::Program, "Main"})->source.starts_with("LDN"));
        QVERIFY(document.draft(Feed));
        QVERIFY(document.isModified());
        document.undo();
        QCOMPARE(document.content<Axis>(Feed)->guardTimeMs.value(), 1000);
    }

    void recoveredEditsSurviveASecondCrash()
    {
        QTemporaryDir dir;
        {
            ProjectDocument crashed;
            QVERIFY(crashed.create(sampleProject(), dir.filePath("p")).ok());
            setGuardTime(crashed, 250);
        }
        {
            ProjectDocument crashed;
            QVERIFY(crashed.open(dir.filePath("p")).ok());
            crashed.acceptRecovery();
        }
        ProjectDocument document;
        QVERIFY(document.open(dir.filePath("p")).ok());
        QVERIFY(document.hasRecovery());
        document.acceptRecovery();
        QCOMPARE(document.content<Axis>(Feed)->guardTimeMs.value(), 250);
    }

    void refusedRecoveryIsNotOfferedAgain()
    {
        QTemporaryDir dir;
        {
            ProjectDocument crashed;
            QVERIFY(crashed.create(sampleProject(), dir.filePath("p")).ok());
            setGuardTime(crashed, 250);
        }
        {
            ProjectDocument document;
            QVERIFY(document.open(dir.filePath("p")).ok());
            document.dropRecovery();
        }
        ProjectDocument document;
        QVERIFY(document.open(dir.filePath("p")).ok());
        QVERIFY(!document.hasRecovery());
    }

    void saveAsLeavesTheOldFolderAsItWasSaved()
    {
        QTemporaryDir dir;
        ProjectDocument document;
        QVERIFY(document.create(sampleProject(), dir.filePath("p")).ok());
        const auto before = filesIn(dir.filePath("p"));
        setGuardTime(document, 250);
        QVERIFY(document.saveAs(dir.filePath("q")).ok());
        QCOMPARE(document.displayName(), QString("q"));
        QVERIFY(!document.isModified());
        document.close();
        auto after = filesIn(dir.filePath("p"));
        after.removeIf([](auto it) { return it.key().startsWith(".camwright"); });
        auto expected = before;
        expected.removeIf([](auto it) { return it.key().startsWith(".camwright"); });
        QCOMPARE(after, expected);
        QVERIFY(document.open(dir.filePath("q")).ok());
        QCOMPARE(document.content<Axis>(Feed)->guardTimeMs.value(), 250);
    }

    void changeByAnotherProgramIsAnnouncedAndReloaded()
    {
        QTemporaryDir dir;
        ProjectDocument document;
        QVERIFY(document.create(sampleProject(), dir.filePath("p")).ok());
        QSignalSpy outside(&document, &ProjectDocument::changedOutside);
        QFile file(dir.filePath("p/programs/Main.il"));
        QVERIFY(file.open(QIODevice::ReadWrite));
        QByteArray text = file.readAll();
        text.replace("LD %I0.0", "LDN %I0.0");
        file.resize(0);
        file.seek(0);
        file.write(text);
        file.close();
        QTRY_VERIFY_WITH_TIMEOUT(!outside.isEmpty(), 5000);
        QCOMPARE(outside.first().first().toStringList(), QStringList{"programs/Main.il"});
        QVERIFY(document.reload().ok());
        QVERIFY(document.content<Program>({ObjectKind::Program, "Main"})->source.starts_with("LDN %I0.0"));
        QVERIFY(!document.isModified());
    }

    void ownSaveIsNotAnOutsideChange()
    {
        QTemporaryDir dir;
        ProjectDocument document;
        QVERIFY(document.create(sampleProject(), dir.filePath("p")).ok());
        QSignalSpy outside(&document, &ProjectDocument::changedOutside);
        setGuardTime(document, 250);
        QVERIFY(document.save().ok());
        QTest::qWait(600); // longer than the watcher gathers changes
        QVERIFY(outside.isEmpty());
    }

    void brokenProjectLeavesTheOpenOneAlone()
    {
        QTemporaryDir dir;
        ProjectDocument document;
        QVERIFY(document.create(sampleProject(), dir.filePath("p")).ok());
        QDir().mkpath(dir.filePath("broken"));
        QFile file(dir.filePath("broken/project.toml"));
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write("format = 99\n");
        file.close();
        const auto result = document.open(dir.filePath("broken"));
        QVERIFY(!result.ok());
        QVERIFY(result.error().front().code == Code::NewerFormat);
        QCOMPARE(document.displayName(), QString("sample"));
    }

    void secondWindowOpensReadOnly()
    {
        QTemporaryDir dir;
        ProjectDocument first;
        QVERIFY(first.create(sampleProject(), dir.filePath("p")).ok());
        ProjectDocument second;
        QVERIFY(second.open(dir.filePath("p")).ok());
        QVERIFY(second.isReadOnly());
        setGuardTime(second, 250);
        QVERIFY(second.save().error().code == Code::LockHeld);
    }
};

QTEST_GUILESS_MAIN(DocumentFilesTest)
#include "tst_documentfiles.moc"
