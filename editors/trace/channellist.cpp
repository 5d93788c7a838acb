#include "editors/trace/channellist.h"

#include "editors/shell/theme.h"
#include "editors/trace/scopeplot.h"

#include <set>

namespace camwright {

ChannelListModel::ChannelListModel(const TraceBuffer& buffer, QObject* parent)
    : QAbstractTableModel(parent), m_buffer(buffer)
{
}

void ChannelListModel::setChannels(std::vector<std::string> channels)
{
    std::set<std::string> hidden;
    for (std::size_t i = 0; i < m_channels.size(); ++i) {
        if (!m_shown[i])
            hidden.insert(m_channels[i]);
    }
    beginResetModel();
    m_channels = std::move(channels);
    m_shown.clear();
    for (const std::string& channel : m_channels)
        m_shown.push_back(!hidden.contains(channel));
    endResetModel();
}

void ChannelListModel::setCursors(std::uint64_t cycleA, std::uint64_t cycleB)
{
    m_cycles[0] = cycleA;
    m_cycles[1] = cycleB;
    refreshValues();
}

void ChannelListModel::refreshValues()
{
    if (!m_channels.empty())
        emit dataChanged(index(0, Name), index(rowCount() - 1, AtB)); // a name shows its unit and colour once it is recorded
}

int ChannelListModel::recorded(int row) const
{
    const auto& recordedChannels = m_buffer.channels();
    for (std::size_t i = 0; i < recordedChannels.size(); ++i) {
        if (recordedChannels[i].name == m_channels[static_cast<std::size_t>(row)])
            return static_cast<int>(i);
    }
    return -1;
}

int ChannelListModel::rowCount(const QModelIndex& parent) const
{
    return parent.isValid() ? 0 : static_cast<int>(m_channels.size());
}

int ChannelListModel::columnCount(const QModelIndex& parent) const
{
    return parent.isValid() ? 0 : ColumnCount;
}

QString ChannelListModel::valueAt(int row, std::uint64_t cycle) const
{
    const int channel = recorded(row);
    const auto value = channel >= 0 ? m_buffer.valueAt(static_cast<std::size_t>(channel), cycle) : std::nullopt;
    if (!value)
        return QStringLiteral("–");
    const ChannelInfo& info = m_buffer.channels()[static_cast<std::size_t>(channel)];
    if (const StateNames names = StateNames::of(info, m_family); names.hasNames())
        return names.name(*value);
    return isFloat(info.type) ? QString::number(*value, 'f', 3) : QString::number(*value, 'f', 0);
}

QVariant ChannelListModel::data(const QModelIndex& index, int role) const
{
    if (!index.isValid())
        return {};
    const int row = index.row();
    if (role == Qt::DisplayRole && index.column() == Name) {
        const int channel = recorded(row);
        const QString name = QString::fromStdString(m_channels[static_cast<std::size_t>(row)]);
        const std::string unit = channel >= 0 ? m_buffer.channels()[static_cast<std::size_t>(channel)].unit : std::string();
        return unit.empty() ? name : QStringLiteral("%1  [%2]").arg(name, QString::fromStdString(unit));
    }
    if (role == Qt::DisplayRole)
        return valueAt(row, m_cycles[index.column() == AtA ? 0 : 1]);
    if (role == Qt::CheckStateRole && index.column() == Name)
        return int(m_shown[static_cast<std::size_t>(row)] ? Qt::Checked : Qt::Unchecked);
    if (role == Qt::ForegroundRole && index.column() == Name && recorded(row) >= 0)
        return theme().color(ScopePlot::channelRole(static_cast<std::size_t>(recorded(row))));
    if (role == Qt::ToolTipRole && index.column() != Name)
        return valueAt(row, m_cycles[index.column() == AtA ? 0 : 1]); // a name may be longer than its column
    if (role == Qt::FontRole && index.column() != Name)
        return theme().monoFont();
    if (role == Qt::TextAlignmentRole && index.column() != Name)
        return int(Qt::AlignRight | Qt::AlignVCenter);
    if (role == Qt::ToolTipRole && index.column() == Name && recorded(row) < 0)
        return tr("Part of the next recording.");
    return {};
}

bool ChannelListModel::setData(const QModelIndex& index, const QVariant& value, int role)
{
    if (!index.isValid() || role != Qt::CheckStateRole || index.column() != Name)
        return false;
    const bool shown = value.toInt() == Qt::Checked;
    m_shown[static_cast<std::size_t>(index.row())] = shown;
    emit dataChanged(index, index);
    emit shownChanged(index.row(), shown);
    return true;
}

QVariant ChannelListModel::headerData(int section, Qt::Orientation orientation, int role) const
{
    if (orientation != Qt::Horizontal)
        return {};
    if (role == Qt::TextAlignmentRole)
        return int((section == Name ? Qt::AlignLeft : Qt::AlignRight) | Qt::AlignVCenter);
    if (role != Qt::DisplayRole)
        return {};
    return section == Name ? tr("Channel") : section == AtA ? tr("at A") : tr("at B");
}

Qt::ItemFlags ChannelListModel::flags(const QModelIndex& index) const
{
    if (!index.isValid())
        return Qt::NoItemFlags;
    const Qt::ItemFlags base = Qt::ItemIsEnabled | Qt::ItemIsSelectable;
    return index.column() == Name ? base | Qt::ItemIsUserCheckable : base;
}

} // namespace camwright
