#pragma once

#include "app/window/services.h"

#include <QObject>
#include <QTimer>

#include <atomic>

namespace camwright {

class Context;

/// Checks and builds on the pool, remembers the newest build, and tells whether the controller runs the same program.
class Workbench : public QObject {
    Q_OBJECT
public:
    Workbench(Context& context, Services& services, QObject* parent = nullptr);

    bool isBusy() const { return m_job != nullptr; }
    bool isBuilt() const;                       ///< the project as it stands was built without errors
    /// The user asked for it: tells the outcome in Output and calls `done` with the package, if there is one.
    void build(std::function<void(const DownloadPackage&)> done = {});
    void check();
    void cancel();

signals:
    void busyChanged(bool busy);
    void builtChanged();

private:
    void start(bool asked, std::function<void(const DownloadPackage&)> done);
    void take(BuildOutcome outcome, quint64 revision, bool asked, const std::function<void(const DownloadPackage&)>& done);
    void compare();

    Context& m_context;
    Services& m_services;
    std::shared_ptr<Job> m_job;                 ///< of a build the user waits for
    QTimer m_quiet;                             ///< background build while online, for the comparison
    bool m_background = false;
    quint64 m_builtRevision = ~quint64(0);
    Hash m_builtHash{};
};

} // namespace camwright
