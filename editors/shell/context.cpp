#include "editors/shell/context.h"

#include "editors/words/words.h"

#include <QCoreApplication>
#include <QThreadPool>

namespace camwright {

Context::Context(ProjectDocument& document, ActionCatalogue& actions, Registry& registry, QThreadPool& pool, QObject* parent)
    : QObject(parent), m_document(document), m_actions(actions), m_registry(registry), m_pool(pool)
{
    m_heartbeat.setInterval(20);
    m_heartbeat.setTimerType(Qt::PreciseTimer);
    connect(&m_heartbeat, &QTimer::timeout, this, [this] {
        if (isOnline())
            m_link->heartbeat();
    });
}

Context::~Context()
{
    setLink(nullptr);
}

void Context::setLink(ControllerLink* link)
{
    if (link == m_link)
        return;
    emit linkAboutToChange();
    if (m_link) {
        for (const int token : m_linkTokens)
            m_link->forget(token);
    }
    m_linkTokens.clear();
    m_link = link;
    m_status = {};
    m_programMatches = false;
    m_armed.clear();
    m_heartbeat.stop();
    if (m_link) {
        m_status = m_link->status();
        m_linkTokens.push_back(m_link->onStatus([this](const ControllerStatus& status) {
            m_status = status;
            emit statusChanged(m_status);
        }));
        m_linkTokens.push_back(m_link->onStateChanged([this](LinkState state, const Diagnostic&) { emit linkStateChanged(state); }));
    }
    emit linkChanged();
    emit armedChanged(false);
}

void Context::setProgramMatches(bool matches)
{
    if (m_programMatches == matches)
        return;
    m_programMatches = matches;
    emit programMatchesChanged(matches);
}

void Context::arm(QObject* panel)
{
    if (m_armed.contains(panel))
        return;
    m_armed.insert(panel);
    connect(panel, &QObject::destroyed, this, [this, panel] { disarm(panel); });
    m_heartbeat.start();
    if (isOnline())
        m_link->heartbeat();
    emit armedChanged(true);
}

void Context::disarm(QObject* panel)
{
    if (!m_armed.remove(panel))
        return;
    disconnect(panel, &QObject::destroyed, this, nullptr);
    if (m_armed.isEmpty())
        m_heartbeat.stop();
    emit armedChanged(isArmed());
}

void Context::disarmAll(const QString& why)
{
    const bool wasArmed = isArmed();
    emit disarmRequested();
    const auto left = m_armed;
    for (QObject* panel : left)
        disarm(panel);
    if (wasArmed)
        notify(Severity::Warning, why);
}

void Context::open(const ObjectKey& key, const QString& viewId)
{
    emit openRequested(key, viewId, false);
}

void Context::preview(const ObjectKey& key)
{
    emit openRequested(key, {}, true);
}

void Context::reveal(const Place& place)
{
    emit revealRequested(place);
}

void Context::showPanel(const QString& id)
{
    emit panelRequested(id);
}

void Context::explain(Code code)
{
    emit explainRequested(code);
}

void Context::select(const Selection& selection)
{
    if (selection == m_selection)
        return;
    m_selection = selection;
    emit selectionChanged(m_selection);
}

void Context::findReferences(const Selection& selection)
{
    m_sought = selection;
    emit panelRequested(QStringLiteral("references"));
    emit referencesRequested(selection);
}

void Context::output(const QString& line)
{
    emit outputAdded(line);
}

void Context::notify(Severity severity, const QString& sentence)
{
    emit outputAdded(sentence);
    emit notified(severity, sentence);
}

void Context::notify(const Diagnostic& diagnostic)
{
    notify(diagnostic.severity(), words::sentence(diagnostic));
}

void Context::run(QObject* owner, std::function<void()> work, std::function<void()> done)
{
    // The result travels through the document's thread: `owner` is looked at only there.
    QPointer<QObject> guard(owner);
    QPointer<Context> self(this);
    m_pool.start([work = std::move(work), done = std::move(done), guard, self, receiver = QCoreApplication::instance()] {
        work();
        QMetaObject::invokeMethod(receiver, [done, guard, self] {
            if (guard && self)
                done();
        }, Qt::QueuedConnection);
    });
}

} // namespace camwright
