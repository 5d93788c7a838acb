#pragma once

namespace camwright {

class ActionCatalogue;
class Registry;

/// The editor of programs and its actions.
void registerProgramEditor(Registry& registry, ActionCatalogue& actions);

} // namespace camwright
