#include "editors/commissioning/plainfield.h"

#include "editors/shell/quantityfield.h"
#include "editors/shell/theme.h"

#include <QEvent>
#include <QLineEdit>

namespace camwright {

namespace {

constexpr int DotRoom = 12; // QuantityField's own

} // namespace

PlainField::PlainField(QuantityField* field, int smallestWidth, QWidget* parent)
    : QWidget(parent), m_field(field), m_smallestWidth(smallestWidth)
{
    field->setParent(this);
    field->setFieldWidth(smallestWidth);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
}

QSize PlainField::sizeHint() const
{
    const int wide = std::max(m_smallestWidth, width());
    const int high = m_field->hasHeightForWidth() ? m_field->heightForWidth(wide + DotRoom) : m_field->sizeHint().height();
    return {m_smallestWidth, std::max(Theme::FieldHeight, high)};
}

bool PlainField::event(QEvent* event)
{
    if (event->type() == QEvent::LayoutRequest) {
        updateGeometry();
        m_field->setGeometry(-DotRoom, 0, width() + DotRoom, height());
    }
    return QWidget::event(event);
}

void PlainField::resizeEvent(QResizeEvent* event)
{
    QWidget::resizeEvent(event);
    if (width() >= m_smallestWidth && m_field->lineEdit()->width() != width())
        m_field->setFieldWidth(width());
    m_field->setGeometry(-DotRoom, 0, width() + DotRoom, height());
}

} // namespace camwright
