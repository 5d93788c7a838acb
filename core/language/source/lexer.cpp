#include "core/language/source/token.h"

#include "core/language/source/headers.h"
#include "core/language/source/letters.h"
#include "core/language/source/operandtext.h"

namespace camwright {

namespace {

/// Walks over one line of code.
class LineLexer {
public:
    LineLexer(const Dialect& dialect, std::string_view line, std::vector<Token>& tokens)
        : m_dialect(dialect), m_line(line), m_tokens(tokens)
    {
    }

    LineState run(LineState state)
    {
        if (state == LineState::Comment && !isNetworkHeader(m_line) && !finishComment())
            return LineState::Comment;
        while (skipBlanks(), m_at < m_line.size()) {
            if (startsComment()) {
                if (!comment())
                    return LineState::Comment;
            } else if (!m_mnemonicSeen) {
                word();
            } else if (m_dialect.commaSeparated) {
                commaOperand();
            } else {
                blankOperand();
            }
        }
        return LineState::Code;
    }

private:
    std::string_view rest() const { return m_line.substr(m_at); }
    bool startsComment(std::size_t at) const
    {
        const std::string_view here = m_line.substr(at);
        return here.starts_with("(*") || (m_dialect.lineComments && here.starts_with("//"));
    }
    bool startsComment() const { return startsComment(m_at); }

    void skipBlanks()
    {
        while (m_at < m_line.size() && isBlank(m_line[m_at]))
            ++m_at;
    }

    void add(TokenKind kind, std::size_t begin, std::size_t end)
    {
        if (end > begin)
            m_tokens.push_back({kind, 0, static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(end - begin)});
    }

    /// The rest of a comment opened on an earlier line. False if it goes on.
    bool finishComment()
    {
        const std::size_t close = m_line.find("*)");
        const std::size_t end = close == std::string_view::npos ? m_line.size() : close + 2;
        add(TokenKind::Comment, 0, end);
        m_at = end;
        return close != std::string_view::npos;
    }

    bool comment()
    {
        if (rest().starts_with("//")) {
            add(TokenKind::Comment, m_at, m_line.size());
            m_at = m_line.size();
            return true;
        }
        if (m_tokens.empty())
            if (const auto header = networkHeaderAt(m_line, m_at)) {
                add(TokenKind::NetworkHeader, m_at, header->end);
                m_at = header->end;
                return true;
            }
        const std::size_t close = m_line.find("*)", m_at + 2);
        const std::size_t end = close == std::string_view::npos ? m_line.size() : close + 2;
        add(TokenKind::Comment, m_at, end);
        m_at = end;
        return close != std::string_view::npos;
    }

    /// The first word of a statement, "AND(" and ")" included.
    void word()
    {
        const std::size_t begin = m_at;
        if (rest().starts_with("(\\*") || rest().starts_with("```")) {
            add(TokenKind::Invalid, begin, m_line.size());
            m_at = m_line.size();
            return;
        }
        if (m_line[m_at] == ')') {
            add(TokenKind::Group, begin, ++m_at);
            m_mnemonicSeen = true;
            return;
        }
        while (m_at < m_line.size() && !isBlank(m_line[m_at]) && !startsComment() && m_line[m_at] != ',')
            if (m_line[m_at++] == '(')
                break;
        if (m_at == begin)
            ++m_at;
        const std::string_view text = m_line.substr(begin, m_at - begin);
        const bool isWord = !isAscii(text.front()) || isAsciiLetter(text.front()) || text.front() == '_';
        add(isWord ? TokenKind::Mnemonic : TokenKind::Invalid, begin, m_at);
        m_mnemonicSeen = isWord;
    }

    void commaOperand()
    {
        if (m_line[m_at] == ',') {
            add(TokenKind::Separator, m_at, m_at + 1);
            ++m_at;
            return;
        }
        const std::size_t begin = m_at;
        while (m_at < m_line.size() && m_line[m_at] != ',' && !startsComment() && !rest().starts_with(":="))
            ++m_at;
        operand(begin, m_at);
    }

    void blankOperand()
    {
        if (m_line[m_at] == ',') {
            add(TokenKind::Invalid, m_at, m_at + 1);
            ++m_at;
            return;
        }
        const std::size_t begin = m_at;
        if (m_line[m_at] == '#') { // "# IN1": the manual prints blanks after the sign of a subroutine variable
            ++m_at;
            skipBlanks();
        }
        while (m_at < m_line.size() && m_line[m_at] != ',' && !isBlank(m_line[m_at]) && !startsComment() && !rest().starts_with(":="))
            ++m_at;
        operand(begin, m_at);
    }

    /// One operand, or the name of a pin if := follows.
    void operand(std::size_t begin, std::size_t end)
    {
        const std::string_view text = trimmed(m_line.substr(begin, end - begin));
        std::size_t after = end;
        while (after < m_line.size() && isBlank(m_line[after]))
            ++after;
        if (m_line.substr(after).starts_with(":=")) {
            add(TokenKind::Pin, begin, begin + text.size());
            add(TokenKind::Separator, after, after + 2);
            m_at = after + 2;
            return;
        }
        add(operandForm(m_dialect, text), begin, begin + text.size());
    }

    const Dialect& m_dialect;
    std::string_view m_line;
    std::vector<Token>& m_tokens;
    std::size_t m_at = 0;
    bool m_mnemonicSeen = false;
};

} // namespace

LineState tokenizeLine(const Dialect& dialect, std::string_view line, LineState state, std::vector<Token>& tokens)
{
    return LineLexer(dialect, line, tokens).run(state);
}

std::vector<Token> tokenize(const Dialect& dialect, std::string_view text)
{
    std::vector<Token> out;
    std::vector<Token> ofLine;
    LineState state = LineState::Code;
    for (std::uint32_t line = 0; !text.empty(); ++line) {
        const std::size_t end = text.find('\n');
        std::string_view here = text.substr(0, end);
        text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
        if (here.ends_with('\r'))
            here.remove_suffix(1);
        ofLine.clear();
        state = tokenizeLine(dialect, here, state, ofLine);
        for (Token& token : ofLine) {
            token.line = line;
            out.push_back(token);
        }
    }
    return out;
}

} // namespace camwright
