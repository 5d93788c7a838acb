#pragma once

#include <QAbstractTableModel>

namespace camwright {

class ActionCatalogue;
class KeyBook;

/// Every action with its keys.
class KeyTableModel : public QAbstractTableModel {
    Q_OBJECT
public:
    enum Column { Name, Keys, Changed, ColumnCount };
    static constexpr int ActionRole = Qt::UserRole;

    KeyTableModel(const ActionCatalogue& actions, const KeyBook& keys, QObject* parent = nullptr);

    int rowCount(const QModelIndex& parent = {}) const override;
    int columnCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

private:
    const ActionCatalogue& m_actions;
    const KeyBook& m_keys;
};

} // namespace camwright
