#include "core/storage/tomltext.h"

#include "core/base/utf8.h"

// Compiled here, once, and not taken from the shared library, so that sanitizers and fuzzers see the parser too. Its
// assertions are off: 3.3 asserts on what a damaged file may well hold ("[!]") before the code that reports it.
#undef TOML_HEADER_ONLY
#undef TOML_SHARED_LIB
#define TOML_HEADER_ONLY 1
#define TOML_EXCEPTIONS 1
#define TOML_ENABLE_FORMATTERS 0
#define TOML_ENABLE_WINDOWS_COMPAT 0
#include <toml++/impl/preprocessor.h>
#undef TOML_ASSERT
#undef TOML_ASSERT_ASSUME
#define TOML_ASSERT(condition) static_cast<void>(0)
#define TOML_ASSERT_ASSUME(condition) static_cast<void>(0)
#include <toml++/toml.h>

#include <algorithm>
#include <charconv>

namespace camwright {

namespace {

/// toml++ counts columns in code points; places and offsets here are bytes.
class Lines {
public:
    explicit Lines(std::string_view text) : m_text(text)
    {
        m_starts.push_back(0);
        for (std::size_t at = 0; at < text.size(); ++at) {
            if (text[at] == '\n')
                m_starts.push_back(at + 1);
        }
    }
    std::size_t offset(const toml::source_position& position) const
    {
        const std::size_t line = position.line < 1 ? 0 : std::min<std::size_t>(position.line - 1, m_starts.size() - 1);
        std::size_t at = m_starts[line];
        if (at == 0 && m_text.starts_with("\xEF\xBB\xBF"))
            at = 3;
        for (std::uint32_t column = 1; column < position.column && at < m_text.size() && m_text[at] != '\n'; ++column) {
            const auto point = codePointAt(m_text, at);
            at += point ? point->length : 1;
        }
        return at;
    }
    TextRange range(std::size_t begin, std::size_t end) const
    {
        const auto [line, column] = position(begin);
        const auto [endLine, endColumn] = position(std::max(begin, end));
        return {line, column, endLine, endColumn};
    }

private:
    std::pair<std::uint32_t, std::uint32_t> position(std::size_t offset) const
    {
        const auto next = std::upper_bound(m_starts.begin(), m_starts.end(), offset);
        const auto line = static_cast<std::uint32_t>(next - m_starts.begin());
        return {line, static_cast<std::uint32_t>(offset - m_starts[line - 1] + 1)};
    }

    std::string_view m_text;
    std::vector<std::size_t> m_starts;
};

class LeafReader {
public:
    explicit LeafReader(std::string_view text) : m_text(text), m_lines(text) {}

    std::vector<TomlLeaf> read(const toml::table& root)
    {
        collect(root, "");
        std::sort(m_leaves.begin(), m_leaves.end(), [](const TomlLeaf& a, const TomlLeaf& b) {
            return std::tie(a.value.begin, a.path) < std::tie(b.value.begin, b.path);
        });
        return std::move(m_leaves);
    }
    const Lines& lines() const { return m_lines; }

private:
    void collect(const toml::table& table, const std::string& prefix)
    {
        for (const auto& [key, node] : table) {
            const std::string path = prefix + tomlKey(key.str());
            const toml::table* inner = node.as_table();
            if (inner && !inner->is_inline())
                collect(*inner, path + '.');
            else
                m_leaves.push_back({path, value(node)});
        }
    }

    TomlValue value(const toml::node& node)
    {
        TomlValue out;
        out.begin = m_lines.offset(node.source().begin);
        out.end = std::max(out.begin, m_lines.offset(node.source().end));
        out.range = m_lines.range(out.begin, out.end);
        out.text = m_text.substr(out.begin, out.end - out.begin);
        if (const auto* string = node.as_string()) {
            out.string = string->get();
        } else if (const auto* integer = node.as_integer()) {
            out.kind = TomlValue::Kind::Integer;
            out.integer = integer->get();
        } else if (const auto* number = node.as_floating_point()) {
            out.kind = TomlValue::Kind::Float;
            out.number = number->get();
        } else if (node.is_boolean()) {
            out.kind = TomlValue::Kind::Boolean;
        } else if (const auto* array = node.as_array()) {
            readArray(*array, out);
        } else if (const auto* table = node.as_table()) {
            readTable(*table, out);
        } else {
            out.kind = TomlValue::Kind::Date;
        }
        return out;
    }

    void readArray(const toml::array& array, TomlValue& out)
    {
        out.kind = TomlValue::Kind::Array;
        for (const toml::node& element : array) {
            const toml::table* table = element.as_table();
            out.hasHeaders = out.hasHeaders || (table && !table->is_inline());
            out.elements.push_back(value(element));
        }
        if (!out.hasHeaders)
            return;
        out.text = "[";
        for (const TomlValue& element : out.elements)
            out.text += (out.text.size() == 1 ? "" : ", ") + element.text;
        out.text += ']';
    }

    void readTable(const toml::table& table, TomlValue& out)
    {
        out.kind = TomlValue::Kind::Table;
        for (const auto& [key, node] : table)
            out.members.push_back({std::string(key.str()), value(node)});
        std::sort(out.members.begin(), out.members.end(),
                  [](const auto& a, const auto& b) { return a.value.begin < b.value.begin; });
        if (table.is_inline())
            return;
        out.text = "{";
        for (const auto& [key, member] : out.members)
            out.text += (out.text.size() == 1 ? " " : ", ") + tomlKey(key) + " = " + member.text;
        out.text += " }";
    }

    std::string_view m_text;
    Lines m_lines;
    std::vector<TomlLeaf> m_leaves;
};

bool isBareKey(std::string_view part)
{
    return !part.empty() && std::all_of(part.begin(), part.end(), [](char c) {
        return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' || c == '-';
    });
}

} // namespace

Result<std::vector<TomlLeaf>> parseToml(std::string_view text, const std::string& file)
{
    LeafReader reader(text);
    Place place;
    place.file = file;
    if (const std::size_t bad = firstInvalidUtf8(text); bad != std::string_view::npos) {
        place.range = reader.lines().range(bad, bad + 1);
        return diagnostic(Code::NotUtf8, {}, place);
    }
    try {
        return reader.read(toml::parse(text));
    } catch (const toml::parse_error& error) {
        const std::size_t at = reader.lines().offset(error.source().begin);
        place.range = reader.lines().range(at, at);
        return diagnostic(Code::NotToml, {std::string(error.description())}, place);
    }
}

std::string tomlString(std::string_view text)
{
    std::string out = "\"";
    for (char c : validUtf8(text)) {
        const auto byte = static_cast<std::uint8_t>(c);
        switch (c) {
        case '"': out += "\\\""; break;
        case '\\': out += "\\\\"; break;
        case '\n': out += "\\n"; break;
        case '\r': out += "\\r"; break;
        case '\t': out += "\\t"; break;
        default:
            if (byte < 0x20 || byte == 0x7F) {
                static constexpr char Digits[] = "0123456789ABCDEF";
                out += "\\u00";
                out += Digits[byte >> 4];
                out += Digits[byte & 15];
            } else {
                out += c;
            }
        }
    }
    return out + '"';
}

std::string tomlNumber(double value)
{
    char buffer[64];
    std::string out(buffer, std::to_chars(buffer, buffer + sizeof buffer, value).ptr);
    if (out.find_first_of(".en") == std::string::npos)
        out += ".0";
    return out;
}

std::string tomlKey(std::string_view part)
{
    return isBareKey(part) ? std::string(part) : tomlString(part);
}

} // namespace camwright
