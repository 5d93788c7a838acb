#include "core/language/source/ilparser.h"

#include "core/language/source/headers.h"
#include "core/language/source/koyodialect.h"
#include "core/language/source/letters.h"
#include "core/language/source/rungsplitting.h"
#include "core/language/source/statementreader.h"
#include "core/language/source/token.h"

#include <algorithm>

namespace camwright {

namespace {

/// A line of the text: its content without the line end, and where the next one begins.
struct Line {
    std::uint32_t number = 0; ///< from 1
    std::size_t begin = 0;
    std::size_t end = 0;
    std::size_t next = 0;
    std::string_view text;
};

class IlParser {
public:
    IlParser(const Dialect& dialect, std::string_view text, const ObjectKey& object)
        : m_dialect(dialect), m_text(text), m_sink(m_program.diagnostics, object), m_reader(dialect, m_sink), m_declarations(dialect, m_program.declarations, &m_sink)
    {
        m_program.dialect = dialect.id;
        m_program.object = object;
        const std::size_t firstEnd = text.find('\n');
        m_program.crlf = firstEnd != std::string_view::npos && firstEnd > 0 && text[firstEnd - 1] == '\r';
    }

    ParsedProgram run()
    {
        Line line;
        while (!m_ended && nextLine(line))
            readLine(line);
        finish();
        if (!m_dialect.networkHeaders)
            joinSplitRungs(m_program, m_dialect.firstNetwork);
        for (ParsedNetwork& network : m_program.networks)
            for (ParsedRung& rung : network.rungs)
                drawRung(m_dialect, rung.rung, &m_sink);
        m_sink.sort();
        return std::move(m_program);
    }

private:
    bool nextLine(Line& line)
    {
        if (line.next >= m_text.size())
            return false;
        line.begin = line.next;
        const std::size_t end = m_text.find('\n', line.begin);
        line.next = end == std::string_view::npos ? m_text.size() : end + 1;
        line.end = end == std::string_view::npos ? m_text.size() : end;
        if (line.end > line.begin && m_text[line.end - 1] == '\r')
            --line.end;
        ++line.number;
        line.text = m_text.substr(line.begin, line.end - line.begin);
        if (line.number == 1 && line.text.starts_with("\xEF\xBB\xBF")) { // a byte order mark is kept and not read
            line.begin += 3;
            line.text.remove_prefix(3);
        }
        return true;
    }

    static TextRange rangeOf(const Line& line, const Token& token)
    {
        return {line.number, token.column + 1, line.number, token.column + token.length + 1};
    }

    void readLine(Line line)
    {
        m_tokens.clear();
        const LineState before = m_state;
        const std::string plain = withPlainBlanks(line.text);
        m_state = tokenizeLine(m_dialect, plain, before, m_tokens);
        m_reader.checkCharacters(line.text, line.number, m_tokens);
        line.text = plain;
        if (m_network == nullptr && before == LineState::Code && readDeclaration(line))
            return;
        std::span<const Token> tokens = m_tokens;
        m_statementOnLine = false;
        if (before == LineState::Comment)
            tokens = continueComment(line, tokens);
        while (!tokens.empty() && !m_ended)
            tokens = readToken(line, tokens);
    }

    /// What is declared before the first network stays in the prologue, with its comments.
    bool readDeclaration(const Line& line)
    {
        if (!m_declarations.read(withoutComments(line.text, m_tokens), line.number))
            return false;
        std::size_t end = line.next;
        if (m_state == LineState::Comment) {
            readComment(line, m_tokens.back(), true);
            end = m_openBegin;
        }
        takeTail(end);
        return true;
    }

    /// The line begins inside a comment: takes what belongs to it.
    std::span<const Token> continueComment(const Line& line, std::span<const Token> tokens)
    {
        if (tokens.empty())
            return tokens; // a blank line of the comment
        if (tokens.front().kind == TokenKind::NetworkHeader) {
            const std::string network = std::to_string(networkHeaderAt(line.text, tokens.front().column)->number);
            m_sink.add(Code::UnterminatedComment, m_openComment, {network}, rangeOf(line, tokens.front()));
            keepComment(m_openBegin, line.begin, line.begin);
            return tokens;
        }
        if (m_state == LineState::Comment && tokens.size() == 1)
            return {};
        const std::size_t end = line.begin + tokens.front().length;
        keepComment(m_openBegin, end, tokens.size() == 1 ? line.next : end);
        return tokens.subspan(1);
    }

