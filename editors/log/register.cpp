#include "editors/log/register.h"

#include "editors/log/logpanel.h"
#include "editors/shell/registry.h"

namespace camwright {

void registerLogPanel(Registry& registry, ActionCatalogue&)
{
    registry.add(PanelFactory{QStringLiteral("log"), LogPanel::tr("Log"), QStringLiteral("log"), PanelArea::Bottom, 50,
        [](Context& context) -> Panel* { return new LogPanel(context); }});
}

} // namespace camwright
