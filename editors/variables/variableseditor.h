#pragma once

#include "editors/shell/editor.h"

class QLineEdit;
class QSortFilterProxyModel;
class QTableView;

namespace camwright {

class VariablesModel;

/// A table of global variables: names, types, addresses. Rows can be filtered, copied to and pasted from a spreadsheet.
class VariablesEditor : public Editor {
    Q_OBJECT
public:
    VariablesEditor(Context& context, ObjectKey key, QWidget* parent = nullptr);

    QString iconName() const override { return QStringLiteral("variables"); }
    void setKey(const ObjectKey& key) override;
    void reveal(const Place& place) override;
    QString positionText() const override;
    bool can(const QString& actionId) const override;
    void perform(const QString& actionId) override;

private:
    std::vector<int> selectedRows() const;
    void showMenu(const QPoint& globalPoint);

    VariablesModel* m_model;
    QSortFilterProxyModel* m_filtered;
    QLineEdit* m_filter;
    QTableView* m_table;
};

} // namespace camwright