    std::span<const Token> readToken(const Line& line, std::span<const Token> tokens)
    {
        const Token& token = tokens.front();
        switch (token.kind) {
        case TokenKind::NetworkHeader:
            beginNetwork(line, token, tokens.size() == 1, networkHeaderAt(line.text, token.column)->number);
            return tokens.subspan(1);
        case TokenKind::Comment:
            readComment(line, token, tokens.size() == 1);
            return tokens.subspan(1);
        case TokenKind::Invalid:
            return readInvalid(line, tokens);
        default:
            return readStatement(line, tokens);
        }
    }

    void readComment(const Line& line, const Token& token, bool isLast)
    {
        const std::size_t begin = line.begin + token.column;
        if (isLast && m_state == LineState::Comment) {
            m_openBegin = begin;
            m_openComment = rangeOf(line, token);
            m_openBelongsToStatement = m_statementOnLine;
            return;
        }
        m_openBelongsToStatement = m_statementOnLine;
        keepComment(begin, begin + token.length, isLast ? line.next : begin + token.length);
    }

    /// Files a finished comment: with the statement before it on its line, or for the statement to come.
    void keepComment(std::size_t begin, std::size_t end, std::size_t pieceEnd)
    {
        std::string_view comment = m_text.substr(begin, end - begin);
        while (!comment.empty() && (comment.back() == '\n' || comment.back() == '\r'))
            comment.remove_suffix(1);
        if (!m_openBelongsToStatement || m_rung == nullptr) {
            m_pending.emplace_back(comment);
            return;
        }
        std::string& trailing = m_rung->rung.statements.back().trailingComment;
        if (!trailing.empty())
            trailing += ' ';
        trailing += comment;
        takePiece(*m_rung, pieceEnd);
    }

    std::span<const Token> readInvalid(const Line& line, std::span<const Token> tokens)
    {
        const Token& token = tokens.front();
        const std::string_view text = line.text.substr(token.column, token.length);
        if (const auto number = escapedNetworkHeader(text)) {
            m_sink.add(Code::MarkdownEscape, rangeOf(line, token),
                {shortened(text), "(* Network " + std::to_string(*number) + " *)"});
            beginNetwork(line, token, true, *number);
            return {};
        }
        const bool isEscapedComment = text.starts_with("(\\*");
        if (isEscapedComment)
            m_sink.add(Code::MarkdownEscape, rangeOf(line, token), {shortened(text), "(* ... *)"});
        else if (text.starts_with("```"))
            m_sink.add(Code::MarkdownFence, rangeOf(line, token));
        else
            m_sink.add(Code::StrayText, rangeOf(line, token), {shortened(text)});
        Statement statement;
        statement.role = StatementRole::Invalid;
        statement.mnemonic = text;
        statement.range = rangeOf(line, token);
        addStatement(line, std::move(statement), tokens.size() == 1);
        return tokens.subspan(1);
    }

    std::span<const Token> readStatement(const Line& line, std::span<const Token> tokens)
    {
        const auto isPart = [](const Token& token) { return token.kind != TokenKind::Comment; };
        std::size_t count = 0; // up to the first comment that is followed by comments only
        for (std::size_t i = 0; i < tokens.size(); ++i)
            if (isPart(tokens[i]))
                count = i + 1;
        std::vector<Token> parts;
        std::copy_if(tokens.begin(), tokens.begin() + static_cast<std::ptrdiff_t>(count), std::back_inserter(parts), isPart);
        Statement statement = m_reader.read(line.text, line.number, parts);
        if (statement.operands.empty() && upperCase(statement.mnemonic) == "END") {
            endProgram(line, tokens.subspan(count));
            return {};
        }
        for (const Token& token : tokens.first(count))
            if (!isPart(token)) {
                if (!statement.trailingComment.empty())
                    statement.trailingComment += ' ';
                statement.trailingComment += line.text.substr(token.column, token.length);
            }
        addStatement(line, std::move(statement), count == tokens.size());
        return tokens.subspan(count);
    }

    void addStatement(const Line& line, Statement statement, bool endsLine)
    {
        if (m_network == nullptr || (m_networkIsDerived && startsRung(statement)))
            deriveNetwork(statement);
        else if (m_rung == nullptr || startsRung(statement))
            m_rung = &m_network->rungs.emplace_back();
        m_splitter.follow(statement.role);
        m_afterMark = m_dialect.id == DialectId::KoyoIl && standsAlone(statement.mnemonic);
        statement.leadingComments = std::move(m_pending);
        m_pending.clear();
        if (!m_rung->rung.range.isValid())
            m_rung->rung.range = statement.range;
        m_rung->rung.range.endLine = statement.range.endLine;
        m_rung->rung.range.endColumn = statement.range.endColumn;
        const std::size_t end = line.begin + statement.range.endColumn - 1;
        m_rung->rung.statements.push_back(std::move(statement));
        m_statementOnLine = true;
        takePiece(*m_rung, endsLine ? line.next : end);
    }

