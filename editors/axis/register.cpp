#include "editors/axis/register.h"

#include "editors/axis/axiseditor.h"
#include "editors/shell/registry.h"

namespace camwright {

void registerAxisEditor(Registry& registry, ActionCatalogue&)
{
    registry.add(EditorFactory{QStringLiteral("axis"), ObjectKind::Axis, AxisEditor::tr("Axis"), QStringLiteral("axis-linear"),
        [](Context& context, const ObjectKey& key) -> Editor* { return new AxisEditor(context, key); }, false});
}

} // namespace camwright
