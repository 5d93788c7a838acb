#pragma once

namespace camwright {

class ActionCatalogue;

/// The window's own rows of the action catalogue. Editors and panels add theirs.
void addWindowActions(ActionCatalogue& actions);

} // namespace camwright
