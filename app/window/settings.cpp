#include "app/window/settings.h"

#include "editors/words/words.h"

#include <QCoreApplication>
#include <QCryptographicHash>
#include <QDir>
#include <QFileInfo>
#include <QGuiApplication>
#include <QPalette>
#include <QScreen>
#include <QSettings>
#include <QStandardPaths>

namespace camwright {

namespace {

constexpr int MaxRecent = 10;
constexpr int MaxAddresses = 8;
constexpr int MaxArranged = 30; // projects whose editors are remembered

QString layoutKey(const QString& key)
{
    const QScreen* screen = QGuiApplication::primaryScreen();
    const QSize size = screen ? screen->size() : QSize();
    return QStringLiteral("layout/%1x%2/%3").arg(size.width()).arg(size.height()).arg(key);
}

/// Short and without characters that mean something in a settings file.
QString projectKey(const QString& path)
{
    return QString::fromLatin1(QCryptographicHash::hash(QDir::cleanPath(path).toUtf8(), QCryptographicHash::Sha1).toHex().left(16));
}

} // namespace

Settings::ThemeChoice Settings::themeChoice() const
{
    const QString word = QSettings().value(QStringLiteral("theme"), QStringLiteral("system")).toString();
    return word == QLatin1String("dark") ? ThemeChoice::Dark : word == QLatin1String("light") ? ThemeChoice::Light : ThemeChoice::System;
}

void Settings::setThemeChoice(ThemeChoice choice)
{
    QSettings().setValue(QStringLiteral("theme"), choice == ThemeChoice::Dark ? "dark" : choice == ThemeChoice::Light ? "light" : "system");
}

Theme::Kind Settings::themeKind() const
{
    const ThemeChoice choice = themeChoice();
    if (choice != ThemeChoice::System)
        return choice == ThemeChoice::Dark ? Theme::Kind::Dark : Theme::Kind::Light;
    static const bool systemIsDark = QGuiApplication::palette().color(QPalette::Window).lightness() < 128;
    return systemIsDark ? Theme::Kind::Dark : Theme::Kind::Light;
}

QString Settings::language() const
{
    const QString chosen = QSettings().value(QStringLiteral("language")).toString();
    return words::languages().contains(chosen) ? chosen : words::systemLanguage();
}

void Settings::setLanguage(const QString& language)
{
    QSettings().setValue(QStringLiteral("language"), language);
}

QList<RecentProject> Settings::recentProjects() const
{
    QList<RecentProject> out;
    QSettings settings;
    const int count = settings.beginReadArray(QStringLiteral("recent"));
    for (int i = 0; i < count; ++i) {
        settings.setArrayIndex(i);
        RecentProject project;
        project.path = settings.value(QStringLiteral("path")).toString();
        project.name = settings.value(QStringLiteral("name")).toString();
        project.controller = settings.value(QStringLiteral("controller")).toString();
        project.state = LastState(settings.value(QStringLiteral("state")).toInt());
        project.problems = settings.value(QStringLiteral("problems")).toInt();
        project.address = settings.value(QStringLiteral("address")).toString();
        project.opened = settings.value(QStringLiteral("opened")).toDateTime();
        if (QFileInfo::exists(project.path + QStringLiteral("/project.toml")))
            out << project;
    }
    settings.endArray();
    return out;
}

namespace {

void writeRecent(const QList<RecentProject>& list)
{
    QSettings settings;
    settings.remove(QStringLiteral("recent"));
    settings.beginWriteArray(QStringLiteral("recent"), int(list.size()));
    for (int i = 0; i < list.size(); ++i) {
        settings.setArrayIndex(i);
        settings.setValue(QStringLiteral("path"), list[i].path);
        settings.setValue(QStringLiteral("name"), list[i].name);
        settings.setValue(QStringLiteral("controller"), list[i].controller);
        settings.setValue(QStringLiteral("state"), int(list[i].state));
        settings.setValue(QStringLiteral("problems"), list[i].problems);
        settings.setValue(QStringLiteral("address"), list[i].address);
        settings.setValue(QStringLiteral("opened"), list[i].opened);
    }
    settings.endArray();
}

} // namespace

void Settings::remember(const RecentProject& project)
{
    QList<RecentProject> list = recentProjects();
    list.removeIf([&](const RecentProject& other) { return other.path == project.path; });
    list.prepend(project);
    while (list.size() > MaxRecent)
        list.removeLast();
    writeRecent(list);
}

void Settings::forget(const QString& path)
{
    QList<RecentProject> list = recentProjects();
    list.removeIf([&](const RecentProject& other) { return other.path == path; });
    writeRecent(list);
}

QStringList Settings::addresses() const
{
    QStringList out = QSettings().value(QStringLiteral("addresses")).toStringList();
    if (!out.contains(QLatin1String("local")))
        out.prepend(QStringLiteral("local"));
    return out;
}

void Settings::rememberAddress(const QString& address)
{
    QStringList list = addresses();
    list.removeAll(address);
    list.prepend(address);
    QSettings().setValue(QStringLiteral("addresses"), list.mid(0, MaxAddresses));
}

QByteArray Settings::layout(const QString& key) const
{
    return QSettings().value(layoutKey(key)).toByteArray();
}

void Settings::setLayout(const QString& key, const QByteArray& state)
{
    QSettings().setValue(layoutKey(key), state);
}

void Settings::forgetLayouts()
{
    QSettings().remove(QStringLiteral("layout"));
}

QByteArray Settings::editors(const QString& projectPath, const QString& layout) const
{
    return projectPath.isEmpty() ? QByteArray() : this->layout(QStringLiteral("editors/%1/%2").arg(projectKey(projectPath), layout));
}

void Settings::setEditors(const QString& projectPath, const QString& layout, const QByteArray& arrangement)
{
    if (projectPath.isEmpty())
        return;
    const QString key = projectKey(projectPath);
    setLayout(QStringLiteral("editors/%1/%2").arg(key, layout), arrangement);
    QSettings settings;
    const QString orderKey = layoutKey(QStringLiteral("arranged"));
    QStringList order = settings.value(orderKey).toStringList();
    order.removeAll(key);
    order.prepend(key);
    while (order.size() > MaxArranged)
        settings.remove(layoutKey(QStringLiteral("editors/") + order.takeLast()));
    settings.setValue(orderKey, order);
}

QString Settings::keyMap() const
{
    return QSettings().value(QStringLiteral("keys/map")).toString();
}

void Settings::setKeyMap(const QString& id)
{
    QSettings().setValue(QStringLiteral("keys/map"), id);
}

QMap<QString, QString> Settings::changedKeys(const QString& keyMap) const
{
    QMap<QString, QString> out;
    QSettings settings;
    settings.beginGroup(QStringLiteral("keys/changed-") + keyMap);
    for (const QString& action : settings.childKeys())
        out.insert(action, settings.value(action).toString());
    return out;
}

void Settings::setChangedKeys(const QString& keyMap, const QMap<QString, QString>& keys)
{
    QSettings settings;
    settings.beginGroup(QStringLiteral("keys/changed-") + keyMap);
    settings.remove(QString());
    for (auto it = keys.begin(); it != keys.end(); ++it)
        settings.setValue(it.key(), it.value());
}

QString Settings::projectsFolder() const
{
    const QString documents = QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation);
    return QSettings().value(QStringLiteral("projectsFolder"), QDir(documents).filePath(QStringLiteral("camwright"))).toString();
}

void Settings::setProjectsFolder(const QString& folder)
{
    QSettings().setValue(QStringLiteral("projectsFolder"), folder);
}

} // namespace camwright
