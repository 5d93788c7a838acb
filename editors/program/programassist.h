#pragma once

#include "core/language/source/dialect.h"
#include "core/model/project.h"

#include <QByteArray>
#include <QString>
#include <QStringList>

#include <optional>

/// What the language knows, in the form the text view shows it. Positions are UTF-8 bytes.
namespace camwright::assist {

/// A tool tip for the word at a place: instruction, pin, variable, address, in rich text; empty if nothing is known.
QString hover(const Project& project, const QByteArray& text, int position);

struct Completions {
    qsizetype begin = 0, end = 0;  ///< what a chosen entry replaces
    QStringList entries;           ///< "MC_HOME   homes an axis": the text, blanks, a hint
};

/// What may be typed at a place. While one types (`asked` false) only from the second letter of a word on.
Completions complete(const Project& project, const QByteArray& text, int position, bool asked);
/// The part of an entry that goes into the text.
QByteArray insertionOf(const QByteArray& entry);

struct TextChange {
    std::size_t offset = 0, removed = 0;
    QByteArray inserted;
};

/// Puts lines (from 1, both included) into comments, or takes them out if all of them are.
TextChange toggleComment(const QByteArray& text, std::uint32_t firstLine, std::uint32_t lastLine);

/// Where a variable, a subroutine or an axis is declared.
std::optional<Place> definitionOf(const Project& project, const QByteArray& word);

} // namespace camwright::assist
