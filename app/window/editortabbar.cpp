#include "app/window/editortabbar.h"

#include "editors/shell/icons.h"

#include <QApplication>
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
constexpr int BarReach = 14;   // a drag this far from the bar is still along it

} // namespace

EditorTabBar::EditorTabBar(QWidget* parent) : QTabBar(parent)
{
    setObjectName(QStringLiteral("editorTabs"));
    setAccessibleName(tr("Editors"));
    setDrawBase(false);
    setExpanding(false);
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

void EditorTabBar::setActive(bool active)
{
    m_active = active;
    update();
}

void EditorTabBar::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    painter.fillRect(rect(), theme().color(Role::Background));
    painter.setPen(theme().color(Role::Line));
    painter.drawLine(0, height() - 1, width(), height() - 1);
    for (int i = 0; i < count(); ++i)
        paintTab(painter, i);
}

void EditorTabBar::paintTab(QPainter& painter, int index)
{
    const QRect tab = tabRect(index);
    const bool current = index == currentIndex();
    const bool lit = current && m_active;
    if (current) {
        painter.fillRect(tab, theme().color(Role::Surface));
        painter.fillRect(QRect(tab.left(), tab.top(), tab.width(), 2), theme().color(lit ? Role::Accent : Role::Line));
    }
    painter.fillRect(QRect(tab.right(), tab.top(), 1, tab.height()), theme().color(Role::FineLine));
    paintIcon(painter, QRectF(tab.left() + Padding, tab.center().y() - 7, 16, 16), lookOf(*this, index).iconName, lit ? Role::Accent : Role::Dim);
    painter.setFont(fontOf(index));
    painter.setPen(theme().color(current ? Role::Text : Role::Dim));
    const QRect words = tab.adjusted(Padding + 24, 0, -(Padding + 18), 0);
    painter.drawText(words, Qt::AlignVCenter | Qt::AlignLeft, painter.fontMetrics().elidedText(tabText(index), Qt::ElideRight, words.width() + 2));
    if (current || index == m_hover)
        paintIcon(painter, QRectF(crossRect(index)).adjusted(1, 1, -1, -1), QStringLiteral("close"), Role::Dim);
    if (current && hasFocus()) {
        painter.setPen(QPen(theme().color(Role::Accent), 1, Qt::DotLine));
        painter.drawRect(tab.adjusted(4, 5, -5, -5));
    }
}

// --- the mouse

void EditorTabBar::mousePressEvent(QMouseEvent* event)
{
    const int index = tabAt(event->position().toPoint());
    m_pressedCross = index >= 0 && crossRect(index).contains(event->position().toPoint()) ? index : -1;
    if (m_pressedCross >= 0)
        return;
    QTabBar::mousePressEvent(event);
    if (event->button() != Qt::LeftButton || index < 0)
        return;
    m_dragged = index;
    m_pressedAt = event->position().toPoint();
    setDrag(Drag::Pressed);
}

void EditorTabBar::mouseReleaseEvent(QMouseEvent* event)
{
    const bool dropped = event->button() == Qt::LeftButton && m_drag == Drag::Outside;
    const int moved = m_dragged;
    if (event->button() == Qt::LeftButton)
        setDrag(Drag::None);
    const int index = tabAt(event->position().toPoint());
    const int cross = std::exchange(m_pressedCross, -1);
    if (dropped)
        emit droppedOutside(moved, event->globalPosition().toPoint());
    else if (index >= 0 && (event->button() == Qt::MiddleButton || (index == cross && crossRect(index).contains(event->position().toPoint()))))
        emit tabCloseRequested(index);
    else
        QTabBar::mouseReleaseEvent(event);
}

void EditorTabBar::mouseMoveEvent(QMouseEvent* event)
{
    const QPoint position = event->position().toPoint();
    const int index = tabAt(position);
    if (index != m_hover) {
        m_hover = index;
        update();
    }
    if (m_drag != Drag::None)
        drag(position, event->globalPosition().toPoint());
    else if (m_pressedCross < 0)
        QTabBar::mouseMoveEvent(event);
}

void EditorTabBar::drag(const QPoint& position, const QPoint& global)
{
    if (m_drag == Drag::Pressed && (position - m_pressedAt).manhattanLength() < QApplication::startDragDistance())
        return;
    if (rect().adjusted(-BarReach, -BarReach, BarReach, BarReach).contains(position)) {
        setDrag(Drag::Inside);
        reorder(position.x());
    } else {
        setDrag(Drag::Outside);
        emit draggedOut(m_dragged, global);
    }
}

/// The tab moves on once the pointer has passed the middle of its neighbour: tabs of unequal width do not flicker.
void EditorTabBar::reorder(int x)
{
    int target = m_dragged;
    while (target + 1 < count() && x > tabRect(target + 1).center().x())
        ++target;
    while (target > 0 && x < tabRect(target - 1).center().x())
        --target;
    if (target == m_dragged)
        return;
    moveTab(m_dragged, target);
    m_dragged = target;
}

void EditorTabBar::setDrag(Drag drag)
{
    if (drag == m_drag)
        return;
    const bool wasOutside = m_drag == Drag::Outside;
    const bool listened = m_drag != Drag::None;
    m_drag = drag;
    if (listened != (drag != Drag::None)) {
        if (listened)
            qApp->removeEventFilter(this);
        else
            qApp->installEventFilter(this);
    }
    if (drag == Drag::None)
        m_dragged = -1;
    setCursor(drag == Drag::Outside ? Qt::ClosedHandCursor : Qt::ArrowCursor);
    if (wasOutside)
        emit dragEnded();
}

/// While a tab is dragged, Escape puts it back, wherever the focus is.
bool EditorTabBar::eventFilter(QObject* watched, QEvent* event)
{
    const bool isKey = event->type() == QEvent::KeyPress || event->type() == QEvent::ShortcutOverride;
    if (isKey && static_cast<QKeyEvent*>(event)->key() == Qt::Key_Escape && m_drag > Drag::Pressed) {
        event->accept();
        if (event->type() == QEvent::KeyPress)
            setDrag(Drag::None);
        return true;
    }
    return QTabBar::eventFilter(watched, event);
}

int EditorTabBar::insertionAt(int x) const
{
    int at = 0;
    while (at < count() && x > tabRect(at).center().x())
        ++at;
    return at;
}

void EditorTabBar::tabRemoved(int index)
{
    setDrag(Drag::None); // a number kept meanwhile may mean another tab now
    QTabBar::tabRemoved(index);
}

void EditorTabBar::hideEvent(QHideEvent* event)
{
    setDrag(Drag::None);
    QTabBar::hideEvent(event);
}

void EditorTabBar::leaveEvent(QEvent* event)
{
    m_hover = -1;
    update();
    QTabBar::leaveEvent(event);
}

} // namespace camwright
