#include "editors/document/editcommands.h"
#include "editors/document/livechecks.h"
#include "sampleproject.h"

#include "core/storage/objecttext.h"

#include <QSignalSpy>
#include <QThreadPool>
#include <QUndoStack>
#include <QtTest>

#include <array>
#include <random>

using namespace camwright;

namespace {

const ObjectKey Feed{ObjectKind::Axis, "Feed"};
const ObjectKey Turn{ObjectKind::Axis, "Turn"};
const ObjectKey Main{ObjectKind::Program, "Main"};

/// The files the project would have, one after the other.
std::string bytesOf(const Project& project)
{
    std::string out;
    for (const auto& [key, object] : project.all())
        out += fileOf(key, project) + '\n' + toText(*object) + '\n';
    return out;
}

std::string source(const ProjectDocument& document)
{
    return document.content<Program>(Main)->source;
}

void type(ProjectDocument& document, std::size_t offset, const char* text)
{
    for (const char* c = text; *c; ++c)
        editText(document, Main, offset++, 0, std::string(1, *c));
}

} // namespace

class ProjectDocumentTest : public QObject {
    Q_OBJECT

private slots:
    void editAnnouncesWhatItChanged()
    {
        ProjectDocument document;
        document.adopt(sampleProject());
        std::vector<ProjectChange> changes;
        connect(&document, &ProjectDocument::changed, this, [&](const ProjectChange& change) { changes.push_back(change); });
        QVERIFY(editObject<Axis>(document, Feed, "Change guard time", "guard_time_ms", [](Axis& axis) { axis.guardTimeMs = 250; }));
        QCOMPARE(changes.size(), std::size_t(1));
        QVERIFY(changes[0].touches(Feed));
        QVERIFY(!changes[0].touches(Turn));
        QVERIFY(changes[0].touchesProperty("guard_time_ms"));
        QVERIFY(!changes[0].touchesProperty("life_factor"));
        QVERIFY(!changes[0].listChanged);
    }

    void editThatChangesNothingLeavesNoStep()
    {
        ProjectDocument document;
        document.adopt(sampleProject());
        QVERIFY(!editObject<Axis>(document, Feed, "Change guard time", "guard_time_ms", [](Axis& axis) { axis.guardTimeMs = 1000; }));
        QVERIFY(!document.undoStack().canUndo());
    }

    void oneStepChangesManyObjects()
    {
        ProjectDocument document;
        document.adopt(sampleProject());
        const std::array keys{Feed, Turn};
        QVERIFY(editObjects<Axis>(document, keys, "Change life factor", "life_factor", [](Axis& axis) { axis.lifeFactor = 5; }));
        QCOMPARE(document.content<Axis>(Turn)->lifeFactor.value(), 5);
        document.undo();
        QCOMPARE(document.content<Axis>(Feed)->lifeFactor.value(), 3);
        QCOMPARE(document.content<Axis>(Turn)->lifeFactor.value(), 3);
        QVERIFY(!document.undoStack().canUndo());
    }

    void typingMergesUntilTheLineEnds()
    {
        ProjectDocument document;
        document.adopt(sampleProject());
        type(document, 0, "LDN");
        QCOMPARE(document.undoStack().count(), 1);
        type(document, 3, "\n");
        type(document, 4, "ST");
        QCOMPARE(document.undoStack().count(), 3);
        document.undo();
        QCOMPARE(source(document).substr(0, 5), std::string("LDN\nL"));
    }

    void cursorMoveEndsARunOfTyping()
    {
        ProjectDocument document;
        document.adopt(sampleProject());
        type(document, 0, "AB");
        document.closeMerge();
        type(document, 2, "CD");
        QCOMPARE(document.undoStack().count(), 2);
        document.undo();
        QCOMPARE(source(document).substr(0, 3), std::string("ABL"));
    }

