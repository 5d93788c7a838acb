#include "editors/commissioning/plainfield.h"

#include "editors/shell/quantityfield.h"

#include <QHBoxLayout>

namespace camwright {

namespace {

constexpr int DotRoom = 12; // QuantityField's own

} // namespace

QWidget* plainField(QuantityField* field, QWidget* parent)
{
    auto* holder = new QWidget(parent);
    auto* row = new QHBoxLayout(holder);
    row->setContentsMargins(-DotRoom, 0, 0, 0);
    row->setSpacing(0);
    row->addWidget(field);
    return holder;
}

} // namespace camwright
