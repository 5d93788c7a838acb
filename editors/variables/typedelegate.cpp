#include "editors/variables/typedelegate.h"

#include "core/base/datatype.h"

#include <QComboBox>

namespace camwright {

QWidget* TypeDelegate::createEditor(QWidget* parent, const QStyleOptionViewItem&, const QModelIndex&) const
{
    auto* box = new QComboBox(parent);
    box->setEditable(true);
    box->setAccessibleName(tr("Type"));
    for (const DataType type : {DataType::Bool, DataType::Byte, DataType::Word, DataType::Dword, DataType::Int, DataType::Dint, DataType::Real})
        box->addItem(QString::fromUtf8(name(type).data(), static_cast<qsizetype>(name(type).size())));
    return box;
}

void TypeDelegate::setEditorData(QWidget* editor, const QModelIndex& index) const
{
    static_cast<QComboBox*>(editor)->setCurrentText(index.data(Qt::EditRole).toString());
}

void TypeDelegate::setModelData(QWidget* editor, QAbstractItemModel* model, const QModelIndex& index) const
{
    model->setData(index, static_cast<QComboBox*>(editor)->currentText(), Qt::EditRole);
}

} // namespace camwright
