#include "editors/variables/variablesmodel.h"

#include "editors/document/editcommands.h"
#include "editors/document/projectdocument.h"
#include "editors/shell/theme.h"
#include "editors/words/words.h"

#include <charconv>
#include <set>

namespace camwright {

namespace {

Field<DataType> typeFrom(const QString& text)
{
    if (const auto type = dataTypeByName(text.trimmed().toStdString()))
        return *type;
    return Field<DataType>::typed(text.trimmed().toStdString());
}

/// As this table and spreadsheets write it.
bool isYes(const QString& text)
{
    const auto is = [&](const char* word) { return text.compare(QLatin1String(word), Qt::CaseInsensitive) == 0; };
    return is("RETAIN") || is("TRUE") || is("1");
}

void setCell(Variable& variable, int column, const QString& text)
{
    const std::string value = text.trimmed().toStdString();
    switch (column) {
    case VariablesModel::Name: variable.name = value; break;
    case VariablesModel::Type: variable.type = typeFrom(text); break;
    case VariablesModel::Address: variable.address = value; break;
    case VariablesModel::Initial: variable.initial = value; break;
    case VariablesModel::Retain: variable.retain = isYes(text.trimmed()); break;
    case VariablesModel::Comment: variable.comment = value; break;
    default: break;
    }
}

/// "rows[12].address" -> row 12, column Address.
std::optional<std::pair<int, int>> cellOf(const std::string& field)
{
    static constexpr std::pair<std::string_view, int> Names[] = {{"name", VariablesModel::Name}, {"type", VariablesModel::Type},
        {"address", VariablesModel::Address}, {"initial", VariablesModel::Initial}, {"retain", VariablesModel::Retain}, {"comment", VariablesModel::Comment}};
    constexpr std::string_view Prefix = "rows[";
    if (!field.starts_with(Prefix))
        return std::nullopt;
    int row = 0;
    const auto [end, error] = std::from_chars(field.data() + Prefix.size(), field.data() + field.size(), row);
    if (error != std::errc{})
        return std::nullopt;
    const std::string_view rest(end, static_cast<std::size_t>(field.data() + field.size() - end));
    for (const auto& [name, column] : Names) {
        if (rest.ends_with(name))
            return std::pair{row, column};
    }
    return std::pair{row, int(VariablesModel::Name)};
}

} // namespace

VariablesModel::VariablesModel(ProjectDocument& document, ObjectKey key, QObject* parent)
    : RowsModel(parent), m_document(document), m_key(std::move(key))
{
    resetRows(storedRows());
    connect(&m_document, &ProjectDocument::changed, this, &VariablesModel::documentChanged);
    connect(&m_document, &ProjectDocument::diagnosticsChanged, this, &VariablesModel::refreshProblems);
    refreshProblems();
}

void VariablesModel::setKey(const ObjectKey& key)
{
    m_key = key;
    takeRows(storedRows());
    refreshProblems();
}

std::vector<Variable> VariablesModel::storedRows() const
{
    const auto* table = m_document.content<VariableTable>(m_key);
    return table ? table->rows() : std::vector<Variable>();
}

int VariablesModel::columnCount(const QModelIndex& parent) const
{
    return parent.isValid() ? 0 : ColumnCount;
}

QString VariablesModel::text(const Variable& variable, int column) const
{
    switch (column) {
    case Name: return QString::fromStdString(variable.name);
    case Type: return variable.type.isValid() ? QString::fromUtf8(camwright::name(variable.type.value()).data()) : QString::fromStdString(variable.type.text());
    case Address: return QString::fromStdString(variable.address);
    case Initial: return QString::fromStdString(variable.initial);
    case Comment: return QString::fromStdString(variable.comment);
    default: return {};
    }
}

const Diagnostic* VariablesModel::problem(int row, int column) const
{
    const auto found = m_problems.find({row, column});
    return found == m_problems.end() ? nullptr : &found->second;
}

QVariant VariablesModel::data(const QModelIndex& index, int role) const
{
    if (!index.isValid())
        return {};
    if (isEmptyRow(index.row())) {
        if (role == Qt::DisplayRole && index.column() == Name)
            return tr("new variable");
        return role == Qt::ForegroundRole ? QVariant(theme().color(Role::Faint)) : QVariant();
    }
    const Variable& variable = rowAt(index.row());
    const Diagnostic* wrong = problem(index.row(), index.column());
    switch (role) {
    case Qt::DisplayRole:
    case Qt::EditRole: return text(variable, index.column());
    case Qt::CheckStateRole: return index.column() == Retain ? QVariant(int(variable.retain ? Qt::Checked : Qt::Unchecked)) : QVariant();
    case Qt::FontRole: return index.column() == Address || index.column() == Initial || index.column() == Type ? QVariant(theme().monoFont()) : QVariant();
    case Qt::ForegroundRole: return wrong ? QVariant(theme().color(wrong->severity() == Severity::Error ? Role::Error : Role::Warn)) : QVariant();
    case Qt::BackgroundRole: return wrong ? QVariant(theme().color(wrong->severity() == Severity::Error ? Role::ErrorSoft : Role::WarnSoft)) : QVariant();
    case Qt::ToolTipRole: return wrong ? QVariant(words::sentence(*wrong)) : QVariant();
    default: return {};
    }
}

bool VariablesModel::setData(const QModelIndex& index, const QVariant& value, int role)
{
    const bool check = role == Qt::CheckStateRole && index.column() == Retain;
    if (!index.isValid() || (role != Qt::EditRole && !check))
        return false;
    const bool isNew = isEmptyRow(index.row());
    Variable variable = isNew ? Variable{} : rowAt(index.row());
    if (check)
        variable.retain = value.toInt() == Qt::Checked;
    else
        setCell(variable, index.column(), value.toString());
    if (isNew && variable == Variable{})
        return false;
    replace(index.row(), isNew ? 0 : 1, {variable}, isNew ? tr("Add variable") : tr("Change variable %1").arg(QString::fromStdString(variable.name)));
    return true;
}

QVariant VariablesModel::headerData(int section, Qt::Orientation orientation, int role) const
{
    if (orientation != Qt::Horizontal || role != Qt::DisplayRole)
        return {};
    switch (section) {
    case Name: return tr("Name");
    case Type: return tr("Type");
    case Address: return tr("Address");
    case Initial: return tr("Initial value");
    case Retain: return tr("Retain");
    case Comment: return tr("Comment");
    default: return {};
    }
}

Qt::ItemFlags VariablesModel::flags(const QModelIndex& index) const
{
    if (!index.isValid())
        return Qt::NoItemFlags;
    const Qt::ItemFlags base = Qt::ItemIsEnabled | Qt::ItemIsSelectable;
    if (index.column() == Retain)
        return isEmptyRow(index.row()) ? base : base | Qt::ItemIsUserCheckable;
    return base | Qt::ItemIsEditable;
}

void VariablesModel::replace(int first, int removed, const std::vector<Variable>& inserted, const QString& label)
{
    editObject<VariableTable>(m_document, m_key, label, "rows", [&](VariableTable& table) {
        table = table.replaced(static_cast<std::size_t>(first), static_cast<std::size_t>(removed), inserted);
    });
}

void VariablesModel::insert(int row, const std::vector<Variable>& variables)
{
    if (!variables.empty())
        replace(std::min(row, static_cast<int>(rows().size())), 0, variables, tr("Add %n variable(s)", nullptr, static_cast<int>(variables.size())));
}

void VariablesModel::removeVariables(const std::vector<int>& removed)
{
    std::set<int> gone;
    std::ranges::copy_if(removed, std::inserter(gone, gone.end()), [this](int row) { return row >= 0 && row < static_cast<int>(rows().size()); });
    if (gone.empty())
        return;
    std::vector<Variable> left; // of the stretch from the first to the last; what lies outside stays shared
    for (int row = *gone.begin(); row <= *gone.rbegin(); ++row) {
        if (!gone.contains(row))
            left.push_back(rowAt(row));
    }
    replace(*gone.begin(), *gone.rbegin() - *gone.begin() + 1, left, tr("Delete %n variable(s)", nullptr, static_cast<int>(gone.size())));
}

QString VariablesModel::toText(const std::vector<int>& wanted) const
{
    QStringList lines;
    for (const int row : wanted) {
        if (row >= static_cast<int>(rows().size()))
            continue;
        const Variable& variable = rowAt(row);
        QStringList cells;
        for (int column = 0; column < ColumnCount; ++column)
            cells << (column == Retain ? (variable.retain ? QStringLiteral("RETAIN") : QString()) : text(variable, column));
        lines << cells.join(QLatin1Char('\t'));
    }
    return lines.join(QLatin1Char('\n'));
}

std::vector<Variable> VariablesModel::fromText(const QString& text)
{
    std::vector<Variable> out;
    for (const QString& line : text.split(QLatin1Char('\n'))) {
        if (line.trimmed().isEmpty())
            continue;
        const QStringList cells = line.split(QLatin1Char('\t'));
        Variable variable;
        for (int column = 0; column < std::min<int>(ColumnCount, static_cast<int>(cells.size())); ++column)
            setCell(variable, column, cells[column]);
        out.push_back(variable);
    }
    return out;
}

void VariablesModel::documentChanged(const ProjectChange& change)
{
    if (!change.touches(m_key) || !m_document.object(m_key)) // renamed: setKey() follows; removed: the view goes
        return;
    takeRows(storedRows());
}

void VariablesModel::refreshProblems()
{
    m_problems.clear();
    for (const Diagnostic& d : m_document.diagnosticsOf(m_key)) {
        if (const auto cell = cellOf(d.place.field))
            m_problems.try_emplace(*cell, d);
    }
    emit dataChanged(index(0, 0), index(rowCount() - 1, ColumnCount - 1),
        {Qt::ForegroundRole, Qt::BackgroundRole, Qt::ToolTipRole});
}

} // namespace camwright
