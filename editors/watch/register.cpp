#include "editors/watch/register.h"

#include "editors/shell/actions.h"
#include "editors/shell/registry.h"
#include "editors/watch/watcheditor.h"
#include "editors/watch/watchpanel.h"

namespace camwright {

void registerWatch(Registry& registry, ActionCatalogue& actions)
{
    if (!actions.action(QStringLiteral("watch.force")))
        actions.add(ActionRow{"watch.force", QT_TRANSLATE_NOOP("Actions", "&Force Selected Value"),
            QT_TRANSLATE_NOOP("Actions", "Holds the selected watched value, as typed or as it is, until it is released."), "force", "F7", Availability::Online});
    registry.add(EditorFactory{QStringLiteral("watch"), ObjectKind::WatchTable, WatchPanel::tr("Watch List"), QStringLiteral("watch"),
        [](Context& context, const ObjectKey& key) -> Editor* { return new WatchEditor(context, key); }, false});
    registry.add(PanelFactory{QStringLiteral("watch"), WatchPanel::tr("Watch"), QStringLiteral("watch"), PanelArea::Bottom, 30,
        [](Context& context) -> Panel* { return new WatchPanel(context); }});
}

} // namespace camwright
