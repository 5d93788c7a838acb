#include "editors/network/axislistmodel.h"

#include "editors/shell/theme.h"

#include <cstdlib>

namespace camwright {

namespace {

QString shown(const Field<std::int64_t>& field)
{
    return field.isValid() ? QString::number(field.value()) : QString::fromStdString(field.text());
}

QString shown(const Field<double>& field)
{
    return field.isValid() ? QString::number(field.value(), 'g', 10) : QString::fromStdString(field.text());
}

/// A heading in two lines of about one length, so that nine columns stand side by side.
QString inTwoLines(const QString& heading)
{
    qsizetype best = -1;
    for (qsizetype at = heading.indexOf(QLatin1Char(' ')); at >= 0; at = heading.indexOf(QLatin1Char(' '), at + 1)) {
        if (best < 0 || std::abs(2 * at - heading.size()) < std::abs(2 * best - heading.size()))
            best = at;
    }
    return best < 0 ? heading : heading.left(best) + QLatin1Char('\n') + heading.mid(best + 1);
}

} // namespace

void AxisListModel::setDraft(const MotionNetworkDraft& draft)
{
    if (draft.axes().size() == m_draft.axes().size()) {
        m_draft = draft;
        if (rowCount() > 0)
            emit dataChanged(index(0, 0), index(rowCount() - 1, ColumnCount - 1));
        return;
    }
    beginResetModel();
    m_draft = draft;
    endResetModel();
}

int AxisListModel::rowCount(const QModelIndex& parent) const
{
    return parent.isValid() ? 0 : static_cast<int>(m_draft.axes().size());
}

int AxisListModel::columnCount(const QModelIndex& parent) const
{
    return parent.isValid() ? 0 : ColumnCount;
}

QString AxisListModel::text(const DraftAxis& row, int column) const
{
    const Axis& axis = row.axis();
    const bool rotary = axis.type.valueOr(AxisType::Linear) == AxisType::Rotary;
    switch (column) {
    case Number: return shown(axis.number);
    case Name: return QString::fromStdString(row.object.key.name);
    case Type: return rotary ? tr("Rotary") : tr("Linear");
    case Resolution: return shown(axis.encoderResolution);
    case Travel: return shown(axis.mechanicalEquivalent) + (rotary ? tr("°") : tr(" mm"));
    case GuardTime: return shown(axis.guardTimeMs) + tr(" ms");
    case LifeFactor: return shown(axis.lifeFactor);
    case InhibitTime: return shown(axis.inhibitTimeMs) + tr(" ms");
    case EventTimer: return axis.eventTimerMs == Field<std::int64_t>(0) ? tr("off") : shown(axis.eventTimerMs) + tr(" ms");
    default: return {};
    }
}

QVariant AxisListModel::data(const QModelIndex& index, int role) const
{
    if (!index.isValid())
        return {};
    const bool isText = index.column() == Name || index.column() == Type;
    switch (role) {
    case Qt::DisplayRole: return text(m_draft.axes()[static_cast<std::size_t>(index.row())], index.column());
    case Qt::TextAlignmentRole: return int((isText ? Qt::AlignLeft : Qt::AlignRight) | Qt::AlignVCenter);
    case Qt::FontRole: return isText ? QVariant() : QVariant(theme().monoFont());
    default: return {};
    }
}

QVariant AxisListModel::headerData(int section, Qt::Orientation orientation, int role) const
{
    if (orientation != Qt::Horizontal)
        return {};
    if (role == Qt::TextAlignmentRole)
        return int((section == Name || section == Type ? Qt::AlignLeft : Qt::AlignRight) | Qt::AlignVCenter);
    if (role != Qt::DisplayRole)
        return {};
    switch (section) {
    case Number: return tr("Axis");
    case Name: return tr("Name");
    case Type: return tr("Type");
    case Resolution: return inTwoLines(tr("Encoder resolution"));
    case Travel: return inTwoLines(tr("Travel per turn"));
    case GuardTime: return inTwoLines(tr("Guard time"));
    case LifeFactor: return inTwoLines(tr("Life factor"));
    case InhibitTime: return inTwoLines(tr("PDO inhibit time"));
    case EventTimer: return inTwoLines(tr("PDO event timer"));
    default: return {};
    }
}

} // namespace camwright
