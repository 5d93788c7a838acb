#pragma once

namespace camwright {

class ActionCatalogue;
class Registry;

/// The motion network's window, for the Kinco family.
void registerNetworkEditor(Registry& registry, ActionCatalogue& actions);

} // namespace camwright
