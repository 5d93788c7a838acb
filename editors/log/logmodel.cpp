#include "editors/log/logmodel.h"

#include "editors/shell/icons.h"
#include "editors/words/words.h"

#include <algorithm>

namespace camwright {

namespace {

QIcon severityIcon(Severity severity)
{
    switch (severity) {
    case Severity::Error: return icon(QStringLiteral("error"), Role::Error);
    case Severity::Warning: return icon(QStringLiteral("warning"), Role::Warn);
    case Severity::Information: return icon(QStringLiteral("info"), Role::Dim);
    }
    return {};
}

} // namespace

void LogModel::clear()
{
    beginResetModel();
    m_entries.clear();
    endResetModel();
}

void LogModel::add(const std::vector<LogEntry>& entries)
{
    for (const LogEntry& entry : entries) {
        // Nearly always at the front; history that arrives after the first live entry goes behind it.
        const auto place = std::ranges::find_if(m_entries, [&](const LogEntry& known) { return known.sequence <= entry.sequence; });
        if (place != m_entries.end() && place->sequence == entry.sequence)
            continue;
        const int row = static_cast<int>(place - m_entries.begin());
        beginInsertRows({}, row, row);
        m_entries.insert(place, entry);
        endInsertRows();
    }
    if (m_entries.size() > Limit) {
        beginRemoveRows({}, static_cast<int>(Limit), static_cast<int>(m_entries.size()) - 1);
        m_entries.resize(Limit);
        endRemoveRows();
    }
}

int LogModel::rowCount(const QModelIndex& parent) const
{
    return parent.isValid() ? 0 : static_cast<int>(m_entries.size());
}

int LogModel::columnCount(const QModelIndex& parent) const
{
    return parent.isValid() ? 0 : ColumnCount;
}

QVariant LogModel::data(const QModelIndex& index, int role) const
{
    if (!index.isValid())
        return {};
    const LogEntry& row = entry(index.row());
    if (role == Qt::DecorationRole && index.column() == CodeId)
        return severityIcon(row.message.severity());
    if (role == Qt::FontRole && index.column() != Text)
        return theme().monoFont();
    if (role == Qt::TextAlignmentRole && index.column() <= Cycle)
        return int(Qt::AlignRight | Qt::AlignVCenter);
    if (role == Qt::ToolTipRole)
        return QStringLiteral("%1 %2").arg(words::codeId(row.message.code), words::sentence(row.message));
    if (role != Qt::DisplayRole)
        return {};
    switch (index.column()) {
    case When: return tr("%1 s").arg(seconds(row.time), 0, 'f', 3);
    case Cycle: return QString::number(row.cycle);
    case CodeId: return words::codeId(row.message.code);
    case Text: return words::sentence(row.message);
    default: return {};
    }
}

QVariant LogModel::headerData(int section, Qt::Orientation orientation, int role) const
{
    if (orientation != Qt::Horizontal || role != Qt::DisplayRole)
        return {};
    switch (section) {
    case When: return tr("Controller time");
    case Cycle: return tr("Cycle");
    case CodeId: return tr("Code");
    case Text: return tr("Message");
    default: return {};
    }
}

} // namespace camwright
