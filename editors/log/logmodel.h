#pragma once

#include "core/online/controllerlink.h"

#include <QAbstractTableModel>

#include <deque>

namespace camwright {

/// The controller's log, newest first, at most `Limit` entries.
class LogModel : public QAbstractTableModel {
    Q_OBJECT
public:
    enum Column { When, Cycle, CodeId, Text, ColumnCount };
    static constexpr std::size_t Limit = 10000;

    explicit LogModel(QObject* parent = nullptr) : QAbstractTableModel(parent) {}

    void clear();
    /// Entries already known by their sequence number are left out.
    void add(const std::vector<LogEntry>& entries);
    const LogEntry& entry(int row) const { return m_entries[static_cast<std::size_t>(row)]; }
    std::uint64_t nextSequence() const { return m_entries.empty() ? 0 : m_entries.front().sequence + 1; }

    int rowCount(const QModelIndex& parent = {}) const override;
    int columnCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

private:
    std::deque<LogEntry> m_entries;
};

} // namespace camwright
