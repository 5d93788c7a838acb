#include "app/window/composition.h"

#include "app/window/outputpanel.h"
#include "editors/axis/register.h"
#include "editors/commissioning/register.h"
#include "editors/controller/register.h"
#include "editors/log/register.h"
#include "editors/network/register.h"
#include "editors/program/register.h"
#include "editors/project/projectpanel.h"
#include "editors/shell/context.h"
#include "editors/shell/problemsview.h"
#include "editors/shell/registry.h"
#include "editors/terminals/register.h"
#include "editors/trace/register.h"
#include "editors/variables/register.h"
#include "editors/watch/register.h"

namespace camwright {

void registerEverything(Registry& registry, ActionCatalogue& actions)
{
    registerProject(registry, actions);
    registry.add(PanelFactory{QStringLiteral("problems"), ProblemsView::tr("Problems"), QStringLiteral("problems"), PanelArea::Bottom, 10,
        [](Context& context) -> Panel* { return new ProblemsView(context); }});
    registry.add(PanelFactory{QStringLiteral("output"), OutputPanel::tr("Output"), QStringLiteral("output"), PanelArea::Bottom, 20,
        [](Context& context) -> Panel* { return new OutputPanel(context); }});
    registerProgramEditor(registry, actions);
    registerControllerEditor(registry, actions);
    registerAxisEditor(registry, actions);
    registerCommissioning(registry, actions);
    registerNetworkEditor(registry, actions);
    registerVariablesEditor(registry, actions);
    registerWatch(registry, actions);
    registerTrace(registry, actions);
    registerLogPanel(registry, actions);
    registerTerminalsPanel(registry, actions);
}

} // namespace camwright
