#include "app/window/screenshots.h"

#include "app/window/mainwindow.h"

#include <QApplication>
#include <QDir>

namespace camwright {

namespace {

constexpr int StepMs = 250;
constexpr int LongestWaitMs = 10000;

} // namespace

Screenshots::Screenshots(Workspace& workspace, MainWindow& window, const QString& directory)
    : m_workspace(workspace), m_window(window), m_directory(directory)
{
    QDir().mkpath(directory);
    m_wait.setInterval(StepMs);
    connect(&m_wait, &QTimer::timeout, this, [this] {
        m_waited += StepMs;
        const bool connecting = m_workspace.connection.state() != LinkState::Offline
            && !(m_workspace.context.isOnline() && m_workspace.context.status().state == RunState::Run && m_workspace.context.programMatches());
        if ((connecting || m_workspace.checks.isRunning() || m_waited < 4 * StepMs) && m_waited < LongestWaitMs)
            return;
        m_wait.stop();
        take();
    });
}

void Screenshots::saveStartPage(MainWindow& window, const QString& directory)
{
    QDir().mkpath(directory);
    const Theme::Kind first = theme().kind();
    for (const Theme::Kind kind : {Theme::Kind::Light, Theme::Kind::Dark}) {
        theme().setKind(kind);
        QApplication::processEvents(QEventLoop::ExcludeUserInputEvents, 100);
        window.grab().save(QDir(directory).filePath(kind == Theme::Kind::Dark ? QStringLiteral("start-dark.png") : QStringLiteral("start-light.png")));
    }
    theme().setKind(first);
}

void Screenshots::start()
{
    m_wait.start();
}

void Screenshots::grab(const QString& name)
{
    QApplication::sendPostedEvents();
    QApplication::processEvents(QEventLoop::ExcludeUserInputEvents, 100);
    const QString path = QDir(m_directory).filePath(name + QStringLiteral(".png"));
    m_saved = m_window.grab().save(path) && m_saved;
}

void Screenshots::take()
{
    const Theme::Kind first = theme().kind();
    for (const Theme::Kind kind : {Theme::Kind::Light, Theme::Kind::Dark}) {
        theme().setKind(kind);
        const QString suffix = kind == Theme::Kind::Dark ? QStringLiteral("-dark") : QStringLiteral("-light");
        if (!m_workspace.document.isOpen()) {
            grab(QStringLiteral("start") + suffix);
            continue;
        }
        m_window.setLayoutPreset(Layout::Program);
        for (const EditorFactory& factory : m_workspace.registry.editors()) {
            const auto objects = m_workspace.document.project().objects(factory.kind);
            if (objects.empty())
                continue;
            m_workspace.context.open(objects.front()->key, factory.viewId);
            grab(factory.viewId + suffix);
        }
        for (const PanelFactory& factory : m_workspace.registry.panels()) {
            if (factory.area == PanelArea::Left)
                continue;
            m_window.showPanel(factory.id);
            grab(QStringLiteral("panel-") + factory.id + suffix);
        }
    }
    theme().setKind(first);
    emit done(m_saved);
}

} // namespace camwright
