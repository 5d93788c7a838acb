#include "core/family/csv.h"

#include <algorithm>
#include <charconv>

namespace camwright {

/// One pass over the text of a table.
class CsvParser {
public:
    CsvParser(std::string_view name, std::string_view text) : m_name(name), m_text(text) {}

    bool atEnd() const { return m_at == m_text.size(); }

    CsvTable::Row row(std::size_t expectedCells)
    {
        CsvTable::Row out;
        out.line = m_line;
        out.cells.reserve(expectedCells);
        do
            out.cells.push_back(cell());
        while (take(','));
        endOfRow();
        return out;
    }

    void say(Code code, std::uint32_t line, std::vector<std::string> arguments = {})
    {
        Place place;
        place.file = m_name;
        place.range = {line, 1, line, 1};
        m_diagnostics.push_back(diagnostic(code, std::move(arguments), std::move(place)));
    }
    Diagnostics takeDiagnostics() { return std::move(m_diagnostics); }

private:
    bool take(char c)
    {
        if (atEnd() || m_text[m_at] != c)
            return false;
        ++m_at;
        return true;
    }

    std::string cell()
    {
        if (take('"'))
            return quoted();
        const std::size_t begin = m_at;
        while (!atEnd() && m_text[m_at] != ',' && m_text[m_at] != '\n' && m_text[m_at] != '\r')
            ++m_at;
        return std::string(m_text.substr(begin, m_at - begin));
    }

    std::string quoted()
    {
        const std::uint32_t line = m_line;
        std::string out;
        while (!atEnd()) {
            const char c = m_text[m_at++];
            if (c == '"' && !take('"'))
                return out;
            m_line += c == '\n';
            out += c;
        }
        say(Code::TableQuoteOpen, line);
        return out;
    }

    void endOfRow()
    {
        const std::uint32_t line = m_line;
        take('\r');
        if (!atEnd() && !take('\n')) {
            say(Code::TableQuoteOpen, line);
            while (!atEnd() && m_text[m_at] != '\n')
                ++m_at;
            take('\n');
        }
        ++m_line;
    }

    std::string m_name;
    std::string_view m_text;
    std::size_t m_at = 0;
    std::uint32_t m_line = 1;
    Diagnostics m_diagnostics;
};

Result<CsvTable, Diagnostics> CsvTable::read(std::string_view name, std::string_view text, std::span<const std::string_view> columns)
{
    CsvParser parser(name, text);
    CsvTable out;
    out.m_name = name;
    if (!parser.atEnd())
        out.m_columns = parser.row(columns.size()).cells;
    for (std::string_view column : columns) {
        if (std::ranges::find(out.m_columns, column) == out.m_columns.end())
            parser.say(Code::TableColumnMissing, 1, {std::string(column)});
    }
    while (!parser.atEnd()) {
        Row row = parser.row(out.m_columns.size());
        if (row.cells.size() != out.m_columns.size())
            parser.say(Code::TableRowWidth, row.line, {std::to_string(row.cells.size()), std::to_string(out.m_columns.size())});
        else
            out.m_rows.push_back(std::move(row));
    }
    Diagnostics diagnostics = parser.takeDiagnostics();
    if (!diagnostics.empty())
        return diagnostics;
    return out;
}

std::string_view CsvTable::cell(std::size_t row, std::string_view column) const
{
    const auto found = std::ranges::find(m_columns, column);
    return found == m_columns.end() ? std::string_view{} : m_rows[row].cells[static_cast<std::size_t>(found - m_columns.begin())];
}

std::int64_t CsvRow::integer(std::string_view column, std::int64_t minimum, std::int64_t maximum)
{
    std::string_view cell = m_table.cell(m_row, column);
    const bool hexadecimal = cell.starts_with("0x");
    if (hexadecimal)
        cell.remove_prefix(2);
    std::int64_t value = 0;
    const auto [end, error] = std::from_chars(cell.data(), cell.data() + cell.size(), value, hexadecimal ? 16 : 10);
    if (error == std::errc{} && end == cell.data() + cell.size() && value >= minimum && value <= maximum)
        return value;
    illegal(column, std::to_string(minimum) + " … " + std::to_string(maximum));
    return minimum;
}

std::optional<double> CsvRow::number(std::string_view column)
{
    const std::string_view cell = m_table.cell(m_row, column);
    if (cell.empty())
        return std::nullopt;
    double value = 0;
    const auto [end, error] = std::from_chars(cell.data(), cell.data() + cell.size(), value);
    if (error == std::errc{} && end == cell.data() + cell.size())
        return value;
    illegal(column, "a number");
    return std::nullopt;
}

bool CsvRow::flag(std::string_view column)
{
    static constexpr std::pair<std::string_view, bool> Choices[] = {{"", false}, {"no", false}, {"yes", true}};
    return choice<bool>(column, Choices);
}

std::vector<std::string> CsvRow::words(std::string_view column) const
{
    std::vector<std::string> out;
    std::string_view rest = m_table.cell(m_row, column);
    while (!rest.empty()) {
        const std::size_t end = std::min(rest.find(' '), rest.size());
        if (end > 0)
            out.emplace_back(rest.substr(0, end));
        rest.remove_prefix(std::min(end + 1, rest.size()));
    }
    return out;
}

void CsvRow::illegal(std::string_view column, std::string legal)
{
    m_diagnostics.push_back(diagnostic(Code::TableCellIllegal, {text(column), std::string(column), std::move(legal)}, place(column)));
}

void CsvRow::duplicate(std::string_view column)
{
    m_diagnostics.push_back(diagnostic(Code::TableDuplicate, {text(column), std::string(column)}, place(column)));
}

Place CsvRow::place(std::string_view column) const
{
    Place out;
    out.file = m_table.name();
    out.field = column;
    const std::uint32_t line = m_table.line(m_row);
    out.range = {line, 1, line, 1};
    return out;
}

} // namespace camwright
