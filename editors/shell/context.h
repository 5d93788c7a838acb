#pragma once

#include "core/online/controllerlink.h"
#include "editors/document/projectdocument.h"

#include <QObject>
#include <QPointer>
#include <QSet>
#include <QTimer>

#include <functional>
#include <memory>

class QThreadPool;

namespace camwright {

class ActionCatalogue;
class Registry;

/// What every view follows: the object or symbol the user points at.
struct Selection {
    Place place;            ///< object, field, range
    QString symbol;         ///< variable, address or axis value under it, may be empty
    bool operator==(const Selection&) const = default;
};

/// What an editor or a panel gets: the document, the link, the ways to navigate. One per window; outlives its views.
/// All of it on the interface's thread.
class Context : public QObject {
    Q_OBJECT
public:
    Context(ProjectDocument& document, ActionCatalogue& actions, Registry& registry, QThreadPool& pool, QObject* parent = nullptr);
    ~Context() override;

    ProjectDocument& document() const { return m_document; }
    ActionCatalogue& actions() const { return m_actions; }
    Registry& registry() const { return m_registry; }

    // --- the controller
    /// Null while offline. Changes are announced by linkAboutToChange (the old one can still be called: forget listeners,
    /// cancel requests) and linkChanged.
    ControllerLink* link() const { return m_link; }
    bool isOnline() const { return m_link && m_link->state() == LinkState::Online; }
    /// The newest status; a default one while offline.
    const ControllerStatus& status() const { return m_status; }
    /// Whether the controller runs the program of this project; live values are off otherwise, with one sentence.
    bool programMatches() const { return m_programMatches; }
    void setLink(ControllerLink* link);                  ///< the window's
    void setProgramMatches(bool matches);                ///< the window's

    // --- dead-man (CONTRACTS 19): while any panel is armed, link()->heartbeat() is called every 20 ms from this thread.
    void arm(QObject* panel);
    void disarm(QObject* panel);
    bool isArmed() const { return !m_armed.isEmpty(); }
    /// The user is no longer there: every armed panel stops what it moves and disarms, and the heartbeat ends whatever they do.
    /// `why` is told if one was armed.
    void disarmAll(const QString& why);

    // --- navigation
    void open(const ObjectKey& key, const QString& viewId = {});
    void preview(const ObjectKey& key);                  ///< a tab that the next preview replaces
    void reveal(const Place& place);                     ///< opens the object and marks the place
    void showPanel(const QString& id);
    void explain(Code code);                             ///< shows the page about a message
    const Selection& selection() const { return m_selection; }
    void select(const Selection& selection);
    /// Lists where the thing at a place, or of a name, is used. The place says it where it is in a program; else the symbol.
    void findReferences(const Selection& selection);
    const Selection& sought() const { return m_sought; } ///< what references were asked for last; empty at first

    // --- saying things. Nothing here blocks.
    void output(const QString& line);                    ///< the Output panel
    void notify(Severity severity, const QString& sentence); ///< a bar above the status bar, and Output
    void notify(const Diagnostic& diagnostic);

    /// Runs `work` on the window's pool and `done` on this thread; `done` is not called if `owner` is gone by then.
    template <class Result>
    void runInBackground(QObject* owner, std::function<Result()> work, std::function<void(Result)> done)
    {
        auto result = std::make_shared<std::optional<Result>>();
        run(owner, [work = std::move(work), result] { result->emplace(work()); },
            [done = std::move(done), result] { done(std::move(**result)); });
    }

signals:
    void linkAboutToChange();
    void linkChanged();
    void linkStateChanged(camwright::LinkState state);
    void statusChanged(const camwright::ControllerStatus& status);
    void programMatchesChanged(bool matches);
    void armedChanged(bool armed);
    void disarmRequested();                              ///< to panels that are armed or about to be
    void selectionChanged(const camwright::Selection& selection);
    void referencesRequested(const camwright::Selection& selection);

    void openRequested(const camwright::ObjectKey& key, const QString& viewId, bool preview);
    void revealRequested(const camwright::Place& place);
    void panelRequested(const QString& id);
    void explainRequested(camwright::Code code);
    void outputAdded(const QString& line);
    void notified(camwright::Severity severity, const QString& sentence);

private:
    void run(QObject* owner, std::function<void()> work, std::function<void()> done);

    ProjectDocument& m_document;
    ActionCatalogue& m_actions;
    Registry& m_registry;
    QThreadPool& m_pool;
    ControllerLink* m_link = nullptr;
    std::vector<int> m_linkTokens;
    ControllerStatus m_status;
    bool m_programMatches = false;
    QSet<QObject*> m_armed;
    QTimer m_heartbeat;
    Selection m_selection;
    Selection m_sought;
};

} // namespace camwright
