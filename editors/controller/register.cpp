#include "editors/controller/register.h"

#include "editors/controller/controllereditor.h"
#include "editors/shell/registry.h"

namespace camwright {

void registerControllerEditor(Registry& registry, ActionCatalogue&)
{
    registry.add(EditorFactory{QStringLiteral("controller"), ObjectKind::Controller, ControllerEditor::tr("Controller"), QStringLiteral("controller"),
        [](Context& context, const ObjectKey& key) -> Editor* { return new ControllerEditor(context, key); }, false});
}

} // namespace camwright
