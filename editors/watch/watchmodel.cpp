#include "editors/watch/watchmodel.h"

#include "editors/document/editcommands.h"
#include "editors/document/projectdocument.h"
#include "editors/shell/theme.h"
#include "editors/watch/variablelookup.h"
#include "editors/words/words.h"

namespace camwright {

namespace {

NumberBase baseOf(const std::string& format)
{
    return format == "hex" ? NumberBase::Hexadecimal : format == "bin" ? NumberBase::Binary : format == "oct" ? NumberBase::Octal : NumberBase::Decimal;
}

QString typeName(DataType type)
{
    return QString::fromUtf8(name(type).data(), static_cast<qsizetype>(name(type).size()));
}

} // namespace

WatchModel::WatchModel(ProjectDocument& document, ObjectKey key, QObject* parent)
    : QAbstractTableModel(parent), m_document(document), m_key(std::move(key))
{
    load();
    connect(&m_document, &ProjectDocument::changed, this, &WatchModel::documentChanged);
}

void WatchModel::load()
{
    const auto* table = m_document.content<WatchTable>(m_key);
    m_rows = table ? table->rows : std::vector<WatchRow>();
}

void WatchModel::setKey(const ObjectKey& key)
{
    beginResetModel();
    m_key = key;
    load();
    endResetModel();
    emit expressionsChanged();
}

void WatchModel::documentChanged(const ProjectChange& change)
{
    if (!change.touches(m_key))
        return;
    beginResetModel();
    load();
    endResetModel();
    emit expressionsChanged();
}

const WatchedValue* WatchModel::watched(int row) const
{
    if (row < 0 || row >= static_cast<int>(m_rows.size()))
        return nullptr;
    const auto found = m_watched.find(m_rows[static_cast<std::size_t>(row)].expression);
    return found == m_watched.end() ? nullptr : &found->second;
}

QString WatchModel::typedValue(int row) const
{
    const auto found = m_typed.find(m_rows[static_cast<std::size_t>(row)].expression);
    return found == m_typed.end() ? QString() : found->second;
}

// Edits of the project

void WatchModel::replace(const std::vector<WatchRow>& rows, const QString& label)
{
    editObject<WatchTable>(m_document, m_key, label, "rows", [&](WatchTable& table) { table.rows = rows; });
}

void WatchModel::add(int row, const std::vector<WatchRow>& added)
{
    std::vector<WatchRow> rows = m_rows;
    rows.insert(rows.begin() + std::min<int>(row, static_cast<int>(rows.size())), added.begin(), added.end());
    if (!added.empty())
        replace(rows, tr("Add %n watched value(s)", nullptr, static_cast<int>(added.size())));
}

void WatchModel::remove(const std::vector<int>& removed)
{
    std::vector<WatchRow> rows;
    for (int row = 0; row < static_cast<int>(m_rows.size()); ++row) {
        if (std::ranges::find(removed, row) == removed.end())
            rows.push_back(m_rows[static_cast<std::size_t>(row)]);
    }
    if (rows.size() != m_rows.size())
        replace(rows, tr("Remove %n watched value(s)", nullptr, static_cast<int>(m_rows.size() - rows.size())));
}

void WatchModel::setFormat(const std::vector<int>& which, const std::string& format)
{
    std::vector<WatchRow> rows = m_rows;
    for (const int row : which) {
        if (row < static_cast<int>(rows.size()))
            rows[static_cast<std::size_t>(row)].format = format;
    }
    if (rows != m_rows)
        replace(rows, tr("Change the display format"));
}

// From the controller

void WatchModel::setType(const std::string& expression, Result<DataType> type)
{
    WatchedValue& watched = m_watched[expression];
    watched.type = type ? std::optional(*type) : std::nullopt;
    watched.problem = type ? std::nullopt : std::optional(type.error());
    if (!m_rows.empty())
        emit dataChanged(index(0, Type), index(static_cast<int>(m_rows.size()) - 1, CurrentValue));
}

void WatchModel::update(const std::vector<MonitoredValue>& values)
{
    for (const MonitoredValue& value : values) {
        WatchedValue& watched = m_watched[value.name];
        watched.value = value;
        watched.history.push_back(value.value.asDouble());
        if (watched.history.size() > HistoryLength)
            watched.history.pop_front();
    }
    m_stale = false;
    if (!m_rows.empty())
        emit dataChanged(index(0, CurrentValue), index(static_cast<int>(m_rows.size()) - 1, History));
}

void WatchModel::setStale(bool stale)
{
    m_stale = stale;
    if (!m_rows.empty())
        emit dataChanged(index(0, CurrentValue), index(static_cast<int>(m_rows.size()) - 1, History));
}

void WatchModel::forgetValues()
{
    m_watched.clear();
    setStale(true);
}

// The model

int WatchModel::rowCount(const QModelIndex& parent) const
{
    return parent.isValid() ? 0 : static_cast<int>(m_rows.size()) + 1;
}

int WatchModel::columnCount(const QModelIndex& parent) const
{
    return parent.isValid() ? 0 : ColumnCount;
}

QString WatchModel::text(int row, int column) const
{
    const WatchRow& watchRow = m_rows[static_cast<std::size_t>(row)];
    const WatchedValue* known = watched(row);
    switch (column) {
    case Name: return QString::fromStdString(watchRow.expression);
    case Type: return known && known->type ? typeName(*known->type) : QString();
    case CurrentValue: {
        if (!known || known->problem)
            return known ? tr("not known") : QString();
        if (!known->value)
            return {};
        const QString value = QString::fromStdString(formatValue(known->value->value, baseOf(watchRow.format)));
        return known->value->forced ? QStringLiteral("F  ") + value : value;
    }
    case NewValue: return typedValue(row);
    case Comment: return commentOf(m_document.project(), watchRow.expression);
    default: return {};
    }
}

QVariant WatchModel::color(int row, int column) const
{
    const WatchedValue* known = watched(row);
    const std::string& expression = m_rows[static_cast<std::size_t>(row)].expression;
    if (column == NewValue && m_typedWrong.contains(expression))
        return theme().color(Role::Error);
    if (column == CurrentValue && known && known->problem)
        return theme().color(Role::Error);
    if (column == CurrentValue && known && known->value && known->value->forced)
        return theme().color(Role::Forced);
    if (column == CurrentValue && m_stale)
        return theme().color(Role::Faint);
    return column == Comment || column == Type ? QVariant(theme().color(Role::Dim)) : QVariant();
}

QVariant WatchModel::data(const QModelIndex& index, int role) const
{
    if (!index.isValid())
        return {};
    if (index.row() == static_cast<int>(m_rows.size())) {
        if (role == Qt::DisplayRole && index.column() == Name)
            return tr("name or address");
        return role == Qt::ForegroundRole ? QVariant(theme().color(Role::Faint)) : QVariant();
    }
    const WatchedValue* known = watched(index.row());
    switch (role) {
    case Qt::DisplayRole:
    case Qt::EditRole: return text(index.row(), index.column());
    case Qt::FontRole: return index.column() == Comment ? QVariant() : QVariant(theme().monoFont());
    case Qt::TextAlignmentRole:
        return int((index.column() == CurrentValue || index.column() == NewValue ? Qt::AlignRight : Qt::AlignLeft) | Qt::AlignVCenter);
    case Qt::ForegroundRole: return color(index.row(), index.column());
    case Qt::BackgroundRole: return known && known->value && known->value->forced ? QVariant(theme().color(Role::ForcedSoft)) : QVariant();
    case Qt::ToolTipRole: {
        const auto wrong = m_typedWrong.find(m_rows[static_cast<std::size_t>(index.row())].expression);
        if (index.column() == NewValue && wrong != m_typedWrong.end())
            return words::sentence(wrong->second);
        return known && known->problem ? QVariant(words::sentence(*known->problem)) : QVariant();
    }
    default: return {};
    }
}

bool WatchModel::enterNewValue(int row, const QString& text)
{
    const std::string& expression = m_rows[static_cast<std::size_t>(row)].expression;
    m_typedWrong.erase(expression);
    if (text.trimmed().isEmpty()) {
        m_typed.erase(expression);
    } else {
        m_typed[expression] = text;
        const WatchedValue* known = watched(row);
        const auto value = known && known->type ? parseValue(*known->type, text.toStdString())
                                                : Result<Value>(diagnostic(Code::NotConnected));
        if (value)
            emit writeRequested(QString::fromStdString(expression), *value);
        else
            m_typedWrong.emplace(expression, value.error());
    }
    emit dataChanged(index(row, NewValue), index(row, NewValue));
    return true;
}

bool WatchModel::setData(const QModelIndex& index, const QVariant& value, int role)
{
    if (!index.isValid() || role != Qt::EditRole)
        return false;
    const QString text = value.toString().trimmed();
    if (index.row() == static_cast<int>(m_rows.size())) {
        if (index.column() != Name || text.isEmpty())
            return false;
        add(index.row(), {WatchRow{text.toStdString(), {}}});
        return true;
    }
    if (index.column() == NewValue)
        return enterNewValue(index.row(), text);
    if (index.column() != Name)
        return false;
    std::vector<WatchRow> rows = m_rows;
    rows[static_cast<std::size_t>(index.row())].expression = text.toStdString();
    if (text.isEmpty())
        rows.erase(rows.begin() + index.row());
    replace(rows, tr("Change a watched value"));
    return true;
}

QVariant WatchModel::headerData(int section, Qt::Orientation orientation, int role) const
{
    if (orientation != Qt::Horizontal)
        return {};
    if (role == Qt::TextAlignmentRole)
        return int((section == CurrentValue || section == NewValue ? Qt::AlignRight : Qt::AlignLeft) | Qt::AlignVCenter);
    if (role != Qt::DisplayRole)
        return {};
    switch (section) {
    case Name: return tr("Name");
    case Type: return tr("Type");
    case CurrentValue: return tr("Value");
    case NewValue: return tr("New value");
    case History: return tr("Last 10 s");
    case Comment: return tr("Comment");
    default: return {};
    }
}

Qt::ItemFlags WatchModel::flags(const QModelIndex& index) const
{
    if (!index.isValid())
        return Qt::NoItemFlags;
    const bool isNew = index.row() == static_cast<int>(m_rows.size());
    const bool editable = index.column() == Name || (index.column() == NewValue && !isNew);
    return Qt::ItemIsEnabled | Qt::ItemIsSelectable | (editable ? Qt::ItemIsEditable : Qt::NoItemFlags);
}

} // namespace camwright
