#include "editors/commissioning/stopbutton.h"

#include "editors/shell/theme.h"

#include <QPainter>

namespace camwright {

namespace {

constexpr int Side = 16, GlyphSize = 18;

} // namespace

StopButton::StopButton(QWidget* parent) : QAbstractButton(parent)
{
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    setFocusPolicy(Qt::StrongFocus);
    connect(&theme(), &Theme::changed, this, qOverload<>(&QWidget::update));
}

void StopButton::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    QColor fill = theme().color(isEnabled() ? Role::Error : Role::Line);
    if (isDown())
        fill = fill.darker(125);
    const QColor ink = theme().color(isEnabled() ? Role::OnError : Role::Dim);
    painter.setPen(hasFocus() ? QPen(theme().color(Role::Text), 2) : QPen(Qt::NoPen));
    painter.setBrush(fill);
    painter.drawRoundedRect(QRectF(rect()).adjusted(1, 1, -1, -1), 6, 6);

    painter.setPen(ink);
    painter.setFont(theme().font());
    painter.drawText(rect().adjusted(Side, 0, 0, 0), Qt::AlignVCenter | Qt::AlignLeft, tr("all axes"));

    QFont big = theme().font();
    big.setPixelSize(25);
    big.setWeight(QFont::ExtraBold);
    big.setLetterSpacing(QFont::AbsoluteSpacing, 2);
    painter.setFont(big);
    const QString word = tr("STOP");
    const double wide = painter.fontMetrics().horizontalAdvance(word);
    const double left = (width() - wide - GlyphSize - 14) / 2;
    painter.fillRect(QRectF(left, (height() - GlyphSize) / 2.0, GlyphSize, GlyphSize), ink);
    painter.drawText(QRectF(left + GlyphSize + 14, 0, wide + 4, height()), Qt::AlignVCenter | Qt::AlignLeft, word);

    painter.setFont(theme().monoFont());
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(ink, 1));
    double right = width() - Side;
    for (const QString& key : {QStringLiteral("Space"), QStringLiteral("Esc")}) {
        const double cap = painter.fontMetrics().horizontalAdvance(key) + 14;
        const QRectF frame(right - cap + 0.5, (height() - 22) / 2.0 + 0.5, cap - 1, 21);
        painter.drawRoundedRect(frame, 3, 3);
        painter.drawText(frame, Qt::AlignCenter, key);
        right -= cap + 6;
    }
}

} // namespace camwright
