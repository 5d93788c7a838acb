#pragma once

namespace camwright {

class ActionCatalogue;
class Registry;

/// Commissioning of an axis: readings, state, and the panel that moves it.
void registerCommissioning(Registry& registry, ActionCatalogue& actions);

} // namespace camwright
