#pragma once

namespace camwright {

class ActionCatalogue;
class Registry;

/// The controller's page.
void registerControllerEditor(Registry& registry, ActionCatalogue& actions);

} // namespace camwright