    void deletingWhatWasJustTypedUndoesCleanly()
    {
        ProjectDocument document;
        document.adopt(sampleProject());
        const std::string before = source(document);
        type(document, 0, "ABC");
        editText(document, Main, 2, 1, "");
        editText(document, Main, 1, 1, "");
        QCOMPARE(source(document), "A" + before);
        document.undo();
        QCOMPARE(source(document), before);
        document.redo();
        QCOMPARE(source(document), "A" + before);
    }

    void groupIsOneStep()
    {
        ProjectDocument document;
        document.adopt(sampleProject());
        document.beginGroup("Add two axes");
        addObject(document, newObject(document.project(), ObjectKind::Axis));
        addObject(document, newObject(document.project(), ObjectKind::Axis));
        document.endGroup();
        QCOMPARE(document.project().objects(ObjectKind::Axis).size(), std::size_t(4));
        document.undo();
        QCOMPARE(document.project().objects(ObjectKind::Axis).size(), std::size_t(2));
    }

    void undoGoesBackToThePlace()
    {
        ProjectDocument document;
        document.adopt(sampleProject());
        editObject<Axis>(document, Feed, "Change guard time", "guard_time_ms", [](Axis& axis) { axis.guardTimeMs = 250; });
        Place place;
        connect(&document, &ProjectDocument::revealRequested, this, [&](const Place& p) { place = p; });
        document.undo();
        QCOMPARE(place.object.name, std::string("Feed"));
        QCOMPARE(place.field, std::string("guard_time_ms"));
    }

    void duplicatedAxisTakesNextFreeNameAndNumber()
    {
        ProjectDocument document;
        document.adopt(sampleProject());
        const ObjectKey copy = duplicateObject(document, Feed);
        QCOMPARE(copy.name, std::string("Feed2"));
        QCOMPARE(document.content<Axis>(copy)->number.value(), 3);
        QCOMPARE(duplicateObject(document, copy).name, std::string("Feed3"));
    }

    void renameKeepsContentAndOrder()
    {
        ProjectDocument document;
        document.adopt(sampleProject());
        QVERIFY(renameObject(document, Feed, "Infeed").ok());
        QVERIFY(!document.object(Feed));
        const ObjectPtr renamed = document.object({ObjectKind::Axis, "Infeed"});
        QVERIFY(renamed);
        QCOMPARE(renamed->order, 1);
        QCOMPARE(std::get<Axis>(renamed->content).mechanicalEquivalent.value(), 100.0);
        document.undo();
        QVERIFY(document.object(Feed));
    }

    void renameRefusesTakenAndIllegalNames()
    {
        ProjectDocument document;
        document.adopt(sampleProject());
        QVERIFY(renameObject(document, Feed, "turn").error().code == Code::NameTwice);
        QVERIFY(renameObject(document, Feed, "  ").error().code == Code::NameNotIdentifier);
        QVERIFY(renameObject(document, Main, "1st").error().code == Code::NameNotIdentifier);
        QVERIFY(!document.undoStack().canUndo());
    }

    void illegalTextIsKeptAndUndone()
    {
        ProjectDocument document;
        document.adopt(sampleProject());
        editObject<Axis>(document, Feed, "Change guard time", "guard_time_ms",
            [](Axis& axis) { axis.guardTimeMs = Field<std::int64_t>::typed("many"); });
        QCOMPARE(document.content<Axis>(Feed)->guardTimeMs.text(), std::string("many"));
        document.undo();
        QCOMPARE(document.content<Axis>(Feed)->guardTimeMs.value(), 1000);
    }

    void unappliedPageCountsAsUnsaved()
    {
        ProjectDocument document;
        document.adopt(sampleProject());
        QVERIFY(!document.isModified());
        Object draft = *document.object(Feed);
        std::get<Axis>(draft.content).lifeFactor = 9;
        document.setDraft(Feed, std::make_shared<const Object>(draft));
        QVERIFY(document.isModified());
        document.setDraft(Feed, nullptr);
        QVERIFY(!document.isModified());
    }

