#pragma once

#include "editors/shell/actions.h"

#include <map>

namespace camwright {

/// A set of keys that people bring along from another tool.
struct KeyMap {
    const char* id;           ///< "codesys"; stored in the user's settings
    const char* name;         ///< for translation in the context "KeyMaps"
    const char* description;  ///< one sentence, the same
};

/// The default one first.
const std::vector<KeyMap>& keyMaps();
/// What a map says of an action; nothing where the action keeps its default keys.
std::optional<QList<QKeySequence>> keysOfMap(const QString& map, const QString& action);
/// Actions a map gives keys to.
QStringList actionsOfMap(const QString& map);

/// Portable text, several keys separated by blanks: "Ctrl+Z Alt+Backspace".
QList<QKeySequence> keysFromText(const QString& text);
QString textOfKeys(const QList<QKeySequence>& keys);

/// Whether a key can be an action's everywhere in the window: one stroke, a function key or one with Ctrl, Alt or Meta. A
/// bare letter is for typing.
bool isUsableKey(const QKeySequence& key);

using KeyAssignment = std::map<QString, QList<QKeySequence>>; ///< by action

/// The keys of every action: what the user changed goes before what the map says, and that before the defaults. A key that two
/// want belongs to the one that goes before; no two actions share one.
KeyAssignment assignKeys(const std::vector<ActionRow>& rows, const QString& map, const KeyAssignment& changed);

} // namespace camwright
