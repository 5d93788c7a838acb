#include "editors/document/projecttreemodel.h"

#include "editors/document/editcommands.h"

#include <algorithm>

namespace camwright {

namespace {

// Sections carry 0 as internal id, their objects the section's row + 1.
constexpr quintptr SectionId = 0;

} // namespace

QString sectionTitle(ObjectKind kind)
{
    switch (kind) {
    case ObjectKind::Project: return ProjectTreeModel::tr("Project");
    case ObjectKind::Controller: return ProjectTreeModel::tr("Controller");
    case ObjectKind::Axis: return ProjectTreeModel::tr("Axes");
    case ObjectKind::Network: return ProjectTreeModel::tr("Networks");
    case ObjectKind::Program: return ProjectTreeModel::tr("Programs");
    case ObjectKind::VariableTable: return ProjectTreeModel::tr("Variables");
    case ObjectKind::WatchTable: return ProjectTreeModel::tr("Watch lists");
    }
    return {};
}

ProjectTreeModel::ProjectTreeModel(ProjectDocument& document, QObject* parent) : QAbstractItemModel(parent), m_document(document)
{
    for (const ObjectKind kind : {ObjectKind::Controller, ObjectKind::Axis, ObjectKind::Network, ObjectKind::Program,
             ObjectKind::VariableTable, ObjectKind::WatchTable})
        m_sections.push_back({kind, keysNow(kind)});
    connect(&document, &ProjectDocument::changed, this, &ProjectTreeModel::follow);
    connect(&document, &ProjectDocument::diagnosticsChanged, this, &ProjectTreeModel::refreshDetails);
}

std::vector<ObjectKey> ProjectTreeModel::keysNow(ObjectKind kind) const
{
    std::vector<ObjectKey> out;
    if (kind == ObjectKind::Controller)
        return out; // the section is the object
    for (const ObjectPtr& object : m_document.project().objects(kind))
        out.push_back(object->key);
    return out;
}

QModelIndex ProjectTreeModel::index(int row, int column, const QModelIndex& parent) const
{
    if (!hasIndex(row, column, parent))
        return {};
    return createIndex(row, column, parent.isValid() ? quintptr(parent.row()) + 1 : SectionId);
}

QModelIndex ProjectTreeModel::parent(const QModelIndex& child) const
{
    if (!child.isValid() || child.internalId() == SectionId)
        return {};
    return createIndex(int(child.internalId()) - 1, 0, SectionId);
}

int ProjectTreeModel::rowCount(const QModelIndex& parent) const
{
    if (!parent.isValid())
        return int(m_sections.size());
    if (parent.internalId() != SectionId || parent.column() != 0)
        return 0;
    return int(m_sections[std::size_t(parent.row())].keys.size());
}

int ProjectTreeModel::columnCount(const QModelIndex&) const
{
    return 1;
}

QString ProjectTreeModel::iconOf(const ObjectKey& key) const
{
    switch (key.kind) {
    case ObjectKind::Axis: {
        const Axis* axis = m_document.content<Axis>(key);
        return axis && axis->type.valueOr(AxisType::Linear) == AxisType::Rotary ? QStringLiteral("axis-rotary") : QStringLiteral("axis-linear");
    }
    case ObjectKind::Program: {
        const Program* program = m_document.content<Program>(key);
        if (program && program->role == ProgramRole::Interrupt)
            return QStringLiteral("interrupt");
        return program && program->role == ProgramRole::Subroutine ? QStringLiteral("subroutine") : QStringLiteral("program");
    }
    case ObjectKind::Network: return QStringLiteral("bus");
    case ObjectKind::VariableTable: return QStringLiteral("variables");
    case ObjectKind::WatchTable: return QStringLiteral("watch");
    case ObjectKind::Controller:
    case ObjectKind::Project: break;
    }
    return QStringLiteral("controller");
}

QVariant ProjectTreeModel::sectionData(const Section& section, int role) const
{
    const bool isObject = section.kind == ObjectKind::Controller;
    switch (role) {
    case Qt::DisplayRole:
    case Qt::AccessibleTextRole: return sectionTitle(section.kind);
    case KeyRole: return QVariant::fromValue(ObjectKey{section.kind, {}});
    case IsSectionRole: return !isObject;
    case IconRole:
        switch (section.kind) {
        case ObjectKind::Axis: return QStringLiteral("axes");
        case ObjectKind::Network: return QStringLiteral("network");
        case ObjectKind::Program: return QStringLiteral("programs");
        default: return iconOf(ObjectKey{section.kind, {}});
        }
    case DetailRole: {
        if (!isObject)
            return section.keys.empty() ? tr("none") : QString::number(section.keys.size());
        const Detail detail = m_details ? m_details(ObjectKey{section.kind, {}}) : Detail{};
        return detail.text.isEmpty() ? QString::fromStdString(m_document.project().controller().model) : detail.text;
    }
    case DetailIconRole: return isObject && m_details ? m_details(ObjectKey{section.kind, {}}).icon : QString();
    case ProblemRole: {
        int worst = -1;
        for (const Diagnostic& diagnostic : m_document.diagnostics()) {
            if (diagnostic.place.object.kind == section.kind)
                worst = std::max(worst, int(diagnostic.severity()));
        }
        return worst;
    }
    default: return {};
    }
}

QVariant ProjectTreeModel::objectData(const ObjectKey& key, int role) const
{
    switch (role) {
    case Qt::DisplayRole:
    case Qt::EditRole: return QString::fromStdString(key.name);
    case Qt::AccessibleTextRole: {
        const QString detail = m_details ? m_details(key).text : QString();
        return detail.isEmpty() ? QString::fromStdString(key.name) : QStringLiteral("%1, %2").arg(QString::fromStdString(key.name), detail);
    }
    case KeyRole: return QVariant::fromValue(key);
    case IsSectionRole: return false;
    case IconRole: return iconOf(key);
    case DetailRole: return m_details ? m_details(key).text : QString();
    case DetailIconRole: return m_details ? m_details(key).icon : QString();
    case ProblemRole: {
        int worst = -1;
        for (const Diagnostic& diagnostic : m_document.diagnosticsOf(key))
            worst = std::max(worst, int(diagnostic.severity()));
        return worst;
    }
    case ProblemCountRole: return int(m_document.diagnosticsOf(key).size());
    default: return {};
    }
}

QVariant ProjectTreeModel::data(const QModelIndex& index, int role) const
{
    if (!index.isValid())
        return {};
    if (index.internalId() == SectionId)
        return sectionData(m_sections[std::size_t(index.row())], role);
    return objectData(m_sections[index.internalId() - 1].keys[std::size_t(index.row())], role);
}

bool ProjectTreeModel::setData(const QModelIndex& index, const QVariant& value, int role)
{
    if (role != Qt::EditRole || !index.isValid() || index.internalId() == SectionId)
        return false;
    const auto done = renameObject(m_document, keyOf(index), value.toString().trimmed().toStdString());
    if (!done)
        emit renameRefused(done.error());
    return done.ok();
}

Qt::ItemFlags ProjectTreeModel::flags(const QModelIndex& index) const
{
    if (!index.isValid())
        return {};
    Qt::ItemFlags out = Qt::ItemIsEnabled | Qt::ItemIsSelectable;
    if (index.internalId() != SectionId)
        out |= Qt::ItemIsEditable | Qt::ItemNeverHasChildren;
    return out;
}

QModelIndex ProjectTreeModel::indexOf(const ObjectKey& key) const
{
    for (std::size_t s = 0; s < m_sections.size(); ++s) {
        if (m_sections[s].kind != key.kind)
            continue;
        if (key.kind == ObjectKind::Controller)
            return createIndex(int(s), 0, SectionId);
        const auto& keys = m_sections[s].keys;
        const auto it = std::find(keys.begin(), keys.end(), key);
        if (it != keys.end())
            return createIndex(int(it - keys.begin()), 0, quintptr(s) + 1);
    }
    return {};
}

ObjectKey ProjectTreeModel::keyOf(const QModelIndex& index)
{
    return index.data(KeyRole).value<ObjectKey>();
}

void ProjectTreeModel::setDetails(std::function<Detail(const ObjectKey&)> details)
{
    m_details = std::move(details);
    refreshDetails();
}

void ProjectTreeModel::refreshDetails()
{
    emit dataChanged(index(0, 0), index(int(m_sections.size()) - 1, 0));
    for (int s = 0; s < int(m_sections.size()); ++s) {
        const QModelIndex section = index(s, 0);
        if (const int rows = rowCount(section); rows > 0)
            emit dataChanged(index(0, 0, section), index(rows - 1, 0, section));
    }
}

void ProjectTreeModel::follow(const ProjectChange& change)
{
    for (int s = 0; s < int(m_sections.size()); ++s) {
        const ObjectKind kind = m_sections[std::size_t(s)].kind;
        if (!change.touches(kind))
            continue;
        if (change.listChanged || change.everything)
            updateSection(s);
        emit dataChanged(index(s, 0), index(s, 0));
        const QModelIndex section = index(s, 0);
        if (const int rows = rowCount(section); rows > 0)
            emit dataChanged(index(0, 0, section), index(rows - 1, 0, section));
    }
}

void ProjectTreeModel::updateSection(int row)
{
    // Rows that stay keep their indexes, so the tree keeps what is open and what is selected.
    std::vector<ObjectKey>& keys = m_sections[std::size_t(row)].keys;
    const std::vector<ObjectKey> now = keysNow(m_sections[std::size_t(row)].kind);
    const QModelIndex section = index(row, 0);
    for (int i = int(keys.size()) - 1; i >= 0; --i) {
        if (std::find(now.begin(), now.end(), keys[std::size_t(i)]) != now.end())
            continue;
        beginRemoveRows(section, i, i);
        keys.erase(keys.begin() + i);
        endRemoveRows();
    }
    for (std::size_t i = 0; i < now.size(); ++i) {
        if (i < keys.size() && keys[i] == now[i])
            continue;
        if (const auto it = std::find(keys.begin(), keys.end(), now[i]); it != keys.end()) {
            const int from = int(it - keys.begin());
            beginRemoveRows(section, from, from);
            keys.erase(it);
            endRemoveRows();
        }
        beginInsertRows(section, int(i), int(i));
        keys.insert(keys.begin() + std::ptrdiff_t(i), now[i]);
        endInsertRows();
    }
}

} // namespace camwright
