#include "app/window/badgetabbar.h"

#include "editors/shell/theme.h"

#include <QPainter>

namespace camwright {

namespace {

constexpr int Height = 30;

QFont wordFont(bool current)
{
    QFont out = theme().smallFont();
    out.setWeight(current ? QFont::DemiBold : QFont::Normal);
    return out;
}

QFont badgeFont()
{
    QFont out = theme().smallFont();
    out.setPixelSize(10);
    out.setWeight(QFont::DemiBold);
    return out;
}

} // namespace

BadgeTabBar::BadgeTabBar(QWidget* parent) : QTabBar(parent)
{
    setDrawBase(false);
    setExpanding(false);
    setFixedHeight(Height);
    setFocusPolicy(Qt::TabFocus);
    connect(&theme(), &Theme::changed, this, qOverload<>(&QWidget::update));
}

QSize BadgeTabBar::badgeSize(int index) const
{
    const int number = tabData(index).toInt();
    if (number <= 0)
        return {};
    return {QFontMetrics(badgeFont()).horizontalAdvance(QString::number(number)) + 10, 16};
}

QSize BadgeTabBar::tabSizeHint(int index) const
{
    const QSize badge = badgeSize(index);
    return {QFontMetrics(wordFont(true)).horizontalAdvance(tabText(index)) + 24 + (badge.isEmpty() ? 0 : badge.width() + 6), Height};
}

void BadgeTabBar::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    for (int i = 0; i < count(); ++i) {
        const QRect tab = tabRect(i);
        const bool current = i == currentIndex();
        if (current)
            painter.fillRect(QRect(tab.left(), height() - 2, tab.width(), 2), theme().color(Role::Accent));
        painter.setFont(wordFont(current));
        painter.setPen(theme().color(current ? Role::Text : Role::Dim));
        painter.drawText(QRect(tab.left() + 12, 0, tab.width(), height()), Qt::AlignVCenter | Qt::AlignLeft, tabText(i));
        const QSize badge = badgeSize(i);
        if (!badge.isEmpty()) {
            const QRect box(QPoint(tab.right() - 10 - badge.width(), (height() - 16) / 2), badge);
            painter.setPen(Qt::NoPen);
            painter.setBrush(theme().color(Role::WarnSoft));
            painter.drawRoundedRect(box, 8, 8);
            painter.setFont(badgeFont());
            painter.setPen(theme().color(Role::Warn));
            painter.drawText(box, Qt::AlignCenter, QString::number(tabData(i).toInt()));
        }
        if (current && hasFocus()) {
            painter.setPen(QPen(theme().color(Role::Accent), 1, Qt::DotLine));
            painter.setBrush(Qt::NoBrush);
            painter.drawRect(tab.adjusted(4, 4, -5, -6));
        }
    }
}

} // namespace camwright