    /// Any edits, all undone, all redone, give the same bytes at both ends, and each step its own.
    void thousandRandomStepsUndoAndRedo()
    {
        ProjectDocument document;
        document.adopt(sampleProject());
        std::mt19937 random(20261122);
        std::vector<std::string> states{bytesOf(document.project())};
        int made = 0;
        while (made < 1000) {
            const int stepsBefore = document.undoStack().count();
            randomEdit(document, random);
            document.closeMerge();
            if (document.undoStack().count() == stepsBefore)
                continue;
            states.push_back(bytesOf(document.project()));
            ++made;
        }
        QCOMPARE(document.undoStack().count(), 1000);
        for (int i = 1000; i-- > 0;) {
            document.undo();
            QVERIFY2(bytesOf(document.project()) == states[std::size_t(i)], qPrintable(QString("undo to step %1").arg(i)));
        }
        QVERIFY(document.project() == sampleProject());
        for (std::size_t i = 1; i <= 1000; ++i) {
            document.redo();
            QVERIFY2(bytesOf(document.project()) == states[i], qPrintable(QString("redo to step %1").arg(i)));
        }
    }

    void liveChecksPublishTheNewestResult()
    {
        ProjectDocument document;
        QThreadPool pool;
        LiveChecks checks(document, pool, [](const Project& project) {
            Diagnostics out;
            for (const ObjectPtr& object : project.objects(ObjectKind::Axis))
                out.push_back(diagnostic(Code::NameTwice, {object->key.name}, Place{object->key, {}, {}, {}}));
            return out;
        });
        checks.setDelayMs(0);
        QSignalSpy finished(&checks, &LiveChecks::finished);
        document.adopt(sampleProject());
        addObject(document, newObject(document.project(), ObjectKind::Axis));
        QTRY_COMPARE(document.diagnostics().size(), std::size_t(3));
        QCOMPARE(document.errorCount(), 3);
        QCOMPARE(document.diagnosticsOf(Feed).size(), std::size_t(1));
        QTRY_VERIFY(!checks.isRunning());
        pool.waitForDone();
    }

private:
    static void randomEdit(ProjectDocument& document, std::mt19937& random)
    {
        const auto pick = [&random](std::size_t count) { return std::size_t(random() % count); };
        const auto programs = document.project().objects(ObjectKind::Program);
        const auto axes = document.project().objects(ObjectKind::Axis);
        switch (pick(8)) {
        case 0:
            if (axes.size() < 12)
                addObject(document, newObject(document.project(), ObjectKind::Axis));
            break;
        case 1:
            if (!axes.empty())
                duplicateObject(document, axes[pick(axes.size())]->key);
            break;
        case 2:
            if (axes.size() > 1)
                removeObjects(document, std::array{axes[pick(axes.size())]->key});
            break;
        case 3:
            if (!axes.empty())
                (void)renameObject(document, axes[pick(axes.size())]->key, "Axis" + std::to_string(random() % 40));
            break;
        case 4:
            if (!axes.empty())
                editObject<Axis>(document, axes[pick(axes.size())]->key, "Change", "inhibit_time_ms", [&](Axis& axis) {
                    axis.inhibitTimeMs = random() % 5 ? Field<std::int64_t>(std::int64_t(random() % 1000)) : Field<std::int64_t>::typed("x1");
                });
            break;
        case 5:
            editObject<VariableTable>(document, {ObjectKind::VariableTable, "Globals"}, "Change", "rows", [&](VariableTable& table) {
                const std::size_t row = pick(table.rowCount() + 1);
                table = table.replaced(row, row < table.rowCount() ? random() % 2 : 0,
                    {{"V" + std::to_string(random() % 1000), DataType::Int, "%VW" + std::to_string(random() % 100 * 2), "", false, "c"}});
            });
            break;
        default: {
            const ObjectKey key = programs[pick(programs.size())]->key;
            const std::size_t size = document.content<Program>(key)->source.size();
            const std::size_t at = pick(size + 1);
            editText(document, key, at, random() % 3 ? 0 : std::min<std::size_t>(size - at, random() % 6), random() % 4 ? "AND %M0.1\n" : "");
            break;
        }
        }
    }
};

QTEST_GUILESS_MAIN(ProjectDocumentTest)
#include "tst_projectdocument.moc"
