#include "editors/network/register.h"

#include "editors/network/networkeditor.h"
#include "editors/shell/registry.h"

namespace camwright {

void registerNetworkEditor(Registry& registry, ActionCatalogue&)
{
    registry.add(EditorFactory{QStringLiteral("network"), ObjectKind::Network, NetworkEditor::tr("Motion Network"), QStringLiteral("network"),
        [](Context& context, const ObjectKey& key) -> Editor* { return new NetworkEditor(context, key); }, false});
}

} // namespace camwright
