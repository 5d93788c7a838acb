// Values behind the lines of a program's text: painted over it, so that the text stays the text.
#include "editors/program/ilcodeview.h"

#include "editors/program/indicators.h"
#include "editors/shell/theme.h"

#include <QPainter>

#include <algorithm>

namespace camwright {

namespace {

constexpr int Gap = 28;       // between the longest line and the column of values
constexpr int Between = 12;   // between two values of a line
constexpr int Padding = 5;    // inside the frame of a value
constexpr double WidestColumn = 0.6; // of the view: values of long lines follow their lines, they move no others

/// One value with its label; returns where the next begins.
int paintValue(QPainter& painter, const QRect& row, int x, const LineValue& value, bool stale)
{
    const QFont mono = theme().monoFont();
    QFont label = theme().smallFont();
    QFont figures = mono;
    figures.setPixelSize(label.pixelSize());
    figures.setItalic(stale);
    if (!value.label.isEmpty()) {
        painter.setFont(label);
        painter.setPen(theme().color(Role::Dim));
        const int width = painter.fontMetrics().horizontalAdvance(value.label);
        painter.drawText(QRect(x, row.top(), width + 2, row.height()), Qt::AlignVCenter, value.label);
        x += width + 4;
    }
    const QString text = value.forced ? QStringLiteral("F %1").arg(value.text) : value.text;
    figures.setBold(value.energised && !stale);
    painter.setFont(figures);
    const int width = painter.fontMetrics().horizontalAdvance(text) + 2 * Padding;
    const QRect frame = QRect(x, row.top() + 1, width, row.height() - 2);
    QColor fill = Qt::transparent;
    if (!stale && value.forced) {
        fill = theme().color(Role::ForcedSoft);
    } else if (!stale && value.energised) {
        fill = theme().color(Role::Energised);
        fill.setAlpha(38);
    }
    painter.setBrush(fill);
    painter.setPen(stale ? QPen(theme().color(Role::Faint), 1, Qt::DashLine) : QPen(Qt::NoPen));
    painter.drawRoundedRect(frame, 3, 3);
    painter.setPen(theme().color(stale ? Role::Dim : value.forced ? Role::Forced : Role::Text));
    painter.drawText(frame, Qt::AlignCenter, text);
    return frame.right() + Between;
}

} // namespace

void IlCodeView::setLineValues(const std::map<int, std::vector<LineValue>>& values, bool stale)
{
    if (values == m_values && stale == m_valuesStale)
        return;
    m_values = values;
    m_valuesStale = stale;
    SendScintilla(SCI_SETINDICATORCURRENT, static_cast<unsigned long>(EnergisedIndicator));
    SendScintilla(SCI_INDICATORCLEARRANGE, 0UL, static_cast<long>(SendScintilla(SCI_GETLENGTH)));
    if (!stale)
        for (const auto& [line, shown] : values)
            for (const LineValue& value : shown)
                if (value.energised)
                    SendScintilla(SCI_INDICATORFILLRANGE, static_cast<unsigned long>(value.offset), static_cast<long>(value.length));
    viewport()->update();
}

void IlCodeView::paintEvent(QPaintEvent* event)
{
    QsciScintilla::paintEvent(event);
    if (!m_values.empty())
        paintLineValues();
}

void IlCodeView::resizeEvent(QResizeEvent* event)
{
    QsciScintilla::resizeEvent(event);
    emit viewChanged();
}

void IlCodeView::paintLineValues()
{
    const auto [first, last] = visibleLines();
    const int height = static_cast<int>(SendScintilla(SCI_TEXTHEIGHT, 0UL));
    const auto endOf = [this](int line) {
        const long end = SendScintilla(SCI_GETLINEENDPOSITION, static_cast<unsigned long>(line));
        return static_cast<int>(SendScintilla(SCI_POINTXFROMPOSITION, 0UL, end));
    };
    const auto from = m_values.lower_bound(first), to = m_values.upper_bound(last);
    const int widest = static_cast<int>(viewport()->width() * WidestColumn);
    int column = 0;
    for (auto it = from; it != to; ++it)
        if (const int end = endOf(it->first); end <= widest)
            column = std::max(column, end);
    int margins = 0;
    for (int margin = 0; margin < 5; ++margin)
        margins += marginWidth(margin);
    QPainter painter(viewport());
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setClipRect(viewport()->rect().adjusted(margins, 0, 0, 0));
    for (auto it = from; it != to; ++it) {
        const long start = SendScintilla(SCI_POSITIONFROMLINE, static_cast<unsigned long>(it->first));
        const QRect row(0, static_cast<int>(SendScintilla(SCI_POINTYFROMPOSITION, 0UL, start)), viewport()->width(), height);
        int x = std::max(column, endOf(it->first)) + Gap;
        for (const LineValue& value : it->second)
            x = paintValue(painter, row, x, value, m_valuesStale);
    }
}

} // namespace camwright
