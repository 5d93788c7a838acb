#pragma once

#include "editors/document/projectdocument.h"

#include <QAbstractTableModel>

namespace camwright {

/// What is wrong with the project, errors first, then by place: severity, sentence, place, code.
class ProblemsModel : public QAbstractTableModel {
    Q_OBJECT
public:
    enum Column { SentenceColumn, PlaceColumn, CodeColumn, ColumnCount };
    enum Role { SeverityRole = Qt::UserRole };

    explicit ProblemsModel(ProjectDocument& document, QObject* parent = nullptr);

    int rowCount(const QModelIndex& parent = {}) const override;
    int columnCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role = Qt::DisplayRole) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

    const Diagnostic& problem(int row) const { return m_rows[std::size_t(row)]; }
    void reload();

private:
    ProjectDocument& m_document;
    Diagnostics m_rows;
};

} // namespace camwright
