// Where the tabs of the editor area stand: groups, windows, dragging.
#include "app/window/dropzone.h"
#include "app/window/editorarea.h"
#include "app/window/editorwindow.h"
#include "editors/shell/actions.h"

#include <QApplication>
#include <QMenu>
#include <QScopedValueRollback>

#include <algorithm>

namespace camwright {

namespace {

constexpr int Shift = 40; // of a new window from where its tab was

} // namespace

// --- groups

QString EditorArea::emptySentence() const
{
    const QAction* find = m_context.actions().action(QStringLiteral("go.anything"));
    const QString key = find ? find->shortcut().toString(QKeySequence::NativeText) : QString();
    return key.isEmpty() ? tr("Open an object from the project tree.") : tr("Open an object from the project tree, or press %1 to find one.").arg(key);
}

EditorGroup* EditorArea::newGroup()
{
    auto* group = new EditorGroup([this](Tab& tab) { makePage(tab); }, emptySentence());
    connect(group, &EditorGroup::currentChanged, this, [this, group] {
        nameWindow(group);
        if (m_arranging || group != m_active)
            return;
        note();
        emit currentChanged();
    });
    connect(group, &EditorGroup::activated, this, [this, group] {
        activate(group);
        group->focusPage();
    });
    connect(group, &EditorGroup::closeRequested, this, [this, group](int index) { closeTab(group, index); });
    connect(group, &EditorGroup::menuRequested, this, [this, group](int index, const QPoint& global) { showMenu(group, index, global); });
    connect(group, &EditorGroup::draggedOut, this, [this](int, const QPoint& global) { dragged(global); });
    connect(group, &EditorGroup::droppedOutside, this, [this, group](int index, const QPoint& global) { dropped(group, index, global); });
    connect(group, &EditorGroup::dragEnded, this, [this] { m_mark->vanish(); });
    return group;
}

std::vector<EditorGroup*> EditorArea::groups() const
{
    std::vector<EditorGroup*> out = m_tree->groups();
    for (const EditorWindow* window : m_windows) {
        const auto more = window->tree().groups();
        out.insert(out.end(), more.begin(), more.end());
    }
    return out;
}

void EditorArea::activate(EditorGroup* group)
{
    m_active = group;
    if (m_tree->has(group))
        m_mainActive = group;
    for (EditorGroup* each : groups())
        each->setActive(each == group);
    if (!m_arranging) {
        note();
        emit currentChanged();
    }
    nameWindow(group);
}

void EditorArea::nameWindow(const EditorGroup* group)
{
    if (EditorWindow* window = windowOf(group); window && group->current())
        window->setWindowTitle(QStringLiteral("%1 - Camwright").arg(group->current()->title));
}

/// The group with the focus is the active one. The main window without the focus in a group has its last one active, so
/// that its keys never act on another window.
void EditorArea::followFocus(const QWidget* now)
{
    if (!now || m_arranging)
        return;
    EditorGroup* wanted = nullptr;
    for (EditorGroup* group : groups()) {
        if (group == now || group->isAncestorOf(now))
            wanted = group;
    }
    if (!wanted && now->window() == window() && !m_tree->has(m_active))
        wanted = m_mainActive;
    if (wanted && wanted != m_active)
        activate(wanted);
}

GroupTree* EditorArea::treeOf(const EditorGroup* group) const
{
    const EditorWindow* window = windowOf(group);
    return window ? &window->tree() : m_tree;
}

void EditorArea::dissolve(EditorGroup* group)
{
    if (group->count() > 0)
        return;
    GroupTree* tree = treeOf(group);
    const auto all = tree->groups();
    if (all.size() > 1) {
        const auto at = std::find(all.begin(), all.end(), group);
        EditorGroup* heir = at == all.begin() ? all[1] : *(at - 1);
        tree->remove(group);
        group->deleteLater();
        if (m_mainActive == group)
            m_mainActive = heir;
        if (m_active == group)
            activate(heir);
    } else if (EditorWindow* window = windowOf(group)) {
        dropWindow(window);
        if (m_active == group)
            activate(m_mainActive);
    }
    emit currentChanged();
}

void EditorArea::split(Side side)
{
    if (m_active->count() > 1) {
        moveTabBeside(m_active, m_active->currentIndex(), m_active, side);
        return;
    }
    EditorGroup* fresh = newGroup();
    treeOf(m_active)->insert(fresh, m_active, side);
    activate(fresh);
    fresh->focusPage();
}

void EditorArea::moveTab(EditorGroup* from, int index, EditorGroup* to, int at)
{
    if (from == to || index < 0 || index >= from->count())
        return;
    {
        const QScopedValueRollback<bool> quiet(m_arranging, true);
        const int arrived = to->add(from->take(index), at);
        to->setCurrent(arrived);
    }
    activate(to);
    dissolve(from);
    if (windowOf(to))
        to->window()->activateWindow();
    to->focusPage();
}

void EditorArea::moveTabBeside(EditorGroup* from, int index, EditorGroup* beside, Side side)
{
    if (from == beside && from->count() < 2)
        return;
    EditorGroup* fresh = newGroup();
    treeOf(beside)->insert(fresh, beside, side);
    moveTab(from, index, fresh);
}

bool EditorArea::canMove() const
{
    return m_active->count() > 1 || (m_active->count() == 1 && groups().size() > 1);
}

void EditorArea::moveToNextGroup()
{
    const auto all = groups();
    if (all.size() == 1)
        moveTabBeside(m_active, m_active->currentIndex(), m_active, Side::Right);
    else
        moveTab(m_active, m_active->currentIndex(), all[std::size_t(std::find(all.begin(), all.end(), m_active) - all.begin() + 1) % all.size()]);
}

void EditorArea::stepGroup(int direction)
{
    const auto all = groups();
    const auto at = int(std::find(all.begin(), all.end(), m_active) - all.begin()), size = int(all.size());
    EditorGroup* next = all[std::size_t((at + direction + size) % size)];
    if (next->window() != QApplication::activeWindow())
        next->window()->activateWindow();
    activate(next);
    next->focusPage();
}

void EditorArea::moveCurrentTab(int direction)
{
    m_active->moveCurrent(direction);
}

// --- windows

EditorWindow* EditorArea::windowOf(const EditorGroup* group) const
{
    const auto found = std::find_if(m_windows.begin(), m_windows.end(), [&](const EditorWindow* window) { return window->tree().has(group); });
    return found == m_windows.end() ? nullptr : *found;
}

EditorWindow* EditorArea::newWindow(EditorGroup* group)
{
    auto* window = new EditorWindow(group);
    m_windows.push_back(window);
    connect(window, &EditorWindow::closing, this, [this, window] { bringBack(window); });
    emit windowMade(window);
    return window;
}

void EditorArea::dropWindow(EditorWindow* window)
{
    std::erase(m_windows, window);
    window->disconnect(this);
    window->hide();
    window->deleteLater();
}

void EditorArea::bringBack(EditorWindow* window)
{
    {
        const QScopedValueRollback<bool> quiet(m_arranging, true);
        for (EditorGroup* group : window->tree().groups()) {
            for (Tab& tab : group->takeAll())
                m_mainActive->setCurrent(m_mainActive->add(std::move(tab)));
        }
    }
    dropWindow(window);
    activate(m_mainActive);
}

void EditorArea::closeWindows()
{
    while (!m_windows.empty())
        bringBack(m_windows.back());
}

void EditorArea::moveTabOut(EditorGroup* from, int index, const QRect& place)
{
    EditorGroup* fresh = newGroup();
    EditorWindow* window = newWindow(fresh);
    window->place(place);
    window->show();
    moveTab(from, index, fresh);
}

bool EditorArea::isInOwnWindow() const
{
    return windowOf(m_active) != nullptr;
}

void EditorArea::toggleOwnWindow()
{
    if (m_active->count() == 0)
        return;
    if (isInOwnWindow()) {
        moveTab(m_active, m_active->currentIndex(), m_mainActive);
        window()->activateWindow();
        m_active->focusPage();
    } else {
        const QRect here(m_active->mapToGlobal(QPoint(Shift, Shift)), m_active->size().expandedTo({640, 420}));
        moveTabOut(m_active, m_active->currentIndex(), here);
    }
}

void EditorArea::showMenu(EditorGroup* group, int index, const QPoint& global)
{
    if (index < 0)
        return;
    group->setCurrent(index);
    activate(group);
    auto* menu = new QMenu(group);
    menu->setAttribute(Qt::WA_DeleteOnClose);
    for (const char* id : {"view.closeTab", "", "view.splitRight", "view.splitDown", "view.moveTab", "view.ownWindow"}) {
        if (!*id)
            menu->addSeparator();
        else if (QAction* action = m_context.actions().action(QString::fromLatin1(id)))
            menu->addAction(action);
    }
    menu->popup(global);
}

// --- dragging

EditorArea::Target EditorArea::targetAt(const QPoint& global) const
{
    Target out;
    const auto isOver = [&](const QWidget* window) { return window->frameGeometry().contains(global); };
    QWidget* top = QApplication::topLevelAt(global); // where windows overlap; null beside the screen
    const bool ours = top && (top == window() || std::any_of(m_windows.begin(), m_windows.end(), [&](const EditorWindow* each) { return each == top; }));
    for (EditorGroup* group : groups()) {
        if ((ours && group->window() != top) || !group->isVisible() || !group->rect().contains(group->mapFromGlobal(global)))
            continue;
        out.group = group;
        out.zone = group->dropZoneAt(group->mapFromGlobal(global));
        return out;
    }
    out.outside = !isOver(window()) && std::none_of(m_windows.begin(), m_windows.end(), isOver);
    return out;
}

void EditorArea::dragged(const QPoint& global)
{
    const Target target = targetAt(global);
    if (target.group)
        m_mark->showOn(target.group, target.zone.area);
    else
        m_mark->vanish();
}

void EditorArea::dropped(EditorGroup* from, int index, const QPoint& global)
{
    const Target target = targetAt(global);
    if (target.group && target.zone.side)
        moveTabBeside(from, index, target.group, *target.zone.side);
    else if (target.group)
        moveTab(from, index, target.group, target.zone.at);
    else if (target.outside && !(windowOf(from) && from->count() == 1 && treeOf(from)->groups().size() == 1))
        moveTabOut(from, index, {global - QPoint(Shift, Shift / 2), from->size().expandedTo({640, 420})});
    else if (target.outside)
        from->window()->move(global - QPoint(Shift, Shift / 2)); // it has a window of its own already
}

} // namespace camwright
