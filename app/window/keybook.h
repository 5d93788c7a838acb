#pragma once

#include "editors/shell/keymap.h"

#include <QObject>

namespace camwright {

class Settings;

/// The keys of the actions as the user has them: a map, and what he changed in it. Every change takes effect and is kept at
/// once; each map remembers its own changes.
class KeyBook : public QObject {
    Q_OBJECT
public:
    KeyBook(Settings& settings, ActionCatalogue& actions, QObject* parent = nullptr);

    /// Gives the actions their keys; again when actions were added.
    void apply();
    QString map() const { return m_map; }
    void setMap(const QString& id);

    QList<QKeySequence> keys(const QString& action) const;
    bool isChanged(const QString& action) const { return m_changed.contains(action); }
    bool hasChanges() const { return !m_changed.empty(); }
    /// The action that has a key; empty: nobody.
    QString holder(const QKeySequence& key) const;
    /// Whoever had one of the keys loses it.
    void change(const QString& action, const QList<QKeySequence>& keys);
    void reset(const QString& action);     ///< to what the map says, as far as those keys are free
    void resetAll();

signals:
    void changed();

private:
    void keep();

    Settings& m_settings;
    ActionCatalogue& m_actions;
    QString m_map;
    KeyAssignment m_changed;
};

} // namespace camwright
