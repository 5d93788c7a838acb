#include "editors/words/words.h"

#include <QCoreApplication>
#include <QLibraryInfo>
#include <QLocale>
#include <QRegularExpression>
#include <QTranslator>

#include <memory>
#include <vector>

/// A static library's resources are linked in only where they are asked for; the macro works outside namespaces alone.
static void registerTranslations()
{
    Q_INIT_RESOURCE(camwright_translations);
}

namespace camwright::words {

namespace {

struct Installed {
    QString language = QStringLiteral("en");
    std::vector<std::unique_ptr<QTranslator>> translators;
};

Installed& installed()
{
    static Installed state;
    return state;
}

QString text(const std::string& utf8)
{
    return QString::fromUtf8(utf8.data(), qsizetype(utf8.size()));
}

/// "simulation.home_switch" to words people read: "home switch".
QString fieldWords(const std::string& field)
{
    QString out = text(field);
    out = out.mid(out.lastIndexOf(QLatin1Char('.')) + 1);
    for (const char* unit : {"_ms", "_us"}) {
        if (out.endsWith(QLatin1String(unit)))
            out.chop(qsizetype(qstrlen(unit)));
    }
    return out.replace(QLatin1Char('_'), QLatin1Char(' '));
}

/// A phrase among the arguments, marked with CW_TEXT("Arguments", …) at its origin; a number in it stands there as %1. What is
/// not marked, such as a path, stays as it is.
std::string phrase(const std::string& argument)
{
    const QString whole = QCoreApplication::translate("Arguments", argument.c_str());
    if (whole != text(argument))
        return whole.toStdString();
    static const QRegularExpression number(QStringLiteral("[0-9]+"));
    const QRegularExpressionMatch match = number.match(whole);
    if (!match.hasMatch())
        return argument;
    const QByteArray marked = QString(whole).replace(match.capturedStart(), match.capturedLength(), QStringLiteral("%1")).toUtf8();
    const QString translated = QCoreApplication::translate("Arguments", marked.constData());
    return translated.toUtf8() == marked ? argument : fillTemplate(translated.toStdString(), {match.captured().toStdString()});
}

/// The suffix of Qt's own translation files.
QString qtName(const QString& language)
{
    return language == QLatin1String("zh") ? QStringLiteral("zh_CN") : language;
}

} // namespace

QString sentence(const Diagnostic& diagnostic)
{
    const std::string_view english = codeInfo(diagnostic.code).text;
    const QString translated = QCoreApplication::translate("Diagnostics", std::string(english).c_str());
    std::vector<std::string> arguments = diagnostic.arguments;
    for (std::string& argument : arguments) {
        if (argument.find(' ') != std::string::npos) // names have no blanks
            argument = phrase(argument);
    }
    return text(fillTemplate(translated.toStdString(), arguments));
}

QString unitWord(const std::string& unit)
{
    static constexpr const char* known[] = {QT_TRANSLATE_NOOP("Units", "mm"), QT_TRANSLATE_NOOP("Units", "mm/s"), QT_TRANSLATE_NOOP("Units", "°/s"),
        QT_TRANSLATE_NOOP("Units", "ms"), QT_TRANSLATE_NOOP("Units", "s")};
    for (const char* name : known) {
        if (unit == name)
            return QCoreApplication::translate("Units", name);
    }
    return text(unit);
}

QString plainName(QString menuText)
{
    static const QRegularExpression key(QStringLiteral("\\s*\\(&.\\)"));
    menuText.remove(key).remove(QLatin1Char('&'));
    if (menuText.endsWith(QLatin1String("...")))
        menuText.chop(3);
    return menuText;
}

QString codeId(Code code)
{
    const std::string_view id = codeInfo(code).id;
    return QString::fromLatin1(id.data(), qsizetype(id.size()));
}

QString severityWord(Severity severity)
{
    switch (severity) {
    case Severity::Error: return QCoreApplication::translate("Words", "error");
    case Severity::Warning: return QCoreApplication::translate("Words", "warning");
    case Severity::Information: break;
    }
    return QCoreApplication::translate("Words", "note");
}

QString kindWord(ObjectKind kind)
{
    switch (kind) {
    case ObjectKind::Project: return QCoreApplication::translate("Words", "project");
    case ObjectKind::Controller: return QCoreApplication::translate("Words", "controller");
    case ObjectKind::Axis: return QCoreApplication::translate("Words", "axis");
    case ObjectKind::Network: return QCoreApplication::translate("Words", "network");
    case ObjectKind::Program: return QCoreApplication::translate("Words", "program");
    case ObjectKind::VariableTable: return QCoreApplication::translate("Words", "variable table");
    case ObjectKind::WatchTable: return QCoreApplication::translate("Words", "watch list");
    }
    return {};
}

QString placeText(const Place& place)
{
    QStringList parts;
    if (!place.object.name.empty())
        parts << text(place.object.name);
    else if (place.object.kind != ObjectKind::Project)
        parts << kindWord(place.object.kind);
    else if (!place.file.empty())
        parts << text(place.file);
    if (place.range.isValid())
        parts << QCoreApplication::translate("Words", "line %1, column %2").arg(place.range.line).arg(place.range.column);
    else if (!place.field.empty())
        parts << fieldWords(place.field);
    return parts.join(QStringLiteral(", "));
}

QStringList languages()
{
    return {QStringLiteral("en"), QStringLiteral("zh"), QStringLiteral("ru")};
}

QString languageName(const QString& language)
{
    if (language == QLatin1String("zh"))
        return QStringLiteral("中文");
    if (language == QLatin1String("ru"))
        return QStringLiteral("Русский");
    return QStringLiteral("English");
}

bool setLanguage(QCoreApplication& application, const QString& language, const QString& directory)
{
    registerTranslations();
    const QString folder = directory.isEmpty() ? QStringLiteral(":/translations") : directory;
    const bool isEnglish = language == QLatin1String("en");
    std::vector<std::unique_ptr<QTranslator>> fresh; // the last one is asked first
    if (!isEnglish) {
        auto ofQt = std::make_unique<QTranslator>();
        if (ofQt->load(QStringLiteral("qtbase_") + qtName(language), QLibraryInfo::path(QLibraryInfo::TranslationsPath)))
            fresh.push_back(std::move(ofQt));
    }
    auto ours = std::make_unique<QTranslator>();
    if (ours->load(QStringLiteral("camwright_") + language, folder))
        fresh.push_back(std::move(ours));
    else if (!isEnglish)
        return false;
    Installed& state = installed();
    for (const auto& old : state.translators)
        application.removeTranslator(old.get());
    state.translators = std::move(fresh);
    state.language = language;
    for (const auto& translator : state.translators)
        application.installTranslator(translator.get());
    return true;
}

QString currentLanguage()
{
    return installed().language;
}

QString systemLanguage()
{
    for (const QString& wanted : QLocale::system().uiLanguages()) {
        const QString language = wanted.section(QLatin1Char('-'), 0, 0);
        if (languages().contains(language))
            return language;
    }
    return QStringLiteral("en");
}

QString pick(const std::string& english, const std::string& chinese, const std::string& russian)
{
    const QString& language = installed().language;
    if (language == QLatin1String("zh") && !chinese.empty())
        return text(chinese);
    if (language == QLatin1String("ru") && !russian.empty())
        return text(russian);
    return text(english);
}

} // namespace camwright::words
