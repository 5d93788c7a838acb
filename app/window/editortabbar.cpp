#include "app/window/editortabbar.h"

#include "editors/shell/icons.h"

#include <QMouseEvent>
#include <QPainter>

namespace camwright {

namespace {

struct TabLook {
    QString iconName;
    bool preview = false;
};

} // namespace

} // namespace camwright

Q_DECLARE_METATYPE(camwright::TabLook)

namespace camwright {

namespace {

TabLook lookOf(const QTabBar& bar, int index)
{
    return bar.tabData(index).value<TabLook>();
}

constexpr int Height = 32;
constexpr int Padding = 14;

} // namespace

EditorTabBar::EditorTabBar(QWidget* parent) : QTabBar(parent)
{
    setObjectName(QStringLiteral("editorTabs"));
    setAccessibleName(tr("Editors"));
    setDrawBase(false);
    setExpanding(false);
    setMovable(true);
    setMouseTracking(true);
    setElideMode(Qt::ElideRight);
    setFixedHeight(Height);
    setFocusPolicy(Qt::TabFocus);
}

void EditorTabBar::setTabIconName(int index, const QString& name)
{
    TabLook look = lookOf(*this, index);
    look.iconName = name;
    setTabData(index, QVariant::fromValue(look));
    update();
}

void EditorTabBar::setPreview(int index, bool preview)
{
    TabLook look = lookOf(*this, index);
    look.preview = preview;
    setTabData(index, QVariant::fromValue(look));
    update();
}

QFont EditorTabBar::fontOf(int index) const
{
    QFont out = index == currentIndex() ? theme().boldFont() : theme().font();
    out.setItalic(lookOf(*this, index).preview);
    return out;
}

QSize EditorTabBar::tabSizeHint(int index) const
{
    // As wide as the bold text, so that tabs do not move when another becomes current.
    QFont font = theme().boldFont();
    return {Padding + 16 + 8 + std::min(QFontMetrics(font).horizontalAdvance(tabText(index)), 220) + 8 + 16 + Padding - 4, Height};
}

QRect EditorTabBar::crossRect(int index) const
{
    const QRect tab = tabRect(index);
    return {tab.right() - Padding - 10, tab.center().y() - 7, 16, 16};
}

void EditorTabBar::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    painter.fillRect(rect(), theme().color(Role::Background));
    painter.setPen(theme().color(Role::Line));
    painter.drawLine(0, height() - 1, width(), height() - 1);
    for (int i = 0; i < count(); ++i) {
        const QRect tab = tabRect(i);
        const bool current = i == currentIndex();
        if (current) {
            painter.fillRect(tab, theme().color(Role::Surface));
            painter.fillRect(QRect(tab.left(), tab.top(), tab.width(), 2), theme().color(Role::Accent));
        }
        painter.fillRect(QRect(tab.right(), tab.top(), 1, tab.height()), theme().color(Role::FineLine));
        paintIcon(painter, QRectF(tab.left() + Padding, tab.center().y() - 7, 16, 16), lookOf(*this, i).iconName, current ? Role::Accent : Role::Dim);
        painter.setFont(fontOf(i));
        painter.setPen(theme().color(current ? Role::Text : Role::Dim));
        const QRect words = tab.adjusted(Padding + 24, 0, -(Padding + 18), 0);
        painter.drawText(words, Qt::AlignVCenter | Qt::AlignLeft, painter.fontMetrics().elidedText(tabText(i), Qt::ElideRight, words.width() + 2));
        if (current || i == m_hover)
            paintIcon(painter, QRectF(crossRect(i)).adjusted(1, 1, -1, -1), QStringLiteral("close"), Role::Dim);
        if (current && hasFocus()) {
            painter.setPen(QPen(theme().color(Role::Accent), 1, Qt::DotLine));
            painter.drawRect(tab.adjusted(4, 5, -5, -5));
        }
    }
}

void EditorTabBar::mousePressEvent(QMouseEvent* event)
{
    const int index = tabAt(event->position().toPoint());
    m_pressedCross = index >= 0 && crossRect(index).contains(event->position().toPoint()) ? index : -1;
    if (m_pressedCross < 0)
        QTabBar::mousePressEvent(event);
}

void EditorTabBar::mouseReleaseEvent(QMouseEvent* event)
{
    const int index = tabAt(event->position().toPoint());
    if (index >= 0 && (event->button() == Qt::MiddleButton || (index == m_pressedCross && crossRect(index).contains(event->position().toPoint()))))
        emit tabCloseRequested(index);
    else
        QTabBar::mouseReleaseEvent(event);
    m_pressedCross = -1;
}

void EditorTabBar::mouseMoveEvent(QMouseEvent* event)
{
    const int index = tabAt(event->position().toPoint());
    if (index != m_hover) {
        m_hover = index;
        update();
    }
    if (m_pressedCross < 0)
        QTabBar::mouseMoveEvent(event);
}

void EditorTabBar::leaveEvent(QEvent* event)
{
    m_hover = -1;
    update();
    QTabBar::leaveEvent(event);
}

} // namespace camwright
