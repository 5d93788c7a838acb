#pragma once

#include "core/base/diagnostic.h"
#include "core/base/result.h"

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace camwright {

/// A table of comma-separated values (RFC 4180): a header row, then rows of the same width. Cells may be quoted; a quoted
/// cell may hold commas, doubled quotes and line breaks.
class CsvTable {
public:
    /// `name` is the file the diagnostics name. Every wrong row is reported, and every column missing of `columns`.
    static Result<CsvTable, Diagnostics> read(std::string_view name, std::string_view text, std::span<const std::string_view> columns);

    const std::string& name() const { return m_name; }
    std::size_t rowCount() const { return m_rows.size(); }
    /// The text of a cell; empty if the table has no such column.
    std::string_view cell(std::size_t row, std::string_view column) const;
    std::uint32_t line(std::size_t row) const { return m_rows[row].line; } ///< where the row begins, from 1

private:
    struct Row {
        std::uint32_t line = 0;
        std::vector<std::string> cells;
    };
    friend class CsvParser;

    std::string m_name;
    std::vector<std::string> m_columns;
    std::vector<Row> m_rows;
};

/// Reads typed cells of one row and collects what is wrong, located by file, line and column name.
class CsvRow {
public:
    CsvRow(const CsvTable& table, std::size_t row, Diagnostics& diagnostics) : m_table(table), m_row(row), m_diagnostics(diagnostics) {}

    std::string text(std::string_view column) const { return std::string(m_table.cell(m_row, column)); }
    bool isEmpty(std::string_view column) const { return m_table.cell(m_row, column).empty(); }
    std::int64_t integer(std::string_view column, std::int64_t minimum, std::int64_t maximum);
    /// As integer, but an empty cell is 0.
    template <class T>
    T count(std::string_view column, std::int64_t maximum = 0xFFFFFFFF)
    {
        return isEmpty(column) ? T{} : static_cast<T>(integer(column, 0, maximum));
    }
    std::optional<double> number(std::string_view column); ///< empty: nothing
    bool flag(std::string_view column);                    ///< "yes", "no" or empty (no)
    std::vector<std::string> words(std::string_view column) const; ///< blank-separated

    template <class T>
    T choice(std::string_view column, std::span<const std::pair<std::string_view, T>> choices)
    {
        const std::string_view cell = m_table.cell(m_row, column);
        for (const auto& [word, value] : choices) {
            if (word == cell)
                return value;
        }
        std::string legal;
        for (const auto& [word, value] : choices)
            legal += (legal.empty() ? "" : ", ") + std::string(word.empty() ? "nothing" : word);
        illegal(column, legal);
        return choices.front().second;
    }

    void illegal(std::string_view column, std::string legal);
    void duplicate(std::string_view column);

private:
    Place place(std::string_view column) const;

    const CsvTable& m_table;
    std::size_t m_row;
    Diagnostics& m_diagnostics;
};

} // namespace camwright
