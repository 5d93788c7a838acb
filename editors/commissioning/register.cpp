#include "editors/commissioning/register.h"

#include "editors/commissioning/commissioningeditor.h"
#include "editors/shell/registry.h"

namespace camwright {

void registerCommissioning(Registry& registry, ActionCatalogue&)
{
    registry.add(EditorFactory{QStringLiteral("axis.commissioning"), ObjectKind::Axis, CommissioningEditor::tr("Commissioning"), QStringLiteral("jog"),
        [](Context& context, const ObjectKey& key) -> Editor* { return new CommissioningEditor(context, key); }, true});
}

} // namespace camwright
