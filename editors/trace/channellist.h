#pragma once

#include "core/online/tracebuffer.h"

#include <QAbstractTableModel>

#include <vector>

namespace camwright {

/// The channels of the oscilloscope: what is recorded now and what the next recording asks for, with the values at the cursors.
class ChannelListModel : public QAbstractTableModel {
    Q_OBJECT
public:
    enum Column { Name, AtA, AtB, ColumnCount };

    explicit ChannelListModel(const TraceBuffer& buffer, QObject* parent = nullptr);

    const std::vector<std::string>& channels() const { return m_channels; }
    /// A channel that stays in the list stays shown or hidden.
    void setChannels(std::vector<std::string> channels);
    void setFamily(const std::string& family) { m_family = family; } ///< whose states the channels of axes tell
    void setCursors(std::uint64_t cycleA, std::uint64_t cycleB);
    void refreshValues();
    bool isShown(int row) const { return m_shown[static_cast<std::size_t>(row)]; }
    /// Index of the channel in the recording; −1 when it is not part of it.
    int recorded(int row) const;

    int rowCount(const QModelIndex& parent = {}) const override;
    int columnCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role) const override;
    bool setData(const QModelIndex& index, const QVariant& value, int role) override;
    QVariant headerData(int section, Qt::Orientation orientation, int role) const override;
    Qt::ItemFlags flags(const QModelIndex& index) const override;

signals:
    void shownChanged(int row, bool shown);

private:
    QString valueAt(int row, std::uint64_t cycle) const;

    const TraceBuffer& m_buffer;
    std::string m_family;
    std::vector<std::string> m_channels;
    std::vector<bool> m_shown;
    std::uint64_t m_cycles[2] = {0, 0};
};

} // namespace camwright
