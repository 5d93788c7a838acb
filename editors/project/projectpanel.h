#pragma once

#include "editors/document/projecttreemodel.h"
#include "editors/shell/actions.h"
#include "editors/shell/panel.h"
#include "editors/shell/registry.h"

class QLabel;
class QLineEdit;
class QMenu;
class QSortFilterProxyModel;
class QTreeView;

namespace camwright {

/// The project as a tree with the live state of its axes and programs. One click previews, double-click or Enter opens;
/// F2 renames, Del deletes, the context menu has the rest.
class ProjectPanel : public Panel {
    Q_OBJECT
public:
    explicit ProjectPanel(Context& context, QWidget* parent = nullptr);

    bool can(const QString& actionId) const override;
    void perform(const QString& actionId) override;
    QTreeView* tree() const { return m_tree; }
    /// Marks the object without opening it.
    void showObject(const ObjectKey& key);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    ObjectKey current() const;
    std::vector<ObjectKey> selectedObjects() const;
    void open(const QModelIndex& index);
    void fillMenu(QMenu& menu, const ObjectKey& key);
    void add(ObjectKind kind);
    void rename();
    void remove();
    void duplicate();
    void expandAll();
    ProjectTreeModel::Detail detail(const ObjectKey& key) const;

    ProjectTreeModel m_model;
    QSortFilterProxyModel* m_filter;
    QTreeView* m_tree;
    QLineEdit* m_search;
};

void registerProject(Registry& registry, ActionCatalogue& actions);

} // namespace camwright
