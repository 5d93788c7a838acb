#include "editors/shell/quantityfield.h"

#include "editors/shell/quantity.h"
#include "editors/shell/theme.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QPainter>
#include <QStyle>
#include <QToolButton>
#include <QVBoxLayout>
#include <QWheelEvent>

#include <cmath>

namespace camwright {

namespace {

constexpr int DotWidth = 12;

class DotButton : public QToolButton {
public:
    explicit DotButton(QWidget* parent) : QToolButton(parent)
    {
        setFixedSize(DotWidth, Theme::FieldHeight);
        setFocusPolicy(Qt::NoFocus);
        setCursor(Qt::PointingHandCursor);
    }

protected:
    void paintEvent(QPaintEvent*) override
    {
        QPainter painter(this);
        painter.setRenderHint(QPainter::Antialiasing);
        painter.setPen(Qt::NoPen);
        painter.setBrush(theme().color(Role::Accent));
        const qreal r = underMouse() ? 4 : 3;
        painter.drawEllipse(QPointF(width() / 2.0 - 1, height() / 2.0), r, r);
    }
};

} // namespace

QuantityField::QuantityField(const QuantitySpec& spec, QWidget* parent) : QWidget(parent)
{
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(2);
    auto* row = new QHBoxLayout;
    row->setSpacing(0);
    m_dot = new DotButton(this);
    QSizePolicy keep = m_dot->sizePolicy();
    keep.setRetainSizeWhenHidden(true);
    m_dot->setSizePolicy(keep);
    m_edit = new QLineEdit(this);
    m_edit->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    m_edit->setFont(theme().monoFont());
    m_edit->installEventFilter(this);
    m_unit = new QLabel(m_edit);
    m_unit->setAttribute(Qt::WA_TransparentForMouseEvents);
    row->addWidget(m_dot);
    row->addWidget(m_edit);
    row->addStretch();
    column->addLayout(row);
    m_error = new QLabel(this);
    m_error->setWordWrap(true);
    m_error->setContentsMargins(DotWidth, 0, 0, 0);
    m_error->hide();
    column->addWidget(m_error);
    setFocusProxy(m_edit);
    setFieldWidth(132);
    connect(m_edit, &QLineEdit::textEdited, this, [this] { m_edited = true; });
    connect(m_edit, &QLineEdit::editingFinished, this, &QuantityField::commit);
    connect(m_edit, &QLineEdit::returnPressed, this, &QuantityField::returnPressed);
    connect(m_dot, &QToolButton::clicked, this, [this] {
        setField(Field<double>(*m_spec.defaultValue));
        emit edited();
    });
    setSpec(spec);
}

void QuantityField::setSpec(const QuantitySpec& spec)
{
    m_spec = spec;
    m_unit->setText(spec.unit);
    m_unit->adjustSize();
    m_edit->setAccessibleName(spec.unit.isEmpty() ? spec.name : tr("%1 in %2").arg(spec.name, spec.unit));
    m_edit->setPlaceholderText(spec.defaultValue ? formatted(*spec.defaultValue) : QString());
    m_dot->setAccessibleName(tr("%1: return to the default").arg(spec.name));
    m_dot->setToolTip(spec.defaultValue ? tr("Differs from the default %1 %2. Click to return to it.").arg(formatted(*spec.defaultValue), spec.unit)
                                        : QString());
    refresh();
}

QString QuantityField::formatted(double value) const
{
    if (m_spec.base == 16)
        return QStringLiteral("0x") + QString::number(qulonglong(value), 16).toUpper();
    return formatQuantity(value, m_spec.integer ? 0 : m_spec.decimals);
}

void QuantityField::setField(const Field<double>& field)
{
    m_field = field;
    m_edited = false;
    refresh();
}

void QuantityField::setField(const Field<std::int64_t>& field)
{
    setField(field.isValid() ? Field<double>(double(field.value())) : Field<double>::typed(field.text()));
}

Field<std::int64_t> QuantityField::integerField() const
{
    if (!m_field.isValid())
        return Field<std::int64_t>::typed(m_field.text());
    return Field<std::int64_t>(std::llround(m_field.value()));
}

void QuantityField::commit()
{
    if (!m_edited)
        return;
    m_edited = false;
    const QString text = m_edit->text().trimmed();
    const Field<double> before = m_field;
    if (text.isEmpty() && m_spec.defaultValue)
        m_field = Field<double>(*m_spec.defaultValue);
    else if (const auto value = parseQuantity(text, m_spec.unit, m_spec.perTurn); value && (!m_spec.integer || *value == std::round(*value)))
        m_field = Field<double>(*value);
    else
        m_field = Field<double>::typed(text.toStdString());
    refresh();
    if (!(m_field == before))
        emit edited();
}

void QuantityField::stepBy(int steps)
{
    if (m_edit->isReadOnly() || !isEnabled())
        return;
    commit();
    const double now = m_field.valueOr(m_spec.defaultValue.value_or(0));
    const double next = std::clamp(now + steps * m_spec.step, m_spec.minimum, m_spec.maximum);
    // Steps of 0.1 must not print 0.30000000000000004.
    m_field = Field<double>(std::round(next * 1e9) / 1e9);
    refresh();
    emit edited();
}

QString QuantityField::rangeError() const
{
    const QString unit = m_spec.unit.isEmpty() ? QString() : QLatin1Char(' ') + m_spec.unit;
    if (!m_field.isValid()) {
        const QString text = QString::fromStdString(m_field.text());
        return m_spec.integer ? tr("\"%1\" is not a whole number%2.").arg(text, m_spec.unit.isEmpty() ? QString() : tr(" of %1").arg(m_spec.unit))
                              : tr("\"%1\" is not a number%2.").arg(text, m_spec.unit.isEmpty() ? QString() : tr(" of %1").arg(m_spec.unit));
    }
    const double value = m_field.value();
    if (value < m_spec.minimum && std::isfinite(m_spec.maximum))
        return tr("Below the range %1 to %2%3.").arg(formatted(m_spec.minimum), formatted(m_spec.maximum), unit);
    if (value > m_spec.maximum && std::isfinite(m_spec.minimum))
        return tr("Above the range %1 to %2%3.").arg(formatted(m_spec.minimum), formatted(m_spec.maximum), unit);
    if (value < m_spec.minimum)
        return tr("At least %1%2.").arg(formatted(m_spec.minimum), unit);
    if (value > m_spec.maximum)
        return tr("At most %1%2.").arg(formatted(m_spec.maximum), unit);
    return {};
}

QString QuantityField::problem() const
{
    const QString own = rangeError();
    return own.isEmpty() ? m_checkProblem : own;
}

void QuantityField::setProblem(const QString& sentence, bool warning)
{
    m_checkProblem = sentence;
    m_checkWarning = warning;
    refresh();
}

void QuantityField::setReadOnly(bool readOnly)
{
    m_edit->setReadOnly(readOnly);
    refresh();
}

void QuantityField::setFieldWidth(int width)
{
    m_edit->setFixedWidth(width);
    m_error->setMaximumWidth(std::max(width + DotWidth, 320));
    refresh();
}

void QuantityField::selectAll()
{
    m_edit->setFocus();
    m_edit->selectAll();
}

void QuantityField::refresh()
{
    if (!m_edited) {
        const QString text = m_field.isValid() ? formatted(m_field.value()) : QString::fromStdString(m_field.text());
        if (m_edit->text() != text)
            m_edit->setText(text);
    }
    const bool differs = m_spec.defaultValue && (!m_field.isValid() || m_field.value() != *m_spec.defaultValue);
    m_dot->setVisible(differs && !m_edit->isReadOnly() && isEnabled());
    const QString own = rangeError();
    const QString sentence = own.isEmpty() ? m_checkProblem : own;
    const bool warning = own.isEmpty() && m_checkWarning;
    const QString state = sentence.isEmpty() ? QString() : warning ? QStringLiteral("warning") : QStringLiteral("error");
    if (m_edit->property("state").toString() != state) {
        m_edit->setProperty("state", state);
        m_error->setProperty("tone", warning ? QStringLiteral("warning") : QStringLiteral("error"));
        for (QWidget* widget : {static_cast<QWidget*>(m_edit), static_cast<QWidget*>(m_error)}) {
            widget->style()->unpolish(widget);
            widget->style()->polish(widget);
        }
    }
    m_error->setText(sentence);
    m_error->setVisible(!sentence.isEmpty());
    m_unit->setStyleSheet(QStringLiteral("color: %1;").arg(theme().name(state == QLatin1String("error") ? Role::Error : Role::Dim)));
    m_unit->adjustSize();
    m_edit->setTextMargins(0, 0, m_spec.unit.isEmpty() ? 0 : m_unit->width() + 6, 0);
    m_unit->move(m_edit->width() - m_unit->width() - 9, (m_edit->height() - m_unit->height()) / 2);
    refreshToolTip();
}

void QuantityField::refreshToolTip()
{
    QStringList lines;
    if (!m_spec.name.isEmpty())
        lines << QStringLiteral("<b>%1</b>").arg(m_spec.name.toHtmlEscaped());
    if (!m_spec.help.isEmpty())
        lines << m_spec.help.toHtmlEscaped();
    if (std::isfinite(m_spec.minimum) && std::isfinite(m_spec.maximum))
        lines << tr("Range: %1 to %2 %3").arg(formatted(m_spec.minimum), formatted(m_spec.maximum), m_spec.unit).trimmed().toHtmlEscaped();
    if (m_spec.defaultValue)
        lines << tr("Default: %1 %2").arg(formatted(*m_spec.defaultValue), m_spec.unit).trimmed().toHtmlEscaped();
    if (!m_spec.reference.isEmpty())
        lines << m_spec.reference.toHtmlEscaped();
    m_edit->setToolTip(lines.join(QStringLiteral("<br>")));
}

bool QuantityField::eventFilter(QObject* watched, QEvent* event)
{
    if (watched != m_edit)
        return QWidget::eventFilter(watched, event);
    if (event->type() == QEvent::Wheel) {
        if (!m_edit->hasFocus()) {
            event->ignore();
            return true; // the page scrolls instead
        }
        const int steps = static_cast<QWheelEvent*>(event)->angleDelta().y() / 120;
        if (steps != 0)
            stepBy(steps);
        return true;
    }
    if (event->type() == QEvent::KeyPress) {
        const auto* key = static_cast<QKeyEvent*>(event);
        if (key->key() == Qt::Key_Up || key->key() == Qt::Key_Down) {
            stepBy(key->key() == Qt::Key_Up ? 1 : -1);
            return true;
        }
        if (key->key() == Qt::Key_Escape && m_edited) {
            m_edited = false;
            refresh();
            m_edit->selectAll();
            return true;
        }
    }
    if (event->type() == QEvent::Resize)
        m_unit->move(m_edit->width() - m_unit->width() - 9, (m_edit->height() - m_unit->height()) / 2);
    return QWidget::eventFilter(watched, event);
}

void QuantityField::changeEvent(QEvent* event)
{
    if (event->type() == QEvent::EnabledChange || event->type() == QEvent::StyleChange)
        QMetaObject::invokeMethod(this, [this] { refresh(); }, Qt::QueuedConnection);
    QWidget::changeEvent(event);
}

} // namespace camwright
