#pragma once

#include <QStyledItemDelegate>

namespace camwright {

class WatchModel;

/// Paints the last ten seconds of a value as a small curve.
class HistoryDelegate : public QStyledItemDelegate {
    Q_OBJECT
public:
    HistoryDelegate(const WatchModel& model, QObject* parent);
    void paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const override;

private:
    const WatchModel& m_model;
};

} // namespace camwright
