#include "editors/terminals/register.h"

#include "editors/terminals/terminalspanel.h"
#include "editors/shell/registry.h"

namespace camwright {

void registerTerminalsPanel(Registry& registry, ActionCatalogue&)
{
    registry.add(PanelFactory{QStringLiteral("terminals"), TerminalsPanel::tr("Inputs and Outputs"), QStringLiteral("controller"), PanelArea::Bottom, 45,
        [](Context& context) -> Panel* { return new TerminalsPanel(context); }});
}

} // namespace camwright
