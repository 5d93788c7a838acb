#include "editors/document/problemsmodel.h"

#include "editors/words/words.h"

#include <algorithm>

namespace camwright {

ProblemsModel::ProblemsModel(ProjectDocument& document, QObject* parent) : QAbstractTableModel(parent), m_document(document)
{
    connect(&document, &ProjectDocument::diagnosticsChanged, this, &ProblemsModel::reload);
    reload();
}

void ProblemsModel::reload()
{
    beginResetModel();
    m_rows = m_document.diagnostics();
    std::sort(m_rows.begin(), m_rows.end(), [](const Diagnostic& a, const Diagnostic& b) {
        return std::tuple(-int(a.severity()), a.place, a.code, a.arguments) < std::tuple(-int(b.severity()), b.place, b.code, b.arguments);
    });
    endResetModel();
}

int ProblemsModel::rowCount(const QModelIndex& parent) const
{
    return parent.isValid() ? 0 : int(m_rows.size());
}

int ProblemsModel::columnCount(const QModelIndex& parent) const
{
    return parent.isValid() ? 0 : ColumnCount;
}

QVariant ProblemsModel::data(const QModelIndex& index, int role) const
{
    if (!index.isValid())
        return {};
    const Diagnostic& row = m_rows[std::size_t(index.row())];
    if (role == SeverityRole)
        return int(row.severity());
    if (role == Qt::ToolTipRole)
        return words::sentence(row);
    if (role == Qt::AccessibleTextRole && index.column() == SentenceColumn)
        return QStringLiteral("%1: %2").arg(words::severityWord(row.severity()), words::sentence(row));
    if (role != Qt::DisplayRole)
        return {};
    switch (index.column()) {
    case SentenceColumn: return words::sentence(row);
    case PlaceColumn: return words::placeText(row.place);
    case CodeColumn: return words::codeId(row.code);
    default: return {};
    }
}

QVariant ProblemsModel::headerData(int section, Qt::Orientation orientation, int role) const
{
    if (orientation != Qt::Horizontal || role != Qt::DisplayRole)
        return QAbstractTableModel::headerData(section, orientation, role);
    switch (section) {
    case SentenceColumn: return tr("Problem");
    case PlaceColumn: return tr("Place");
    case CodeColumn: return tr("Code");
    default: return {};
    }
}

} // namespace camwright
