#pragma once

#include "core/model/project.h"
#include "core/base/diagnostic.h"

#include <QObject>
#include <QTimer>

#include <functional>

class QThreadPool;

namespace camwright {

class ProjectDocument;

/// Checks the newest snapshot on a worker after each change and puts the result into the document. A change while a check
/// runs starts one more when it ends; an outdated result is shown meanwhile, never a result of another project.
class LiveChecks : public QObject {
    Q_OBJECT
public:
    using Check = std::function<Diagnostics(const Project&)>; ///< called on a thread of `pool`

    LiveChecks(ProjectDocument& document, QThreadPool& pool, Check check, QObject* parent = nullptr);
    void setDelayMs(int milliseconds) { m_delay.setInterval(milliseconds); }
    bool isRunning() const { return m_running || m_delay.isActive(); }
    void checkNow();

signals:
    void finished();

private:
    void start();
    void take(Diagnostics result, quint64 generation);

    ProjectDocument& m_document;
    QThreadPool& m_pool;
    Check m_check;
    QTimer m_delay;
    bool m_running = false;
    bool m_again = false;
    quint64 m_generation = 0; ///< counts projects opened
};

} // namespace camwright
