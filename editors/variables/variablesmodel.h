#pragma once

#include "core/base/diagnostic.h"
#include "core/model/objects.h"
#include "editors/document/projectchange.h"
#include "editors/document/rowsmodel.h"

#include <map>

namespace camwright {

class ProjectDocument;

/// A variable table of the document as rows to edit. Every change is a command; the model follows the document. One empty
/// row at the end waits for a new variable.
class VariablesModel : public RowsModel<Variable> {
    Q_OBJECT
public:
    enum Column { Name, Type, Address, Initial, Retain, Comment, ColumnCount };

    VariablesModel(ProjectDocument& document, ObjectKey key, QObject* parent = nullptr);

    int columnCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role) const override;
    bool setData(const QModelIndex& index, const QVariant& value, int role) override;
    QVariant headerData(int section, Qt::Orientation orientation, int role) const override;
    Qt::ItemFlags flags(const QModelIndex& index) const override;

    void setKey(const ObjectKey& key);
    void insert(int row, const std::vector<Variable>& variables);
    void removeVariables(const std::vector<int>& removed);

    /// Rows as lines with tabs between the columns, and back; what a spreadsheet copies can be pasted.
    QString toText(const std::vector<int>& wanted) const;
    static std::vector<Variable> fromText(const QString& text);

private:
    std::vector<Variable> storedRows() const;
    void documentChanged(const ProjectChange& change);
    void refreshProblems();
    void replace(int first, int removed, const std::vector<Variable>& inserted, const QString& label);
    QString text(const Variable& variable, int column) const;
    const Diagnostic* problem(int row, int column) const;

    ProjectDocument& m_document;
    ObjectKey m_key;
    std::map<std::pair<int, int>, Diagnostic> m_problems; ///< by row and column
};

} // namespace camwright
