#include "app/window/keytable.h"

#include "app/window/keybook.h"
#include "editors/shell/theme.h"

namespace camwright {

KeyTableModel::KeyTableModel(const ActionCatalogue& actions, const KeyBook& keys, QObject* parent)
    : QAbstractTableModel(parent), m_actions(actions), m_keys(keys)
{
    connect(&keys, &KeyBook::changed, this, [this] { emit dataChanged(index(0, 0), index(rowCount() - 1, ColumnCount - 1)); });
}

int KeyTableModel::rowCount(const QModelIndex& parent) const
{
    return parent.isValid() ? 0 : int(m_actions.rows().size());
}

int KeyTableModel::columnCount(const QModelIndex& parent) const
{
    return parent.isValid() ? 0 : ColumnCount;
}

QVariant KeyTableModel::data(const QModelIndex& index, int role) const
{
    if (!index.isValid())
        return {};
    const ActionRow& row = m_actions.rows()[std::size_t(index.row())];
    const QString action = QString::fromLatin1(row.id);
    if (role == ActionRole)
        return action;
    if (role == Qt::ToolTipRole)
        return ActionCatalogue::sentence(row);
    if (role == Qt::ForegroundRole && index.column() == Changed)
        return theme().color(Role::Dim);
    if (role != Qt::DisplayRole)
        return {};
    switch (index.column()) {
    case Name: return ActionCatalogue::plainName(row);
    case Keys: return QKeySequence::listToString(m_keys.keys(action), QKeySequence::NativeText).replace(QLatin1String("; "), QLatin1String(",  "));
    default: return m_keys.isChanged(action) ? tr("yours") : QString();
    }
}

QVariant KeyTableModel::headerData(int section, Qt::Orientation orientation, int role) const
{
    if (orientation != Qt::Horizontal)
        return {};
    if (role == Qt::TextAlignmentRole)
        return int(Qt::AlignLeft | Qt::AlignVCenter);
    if (role != Qt::DisplayRole)
        return {};
    return section == Name ? tr("Action") : section == Keys ? tr("Keys") : QString();
}

} // namespace camwright
