#pragma once

namespace camwright {

class ActionCatalogue;
class Registry;

/// The watch dock, the editor of watch lists, and the actions to force.
void registerWatch(Registry& registry, ActionCatalogue& actions);

} // namespace camwright
