#pragma once

namespace camwright {

class ActionCatalogue;
class Registry;

/// The page of an axis.
void registerAxisEditor(Registry& registry, ActionCatalogue& actions);

} // namespace camwright
