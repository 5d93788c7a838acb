#include "app/window/workspace.h"

#include "app/window/windowactions.h"
#include "core/family/family.h"

namespace camwright {

Workspace::Workspace(Services wanted, Registrar registrar)
    : keys(settings, actions)
    , context(document, actions, registry, pool)
    , services(std::move(wanted))
    , checks(document, pool, services.check)
    , connection(context, services)
    , workbench(context, services)
    , m_registrar(std::move(registrar))
{
    pool.setMaxThreadCount(std::max(2, QThread::idealThreadCount() - 1));
    addWindowActions(actions);
    m_registrar(registry, actions);
    keys.apply();
}

Workspace::~Workspace()
{
    connection.disconnectNow();
    workbench.cancel();
    pool.clear();
    pool.waitForDone();
}

void Workspace::retranslate()
{
    registry.clear();
    m_registrar(registry, actions);
    actions.retranslate();
}

void Workspace::rememberProject()
{
    if (!document.isOpen() || document.path().isEmpty())
        return;
    RecentProject project;
    project.path = document.path();
    project.name = document.displayName();
    const ControllerSettings& controller = document.project().controller();
    const Family* family = findFamily(controller.family);
    project.controller = family ? QString::fromStdString(family->displayName()).section(QLatin1Char(' '), 0, 0) + QLatin1Char(' ') + QString::fromStdString(controller.model)
                                : QString::fromStdString(controller.model);
    project.opened = QDateTime::currentDateTime();
    if (document.isModified())
        project.state = LastState::UnsavedKept;
    else if (document.errorCount() > 0)
        project.state = LastState::Errors;
    else if (!connection.lastRunAddress().isEmpty())
        project.state = connection.lastRunSimulated() ? LastState::RanVirtual : LastState::RanReal;
    else if (document.warningCount() > 0)
        project.state = LastState::Warnings;
    else
        project.state = LastState::Edited;
    project.problems = document.errorCount() > 0 ? document.errorCount() : document.warningCount();
    project.address = connection.lastRunAddress();
    settings.remember(project);
}

} // namespace camwright
