#pragma once

namespace camwright {

class ActionCatalogue;
class Registry;

/// The editor of variable tables.
void registerVariablesEditor(Registry& registry, ActionCatalogue& actions);

} // namespace camwright
