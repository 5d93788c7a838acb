#include "editors/shell/keymap.h"

#include <QCoreApplication>

#include <set>

namespace camwright {

namespace {

struct MapRow {
    const char* map;
    const char* action;
    const char* keys; ///< as in textOfKeys; "" takes the default key away
};

/// Where the named tools have the same job on a key. What they lack keeps our key, unless that key means something else there:
/// then it has moved, so that nobody starts a machine with a key he knows as a contact.
constexpr MapRow Rows[] = {
    {"codesys", "online.stop", "Shift+F8"},
    {"codesys", "online.download", "Ctrl+Shift+F8"},
    {"codesys", "project.build", "F11"},
    {"codesys", "edit.complete", "F2 Ctrl+Space"},
    {"codesys", "edit.rename", "Ctrl+R"},

    {"twincat", "online.connect", "F11"},
    {"twincat", "online.disconnect", "Shift+F11"},
    {"twincat", "online.download", "Ctrl+Shift+F4"},
    {"twincat", "project.build", "Ctrl+Shift+B"},
    {"twincat", "view.right", "Ctrl+Shift+J"},
    {"twincat", "view.closeTab", "Ctrl+F4 Ctrl+W"},
    {"twincat", "go.nextProblem", "F8"},
    {"twincat", "go.previousProblem", "Shift+F8"},

    {"gx", "project.build", "F4"},
    {"gx", "online.connect", "F3"},
    {"gx", "online.disconnect", "Alt+F3"},
    {"gx", "online.download", "Ctrl+F8"},
    {"gx", "online.run", "Ctrl+F5"},
    {"gx", "online.stop", "Ctrl+Shift+F5"},
    {"gx", "watch.force", "Ctrl+Shift+F7"},
    {"gx", "edit.findNext", "Ctrl+F3"},
    {"gx", "edit.findPrevious", "Ctrl+Shift+F3"},
    {"gx", "go.nextProblem", "Ctrl+E"},
    {"gx", "go.previousProblem", "Ctrl+Shift+E"},
    {"gx", "go.nextGroup", "Ctrl+Shift+G"},
    {"gx", "go.previousGroup", "Ctrl+Shift+H"},
};

} // namespace

const std::vector<KeyMap>& keyMaps()
{
    static const std::vector<KeyMap> maps{
        {"iec", QT_TRANSLATE_NOOP("KeyMaps", "Camwright"), QT_TRANSLATE_NOOP("KeyMaps", "The keys of the manual.")},
        {"codesys", QT_TRANSLATE_NOOP("KeyMaps", "Like CODESYS"), QT_TRANSLATE_NOOP("KeyMaps", "F11 builds, Alt+F8 goes online, Shift+F8 stops.")},
        {"twincat", QT_TRANSLATE_NOOP("KeyMaps", "Like TwinCAT"), QT_TRANSLATE_NOOP("KeyMaps", "F11 goes online, Ctrl+Shift+B builds, F8 goes to the next problem.")},
        {"gx", QT_TRANSLATE_NOOP("KeyMaps", "Like GX Works"), QT_TRANSLATE_NOOP("KeyMaps", "F4 builds, F3 goes online; F5 to F10 start nothing.")},
    };
    return maps;
}

QList<QKeySequence> keysFromText(const QString& text)
{
    QList<QKeySequence> out;
    for (const QString& key : text.split(QLatin1Char(' '), Qt::SkipEmptyParts)) {
        if (const QKeySequence read = QKeySequence::fromString(key, QKeySequence::PortableText); read.count() == 1 && read[0].key() != Qt::Key_unknown)
            out << read;
    }
    return out;
}

QString textOfKeys(const QList<QKeySequence>& keys)
{
    QStringList out;
    for (const QKeySequence& key : keys)
        out << key.toString(QKeySequence::PortableText);
    return out.join(QLatin1Char(' '));
}

std::optional<QList<QKeySequence>> keysOfMap(const QString& map, const QString& action)
{
    for (const MapRow& row : Rows) {
        if (map == QLatin1String(row.map) && action == QLatin1String(row.action))
            return keysFromText(QString::fromLatin1(row.keys));
    }
    return std::nullopt;
}

QStringList actionsOfMap(const QString& map)
{
    QStringList out;
    for (const MapRow& row : Rows) {
        if (map == QLatin1String(row.map))
            out << QString::fromLatin1(row.action);
    }
    return out;
}

bool isUsableKey(const QKeySequence& key)
{
    if (key.count() != 1)
        return false;
    const Qt::Key code = key[0].key();
    if (code == Qt::Key_unknown || code == Qt::Key(0) || (code >= Qt::Key_Shift && code <= Qt::Key_ScrollLock))
        return false;
    const bool function = code >= Qt::Key_F1 && code <= Qt::Key_F35;
    return function || (key[0].keyboardModifiers() & (Qt::ControlModifier | Qt::AltModifier | Qt::MetaModifier));
}

KeyAssignment assignKeys(const std::vector<ActionRow>& rows, const QString& map, const KeyAssignment& changed)
{
    KeyAssignment out;
    std::set<QString> taken;
    const auto give = [&](const QString& action, const QList<QKeySequence>& wanted) {
        QList<QKeySequence>& keys = out[action];
        for (const QKeySequence& key : wanted) {
            if (taken.insert(key.toString(QKeySequence::PortableText)).second)
                keys << key;
        }
    };
    for (int rank = 0; rank < 3; ++rank) {
        for (const ActionRow& row : rows) {
            const QString action = QString::fromLatin1(row.id);
            const auto own = changed.find(action);
            const auto mapped = keysOfMap(map, action);
            if (rank == 0 && own != changed.end())
                give(action, own->second);
            else if (rank == 1 && own == changed.end() && mapped)
                give(action, *mapped);
            else if (rank == 2 && own == changed.end() && !mapped)
                give(action, ActionCatalogue::defaultKeys(row));
        }
    }
    return out;
}

} // namespace camwright
