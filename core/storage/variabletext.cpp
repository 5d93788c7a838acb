#include "core/storage/variabletext.h"

#include "core/storage/filenames.h"
#include "core/storage/quotedtext.h"

#include <algorithm>

namespace camwright {

namespace {

bool isWordCharacter(char c)
{
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' || static_cast<std::uint8_t>(c) >= 0x80;
}

bool isAddressCharacter(char c)
{
    return isWordCharacter(c) || c == '%' || c == '.';
}

bool isKeyword(std::string_view word)
{
    static constexpr std::string_view Words[] = {"var_global", "end_var", "retain", "at"};
    return std::find(std::begin(Words), std::end(Words), foldedCase(word)) != std::end(Words);
}

constexpr std::size_t MostErrors = 50;

class VariableReader {
public:
    VariableReader(std::string_view text, std::uint32_t firstLine, const std::string& file)
        : m_text(text), m_line(firstLine), m_file(file)
    {
    }

    Result<VariableText, Diagnostics> read()
    {
        skipSpace();
        while (m_at < m_text.size() && m_errors.size() < MostErrors)
            readBlock();
        if (!m_errors.empty())
            return std::move(m_errors);
        return std::move(m_out);
    }

private:
    void readBlock()
    {
        m_out.lines.push_back(m_line);
        if (!takeWord("VAR_GLOBAL")) {
            expected("VAR_GLOBAL");
            skipLine();
            return;
        }
        skipSpace();
        const bool retain = takeWord("RETAIN");
        for (;;) {
            skipSpace();
            m_out.lines.push_back(m_line);
            if (takeWord("END_VAR"))
                break;
            if (m_at == m_text.size() || m_errors.size() >= MostErrors) {
                expected("END_VAR");
                return;
            }
            readRow(retain);
        }
        skipSpace();
    }

    void readRow(bool retain)
    {
        Variable row;
        row.retain = retain;
        TextRange range{m_line, column(), 0, 0};
        if (!readToken(row.name, "NAME", isWordCharacter) || !readAddress(row) || !readType(row) || !readInitial(row)) {
            skipLine();
            return;
        }
        range.endLine = m_line;
        range.endColumn = column();
        row.comment = readComment();
        m_out.rows.push_back(std::move(row));
        m_out.rowRanges.push_back(range);
    }

    bool readAddress(Variable& row)
    {
        skipSpace();
        if (!takeWord("AT"))
            return true;
        skipSpace();
        return readToken(row.address, "ADDRESS", isAddressCharacter);
    }

    bool readType(Variable& row)
    {
        skipSpace();
        if (!take(":"))
            return expected(":");
        skipSpace();
        std::string type;
        const bool inQuotes = peek() == '"';
        if (!readToken(type, "TYPE", isWordCharacter))
            return false;
        const auto known = inQuotes ? std::nullopt : dataTypeByName(type);
        row.type = known ? Field<DataType>(*known) : Field<DataType>::typed(type);
        return true;
    }

    bool readInitial(Variable& row)
    {
        skipSpace();
        if (take(":=")) {
            skipSpace();
            if (peek() == '"') {
                if (!readToken(row.initial, "VALUE", isWordCharacter))
                    return false;
            } else {
                const std::size_t end = std::min(m_text.find_first_of(";\n", m_at), m_text.size());
                row.initial = m_text.substr(m_at, end - m_at);
                m_at = end;
                row.initial.erase(row.initial.find_last_not_of(" \t\r") + 1);
                if (row.initial.empty())
                    return expected("VALUE");
            }
            skipSpace();
        }
        return take(";") || expected(";");
    }

    /// A comment behind the row on its last line.
    std::string readComment()
    {
        while (peek() == ' ' || peek() == '\t')
            ++m_at;
        if (take("//")) {
            if (peek() == ' ')
                ++m_at;
            const std::size_t end = std::min(m_text.find('\n', m_at), m_text.size());
            const std::string out = unescaped(m_text.substr(m_at, end - m_at));
            m_at = end;
            return out;
        }
        if (!m_text.substr(m_at).starts_with("(*"))
            return {};
        const std::size_t begin = m_at + 2;
        skipBlockComment();
        const std::size_t end = m_at >= begin + 2 ? m_at - 2 : begin;
        std::string_view out = m_text.substr(begin, end - begin);
        out.remove_prefix(std::min(out.find_first_not_of(" \t\n"), out.size()));
        return std::string(out.substr(0, out.find_last_not_of(" \t\n") + 1));
    }

    bool readToken(std::string& out, std::string_view what, bool (*belongs)(char))
    {
        if (peek() == '"') {
            const auto length = quotedLength(m_text.substr(m_at));
            if (!length)
                return expected("\"");
            out = unescaped(m_text.substr(m_at + 1, *length - 2));
            m_at += *length;
            return true;
        }
        const auto begin = m_text.begin() + static_cast<std::ptrdiff_t>(m_at);
        const auto end = std::find_if_not(begin, m_text.end(), belongs);
        if (begin == end)
            return expected(what);
        out.assign(begin, end);
        m_at += out.size();
        return true;
    }

