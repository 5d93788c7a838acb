#include "editors/document/livechecks.h"

#include "editors/document/projectdocument.h"

#include <QPointer>
#include <QThreadPool>

namespace camwright {

LiveChecks::LiveChecks(ProjectDocument& document, QThreadPool& pool, Check check, QObject* parent)
    : QObject(parent), m_document(document), m_pool(pool), m_check(std::move(check))
{
    m_delay.setSingleShot(true);
    m_delay.setInterval(150);
    connect(&m_delay, &QTimer::timeout, this, &LiveChecks::start);
    connect(&document, &ProjectDocument::changed, this, [this](const ProjectChange& change) {
        if (change.everything)
            ++m_generation;
        m_delay.start();
    });
}

void LiveChecks::checkNow()
{
    m_delay.stop();
    start();
}

void LiveChecks::start()
{
    if (!m_document.isOpen())
        return;
    if (m_running) {
        m_again = true;
        return;
    }
    m_running = true;
    QPointer<LiveChecks> self(this);
    m_pool.start([self, receiver = this->thread(), check = m_check, project = m_document.project(), generation = m_generation] {
        Diagnostics result = check(project);
        // `self` is only looked at on its own thread.
        auto* carrier = new QObject;
        carrier->moveToThread(receiver);
        QMetaObject::invokeMethod(carrier, [self, carrier, generation, result = std::move(result)] {
            if (self)
                self->take(result, generation);
            delete carrier;
        }, Qt::QueuedConnection);
    });
}

void LiveChecks::take(Diagnostics result, quint64 generation)
{
    m_running = false;
    if (generation == m_generation && m_document.isOpen())
        m_document.setDiagnostics(std::move(result));
    if (m_again) {
        m_again = false;
        start();
    }
    emit finished();
}

} // namespace camwright
