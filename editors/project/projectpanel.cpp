#include "editors/project/projectpanel.h"

#include "core/family/family.h"
#include "editors/document/editcommands.h"
#include "editors/project/projecttreedelegate.h"
#include "editors/shell/context.h"
#include "editors/shell/icons.h"
#include "editors/shell/registry.h"
#include "editors/shell/widgets.h"
#include "editors/words/words.h"

#include <QApplication>
#include <QContextMenuEvent>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QSortFilterProxyModel>
#include <QToolButton>
#include <QTreeView>
#include <QVBoxLayout>

#include <algorithm>

namespace camwright {

namespace {

QToolButton* headerButton(const QString& iconName, const char* objectName, const QString& name, const QString& toolTip, QWidget* parent)
{
    auto* out = new QToolButton(parent);
    out->setIcon(icon(iconName, Role::Dim));
    out->setIconSize({16, 16});
    out->setAutoRaise(true);
    describe(out, objectName, name, toolTip);
    return out;
}

QString addText(ObjectKind kind)
{
    switch (kind) {
    case ObjectKind::Axis: return ProjectPanel::tr("Add Axis");
    case ObjectKind::Network: return ProjectPanel::tr("Add Network");
    case ObjectKind::Program: return ProjectPanel::tr("Add Program");
    case ObjectKind::VariableTable: return ProjectPanel::tr("Add Variable Table");
    case ObjectKind::WatchTable: return ProjectPanel::tr("Add Watch List");
    default: return {};
    }
}

} // namespace

ProjectPanel::ProjectPanel(Context& context, QWidget* parent) : Panel(context, parent), m_model(context.document())
{
    setObjectName(QStringLiteral("projectPanel"));
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    auto* header = new QFrame(this);
    header->setProperty("surface", "plain");
    header->setFixedHeight(Theme::HeaderHeight);
    auto* row = new QHBoxLayout(header);
    row->setContentsMargins(10, 0, 6, 0);
    row->setSpacing(2);
    auto* title = new QLabel(tr("Project"), header);
    title->setProperty("tone", "heading");
    row->addWidget(title);
    row->addStretch();
    auto* filterButton = headerButton(QStringLiteral("filter"), "projectFilterButton", tr("Filter"), tr("Shows only objects whose name contains a word."), header);
    filterButton->setCheckable(true);
    auto* collapse = headerButton(QStringLiteral("collapse"), "projectCollapseButton", tr("Collapse all"), tr("Closes all sections of the tree."), header);
    row->addWidget(filterButton);
    row->addWidget(collapse);
    column->addWidget(header);
    m_search = new QLineEdit(this);
    describe(m_search, "projectFilter", tr("Filter the project"));
    m_search->setPlaceholderText(tr("Name contains"));
    m_search->hide();
    column->addWidget(m_search);

    m_filter = new QSortFilterProxyModel(this);
    m_filter->setSourceModel(&m_model);
    m_filter->setRecursiveFilteringEnabled(true);
    m_filter->setFilterCaseSensitivity(Qt::CaseInsensitive);
    m_tree = new QTreeView(this);
    describe(m_tree, "projectTree", tr("Project"), QString());
    m_tree->setToolTip({});
    m_tree->setModel(m_filter);
    m_tree->setItemDelegate(new ProjectTreeDelegate(m_tree));
    m_tree->setHeaderHidden(true);
    m_tree->setIndentation(16);
    m_tree->setUniformRowHeights(true);
    m_tree->setMouseTracking(true);
    m_tree->setAllColumnsShowFocus(true);
    m_tree->setExpandsOnDoubleClick(false);
    m_tree->setEditTriggers(QAbstractItemView::NoEditTriggers);
    m_tree->setSelectionMode(QAbstractItemView::ExtendedSelection);
    m_tree->setContextMenuPolicy(Qt::DefaultContextMenu);
    m_tree->setFrameShape(QFrame::NoFrame);
    m_tree->setStyleSheet(QStringLiteral("QTreeView { padding: 6px 0; } QTreeView::item:selected, QTreeView::item:hover { background: transparent; }"));
    m_tree->viewport()->installEventFilter(this);
    m_tree->installEventFilter(this);
    column->addWidget(m_tree, 1);

    connect(filterButton, &QToolButton::toggled, this, [this](bool on) {
        m_search->setVisible(on);
        if (on)
            m_search->setFocus();
        else
            m_search->clear();
    });
    connect(m_search, &QLineEdit::textChanged, this, [this](const QString& text) {
        m_filter->setFilterFixedString(text);
        expandAll();
    });
    connect(collapse, &QToolButton::clicked, m_tree, &QTreeView::collapseAll);
    connect(m_tree, &QTreeView::doubleClicked, this, &ProjectPanel::open);
    connect(m_tree, &QTreeView::clicked, this, [this](const QModelIndex& index) {
        if (QApplication::keyboardModifiers() == Qt::NoModifier && !index.data(ProjectTreeModel::IsSectionRole).toBool())
            this->context().preview(ProjectTreeModel::keyOf(index));
    });
    connect(m_tree->selectionModel(), &QItemSelectionModel::currentChanged, this, [this](const QModelIndex& index) {
        if (m_tree->hasFocus() && index.isValid() && !index.data(ProjectTreeModel::IsSectionRole).toBool())
            this->context().select({Place{ProjectTreeModel::keyOf(index), {}, {}, {}}, {}});
    });
    connect(&m_model, &ProjectTreeModel::renameRefused, this, [this](const Diagnostic& why) { this->context().notify(why); });
    connect(&context.document(), &ProjectDocument::changed, this, [this](const ProjectChange& change) {
        if (change.everything)
            expandAll();
    });
    m_model.setDetails([this](const ObjectKey& key) { return detail(key); });
    connect(&context, &Context::statusChanged, &m_model, &ProjectTreeModel::refreshDetails);
    connect(&context, &Context::linkChanged, &m_model, &ProjectTreeModel::refreshDetails);
    connect(&theme(), &Theme::changed, m_tree->viewport(), qOverload<>(&QWidget::update));
    expandAll();
}

void ProjectPanel::expandAll()
{
    m_tree->expandAll();
}

ProjectTreeModel::Detail ProjectPanel::detail(const ObjectKey& key) const
{
    if (!context().isOnline())
        return {};
    const ControllerStatus& status = context().status();
    if (key.kind == ObjectKind::Controller) {
        const bool runs = status.state == RunState::Run;
        return {runs ? QStringLiteral("RUN") : status.state == RunState::Stop ? QStringLiteral("STOP") : tr("ERROR"),
            runs ? QStringLiteral("triangle-right") : QStringLiteral("square")};
    }
    if (key.kind != ObjectKind::Axis)
        return {};
    for (const AxisStatus& axis : status.axes) {
        if (axis.name == key.name)
            return {QStringLiteral("%1 %2").arg(axis.position, 0, 'f', 3).arg(words::unitWord(axis.unit)),
                axis.error != 0 ? QStringLiteral("error") : axis.moving ? QStringLiteral("triangle-right") : axis.enabled ? QStringLiteral("square") : QStringLiteral("ring")};
    }
    return {};
}

ObjectKey ProjectPanel::current() const
{
    return ProjectTreeModel::keyOf(m_tree->currentIndex());
}

std::vector<ObjectKey> ProjectPanel::selectedObjects() const
{
    std::vector<ObjectKey> out;
    for (const QModelIndex& index : m_tree->selectionModel()->selectedIndexes()) {
        if (!index.data(ProjectTreeModel::IsSectionRole).toBool() && ProjectTreeModel::keyOf(index).kind != ObjectKind::Controller)
            out.push_back(ProjectTreeModel::keyOf(index));
    }
    return out;
}

void ProjectPanel::showObject(const ObjectKey& key)
{
    const QModelIndex index = m_filter->mapFromSource(m_model.indexOf(key));
    if (index.isValid() && index != m_tree->currentIndex())
        m_tree->setCurrentIndex(index);
}

void ProjectPanel::open(const QModelIndex& index)
{
    if (!index.isValid())
        return;
    if (index.data(ProjectTreeModel::IsSectionRole).toBool())
        m_tree->setExpanded(index, !m_tree->isExpanded(index));
    else
        context().open(ProjectTreeModel::keyOf(index));
}

void ProjectPanel::add(ObjectKind kind)
{
    const ObjectKey key = addObject(context().document(), newObject(context().document().project(), kind));
    showObject(key);
    context().open(key);
}

void ProjectPanel::rename()
{
    const QModelIndex index = m_tree->currentIndex();
    if (index.flags() & Qt::ItemIsEditable)
        m_tree->edit(index);
}

void ProjectPanel::remove()
{
    // No question: Ctrl+Z brings it back.
    removeObjects(context().document(), selectedObjects());
}

void ProjectPanel::duplicate()
{
    for (const ObjectKey& key : selectedObjects()) {
        if (key.kind != ObjectKind::Network)
            showObject(duplicateObject(context().document(), key));
    }
}

bool ProjectPanel::can(const QString& actionId) const
{
    if (actionId == QLatin1String("edit.delete") || actionId == QLatin1String("edit.duplicate"))
        return !selectedObjects().empty();
    return actionId == QLatin1String("edit.rename") && (m_tree->currentIndex().flags() & Qt::ItemIsEditable);
}

void ProjectPanel::perform(const QString& actionId)
{
    if (actionId == QLatin1String("edit.delete"))
        remove();
    else if (actionId == QLatin1String("edit.duplicate"))
        duplicate();
    else if (actionId == QLatin1String("edit.rename"))
        rename();
}

namespace {

/// Axes and their networks are for families that have them in this version: not for the Koyo DL205, whose axes hang on
/// MECHATROLINK.
bool isOffered(const Project& project, ObjectKind kind)
{
    const Family* family = findFamily(project.controller().family);
    const bool isAxis = kind == ObjectKind::Axis || kind == ObjectKind::Network;
    return !(isAxis && family && family->id() == "koyo");
}

} // namespace

void ProjectPanel::fillMenu(QMenu& menu, const ObjectKey& key)
{
    const bool object = !key.name.empty() || key.kind == ObjectKind::Controller;
    if (object) {
        for (const EditorFactory* view : context().registry().viewsOf(key.kind)) {
            const bool offered = !view->wantsLink || context().isOnline();
            QAction* action = menu.addAction(icon(view->iconName), tr("Open %1").arg(view->name),
                this, [this, key, id = view->viewId] { context().open(key, id); });
            action->setEnabled(offered);
        }
        menu.addSeparator();
    }
    const auto addKind = [&](ObjectKind kind) {
        if (!addText(kind).isEmpty() && isOffered(context().document().project(), kind))
            menu.addAction(icon(QStringLiteral("plus")), addText(kind), this, [this, kind] { add(kind); });
    };
    if (key.kind == ObjectKind::Controller) {
        for (const ObjectKind kind : {ObjectKind::Axis, ObjectKind::Network, ObjectKind::Program, ObjectKind::VariableTable, ObjectKind::WatchTable})
            addKind(kind);
    } else {
        addKind(key.kind);
    }
    if (!object || key.kind == ObjectKind::Controller)
        return;
    menu.addSeparator();
    menu.addAction(icon(QStringLiteral("rename")), tr("Rename") + QStringLiteral("\tF2"), this, &ProjectPanel::rename);
    if (key.kind != ObjectKind::Network)
        menu.addAction(icon(QStringLiteral("copy")), tr("Duplicate") + QStringLiteral("\tCtrl+D"), this, &ProjectPanel::duplicate);
    menu.addAction(icon(QStringLiteral("trash")), tr("Delete") + QStringLiteral("\tDel"), this, &ProjectPanel::remove);
}

bool ProjectPanel::eventFilter(QObject* watched, QEvent* event)
{
    if (event->type() == QEvent::ContextMenu && (watched == m_tree || watched == m_tree->viewport())) {
        const auto* menuEvent = static_cast<QContextMenuEvent*>(event);
        const QPoint at = m_tree->viewport()->mapFromGlobal(menuEvent->globalPos());
        const QModelIndex index = menuEvent->reason() == QContextMenuEvent::Keyboard ? m_tree->currentIndex() : m_tree->indexAt(at);
        if (!context().document().isOpen())
            return true;
        QMenu menu(this);
        menu.setObjectName(QStringLiteral("projectMenu"));
        fillMenu(menu, index.isValid() ? ProjectTreeModel::keyOf(index) : ObjectKey{ObjectKind::Controller, {}});
        if (!menu.isEmpty())
            menu.exec(menuEvent->globalPos());
        return true;
    }
    if (event->type() == QEvent::KeyPress && watched == m_tree) {
        const auto* key = static_cast<QKeyEvent*>(event);
        if (key->key() == Qt::Key_Return || key->key() == Qt::Key_Enter) {
            open(m_tree->currentIndex());
            return true;
        }
        if (key->key() == Qt::Key_F2) {
            rename();
            return true;
        }
        if (key->key() == Qt::Key_Delete) {
            remove();
            return true;
        }
        if (key->key() == Qt::Key_D && key->modifiers() == Qt::ControlModifier) {
            duplicate();
            return true;
        }
    }
    return Panel::eventFilter(watched, event);
}

void registerProject(Registry& registry, ActionCatalogue&)
{
    registry.add(PanelFactory{QStringLiteral("project"), ProjectPanel::tr("Project"), QStringLiteral("controller"), PanelArea::Left, 0,
        [](Context& context) -> Panel* { return new ProjectPanel(context); }});
}

} // namespace camwright
