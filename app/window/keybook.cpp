#include "app/window/keybook.h"

#include "app/window/settings.h"

#include <algorithm>

namespace camwright {

KeyBook::KeyBook(Settings& settings, ActionCatalogue& actions, QObject* parent) : QObject(parent), m_settings(settings), m_actions(actions)
{
    setMap(settings.keyMap());
}

void KeyBook::setMap(const QString& id)
{
    const auto& maps = keyMaps();
    const bool known = std::any_of(maps.begin(), maps.end(), [&](const KeyMap& map) { return id == QLatin1String(map.id); });
    m_map = known ? id : QString::fromLatin1(maps.front().id);
    if (m_map != m_settings.keyMap() && known)
        m_settings.setKeyMap(m_map);
    m_changed.clear();
    const auto kept = m_settings.changedKeys(m_map);
    for (auto it = kept.begin(); it != kept.end(); ++it)
        m_changed[it.key()] = keysFromText(it.value());
    apply();
}

void KeyBook::apply()
{
    const KeyAssignment all = assignKeys(m_actions.rows(), m_map, m_changed);
    for (const auto& [action, keys] : all)
        m_actions.setKeys(action, keys);
    emit changed();
}

QList<QKeySequence> KeyBook::keys(const QString& action) const
{
    return m_actions.keys(action);
}

QString KeyBook::holder(const QKeySequence& key) const
{
    for (const ActionRow& row : m_actions.rows()) {
        if (const QString action = QString::fromLatin1(row.id); keys(action).contains(key))
            return action;
    }
    return {};
}

void KeyBook::change(const QString& action, const QList<QKeySequence>& keys)
{
    for (auto& [other, own] : m_changed) {
        if (other != action)
            own.removeIf([&](const QKeySequence& key) { return keys.contains(key); });
    }
    m_changed[action] = keys;
    keep();
}

void KeyBook::reset(const QString& action)
{
    if (m_changed.erase(action) > 0)
        keep();
}

void KeyBook::resetAll()
{
    m_changed.clear();
    keep();
}

void KeyBook::keep()
{
    QMap<QString, QString> texts;
    for (const auto& [action, keys] : m_changed)
        texts.insert(action, textOfKeys(keys));
    m_settings.setChangedKeys(m_map, texts);
    apply();
}

} // namespace camwright
