// How the editors stand, as a value: taken, kept by the window, and put back.
#include "app/window/editorarea.h"
#include "app/window/editorwindow.h"

#include <QScopedValueRollback>

#include <algorithm>

namespace camwright {

namespace {

/// Node without the tabs nobody wants, and without what is empty then.
std::optional<Arrangement::Node> pruned(const Arrangement::Node& node, const std::function<bool(const Arrangement::Tab&)>& wanted)
{
    Arrangement::Node out;
    if (node.parts.empty()) {
        for (std::size_t i = 0; i < node.tabs.size(); ++i) {
            if (int(i) == node.current)
                out.current = int(out.tabs.size());
            if (wanted(node.tabs[i]))
                out.tabs.push_back(node.tabs[i]);
        }
        out.current = std::clamp(out.current, 0, std::max(0, int(out.tabs.size()) - 1));
        return out.tabs.empty() ? std::nullopt : std::optional(out);
    }
    out.horizontal = node.horizontal;
    for (std::size_t i = 0; i < node.parts.size(); ++i) {
        if (auto part = pruned(node.parts[i], wanted)) {
            out.parts.push_back(std::move(*part));
            out.sizes.append(node.sizes[qsizetype(i)]);
        }
    }
    if (out.parts.size() == 1)
        return std::move(out.parts.front());
    return out.parts.empty() ? std::nullopt : std::optional(out);
}

} // namespace

Arrangement EditorArea::arrangement() const
{
    Arrangement out;
    out.main = m_tree->arrangement();
    for (const EditorWindow* window : m_windows)
        out.windows.push_back({window->saveGeometry(), window->tree().arrangement()});
    return out;
}

std::vector<EditorArea::Tab> EditorArea::takeAllTabs()
{
    std::vector<Tab> out;
    for (EditorGroup* group : groups()) {
        for (Tab& tab : group->takeAll())
            out.push_back(std::move(tab));
    }
    return out;
}

EditorGroup* EditorArea::fillGroup(const Arrangement::Node& leaf, std::vector<Tab>& pool)
{
    EditorGroup* group = newGroup();
    std::vector<Tab> tabs;
    for (const Arrangement::Tab& wanted : leaf.tabs) {
        const auto open = std::find_if(pool.begin(), pool.end(), [&](const Tab& tab) { return tab.key == wanted.key && tab.viewId == wanted.viewId; });
        if (open != pool.end()) {
            tabs.push_back(std::move(*open));
            pool.erase(open);
        } else if (auto fresh = describeTab(wanted.key, wanted.viewId)) {
            fresh->preview = wanted.preview;
            tabs.push_back(std::move(*fresh));
        }
    }
    group->setTabs(std::move(tabs), leaf.current);
    return group;
}

void EditorArea::arrange(const Arrangement& wanted, Missing missing)
{
    const auto here = [&](const Arrangement::Tab& tab) {
        return missing == Missing::Open ? describeTab(tab.key, tab.viewId).has_value() : find(tab.key, tab.viewId).group != nullptr;
    };
    const auto current = m_active->current() ? std::optional(std::pair(m_active->current()->key, m_active->current()->viewId)) : std::nullopt;
    auto main = pruned(wanted.main, here);
    {
        const QScopedValueRollback<bool> quiet(m_arranging, true);
        std::vector<Arrangement::Window> windows;
        for (const Arrangement::Window& window : wanted.windows) {
            if (auto root = pruned(window.root, here))
                windows.push_back({window.geometry, std::move(*root)});
        }
        std::vector<Tab> pool = takeAllTabs();
        const auto make = [&](const Arrangement::Node& leaf) { return fillGroup(leaf, pool); };
        const auto former = m_tree->groups();
        while (!m_windows.empty())
            dropWindow(m_windows.back());
        m_tree->rebuild(main.value_or(Arrangement::Node()), make);
        for (EditorGroup* group : former)
            group->deleteLater();
        m_active = m_mainActive = m_tree->groups().front();
        for (const Arrangement::Window& window : windows) {
            EditorWindow* made = newWindow(newGroup());
            const auto placeholder = made->tree().groups();
            made->tree().rebuild(window.root, make);
            for (EditorGroup* group : placeholder)
                group->deleteLater();
            made->restoreGeometry(window.geometry);
            made->place(made->geometry());
            nameWindow(made->tree().groups().front());
            made->setAttribute(Qt::WA_ShowWithoutActivating);
            made->show();
        }
        for (Tab& tab : pool)
            m_mainActive->add(std::move(tab));
    }
    const Found again = current ? find(current->first, current->second) : Found();
    if (again.group)
        again.group->setCurrent(again.index);
    activate(again.group ? again.group : m_mainActive);
}

void EditorArea::unite()
{
    Arrangement one;
    for (const EditorGroup* group : groups()) {
        const auto tabs = group->arrangement().tabs;
        one.main.tabs.insert(one.main.tabs.end(), tabs.begin(), tabs.end());
    }
    if (groups().size() > 1)
        arrange(one, Missing::LeaveClosed);
}

} // namespace camwright
