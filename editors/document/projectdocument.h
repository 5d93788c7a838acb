#pragma once

#include "core/base/result.h"
#include "editors/document/projectchange.h"
#include "editors/document/projectedit.h"

#include <QObject>
#include <QString>
#include <QStringList>
#include <QTimer>

#include <map>
#include <memory>

class QUndoStack;
class QFileSystemWatcher;

namespace camwright {

class ProjectFiles;

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

    // --- files. Failures carry a diagnostic with file and line; the document stays as it was.
    QString path() const { return m_path; }              ///< the project's folder; empty while never saved
    QString displayName() const;                         ///< the project's name, for titles
    bool isModified() const;
    Result<void> open(const QString& path);
    /// A project made in memory; `path` may be empty until the first save.
    void adopt(Project project, const QString& path = {});
    Result<void> save();
    Result<void> saveAs(const QString& path);
    Result<void> reload();                               ///< reads the folder again; can be undone as one step
    void close();
    /// Objects whose last unsaved edits an interrupted session left behind; offered once after open().
    bool hasRecovery() const { return !m_recovered.empty(); }
    int recoveredObjects() const { return static_cast<int>(m_recovered.size()); }
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
    void apply(const std::vector<Delta>& deltas, const std::set<std::string>& properties);
    void replaceEverything(Project project, const QString& path);
    void watch();
    void outsideChanged();
    void noteModified();

    Project m_project;
    Project m_saved;                                     ///< as the files hold it
    QString m_path;
    bool m_open = false;
    bool m_wasModified = false;
    quint64 m_revision = 0;
    std::unique_ptr<QUndoStack> m_stack;
    std::unique_ptr<ProjectFiles> m_files;
    std::unique_ptr<QFileSystemWatcher> m_watcher;
    QTimer m_outsideTimer;
    QTimer m_mergeTimer;
    int m_mergeEpoch = 0;
    std::vector<Delta> m_recovered;
    std::map<ObjectKey, ObjectPtr> m_drafts;
    Diagnostics m_diagnostics;
};

} // namespace camwright
