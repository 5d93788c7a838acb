#include "editors/document/projectdocument.h"

#include "editors/document/projectfiles.h"
#include "editors/document/projectstep.h"

#include <QDir>
#include <QFileInfo>
#include <QFileSystemWatcher>
#include <QUndoStack>

#include <algorithm>

namespace camwright {

namespace {

constexpr int MergePauseMs = 1000;
constexpr int JournalSyncMs = 1500; // a power cut may lose 2 s at most
constexpr int OutsideQuietMs = 300;

std::string utf8(const QString& text)
{
    return text.toStdString();
}

} // namespace

ProjectDocument::ProjectDocument(QObject* parent) : QObject(parent), m_stack(std::make_unique<QUndoStack>())
{
    m_mergeTimer.setSingleShot(true);
    m_mergeTimer.setInterval(MergePauseMs);
    connect(&m_mergeTimer, &QTimer::timeout, this, &ProjectDocument::closeMerge);
    m_syncTimer.setSingleShot(true);
    m_syncTimer.setInterval(JournalSyncMs);
    connect(&m_syncTimer, &QTimer::timeout, this, [this] {
        if (m_files && m_files->journal)
            journalDone(m_files->journal->sync());
    });
    m_outsideTimer.setSingleShot(true);
    m_outsideTimer.setInterval(OutsideQuietMs);
    connect(&m_outsideTimer, &QTimer::timeout, this, &ProjectDocument::lookOutside);
    connect(m_stack.get(), &QUndoStack::cleanChanged, this, &ProjectDocument::noteModified);
}

ProjectDocument::~ProjectDocument() = default;

QString ProjectDocument::displayName() const
{
    const std::string_view name = m_project.name();
    if (!name.empty())
        return QString::fromUtf8(name.data(), qsizetype(name.size()));
    return QFileInfo(m_path).fileName();
}

bool ProjectDocument::isModified() const
{
    return m_open && (!m_stack->isClean() || !m_drafts.empty());
}

bool ProjectDocument::isReadOnly() const
{
    return m_open && m_files && !m_files->lock;
}

// --- edits

bool ProjectDocument::push(ProjectEdit edit)
{
    edit.deltas = withoutNoise(std::move(edit.deltas));
    if (edit.deltas.empty())
        return false;
    const bool merging = !edit.mergeKey.isEmpty();
    if (!merging)
        closeMerge();
    m_stack->push(new ProjectStep(*this, std::move(edit), m_mergeEpoch));
    if (merging)
        m_mergeTimer.start();
    return true;
}

void ProjectDocument::beginGroup(const QString& label)
{
    closeMerge();
    m_stack->beginMacro(label);
}

void ProjectDocument::endGroup()
{
    m_stack->endMacro();
    closeMerge();
}

void ProjectDocument::closeMerge()
{
    ++m_mergeEpoch;
    m_mergeTimer.stop();
}

void ProjectDocument::undo()
{
    closeMerge();
    const Place place = placeOf(m_stack->command(m_stack->index() - 1));
    m_stack->undo();
    emit revealRequested(place);
}

void ProjectDocument::redo()
{
    closeMerge();
    const Place place = placeOf(m_stack->command(m_stack->index()));
    m_stack->redo();
    emit revealRequested(place);
}

void ProjectDocument::apply(const std::vector<Delta>& deltas, const std::set<std::string>& properties, const QString& label)
{
    const Project before = m_project;
    const ProjectChange change = changeOf(deltas, properties);
    m_project = applied(m_project, deltas);
    ++m_revision;
    journal(label, before, change);
    emit changed(change);
    noteModified();
}

void ProjectDocument::noteModified()
{
    const bool modified = isModified();
    if (modified == m_wasModified)
        return;
    m_wasModified = modified;
    emit modifiedChanged(modified);
}

// --- journal

void ProjectDocument::startJournal()
{
    if (!m_files || !m_files->lock || m_files->journal)
        return;
    auto journal = Journal::begin(m_files->system, utf8(m_path), m_files->saved);
    if (journal)
        m_files->journal = std::move(*journal);
    else
        emit journalFailed(journal.error());
}

void ProjectDocument::journal(const QString& label, const Project& before, const ProjectChange& change)
{
    startJournal();
    if (!m_files || !m_files->journal)
        return;
    std::vector<ObjectDelta> deltas;
    for (const ObjectKey& key : change.objects)
        deltas.push_back({key, before.find(key), m_project.find(key)});
    journalDone(m_files->journal->append(utf8(label), deltas));
    if (!m_syncTimer.isActive())
        m_syncTimer.start();
}

void ProjectDocument::journalDone(const Result<void>& result)
{
    if (!result)
        emit journalFailed(result.error());
}

void ProjectDocument::setDraft(const ObjectKey& key, ObjectPtr draft)
{
    const ObjectPtr old = this->draft(key);
    if (old == draft || (old && draft && *old == *draft))
        return;
    if (draft)
        m_drafts[key] = draft;
    else
        m_drafts.erase(key);
    startJournal();
    if (m_files && m_files->journal) {
        journalDone(m_files->journal->setDraft(key, draft));
        if (!m_syncTimer.isActive())
            m_syncTimer.start();
    }
    emit draftChanged(key);
    noteModified();
}

ObjectPtr ProjectDocument::draft(const ObjectKey& key) const
{
    const auto it = m_drafts.find(key);
    return it == m_drafts.end() ? nullptr : it->second;
}

void ProjectDocument::acceptRecovery()
{
    if (!m_recovery)
        return;
    const JournalContent content = std::move(*m_recovery);
    dropRecovery();
    push({tr("Restore unsaved edits"), deltasBetween(m_project, content.project), {}, {}, {}});
    for (const auto& [key, draft] : content.drafts)
        setDraft(key, draft);
}

void ProjectDocument::dropRecovery()
{
    m_recovery.reset();
    if (m_files && m_files->lock && !m_files->journal)
        journalDone(discardJournal(m_files->system, utf8(m_path)));
}

// --- problems

void ProjectDocument::setDiagnostics(Diagnostics diagnostics)
{
    if (diagnostics == m_diagnostics)
        return;
    m_diagnostics = std::move(diagnostics);
    emit diagnosticsChanged();
}

Diagnostics ProjectDocument::diagnosticsOf(const ObjectKey& key) const
{
    Diagnostics out;
    std::copy_if(m_diagnostics.begin(), m_diagnostics.end(), std::back_inserter(out),
        [&](const Diagnostic& diagnostic) { return diagnostic.place.object == key; });
    return out;
}

int ProjectDocument::errorCount() const
{
    return int(std::count_if(m_diagnostics.begin(), m_diagnostics.end(),
        [](const Diagnostic& diagnostic) { return diagnostic.severity() == Severity::Error; }));
}

int ProjectDocument::warningCount() const
{
    return int(std::count_if(m_diagnostics.begin(), m_diagnostics.end(),
        [](const Diagnostic& diagnostic) { return diagnostic.severity() == Severity::Warning; }));
}

} // namespace camwright
