#include "editors/watch/historydelegate.h"

#include "editors/shell/theme.h"
#include "editors/watch/watchmodel.h"

#include <QPainter>
#include <QPainterPath>

#include <algorithm>
#include <cmath>

namespace camwright {

HistoryDelegate::HistoryDelegate(const WatchModel& model, QObject* parent)
    : QStyledItemDelegate(parent), m_model(model)
{
}

void HistoryDelegate::paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const
{
    QStyledItemDelegate::paint(painter, option, index);
    const WatchedValue* watched = m_model.watched(index.row());
    if (!watched || watched->history.size() < 2)
        return;
    const bool isBit = watched->type == DataType::Bool;
    const auto [low, high] = std::ranges::minmax(watched->history);
    if (!std::isfinite(low) || !std::isfinite(high))
        return;
    const QRectF area = QRectF(option.rect).adjusted(6, 5, -6, -5);
    const double span = high - low, step = area.width() / double(WatchModel::HistoryLength - 1);
    const auto yOf = [&](double value) {
        if (isBit)
            return value != 0 ? area.top() : area.bottom();
        return span > 0 ? area.bottom() - (value - low) / span * area.height() : area.center().y();
    };
    QPainterPath path;
    double x = area.right() - step * double(watched->history.size() - 1);
    path.moveTo(x, yOf(watched->history.front()));
    for (std::size_t i = 1; i < watched->history.size(); ++i) {
        if (isBit)
            path.lineTo(x + step, yOf(watched->history[i - 1]));
        x += step;
        path.lineTo(x, yOf(watched->history[i]));
    }
    painter->save();
    painter->setRenderHint(QPainter::Antialiasing);
    painter->setPen(QPen(theme().color(watched->value && watched->value->forced ? Role::Forced : Role::Accent), 1.2));
    painter->drawPath(path);
    painter->restore();
}

} // namespace camwright