    /// Whether a statement begins a rung of its own: only where networks are not headed by text, at a LD after a finished
    /// flow.
    bool startsRung(const Statement& statement) const
    {
        if (m_dialect.id == DialectId::KoyoIl && (standsAlone(statement.mnemonic) || m_afterMark))
            return true;
        return !m_dialect.networkHeaders && m_splitter.startsRung(statement.role);
    }

    void deriveNetwork(const Statement& statement)
    {
        if (m_dialect.networkHeaders)
            m_sink.add(Code::StatementBeforeNetwork, statement.range);
        ParsedNetwork& network = openNetwork(m_nextNumber, statement.range);
        m_networkIsDerived = !m_dialect.networkHeaders;
        m_rung = &network.rungs.emplace_back();
    }

    void beginNetwork(const Line& line, const Token& token, bool wholeLine, std::uint32_t number)
    {
        if (number != m_nextNumber)
            m_sink.add(Code::NetworkNumber, rangeOf(line, token), {std::to_string(number), std::to_string(m_nextNumber)});
        const bool startsLine = trimmed(line.text.substr(0, token.column)).empty();
        takeTail(startsLine ? line.begin : line.begin + token.column);
        ParsedNetwork& network = openNetwork(number, rangeOf(line, token));
        m_networkIsDerived = false;
        m_rung = nullptr;
        const std::size_t end = wholeLine ? line.next : line.begin + token.column + token.length;
        network.header = m_text.substr(m_pieceBegin, end - m_pieceBegin);
        m_pieceBegin = end;
    }

    ParsedNetwork& openNetwork(std::uint32_t number, const TextRange& range)
    {
        m_network = &m_program.networks.emplace_back();
        m_network->number = number;
        m_network->range = range;
        m_nextNumber = number + 1;
        m_splitter = {};
        m_afterMark = false;
        return *m_network;
    }

    void takePiece(ParsedRung& rung, std::size_t end)
    {
        if (end <= m_pieceBegin)
            return;
        rung.source += m_text.substr(m_pieceBegin, end - m_pieceBegin);
        m_pieceBegin = end;
    }

    /// What stands between the last statement and `end` belongs to no statement.
    void takeTail(std::size_t end)
    {
        end = std::max(end, m_pieceBegin);
        std::string& piece = m_network ? m_network->tail : m_program.prologue;
        piece += m_text.substr(m_pieceBegin, end - m_pieceBegin);
        m_pieceBegin = end;
        m_pending.clear();
    }

    void endProgram(const Line& line, std::span<const Token> rest)
    {
        takeTail(line.begin);
        m_program.epilogue = m_text.substr(m_pieceBegin);
        m_pieceBegin = m_text.size();
        m_ended = true;
        const bool clean = std::all_of(rest.begin(), rest.end(), [](const Token& t) { return t.kind == TokenKind::Comment; });
        Line after = line;
        if (!clean)
            m_sink.add(Code::TextAfterEnd, rangeOf(line, rest.front()));
        while (nextLine(after)) {
            m_tokens.clear();
            m_state = tokenizeLine(m_dialect, after.text, m_state, m_tokens);
            for (const Token& token : m_tokens)
                if (token.kind != TokenKind::Comment) {
                    m_sink.add(Code::TextAfterEnd, rangeOf(after, token));
                    m_state = LineState::Code;
                    return;
                }
        }
    }

    void finish()
    {
        if (m_state == LineState::Comment && !m_ended)
            m_sink.add(Code::CommentOpenAtEnd, m_openComment);
        takeTail(m_text.size());
    }

    const Dialect& m_dialect;
    std::string_view m_text;
    ParsedProgram m_program;
    DiagnosticSink m_sink;
    StatementReader m_reader;
    DeclarationReader m_declarations;
    std::vector<Token> m_tokens;
    LineState m_state = LineState::Code;
    std::size_t m_pieceBegin = 0;
    std::vector<std::string> m_pending;
    std::size_t m_openBegin = 0;
    TextRange m_openComment;
    bool m_openBelongsToStatement = false;
    bool m_statementOnLine = false;
    ParsedNetwork* m_network = nullptr;
    ParsedRung* m_rung = nullptr;
    bool m_networkIsDerived = false;
    std::uint32_t m_nextNumber = m_dialect.firstNetwork;
    RungSplitter m_splitter;
    bool m_afterMark = false; ///< the last statement was a rung of its own (NEXT)
    bool m_ended = false;
};

} // namespace

ParsedProgram parseIl(const Dialect& dialect, std::string_view text, const ObjectKey& object)
{
    return IlParser(dialect, text, object).run();
}

} // namespace camwright
