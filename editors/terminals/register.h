#pragma once

namespace camwright {

class ActionCatalogue;
class Registry;

/// The panel of the virtual controller's inputs and outputs.
void registerTerminalsPanel(Registry& registry, ActionCatalogue& actions);

} // namespace camwright
