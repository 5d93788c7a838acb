#pragma once

namespace camwright {

class ActionCatalogue;
class Registry;

/// The oscilloscope.
void registerTrace(Registry& registry, ActionCatalogue& actions);

} // namespace camwright
