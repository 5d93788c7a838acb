// Opening, closing, back and forward. Groups and windows are in editorplaces.cpp.
#include "app/window/editorarea.h"

#include "app/window/dropzone.h"
#include "app/window/editorwindow.h"
#include "editors/shell/actions.h"
#include "editors/shell/registry.h"

#include <QApplication>
#include <QVBoxLayout>

namespace camwright {

EditorArea::EditorArea(Context& context, QWidget* parent) : QWidget(parent), m_context(context), m_mark(std::make_unique<DropMark>())
{
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    m_active = m_mainActive = newGroup();
    m_tree = new GroupTree(m_active, this);
    column->addWidget(m_tree);
    connect(&context.document(), &ProjectDocument::changed, this, &EditorArea::follow);
    connect(qApp, &QApplication::focusChanged, this, [this](QWidget*, QWidget* now) { followFocus(now); });
    connect(&context.actions(), &ActionCatalogue::keysChanged, this, [this] {
        for (EditorGroup* group : groups())
            group->setEmptySentence(emptySentence());
    });
}

EditorArea::~EditorArea()
{
    // Pages lose the focus and tell of their end while they go: nobody here listens any more.
    disconnect(qApp, nullptr, this, nullptr);
    for (EditorGroup* group : groups()) {
        group->disconnect(this);
        for (const Tab& tab : group->tabs()) {
            if (tab.page)
                tab.page->disconnect(this);
        }
    }
    m_mark.reset();
    for (EditorWindow* window : m_windows)
        delete window;
}

int EditorArea::count() const
{
    int out = 0;
    for (const EditorGroup* group : groups())
        out += group->count();
    return out;
}

Editor* EditorArea::current() const
{
    return m_active->current() ? m_active->current()->editor : nullptr;
}

Panel* EditorArea::currentPanel() const
{
    return m_active->currentPanel();
}

EditorArea::Found EditorArea::find(const ObjectKey& key, const QString& viewId) const
{
    for (EditorGroup* group : groups()) {
        if (const int index = group->find(key, viewId); index >= 0)
            return {group, index};
    }
    return {};
}

/// What a tab needs to be seen in a strip; nothing where the object or the view does not exist.
std::optional<EditorArea::Tab> EditorArea::describeTab(const ObjectKey& key, const QString& viewId) const
{
    const Registry& registry = m_context.registry();
    Tab out;
    if (key == ObjectKey{}) {
        const PanelFactory* panel = registry.panel(viewId);
        if (!panel || panel->area != PanelArea::Center)
            return std::nullopt;
        out.viewId = panel->id;
        out.title = panel->name;
        out.iconName = panel->iconName;
        return out;
    }
    const EditorFactory* factory = viewId.isEmpty() ? registry.defaultView(key.kind) : registry.view(viewId);
    if (!factory || factory->kind != key.kind || !m_context.document().object(key))
        return std::nullopt;
    out.key = key;
    out.viewId = factory->viewId;
    out.iconName = factory->iconName;
    out.title = QString::fromStdString(key.name);
    if (factory != registry.defaultView(key.kind))
        out.title += QStringLiteral(" · ") + factory->name;
    return out;
}

void EditorArea::makePage(Tab& tab)
{
    if (tab.key == ObjectKey{}) {
        tab.page = m_context.registry().panel(tab.viewId)->create(m_context);
        return;
    }
    Editor* editor = m_context.registry().view(tab.viewId)->create(m_context, tab.key);
    tab.page = tab.editor = editor;
    connect(editor, &Editor::positionChanged, this, &EditorArea::positionChanged);
    connect(editor, &Editor::abilitiesChanged, this, &EditorArea::positionChanged);
    connect(editor, &Editor::closeRequested, this, [this, editor] {
        for (EditorGroup* group : groups()) {
            if (const int index = group->indexOf(editor); index >= 0) {
                closeTab(group, index);
                return;
            }
        }
    }, Qt::QueuedConnection);
}

void EditorArea::open(const ObjectKey& key, const QString& viewId, bool preview)
{
    auto tab = describeTab(key, viewId);
    if (!tab)
        return;
    Found place = find(key, tab->viewId);
    if (!place.group) {
        place.group = m_active;
        if (preview && m_active->previewTab() >= 0) {
            m_arranging = true; // its group stays, though it may be empty for a moment
            closeTab(m_active, m_active->previewTab());
            m_arranging = false;
        }
        tab->preview = preview;
        place.index = place.group->add(std::move(*tab));
    } else if (!preview) {
        place.group->keep(place.index);
    }
    show(place, !preview);
}

void EditorArea::openPanel(const PanelFactory& factory)
{
    Found place = find({}, factory.id);
    if (!place.group) {
        auto tab = describeTab({}, factory.id);
        if (!tab)
            return;
        place = {m_active, m_active->add(std::move(*tab))};
    }
    show(place, false);
}

void EditorArea::show(const Found& tab, bool withFocus)
{
    tab.group->setCurrent(tab.index);
    activate(tab.group);
    if (!withFocus)
        return;
    if (tab.group->window() != QApplication::activeWindow() && windowOf(tab.group)) {
        tab.group->window()->raise();
        tab.group->window()->activateWindow();
    }
    tab.group->focusPage();
}

void EditorArea::reveal(const Place& place)
{
    const Editor* before = current();
    open(place.object, {}, false);
    if (Editor* editor = current(); editor && editor->key() == place.object) {
        editor->reveal(place);
        if (before != editor || !m_visiting)
            note();
    }
}

bool EditorArea::closeTab(EditorGroup* group, int index)
{
    if (index < 0 || index >= group->count())
        return true;
    Editor* editor = group->tab(index).editor;
    if (editor && m_context.document().object(editor->key()) && !editor->mayClose())
        return false;
    const Tab gone = group->take(index);
    if (gone.page)
        gone.page->deleteLater();
    if (!m_arranging)
        dissolve(group);
    return true;
}

bool EditorArea::closeCurrent()
{
    if (m_active->count() > 0)
        return closeTab(m_active, m_active->currentIndex());
    dissolve(m_active);
    return true;
}

bool EditorArea::closeAll()
{
    while (count() > 0) {
        const auto all = groups();
        EditorGroup* last = *std::find_if(all.rbegin(), all.rend(), [](const EditorGroup* group) { return group->count() > 0; });
        if (!closeTab(last, last->count() - 1))
            return false;
    }
    unite(); // empty groups
    m_history.clear();
    return true;
}

void EditorArea::follow(const ProjectChange& change)
{
    if (change.everything) {
        closeAll();
        return;
    }
    if (!change.listChanged)
        return;
    for (EditorGroup* group : groups()) {
        for (int i = group->count() - 1; i >= 0; --i) {
            const ObjectKey& key = group->tab(i).key;
            if (key != ObjectKey{} && !m_context.document().object(key))
                followGone(group, i, change);
        }
    }
}

/// The object of a tab is gone, or renamed: then exactly one object of the kind went and one came.
void EditorArea::followGone(EditorGroup* group, int index, const ProjectChange& change)
{
    std::vector<ObjectKey> come;
    for (const ObjectKey& key : change.objects) {
        if (key.kind == group->tab(index).key.kind && m_context.document().object(key))
            come.push_back(key);
    }
    if (come.size() == 1 && change.objects.size() == 2)
        group->setKey(index, come.front());
    else
        closeTab(group, index);
}

// --- back and forward

void EditorArea::note()
{
    if (const Editor* editor = current(); editor && !m_visiting)
        m_history.note(editor->place());
}

void EditorArea::visit(const Place* place)
{
    if (!place)
        return;
    m_visiting = true;
    reveal(Place(*place));
    m_visiting = false;
}

void EditorArea::goBack()
{
    note(); // where the user is now, to come back to
    visit(m_history.back());
}

void EditorArea::goForward()
{
    visit(m_history.forward());
}

void EditorArea::stepTab(int direction)
{
    const int tabs = m_active->count();
    if (tabs == 0)
        return;
    m_active->setCurrent((m_active->currentIndex() + direction + tabs) % tabs);
    m_active->focusPage();
}

} // namespace camwright
