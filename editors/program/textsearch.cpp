#include "editors/program/textsearch.h"

namespace camwright {

namespace {

/// Byte offsets of UTF-16 positions, walked once from left to right.
class ByteOffsets {
public:
    explicit ByteOffsets(const QString& text) : m_text(text) {}

    qsizetype at(qsizetype position)
    {
        for (; m_position < position; ++m_position) {
            const char16_t c = m_text[m_position].unicode();
            // A surrogate pair is four bytes, two for each half.
            m_bytes += c < 0x80 ? 1 : c < 0x800 || QChar::isSurrogate(c) ? 2 : 3;
        }
        return m_bytes;
    }

private:
    const QString& m_text;
    qsizetype m_position = 0;
    qsizetype m_bytes = 0;
};

QString patternOf(const SearchQuery& query)
{
    QString pattern = query.regularExpression ? query.text : QRegularExpression::escape(query.text);
    if (query.wholeWord)
        pattern = QStringLiteral("(?<![\\w%.#])(?:%1)(?![\\w.#])").arg(pattern);
    return pattern;
}

QString expand(const QRegularExpressionMatch& match, const QString& with)
{
    QString out;
    for (qsizetype i = 0; i < with.size(); ++i) {
        if (with[i] == QLatin1Char('\\') && i + 1 < with.size()) {
            const QChar next = with[++i];
            out += next.isDigit() ? match.captured(next.digitValue()) : QString(next);
        } else {
            out += with[i];
        }
    }
    return out;
}

} // namespace

TextSearch::TextSearch(const SearchQuery& query)
    : m_expression(patternOf(query),
          QRegularExpression::MultilineOption | (query.matchCase ? QRegularExpression::NoPatternOption : QRegularExpression::CaseInsensitiveOption)),
      m_empty(query.text.isEmpty()), m_groups(query.regularExpression)
{
}

QString TextSearch::error() const
{
    return m_empty || m_expression.isValid() ? QString() : m_expression.errorString();
}

std::vector<SearchHit> TextSearch::findAll(const QByteArray& text) const
{
    std::vector<SearchHit> out;
    if (m_empty || !m_expression.isValid())
        return out;
    const QString wide = QString::fromUtf8(text);
    ByteOffsets offsets(wide);
    auto matches = m_expression.globalMatch(wide);
    while (matches.hasNext()) {
        const QRegularExpressionMatch match = matches.next();
        if (match.capturedLength() == 0)
            continue;
        const qsizetype from = offsets.at(match.capturedStart());
        out.push_back({from, offsets.at(match.capturedEnd()) - from});
    }
    return out;
}

QByteArray TextSearch::replacement(const QByteArray& text, const SearchHit& hit, const QString& with) const
{
    if (!m_groups)
        return with.toUtf8();
    const QString wide = QString::fromUtf8(text);
    const qsizetype from = QString::fromUtf8(text.left(hit.offset)).size();
    return expand(m_expression.match(wide, from, QRegularExpression::NormalMatch, QRegularExpression::AnchorAtOffsetMatchOption), with).toUtf8();
}

QByteArray TextSearch::replaceAll(const QByteArray& text, const QString& with, int& count) const
{
    count = 0;
    QByteArray out;
    if (m_empty || !m_expression.isValid())
        return text;
    const QString wide = QString::fromUtf8(text);
    qsizetype at = 0;
    auto matches = m_expression.globalMatch(wide);
    while (matches.hasNext()) {
        const QRegularExpressionMatch match = matches.next();
        if (match.capturedLength() == 0)
            continue;
        out += QStringView(wide).mid(at, match.capturedStart() - at).toUtf8();
        out += (m_groups ? expand(match, with) : with).toUtf8();
        at = match.capturedEnd();
        ++count;
    }
    return out + QStringView(wide).mid(at).toUtf8();
}

} // namespace camwright
