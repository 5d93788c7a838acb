// Going online, downloading, running.
#include "app/window/downloaddialog.h"
#include "app/window/mainwindow.h"
#include "app/window/toolrow.h"

namespace camwright {

void MainWindow::connectOnlineActions()
{
    ActionCatalogue& actions = m_workspace.actions;
    Connection& connection = m_workspace.connection;
    const auto on = [&](const char* id, auto function) { actions.on(QString::fromLatin1(id), this, function); };
    on("project.check", [this] { m_workspace.workbench.check(); });
    on("project.build", [this] { m_workspace.workbench.build(); });
    on("online.connect", [this] {
        if (m_workspace.connection.state() == LinkState::Offline)
            goOnline(m_tools->address());
    });
    on("online.disconnect", [&connection] { connection.disconnectNow(); });
    on("online.download", [this] { download(); });
    on("online.run", [this] {
        // A controller without this program is given it first: three clicks to a moving axis.
        if (m_workspace.context.status().program == Hash{})
            download(true, false);
        else
            m_workspace.connection.run();
    });
    on("online.stop", [&connection] { connection.stop(); });
    on("online.releaseForces", [&connection] { connection.releaseForces(); });
    on("online.stopAxes", [this] {
        m_workspace.context.link()->stopAllAxes([this](Result<void> result) {
            if (!result)
                m_workspace.context.notify(result.error());
        });
    });
}

void MainWindow::goOnline(const QString& address)
{
    m_workspace.connection.connectTo(address);
    if (m_workspace.connection.state() != LinkState::Offline) {
        m_workspace.settings.rememberAddress(address);
        m_tools->refreshAddresses();
    }
}

void MainWindow::runDemo(const QString& path)
{
    if (!openProject(path))
        return;
    goOnline(QStringLiteral("local"));
    // Once, when the controller answers. A controller that runs the program already is left alone.
    auto connection = std::make_shared<QMetaObject::Connection>();
    *connection = connect(&m_workspace.context, &Context::linkStateChanged, this, [this, connection](LinkState state) {
        if (state != LinkState::Online)
            return;
        disconnect(*connection);
        if (m_workspace.context.status().state != RunState::Run)
            download(true, false);
    });
}

void MainWindow::download(bool thenRun, bool askFirst)
{
    m_workspace.workbench.build([this, thenRun, askFirst](const DownloadPackage& package) {
        m_workspace.connection.withControl([this, thenRun, askFirst, package] {
            if (askFirst) {
                auto* dialog = new DownloadDialog(m_workspace.context, package, this);
                if (thenRun)
                    connect(dialog, &DownloadDialog::downloaded, &m_workspace.connection, &Connection::run);
                dialog->show();
                return;
            }
            // Nothing can be lost on a controller that has no program.
            m_workspace.context.link()->download(package, [](double) {}, [this, thenRun](Result<void> result) {
                if (!result)
                    m_workspace.context.notify(result.error());
                else if (thenRun)
                    m_workspace.connection.run();
            });
        });
    });
}

} // namespace camwright
