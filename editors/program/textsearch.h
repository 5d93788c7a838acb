#pragma once

#include <QByteArray>
#include <QRegularExpression>
#include <QString>

#include <optional>
#include <vector>

namespace camwright {

/// What the find bar asks for.
struct SearchQuery {
    QString text;
    bool matchCase = false;
    bool wholeWord = false;
    bool regularExpression = false;
};

/// A hit, in UTF-8 bytes from the start of the text.
struct SearchHit {
    qsizetype offset = 0;
    qsizetype length = 0;
    bool operator==(const SearchHit&) const = default;
};

/// Find and replace over the UTF-8 text of a program. A word here is what instruction list calls one: %M0.1 is a word.
class TextSearch {
public:
    explicit TextSearch(const SearchQuery& query);

    bool isEmpty() const { return m_empty; }
    /// Why a regular expression cannot be used; empty if it can.
    QString error() const;

    std::vector<SearchHit> findAll(const QByteArray& text) const;
    /// The hit replaced: \1 … \9 stand for groups of a regular expression.
    QByteArray replacement(const QByteArray& text, const SearchHit& hit, const QString& with) const;
    /// Every hit replaced; `count` tells how many.
    QByteArray replaceAll(const QByteArray& text, const QString& with, int& count) const;

private:
    QRegularExpression m_expression;
    bool m_empty;
    bool m_groups;
};

} // namespace camwright
