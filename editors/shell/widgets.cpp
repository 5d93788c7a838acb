#include "editors/shell/widgets.h"

#include "editors/shell/icons.h"

#include <QButtonGroup>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QPainter>
#include <QStyle>
#include <QVBoxLayout>

namespace camwright {

namespace {

/// One choice of a segmented control, painted flat inside the common frame.
class SegmentButton : public QAbstractButton {
public:
    SegmentButton(const QString& text, const QString& iconName, QWidget* parent) : QAbstractButton(parent), m_icon(iconName)
    {
        setText(text);
        setCheckable(true);
        setAutoExclusive(false);
        setFocusPolicy(Qt::StrongFocus);
        setCursor(Qt::ArrowCursor);
    }
    QSize sizeHint() const override
    {
        const int words = text().isEmpty() ? 0 : QFontMetrics(theme().boldFont()).horizontalAdvance(text());
        return {words + (m_icon.isEmpty() ? 0 : 16 + (words ? 6 : 0)) + 22, 24};
    }

protected:
    void paintEvent(QPaintEvent*) override
    {
        QPainter painter(this);
        painter.setRenderHint(QPainter::Antialiasing);
        const Role ink = !isEnabled() ? Role::Faint : isChecked() ? Role::Accent : Role::Dim;
        if (isChecked()) {
            painter.setPen(QPen(theme().color(Role::Accent), 1));
            painter.setBrush(theme().color(Role::AccentSoft));
            painter.drawRoundedRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5), 4, 4);
        } else if (hasFocus()) {
            painter.setPen(QPen(theme().color(Role::Accent), 1, Qt::DotLine));
            painter.drawRoundedRect(QRectF(rect()).adjusted(2.5, 2.5, -2.5, -2.5), 3, 3);
        }
        painter.setFont(isChecked() ? theme().boldFont() : theme().font());
        painter.setPen(theme().color(ink));
        QRect area = rect().adjusted(10, 0, -10, 0);
        if (!m_icon.isEmpty()) {
            const int left = text().isEmpty() ? (width() - 16) / 2 : area.left();
            paintIcon(painter, QRectF(left, (height() - 16) / 2.0, 16, 16), m_icon, ink);
            area.adjust(22, 0, 0, 0);
        }
        painter.drawText(area, text().isEmpty() ? int(Qt::AlignCenter) : m_icon.isEmpty() ? int(Qt::AlignCenter) : int(Qt::AlignVCenter | Qt::AlignLeft), text());
    }

private:
    QString m_icon;
};

} // namespace

SegmentedControl::SegmentedControl(const QString& accessibleName, QWidget* parent) : QWidget(parent)
{
    setAccessibleName(accessibleName);
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(0);
    setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
}

void SegmentedControl::addSegment(const QString& text, const QString& iconName, const QString& toolTip)
{
    auto* button = new SegmentButton(text, iconName, this);
    button->setToolTip(toolTip.isEmpty() ? text : toolTip);
    button->setAccessibleName(text.isEmpty() ? toolTip : text);
    const int index = int(m_buttons.size());
    m_buttons.push_back(button);
    layout()->addWidget(button);
    connect(button, &QAbstractButton::clicked, this, [this, index] {
        const bool changed = index != m_current;
        setCurrentIndex(index);
        if (changed)
            emit chosen(index);
    });
    if (m_current < 0)
        setCurrentIndex(0);
}

void SegmentedControl::setCurrentIndex(int index)
{
    m_current = index;
    for (int i = 0; i < int(m_buttons.size()); ++i)
        m_buttons[std::size_t(i)]->setChecked(i == index);
}

Switch::Switch(const QString& accessibleName, QWidget* parent) : QAbstractButton(parent)
{
    setAccessibleName(accessibleName);
    setCheckable(true);
    setFocusPolicy(Qt::StrongFocus);
    setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
}

void Switch::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const QRectF body = QRectF(rect()).adjusted(1, 1, -1, -1);
    const Role fill = !isEnabled() ? Role::Line : isChecked() ? m_onRole : Role::Idle;
    painter.setPen(hasFocus() ? QPen(theme().color(Role::Text), 1.5) : QPen(Qt::NoPen));
    painter.setBrush(theme().color(fill));
    painter.drawRoundedRect(body, body.height() / 2, body.height() / 2);
    const qreal r = body.height() / 2 - 3;
    const QPointF center(isChecked() ? body.right() - r - 3 : body.left() + r + 3, body.center().y());
    painter.setPen(Qt::NoPen);
    painter.setBrush(theme().color(Role::Surface));
    painter.drawEllipse(center, r, r);
}

Pill::Pill(QWidget* parent) : QWidget(parent)
{
    setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
}

void Pill::setContent(const QString& text, Role ink, Role fill, const QString& iconName)
{
    m_text = text;
    m_ink = ink;
    m_fill = fill;
    m_icon = iconName;
    setAccessibleName(text);
    updateGeometry();
    update();
}

QSize Pill::sizeHint() const
{
    QFont font = theme().smallFont();
    font.setWeight(QFont::DemiBold);
    return {QFontMetrics(font).horizontalAdvance(m_text) + 18 + (m_icon.isEmpty() ? 0 : 14), 18};
}

