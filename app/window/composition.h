#pragma once

namespace camwright {

class ActionCatalogue;
class Registry;

/// Which editors and panels the window has: the only place that names them.
void registerEverything(Registry& registry, ActionCatalogue& actions);

} // namespace camwright
