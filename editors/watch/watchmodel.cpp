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
    : RowsModel(parent), m_document(document), m_key(std::move(key))
{
    resetRows(storedRows());
    connect(&m_document, &ProjectDocument::changed, this, &WatchModel::documentChanged);
}

std::vector<WatchRow> WatchModel::storedRows() const
{
    const auto* table = m_document.content<WatchTable>(m_key);
    return table ? table->rows : std::vector<WatchRow>();
}

void WatchModel::setKey(const ObjectKey& key)
{
    m_key = key;
    resetRows(storedRows());
    emit expressionsChanged();
}

void WatchModel::documentChanged(const ProjectChange& change)
{
    if (!change.touches(m_key))
        return;
    const auto expressions = [this] {
        std::vector<std::string> out;
        for (const WatchRow& row : rows())
            out.push_back(row.expression);
        return out;
    };
    const auto before = expressions();
    takeRows(storedRows());
    if (expressions() != before)
        emit expressionsChanged();
}

const WatchedValue* WatchModel::watched(int row) const
{
    if (row < 0 || row >= static_cast<int>(rows().size()))
        return nullptr;
    const auto found = m_watched.find(rowAt(row).expression);
    return found == m_watched.end() ? nullptr : &found->second;
}

QString WatchModel::typedValue(int row) const
{
    const auto found = m_typed.find(rowAt(row).expression);
    return found == m_typed.end() ? QString() : found->second;
}

// Edits of the project

void WatchModel::replace(const std::vector<WatchRow>& rows, const QString& label)
{
    editObject<WatchTable>(m_document, m_key, label, "rows", [&](WatchTable& table) { table.rows = rows; });
}

void WatchModel::add(int row, const std::vector<WatchRow>& added)
{
    std::vector<WatchRow> changed = rows();
    changed.insert(changed.begin() + std::min<int>(row, static_cast<int>(changed.size())), added.begin(), added.end());
    if (!added.empty())
        replace(changed, tr("Add %n watched value(s)", nullptr, static_cast<int>(added.size())));
}

void WatchModel::remove(const std::vector<int>& removed)
{
    std::vector<WatchRow> left;
    for (int row = 0; !isEmptyRow(row); ++row) {
        if (std::ranges::find(removed, row) == removed.end())
            left.push_back(rowAt(row));
    }
    if (left.size() != rows().size())
        replace(left, tr("Remove %n watched value(s)", nullptr, static_cast<int>(rows().size() - left.size())));
}

void WatchModel::setFormat(const std::vector<int>& which, const std::string& format)
{
    std::vector<WatchRow> changed = rows();
    for (const int row : which) {
        if (row < static_cast<int>(changed.size()))
            changed[static_cast<std::size_t>(row)].format = format;
    }
    if (changed != rows())
        replace(changed, tr("Change the display format"));
}

// From the controller

void WatchModel::setType(const std::string& expression, Result<DataType> type)
{
    WatchedValue& watched = m_watched[expression];
    watched.type = type ? std::optional(*type) : std::nullopt;
    watched.problem = type ? std::nullopt : std::optional(type.error());
    if (type && m_typedWrong.contains(expression)) // typed before the type was known
        judgeTyped(expression, *type);
    if (!rows().empty())
        emit dataChanged(index(0, Type), index(static_cast<int>(rows().size()) - 1, NewValue));
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
    if (!rows().empty())
        emit dataChanged(index(0, CurrentValue), index(static_cast<int>(rows().size()) - 1, History));
}

void WatchModel::setStale(bool stale)
{
    m_stale = stale;
    if (!rows().empty())
        emit dataChanged(index(0, CurrentValue), index(static_cast<int>(rows().size()) - 1, History));
}

void WatchModel::forgetValues()
{
    m_watched.clear();
    setStale(true);
}

// The model

int WatchModel::columnCount(const QModelIndex& parent) const
{
    return parent.isValid() ? 0 : ColumnCount;
}

QString WatchModel::text(int row, int column) const
{
    const WatchRow& watchRow = rowAt(row);
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
    const std::string& expression = rowAt(row).expression;
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
    if (isEmptyRow(index.row())) {
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
        const auto wrong = m_typedWrong.find(rowAt(index.row()).expression);
        if (index.column() == NewValue && wrong != m_typedWrong.end())
            return words::sentence(wrong->second);
        return known && known->problem ? QVariant(words::sentence(*known->problem)) : QVariant();
    }
    default: return {};
    }
}

std::optional<Value> WatchModel::judgeTyped(const std::string& expression, const std::optional<DataType>& type)
{
    m_typedWrong.erase(expression);
    const auto value = type ? parseValue(*type, m_typed[expression].toStdString()) : Result<Value>(diagnostic(Code::NotConnected));
    if (value)
        return *value;
    m_typedWrong.emplace(expression, value.error());
    return std::nullopt;
}

bool WatchModel::enterNewValue(int row, const QString& text)
{
    const std::string& expression = rowAt(row).expression;
    if (text.trimmed().isEmpty()) {
        m_typed.erase(expression);
        m_typedWrong.erase(expression);
    } else {
        m_typed[expression] = text;
        const WatchedValue* known = watched(row);
        if (const auto value = judgeTyped(expression, known ? known->type : std::nullopt))
            emit writeRequested(QString::fromStdString(expression), *value);
    }
    emit dataChanged(index(row, NewValue), index(row, NewValue));
    return true;
}

bool WatchModel::setData(const QModelIndex& index, const QVariant& value, int role)
{
    if (!index.isValid() || role != Qt::EditRole)
        return false;
    const QString text = value.toString().trimmed();
    if (isEmptyRow(index.row())) {
        if (index.column() != Name || text.isEmpty())
            return false;
        add(index.row(), {WatchRow{text.toStdString(), {}}});
        return true;
    }
    if (index.column() == NewValue)
        return enterNewValue(index.row(), text);
    if (index.column() != Name)
        return false;
    std::vector<WatchRow> changed = rows();
    changed[static_cast<std::size_t>(index.row())].expression = text.toStdString();
    if (text.isEmpty())
        changed.erase(changed.begin() + index.row());
    replace(changed, tr("Change a watched value"));
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
    const bool isNew = isEmptyRow(index.row());
    const bool editable = index.column() == Name || (index.column() == NewValue && !isNew);
    return Qt::ItemIsEnabled | Qt::ItemIsSelectable | (editable ? Qt::ItemIsEditable : Qt::NoItemFlags);
}

} // namespace camwright