void Pill::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(Qt::NoPen);
    painter.setBrush(theme().color(m_fill));
    const QRectF body(0, (height() - 18) / 2.0, width(), 18);
    painter.drawRoundedRect(body, 9, 9);
    qreal left = 9;
    if (!m_icon.isEmpty()) {
        paintIcon(painter, QRectF(left - 2, body.top() + 3, 12, 12), m_icon, m_ink);
        left += 14;
    }
    QFont font = theme().smallFont();
    font.setWeight(QFont::DemiBold);
    painter.setFont(font);
    painter.setPen(theme().color(m_ink));
    painter.drawText(QRectF(left, body.top(), width() - left, 18), Qt::AlignVCenter | Qt::AlignLeft, m_text);
}

SectionHeader::SectionHeader(const QString& title, const QString& explanation, QWidget* parent) : QWidget(parent)
{
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(10);
    m_title = new QLabel(title, this);
    m_title->setProperty("tone", "heading");
    m_explanation = new QLabel(explanation, this);
    m_explanation->setProperty("tone", "dim");
    row->addWidget(m_title);
    row->addWidget(m_explanation);
    row->addStretch();
}

void SectionHeader::addWidget(QWidget* widget) { layout()->addWidget(widget); }
void SectionHeader::setTitle(const QString& title) { m_title->setText(title); }
void SectionHeader::setExplanation(const QString& text) { m_explanation->setText(text); }

EmptyState::EmptyState(const QString& iconName, const QString& sentence, QWidget* parent) : QWidget(parent)
{
    m_layout = new QVBoxLayout(this);
    m_layout->setContentsMargins(24, 24, 24, 24);
    m_layout->setSpacing(12);
    m_layout->addStretch();
    m_icon = new QLabel(this);
    m_icon->setAlignment(Qt::AlignCenter);
    const auto draw = [this, iconName] { m_icon->setPixmap(iconPixmap(iconName, 32, Role::Faint, devicePixelRatioF())); };
    draw();
    connect(&theme(), &Theme::changed, this, draw);
    m_label = new QLabel(sentence, this);
    m_label->setAlignment(Qt::AlignCenter);
    m_label->setWordWrap(true);
    m_label->setProperty("tone", "dim");
    m_layout->addWidget(m_icon);
    m_layout->addWidget(m_label);
    m_layout->addStretch();
}

void EmptyState::setSentence(const QString& sentence) { m_label->setText(sentence); }

QPushButton* EmptyState::addButton(const QString& text, bool primary)
{
    auto* button = new QPushButton(text, this);
    button->setAccessibleName(text);
    if (primary)
        makePrimary(button);
    m_layout->insertWidget(m_layout->count() - 1, button, 0, Qt::AlignHCenter);
    return button;
}

Banner::Banner(Severity severity, const QString& sentence, QWidget* parent) : QFrame(parent)
{
    const bool error = severity == Severity::Error;
    const bool warning = severity == Severity::Warning;
    setProperty("banner", error ? "error" : warning ? "warning" : "info");
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(12, 8, 12, 8);
    row->setSpacing(10);
    auto* sign = new QLabel(this);
    const auto draw = [this, sign, error, warning] {
        sign->setPixmap(iconPixmap(error ? QStringLiteral("error") : warning ? QStringLiteral("warning") : QStringLiteral("info"), 16,
            error ? Role::Error : warning ? Role::Warn : Role::Accent, devicePixelRatioF()));
    };
    draw();
    connect(&theme(), &Theme::changed, this, draw);
    m_text = new QLabel(sentence, this);
    m_text->setWordWrap(true);
    row->addWidget(sign, 0, Qt::AlignTop);
    row->addWidget(m_text, 1);
    m_buttons = row;
    setAccessibleName(sentence);
}

void Banner::setSentence(const QString& sentence)
{
    m_text->setText(sentence);
    setAccessibleName(sentence);
}

QPushButton* Banner::addButton(const QString& text, bool primary)
{
    auto* button = new QPushButton(text, this);
    button->setAccessibleName(text);
    if (primary)
        makePrimary(button);
    m_buttons->addWidget(button);
    return button;
}

LinkLabel::LinkLabel(const QString& text, QWidget* parent) : QLabel(text, parent)
{
    setProperty("tone", "link");
    setCursor(Qt::PointingHandCursor);
    setFocusPolicy(Qt::TabFocus);
    setAccessibleName(text);
}

void LinkLabel::setLinkText(const QString& text)
{
    setText(text);
    setAccessibleName(text);
}

void LinkLabel::mouseReleaseEvent(QMouseEvent* event)
{
    if (event->button() == Qt::LeftButton && rect().contains(event->position().toPoint()))
        emit activated();
}

void LinkLabel::keyPressEvent(QKeyEvent* event)
{
    if (event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter || event->key() == Qt::Key_Space)
        emit activated();
    else
        QLabel::keyPressEvent(event);
}

void makePrimary(QPushButton* button)
{
    button->setProperty("primary", true);
    button->style()->unpolish(button);
    button->style()->polish(button);
}

void describe(QWidget* widget, const char* objectName, const QString& accessibleName, const QString& toolTip)
{
    widget->setObjectName(QString::fromLatin1(objectName));
    widget->setAccessibleName(accessibleName);
    widget->setToolTip(toolTip.isEmpty() ? accessibleName : toolTip);
}

} // namespace camwright
