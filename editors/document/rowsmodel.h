#pragma once

#include <QAbstractTableModel>

#include <algorithm>
#include <vector>

namespace camwright {

/// The rows of one object of the document with an empty row at the end to type a new one into. takeRows() announces only what
/// differs, so that cursor, selection and scroll position stay with the rows they stand on; the empty row that was typed
/// into becomes the new row, and another empty one follows.
template <class Row>
class RowsModel : public QAbstractTableModel {
public:
    using QAbstractTableModel::QAbstractTableModel;

    const std::vector<Row>& rows() const { return m_rows; }
    int rowCount(const QModelIndex& parent = {}) const override
    {
        return parent.isValid() ? 0 : static_cast<int>(m_rows.size()) + (m_hasEmptyRow ? 1 : 0);
    }

protected:
    bool isEmptyRow(int row) const { return row == static_cast<int>(m_rows.size()); }
    const Row& rowAt(int row) const { return m_rows[static_cast<std::size_t>(row)]; }
    void takeRows(std::vector<Row> rows);
    /// For another object: everything anew.
    void resetRows(std::vector<Row> rows)
    {
        beginResetModel();
        m_rows = std::move(rows);
        endResetModel();
    }

private:
    void insertAtEnd(std::vector<Row> rows);

    std::vector<Row> m_rows;
    bool m_hasEmptyRow = true; ///< false only while the empty row turns into a row
};

template <class Row>
void RowsModel<Row>::takeRows(std::vector<Row> rows)
{
    const auto first = std::ranges::mismatch(m_rows, rows).in1 - m_rows.begin();
    auto before = static_cast<std::ptrdiff_t>(m_rows.size()), after = static_cast<std::ptrdiff_t>(rows.size());
    for (; before > first && after > first && m_rows[static_cast<std::size_t>(before - 1)] == rows[static_cast<std::size_t>(after - 1)]; --before)
        --after;
    const auto kept = std::min(before, after); // rows [first, kept) differ in place
    if (kept > first) {
        std::copy(rows.begin() + first, rows.begin() + kept, m_rows.begin() + first);
        emit dataChanged(index(static_cast<int>(first), 0), index(static_cast<int>(kept) - 1, columnCount() - 1));
    }
    if (before > kept) {
        beginRemoveRows({}, static_cast<int>(kept), static_cast<int>(before) - 1);
        m_rows = std::move(rows);
        endRemoveRows();
    } else if (after > kept && kept == static_cast<std::ptrdiff_t>(m_rows.size())) {
        insertAtEnd(std::move(rows));
    } else if (after > kept) {
        beginInsertRows({}, static_cast<int>(kept), static_cast<int>(after) - 1);
        m_rows = std::move(rows);
        endInsertRows();
    }
}

template <class Row>
void RowsModel<Row>::insertAtEnd(std::vector<Row> rows)
{
    const int filled = static_cast<int>(m_rows.size());
    m_hasEmptyRow = false;
    m_rows.push_back(rows[static_cast<std::size_t>(filled)]);
    emit dataChanged(index(filled, 0), index(filled, columnCount() - 1));
    beginInsertRows({}, filled + 1, static_cast<int>(rows.size()));
    m_rows = std::move(rows);
    m_hasEmptyRow = true;
    endInsertRows();
}

} // namespace camwright
