#pragma once

#include <QStyledItemDelegate>

namespace camwright {

class ProjectDocument;

/// Completes the names of variables, addresses and axis values while one types.
class NameDelegate : public QStyledItemDelegate {
    Q_OBJECT
public:
    NameDelegate(ProjectDocument& document, QObject* parent);
    QWidget* createEditor(QWidget* parent, const QStyleOptionViewItem& option, const QModelIndex& index) const override;

private:
    ProjectDocument& m_document;
};

} // namespace camwright
