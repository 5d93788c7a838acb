#pragma once

#include "core/base/result.h"
#include "core/storage/journal.h"
#include "editors/document/projectchange.h"
#include "editors/document/projectedit.h"

#include <QObject>
#include <QString>
#include <QStringList>
#include <QTimer>

#include <map>
#include <memory>
#include <optional>

class QUndoStack;
class QFileSystemWatcher;

namespace camwright {

class ProjectFiles;

enum class SaveOver { Refuse, Allow }; ///< what to do with a file another program changed since it was read

/// The open project of a window: the current snapshot, the steps that led there, where it is saved, what is wrong with it.
/// Views get the project as const; every change is an edit that can be undone without limit, across all editors, and that
/// is in the journal before `push()` returns. Lives on the interface's thread. It exists before a project is open.
class ProjectDocument : public QObject {
    Q_OBJECT
public:
    explicit ProjectDocument(QObject* parent = nullptr);
    ~ProjectDocument() override;

    bool isOpen() const { return m_open; }
    const Project& project() const { return m_project; }
    ObjectPtr object(const ObjectKey& key) const { return m_project.find(key); }
    template <class T>
    const T* content(const ObjectKey& key) const { return m_project.content<T>(key); }

    // --- files. Failures carry diagnostics with file and line; the document stays as it was.
    QString path() const { return m_path; }              ///< the project's folder; empty while never saved
    QString displayName() const;                         ///< the project's name, for titles
    bool isModified() const;
    /// Another Camwright holds the project: edits are possible, saving only under another name.
    bool isReadOnly() const;
    Result<void, Diagnostics> open(const QString& path);
    /// Writes a new project into `path` and opens it.
    Result<void, Diagnostics> create(const Project& project, const QString& path);
    /// A project in memory only, without files and journal, for tests and pictures.
    void adopt(Project project);
    Result<void> save(SaveOver over = SaveOver::Refuse);
    Result<void> saveAs(const QString& path);
    /// Reads the folder again after an outside change; one step that can be undone.
    Result<void, Diagnostics> reload();
    /// The user keeps what stands here; the next save would be refused and offers to write over.
    void keepMine();
    void close();
    /// What opening wants to tell: an interrupted save was finished, a file was set aside.
    const Diagnostics& openingNotes() const { return m_notes; }
    /// Unsaved edits of an interrupted session; offered once after open().
    bool hasRecovery() const { return m_recovery.has_value(); }
    int recoveredSteps() const { return m_recovery ? static_cast<int>(m_recovery->labels.size()) : 0; }
    void acceptRecovery();                               ///< one undoable step
    void dropRecovery();

    // --- edits
    /// Applies and announces an edit. An edit that changes nothing leaves no step and returns false.
    bool push(ProjectEdit edit);
    /// Edits pushed between begin and end become one step.
    void beginGroup(const QString& label);
    void endGroup();
    void closeMerge();                                   ///< the next typing starts a step of its own
    QUndoStack& undoStack() { return *m_stack; }
    void undo();
    void redo();

    // --- pages with Apply and Cancel: what was typed but not applied survives a crash (CONTRACTS 5)
    void setDraft(const ObjectKey& key, ObjectPtr draft); ///< null drops it
    ObjectPtr draft(const ObjectKey& key) const;

    // --- problems, newest live check
    const Diagnostics& diagnostics() const { return m_diagnostics; }
    Diagnostics diagnosticsOf(const ObjectKey& key) const;
    void setDiagnostics(Diagnostics diagnostics);
    int errorCount() const;
    int warningCount() const;

    /// Counts every change of the project; equal numbers mean an equal snapshot.
    quint64 revision() const { return m_revision; }

signals:
    void changed(const camwright::ProjectChange& change);
    void modifiedChanged(bool modified);
    void pathChanged();
    void diagnosticsChanged();
    void draftChanged(const camwright::ObjectKey& key);
    /// Undo or redo moved the project: show this place.
    void revealRequested(const camwright::Place& place);
    void changedOutside(const QStringList& files);
    /// The journal could not be written: edits are safe in memory only.
    void journalFailed(const camwright::Diagnostic& why);

private:
    friend class ProjectStep;
    void apply(const std::vector<Delta>& deltas, const std::set<std::string>& properties, const QString& label);
    void replaceEverything(Project project, const QString& path);
    void startJournal();
    void journal(const QString& label, const Project& before, const ProjectChange& change);
    void journalDone(const Result<void>& result);
    void watch();
    void lookOutside();
    void noteModified();

    Project m_project;
    QString m_path;
    bool m_open = false;
    bool m_wasModified = false;
    quint64 m_revision = 0;
    int m_mergeEpoch = 0;
    std::unique_ptr<QUndoStack> m_stack;
    std::unique_ptr<ProjectFiles> m_files;
    std::unique_ptr<QFileSystemWatcher> m_watcher;
    QTimer m_outsideTimer;                               ///< outside changes come in bursts
    QTimer m_mergeTimer;                                 ///< a pause ends a run of typing
    QTimer m_syncTimer;                                  ///< journal to the disk
    std::optional<JournalContent> m_recovery;
    Diagnostics m_notes;
    std::map<ObjectKey, ObjectPtr> m_drafts;
    Diagnostics m_diagnostics;
};

} // namespace camwright
