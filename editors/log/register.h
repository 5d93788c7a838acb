#pragma once

namespace camwright {

class ActionCatalogue;
class Registry;

/// The panel of the controller's log.
void registerLogPanel(Registry& registry, ActionCatalogue& actions);

} // namespace camwright
