#pragma once

#include "editors/network/motionnetworkdraft.h"

#include <QAbstractTableModel>

namespace camwright {

/// All axes of a draft with the columns of the manual's [Axis List] (KS-MCN-08). Read-only.
class AxisListModel : public QAbstractTableModel {
    Q_OBJECT
public:
    enum Column { Number, Name, Type, Resolution, Travel, GuardTime, LifeFactor, InhibitTime, EventTimer, ColumnCount };

    explicit AxisListModel(QObject* parent = nullptr) : QAbstractTableModel(parent) {}
    void setDraft(const MotionNetworkDraft& draft);

    int rowCount(const QModelIndex& parent = {}) const override;
    int columnCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

private:
    QString text(const DraftAxis& axis, int column) const;

    MotionNetworkDraft m_draft;
};

} // namespace camwright
