#pragma once

#include "core/language/assist/crossreference.h"

#include <QAbstractTableModel>

namespace camwright {

/// Where something is used: how, where, and the line. Uses that only share memory with it say so.
class ReferencesModel : public QAbstractTableModel {
    Q_OBJECT
public:
    enum Column { Use, Where, Text, ColumnCount };

    using QAbstractTableModel::QAbstractTableModel;

    void setReferences(std::vector<Reference> references);
    const Reference& reference(int row) const { return m_references[static_cast<std::size_t>(row)]; }
    /// How many of a kind; ReadsAndWrites counts as both. Overlaps are not counted.
    int count(UseKind kind) const;
    int overlaps() const;

    int rowCount(const QModelIndex& parent = {}) const override;
    int columnCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

private:
    QString text(const Reference& reference, int column) const;

    std::vector<Reference> m_references;
};

} // namespace camwright
