// The part of the document that speaks to the disk.
#include "editors/document/projectdocument.h"
#include "editors/document/projectfiles.h"
#include "editors/document/projectstep.h"

#include <QDir>
#include <QDirIterator>
#include <QFileSystemWatcher>
#include <QUndoStack>

namespace camwright {

namespace {

std::string utf8(const QString& text)
{
    return text.toStdString();
}

} // namespace

Result<void, Diagnostics> ProjectDocument::open(const QString& path)
{
    const QString folder = QDir(path).absolutePath();
    auto files = std::make_unique<ProjectFiles>();
    auto loaded = openProject(files->system, utf8(folder));
    if (!loaded)
        return loaded.error();
    if (m_path == folder)
        close(); // the lock is ours
    if (auto lock = lockProject(files->system, utf8(folder)))
        files->lock = std::move(*lock);
    files->known = std::move(loaded->files);
    files->saved = loaded->project;
    Diagnostics notes = std::move(loaded->notes);
    std::optional<JournalContent> recovery;
    if (files->lock) {
        auto journal = readJournal(files->system, utf8(folder), files->saved);
        if (!journal)
            notes.push_back(journal.error());
        else if (*journal && (!((*journal)->project == files->saved) || !(*journal)->drafts.empty()))
            recovery = std::move(**journal);
    }
    m_files = std::move(files);
    m_notes = std::move(notes);
    m_recovery = std::move(recovery);
    replaceEverything(loaded->project, folder);
    return {};
}

Result<void, Diagnostics> ProjectDocument::create(const Project& project, const QString& path)
{
    const QString folder = QDir(path).absolutePath();
    PosixFileSystem system;
    QDir().mkpath(folder);
    if (const auto made = createProject(system, utf8(folder), project); !made)
        return Diagnostics{made.error()};
    return open(folder);
}

void ProjectDocument::adopt(Project project)
{
    m_files.reset();
    m_notes.clear();
    m_recovery.reset();
    replaceEverything(std::move(project), {});
}

void ProjectDocument::replaceEverything(Project project, const QString& path)
{
    m_project = std::move(project);
    m_path = path;
    m_open = true;
    ++m_revision;
    m_drafts.clear();
    m_diagnostics.clear();
    m_stack->clear();
    m_wasModified = false;
    watch();
    ProjectChange change;
    change.everything = true;
    change.listChanged = true;
    emit pathChanged();
    emit changed(change);
    emit diagnosticsChanged();
    emit modifiedChanged(false);
}

void ProjectDocument::close()
{
    if (m_files && m_files->lock && !m_recovery)
        journalDone(discardJournal(m_files->system, utf8(m_path)));
    m_files.reset();
    m_recovery.reset();
    m_syncTimer.stop();
    replaceEverything(Project(), {});
    m_open = false;
    emit pathChanged();
}

Result<void> ProjectDocument::save(SaveOver over)
{
    if (!m_files)
        return diagnostic(Code::FileNotFound, {utf8(m_path)});
    if (!m_files->lock)
        return diagnostic(Code::LockHeld, {utf8(m_path)});
    closeMerge();
    std::vector<std::string> finished;
    if (m_files->journal) {
        if (auto rotated = m_files->journal->rotate(m_project); !rotated)
            emit journalFailed(rotated.error());
        finished = m_files->journal->finished();
    }
    auto saved = saveProject(m_files->system, utf8(m_path), m_files->known, m_project,
        over == SaveOver::Allow ? Overwrite::Allow : Overwrite::Refuse, finished);
    if (!saved)
        return saved.error();
    m_files->known = std::move(*saved);
    m_files->saved = m_project;
    if (m_files->journal)
        m_files->journal->forgetFinished();
    m_stack->setClean();
    watch();
    noteModified();
    return {};
}

Result<void> ProjectDocument::saveAs(const QString& path)
{
    const QString folder = QDir(path).absolutePath();
    auto files = std::make_unique<ProjectFiles>();
    QDir().mkpath(folder);
    const Project renamed = m_project.withName(utf8(QDir(folder).dirName()));
    auto known = createProject(files->system, utf8(folder), renamed, m_files ? m_files->known : KnownFiles{});
    if (!known)
        return known.error();
    auto lock = lockProject(files->system, utf8(folder));
    if (!lock)
        return lock.error();
    // The edits now live in the new folder: the old one keeps its last save.
    if (m_files && m_files->lock)
        journalDone(discardJournal(m_files->system, utf8(m_path)));
    files->lock = std::move(*lock);
    files->known = std::move(*known);
    files->saved = renamed;
    m_files = std::move(files);
    m_path = folder;
    closeMerge();
    m_project = renamed;
    ++m_revision;
    m_stack->setClean();
    watch();
    startJournal();
    for (const auto& [key, draft] : m_drafts) {
        if (m_files->journal)
            journalDone(m_files->journal->setDraft(key, draft));
    }
    ProjectChange change;
    change.objects.insert(projectKey());
    emit pathChanged();
    emit changed(change);
    noteModified();
    return {};
}

Result<void, Diagnostics> ProjectDocument::reload()
{
    if (!m_files)
        return {};
    auto loaded = openProject(m_files->system, utf8(m_path));
    if (!loaded)
        return loaded.error();
    m_files->known = std::move(loaded->files);
    m_files->saved = loaded->project;
    push({tr("Reload from disk"), deltasBetween(m_project, loaded->project), {}, {}, {}});
    // The journal stands on the files as they were: begin anew on the files as they are.
    if (m_files->journal) {
        m_files->journal.reset();
        journalDone(discardJournal(m_files->system, utf8(m_path)));
        startJournal();
    }
    m_stack->setClean();
    watch();
    noteModified();
    return {};
}

void ProjectDocument::keepMine()
{
    m_outsideTimer.stop();
    m_stack->resetClean();
    noteModified();
}

void ProjectDocument::watch()
{
    m_watcher.reset();
    if (m_path.isEmpty())
        return;
    m_watcher = std::make_unique<QFileSystemWatcher>();
    QStringList paths{m_path};
    QDirIterator it(m_path, QDir::AllEntries | QDir::NoDotAndDotDot, QDirIterator::Subdirectories);
    while (it.hasNext()) {
        const QString entry = it.next();
        if (!entry.contains(QLatin1String("/."))) // our own folder, version control
            paths << entry;
    }
    m_watcher->addPaths(paths);
    connect(m_watcher.get(), &QFileSystemWatcher::fileChanged, &m_outsideTimer, qOverload<>(&QTimer::start));
    connect(m_watcher.get(), &QFileSystemWatcher::directoryChanged, &m_outsideTimer, qOverload<>(&QTimer::start));
}

void ProjectDocument::lookOutside()
{
    if (!m_files)
        return;
    QStringList files;
    for (const std::string& file : filesChangedOutside(m_files->system, utf8(m_path), m_files->known))
        files << QString::fromStdString(file);
    if (!files.isEmpty())
        emit changedOutside(files);
}

} // namespace camwright