    void skipSpace()
    {
        for (;;) {
            if (peek() == '\n')
                newLine();
            else if (peek() == ' ' || peek() == '\t' || peek() == '\r')
                ++m_at;
            else if (m_text.substr(m_at).starts_with("//"))
                m_at = std::min(m_text.find('\n', m_at), m_text.size());
            else if (m_text.substr(m_at).starts_with("(*"))
                skipBlockComment();
            else
                return;
        }
    }

    void skipBlockComment()
    {
        const std::size_t end = m_text.find("*)", m_at + 2);
        if (end == std::string_view::npos)
            expected("*)");
        const std::size_t to = end == std::string_view::npos ? m_text.size() : end + 2;
        while (m_at < to) {
            if (m_text[m_at] == '\n')
                newLine();
            else
                ++m_at;
        }
    }

    void skipLine() { m_at = std::min(m_text.find('\n', m_at), m_text.size()); skipSpace(); }
    void newLine() { ++m_at; ++m_line; m_lineStart = m_at; }
    char peek() const { return m_at < m_text.size() ? m_text[m_at] : '\0'; }
    std::uint32_t column() const { return static_cast<std::uint32_t>(m_at - m_lineStart + 1); }

    bool take(std::string_view token)
    {
        if (!m_text.substr(m_at).starts_with(token))
            return false;
        m_at += token.size();
        return true;
    }

    bool takeWord(std::string_view word)
    {
        const std::string_view here = m_text.substr(m_at, word.size());
        const bool ends = m_at + word.size() >= m_text.size() || !isWordCharacter(m_text[m_at + word.size()]);
        if (!ends || foldedCase(here) != foldedCase(word))
            return false;
        m_at += word.size();
        return true;
    }

    /// The word or character at which reading stopped; empty at the end of a line.
    std::string found() const
    {
        const std::string_view rest = m_text.substr(m_at, 40);
        const auto end = std::find_if_not(rest.begin(), rest.end(), isWordCharacter);
        const std::size_t length = std::max<std::size_t>(static_cast<std::size_t>(end - rest.begin()), 1);
        return rest.starts_with('\n') ? std::string() : std::string(rest.substr(0, length));
    }

    bool expected(std::string_view what)
    {
        Place place;
        place.file = m_file;
        place.range = {m_line, column(), m_line, column() + 1};
        const std::string wanted(what);
        if (m_errors.size() < MostErrors)
            m_errors.push_back(m_at >= m_text.size() ? diagnostic(Code::VariableTextEnds, {wanted}, place)
                                                     : diagnostic(Code::VariableTextWrong, {wanted, found()}, place));
        return false;
    }

    std::string_view m_text;
    std::size_t m_at = 0;
    std::size_t m_lineStart = 0;
    std::uint32_t m_line;
    const std::string& m_file;
    VariableText m_out;
    Diagnostics m_errors;
};

std::string tokenText(std::string_view text, bool (*belongs)(char))
{
    const bool plain = !text.empty() && std::all_of(text.begin(), text.end(), belongs) && !isKeyword(text);
    return plain ? std::string(text) : quoted(text);
}

std::string typeText(const Field<DataType>& type)
{
    if (type.isValid())
        return std::string(name(type.value()));
    return dataTypeByName(type.text()) ? quoted(type.text()) : tokenText(type.text(), isWordCharacter);
}

std::string initialText(std::string_view text)
{
    const bool plain = text.front() != ' ' && text.back() != ' ' && text.find("//") == std::string_view::npos
        && text.find("(*") == std::string_view::npos
        && std::none_of(text.begin(), text.end(), [](char c) { return c == ';' || c == '"' || static_cast<std::uint8_t>(c) < 0x20 || c == 0x7F; });
    return plain ? std::string(text) : quoted(text);
}

std::string rowText(const Variable& row)
{
    std::string out = "    " + tokenText(row.name, isWordCharacter);
    if (!row.address.empty())
        out += " AT " + tokenText(row.address, isAddressCharacter);
    out += " : " + typeText(row.type);
    if (!row.initial.empty())
        out += " := " + initialText(row.initial);
    out += ';';
    if (!row.comment.empty())
        out += "  // " + escapedLine(row.comment);
    return out;
}

} // namespace

Result<VariableText, Diagnostics> readVariables(std::string_view text, std::uint32_t firstLine, const std::string& file)
{
    return VariableReader(text, firstLine, file).read();
}

std::vector<std::string> variableLines(const VariableTable& table)
{
    std::vector<std::string> out;
    bool retain = false;
    for (const VariableTable::Chunk& chunk : table.chunks) {
        for (const Variable& row : *chunk) {
            if (out.empty() || row.retain != retain) {
                if (!out.empty())
                    out.push_back("END_VAR");
                retain = row.retain;
                out.push_back(retain ? "VAR_GLOBAL RETAIN" : "VAR_GLOBAL");
            }
            out.push_back(rowText(row));
        }
    }
    if (out.empty())
        out.push_back("VAR_GLOBAL");
    out.push_back("END_VAR");
    return out;
}

} // namespace camwright
