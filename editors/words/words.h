#pragma once

#include "core/base/diagnostic.h"

#include <QString>
#include <QStringList>

#include <string>

class QCoreApplication;

/// Codes and arguments into sentences, in the language of the program. Qt Core only, so that the command line has it too.
namespace camwright::words {

/// The sentence of a diagnostic in the current language.
QString sentence(const Diagnostic& diagnostic);
/// A unit of the controller as the language writes it: "mm" is "мм" in Russian.
QString unitWord(const std::string& unit);
/// A menu text as a plain name: without access key ("&Run", "运行(&R)") and without closing dots.
QString plainName(QString menuText);
/// "CW3001".
QString codeId(Code code);
/// "error", "warning", "note".
QString severityWord(Severity severity);
/// The word for a kind of object: "axis".
QString kindWord(ObjectKind kind);
/// "program Main, line 4, column 7", "axis Feed, guard time": where it is, for lists.
QString placeText(const Place& place);

/// "en", "zh", "ru".
QStringList languages();
/// The language's own name: "English", "中文", "Русский".
QString languageName(const QString& language);
/// Loads the translation file of `language` from `directory` (or the resource ":/translations", which this library carries)
/// and installs it in place of the earlier one, with Qt's own texts where the system has them. The English file holds the
/// forms of counts only. False when the language has no file; the current language stays then.
bool setLanguage(QCoreApplication& application, const QString& language, const QString& directory = {});
QString currentLanguage();
/// What the system asks for, as one of languages(); English when it is none of them.
QString systemLanguage();

/// Picks the text of the current language from texts per language, English where it is empty.
QString pick(const std::string& english, const std::string& chinese, const std::string& russian);

} // namespace camwright::words
