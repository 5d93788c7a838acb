#pragma once

#include "app/window/services.h"

namespace camwright {

class ActionCatalogue;
class Registry;

/// Which editors and panels the window has: the only place that names them.
void registerEverything(Registry& registry, ActionCatalogue& actions);

/// The real checks, builds and links.
Services realServices();

} // namespace camwright
