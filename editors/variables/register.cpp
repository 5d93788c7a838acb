#include "editors/variables/register.h"

#include "editors/shell/registry.h"
#include "editors/variables/variableseditor.h"

namespace camwright {

void registerVariablesEditor(Registry& registry, ActionCatalogue&)
{
    registry.add(EditorFactory{QStringLiteral("variables"), ObjectKind::VariableTable, VariablesEditor::tr("Variables"), QStringLiteral("variables"),
        [](Context& context, const ObjectKey& key) -> Editor* { return new VariablesEditor(context, key); }, false});
}

} // namespace camwright
