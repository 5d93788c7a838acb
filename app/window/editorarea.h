#pragma once

#include "app/window/arrangement.h"
#include "app/window/editorgroup.h"
#include "app/window/grouptree.h"
#include "app/window/placehistory.h"
#include "editors/shell/context.h"
#include "editors/shell/editor.h"
#include "editors/shell/panel.h"

#include <QWidget>

#include <memory>

namespace camwright {

class DropMark;
class EditorWindow;

/// The editors of the window in tabs: one per object and view, a preview tab that the next preview replaces, panels that
/// live in the middle, and the way back and forward. The tabs stand in groups beside and below one another and in windows
/// of their own; exactly one group is active: it has, or had last, the focus. Opening and closing is in editorarea.cpp,
/// moving in editorplaces.cpp.
class EditorArea : public QWidget {
    Q_OBJECT
public:
    explicit EditorArea(Context& context, QWidget* parent = nullptr);
    ~EditorArea() override;

    /// Shows the tab where it is; a new one opens in the active group.
    void open(const ObjectKey& key, const QString& viewId, bool preview);
    void reveal(const Place& place);
    void openPanel(const PanelFactory& factory);
    Editor* current() const;
    Panel* currentPanel() const;
    int count() const;                     ///< tabs everywhere
    bool closeCurrent();                   ///< the tab, or the empty group; false: the editor wants to stay
    bool closeAll();
    void goBack();
    void goForward();

    // --- groups and windows
    std::vector<EditorGroup*> groups() const;      ///< of this window in reading order, then of the others
    EditorGroup& activeGroup() const { return *m_active; }
    /// The current tab goes into a new group at a side; a lone tab stays and the new group is empty.
    void split(Side side);
    /// To the next group, windows included; beside its own where there is no other.
    void moveToNextGroup();
    void stepTab(int direction);
    void stepGroup(int direction);
    void moveCurrentTab(int direction);    ///< along its strip
    void toggleOwnWindow();                ///< the current tab into a window of its own, or back
    bool isInOwnWindow() const;
    bool canMove() const;                  ///< there is a tab, and somewhere to go
    void unite();                          ///< all tabs into one group of the main window
    void closeWindows();                   ///< their tabs come back

    Arrangement arrangement() const;
    enum class Missing { LeaveClosed, Open };
    /// Puts the tabs where `wanted` has them; those it does not name stay in the first group. Tabs that are not open are
    /// opened or left out; their pages are made when they are first looked at.
    void arrange(const Arrangement& wanted, Missing missing);

signals:
    void currentChanged();                 ///< also when groups came or went
    void positionChanged();
    void windowMade(camwright::EditorWindow* window);

private:
    using Tab = EditorGroup::Tab;
    struct Found {
        EditorGroup* group = nullptr;
        int index = -1;
    };

    // opening and closing
    Found find(const ObjectKey& key, const QString& viewId) const;
    std::optional<Tab> describeTab(const ObjectKey& key, const QString& viewId) const;
    void makePage(Tab& tab);
    void show(const Found& tab, bool withFocus);
    bool closeTab(EditorGroup* group, int index);
    void followGone(EditorGroup* group, int index, const ProjectChange& change);
    void follow(const ProjectChange& change);
    void note();
    void visit(const Place* place);

    // groups
    EditorGroup* newGroup();
    void activate(EditorGroup* group);
    void followFocus(const QWidget* now);
    GroupTree* treeOf(const EditorGroup* group) const;
    EditorWindow* windowOf(const EditorGroup* group) const;
    EditorWindow* newWindow(EditorGroup* group);
    void dropWindow(EditorWindow* window);
    void nameWindow(const EditorGroup* group);
    void dissolve(EditorGroup* group);     ///< if it is empty and not the last of the main window
    void bringBack(EditorWindow* window);
    void moveTab(EditorGroup* from, int index, EditorGroup* to, int at = -1);
    void moveTabBeside(EditorGroup* from, int index, EditorGroup* beside, Side side);
    void moveTabOut(EditorGroup* from, int index, const QRect& place);
    void showMenu(EditorGroup* group, int index, const QPoint& global);
    QString emptySentence() const;

    // dragging
    struct Target {
        EditorGroup* group = nullptr;
        DropZone zone;
        bool outside = false;              ///< of every window of ours
    };
    Target targetAt(const QPoint& global) const;
    void dragged(const QPoint& global);
    void dropped(EditorGroup* from, int index, const QPoint& global);

    // arranging
    std::vector<Tab> takeAllTabs();
    EditorGroup* fillGroup(const Arrangement::Node& leaf, std::vector<Tab>& pool);

    Context& m_context;
    GroupTree* m_tree = nullptr;
    std::vector<EditorWindow*> m_windows;
    EditorGroup* m_active = nullptr;
    EditorGroup* m_mainActive = nullptr;   ///< of the main window, to come back to
    std::unique_ptr<DropMark> m_mark;
    PlaceHistory m_history;
    bool m_visiting = false;
    bool m_arranging = false;
};

} // namespace camwright
