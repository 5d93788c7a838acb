#include "editors/program/referencesmodel.h"

#include "editors/shell/icons.h"
#include "editors/shell/theme.h"
#include "editors/words/words.h"

#include <algorithm>
#include <charconv>

namespace camwright {

namespace {

QString useWord(UseKind kind)
{
    switch (kind) {
    case UseKind::Declares: return ReferencesModel::tr("declares");
    case UseKind::Reads: return ReferencesModel::tr("reads");
    case UseKind::Writes: return ReferencesModel::tr("writes");
    case UseKind::ReadsAndWrites: return ReferencesModel::tr("reads and writes");
    case UseKind::Calls: return ReferencesModel::tr("calls");
    case UseKind::Commands: return ReferencesModel::tr("commands");
    case UseKind::Watches: return ReferencesModel::tr("watches");
    }
    return {};
}

/// The row of a table that a place names, from 0.
std::optional<int> rowOf(const Place& place)
{
    constexpr std::string_view Prefix = "rows[";
    int row = 0;
    const char* const end = place.field.data() + place.field.size();
    const bool isRow = place.field.starts_with(Prefix) && std::from_chars(place.field.data() + Prefix.size(), end, row).ec == std::errc{};
    return isRow ? std::optional(row) : std::nullopt;
}

QString useIcon(UseKind kind)
{
    switch (kind) {
    case UseKind::Declares: return QStringLiteral("variables");
    case UseKind::Reads: return QStringLiteral("arrow-right");
    case UseKind::Writes: return QStringLiteral("rename");
    case UseKind::ReadsAndWrites: return QStringLiteral("replace");
    case UseKind::Calls: return QStringLiteral("subroutine");
    case UseKind::Commands: return QStringLiteral("axes");
    case UseKind::Watches: return QStringLiteral("watch");
    }
    return {};
}

} // namespace

void ReferencesModel::setReferences(std::vector<Reference> references)
{
    beginResetModel();
    m_references = std::move(references);
    endResetModel();
}

int ReferencesModel::count(UseKind kind) const
{
    return static_cast<int>(std::ranges::count_if(m_references, [kind](const Reference& reference) {
        const bool both = reference.use.kind == UseKind::ReadsAndWrites && (kind == UseKind::Reads || kind == UseKind::Writes);
        return !reference.overlaps && (reference.use.kind == kind || both);
    }));
}

int ReferencesModel::overlaps() const
{
    return static_cast<int>(std::ranges::count_if(m_references, &Reference::overlaps));
}

int ReferencesModel::rowCount(const QModelIndex& parent) const
{
    return parent.isValid() ? 0 : static_cast<int>(m_references.size());
}

int ReferencesModel::columnCount(const QModelIndex& parent) const
{
    return parent.isValid() ? 0 : ColumnCount;
}

QString ReferencesModel::text(const Reference& reference, int column) const
{
    const SymbolUse& use = reference.use;
    switch (column) {
    case Use:
        return reference.overlaps ? tr("%1, overlaps as %2").arg(useWord(use.kind), QString::fromStdString(use.text)) : useWord(use.kind);
    case Where:
        if (const auto row = rowOf(use.place))
            return tr("%1, row %2").arg(QString::fromStdString(use.place.object.name)).arg(*row + 1);
        if (use.instruction.empty())
            return words::placeText({use.place.object, {}, {}, {}});
        return tr("%1, network %2, line %3").arg(QString::fromStdString(use.place.object.name)).arg(use.network).arg(use.place.range.line);
    default:
        return QString::fromStdString(use.line.empty() ? use.text : use.line);
    }
}

QVariant ReferencesModel::data(const QModelIndex& index, int role) const
{
    if (!index.isValid() || index.row() >= rowCount())
        return {};
    const Reference& found = reference(index.row());
    switch (role) {
    case Qt::DisplayRole:
    case Qt::ToolTipRole: return text(found, index.column());
    case Qt::DecorationRole: return index.column() == Use ? QVariant(icon(useIcon(found.use.kind), found.overlaps ? Role::Warn : Role::Dim)) : QVariant();
    case Qt::FontRole: return index.column() == Text ? QVariant(theme().monoFont()) : QVariant();
    case Qt::ForegroundRole:
        return theme().color(found.overlaps && index.column() == Use ? Role::Warn : index.column() == Where ? Role::Dim : Role::Text);
    default: return {};
    }
}

QVariant ReferencesModel::headerData(int section, Qt::Orientation orientation, int role) const
{
    if (orientation != Qt::Horizontal)
        return {};
    if (role == Qt::TextAlignmentRole)
        return int(Qt::AlignLeft | Qt::AlignVCenter);
    if (role != Qt::DisplayRole)
        return {};
    return section == Use ? tr("Use") : section == Where ? tr("Where") : tr("Text");
}

} // namespace camwright
