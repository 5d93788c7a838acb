#pragma once

#include "editors/shell/theme.h"

#include <QByteArray>
#include <QDateTime>
#include <QList>
#include <QMap>
#include <QString>

namespace camwright {

enum class LastState { Unknown, Edited, Errors, Warnings, RanVirtual, RanReal, UnsavedKept };

/// A project the user worked on, for the start page.
struct RecentProject {
    QString path;
    QString name;
    QString controller;  ///< "Kinco KS101M-04DX"
    LastState state = LastState::Unknown;
    int problems = 0;
    QString address;     ///< of the controller it last ran on
    QDateTime opened;
};

/// What the program remembers of its user between starts, in the user's configuration folder.
class Settings {
public:
    enum class ThemeChoice { System, Light, Dark };

    ThemeChoice themeChoice() const;
    void setThemeChoice(ThemeChoice choice);
    Theme::Kind themeKind() const;               ///< the choice, or what the system shows
    QString language() const;                    ///< the choice, or what the system asks for
    void setLanguage(const QString& language);

    QList<RecentProject> recentProjects() const; ///< newest first; folders that are gone are left out
    void remember(const RecentProject& project);
    void forget(const QString& path);

    QStringList addresses() const;               ///< controllers connected to, newest first, "local" always there
    void rememberAddress(const QString& address);

    /// Kept per screen size and layout preset.
    QByteArray layout(const QString& key) const;
    void setLayout(const QString& key, const QByteArray& state);
    void forgetLayouts();
    /// How the editors of a project stand in a layout (Arrangement::toBytes). Kept for the projects used last.
    QByteArray editors(const QString& projectPath, const QString& layout) const;
    void setEditors(const QString& projectPath, const QString& layout, const QByteArray& arrangement);

    QString keyMap() const;                      ///< id; empty: the default one
    void setKeyMap(const QString& id);
    /// The user's own keys on top of a map: by action, portable text, empty for none.
    QMap<QString, QString> changedKeys(const QString& keyMap) const;
    void setChangedKeys(const QString& keyMap, const QMap<QString, QString>& keys);

    QString projectsFolder() const;              ///< where new projects are proposed
    void setProjectsFolder(const QString& folder);
};

} // namespace camwright
