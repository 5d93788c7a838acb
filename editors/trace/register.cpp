#include "editors/trace/register.h"

#include "editors/shell/registry.h"
#include "editors/trace/tracepanel.h"

namespace camwright {

void registerTrace(Registry& registry, ActionCatalogue&)
{
    registry.add(PanelFactory{QStringLiteral("trace"), TracePanel::tr("Oscilloscope"), QStringLiteral("trace"), PanelArea::Bottom, 40,
        [](Context& context) -> Panel* { return new TracePanel(context); }});
}

} // namespace camwright
