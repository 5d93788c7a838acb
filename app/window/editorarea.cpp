#include "app/window/editorarea.h"

#include "app/window/editortabbar.h"
#include "editors/shell/registry.h"
#include "editors/shell/theme.h"
#include "editors/shell/widgets.h"

#include <QHBoxLayout>
#include <QStackedWidget>
#include <QVBoxLayout>

#include <algorithm>

namespace camwright {

namespace {

constexpr std::size_t MaxHistory = 100;

} // namespace

EditorArea::EditorArea(Context& context, QWidget* parent) : QWidget(parent), m_context(context)
{
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    auto* strip = new QWidget(this);
    strip->setFixedHeight(32);
    strip->setAttribute(Qt::WA_StyledBackground);
    strip->setObjectName(QStringLiteral("editorTabRow"));
    m_row = new QHBoxLayout(strip);
    m_row->setContentsMargins(0, 0, 8, 0);
    m_row->setSpacing(8);
    m_bar = new EditorTabBar(strip);
    m_row->addWidget(m_bar, 1);
    column->addWidget(strip);
    m_pages = new QStackedWidget(this);
    const auto ground = [this] {
        // Pages in scroll areas fill themselves with the window colour: here that is the surface.
        QPalette pages = theme().palette();
        pages.setColor(QPalette::Window, theme().color(Role::Surface));
        m_pages->setPalette(pages);
        m_pages->setAutoFillBackground(true);
    };
    ground();
    connect(&theme(), &Theme::changed, m_pages, ground);
    auto* empty = new EmptyState(QStringLiteral("programs"), tr("Open an object from the project tree, or press Ctrl+P to find one."));
    m_pages->addWidget(empty);
    column->addWidget(m_pages, 1);
    connect(m_bar, &QTabBar::currentChanged, this, &EditorArea::becameCurrent);
    connect(m_bar, &QTabBar::tabCloseRequested, this, &EditorArea::closeTab);
    connect(m_bar, &QTabBar::tabBarDoubleClicked, this, &EditorArea::keep);
    connect(m_bar, &QTabBar::tabMoved, this, [this](int from, int to) {
        const Tab tab = m_tabs[std::size_t(from)];
        m_tabs.erase(m_tabs.begin() + from);
        m_tabs.insert(m_tabs.begin() + to, tab);
    });
    connect(&context.document(), &ProjectDocument::changed, this, &EditorArea::follow);
    connect(&theme(), &Theme::changed, m_bar, qOverload<>(&QWidget::update));
}

int EditorArea::count() const
{
    return int(m_tabs.size());
}

int EditorArea::find(const ObjectKey& key, const QString& viewId) const
{
    for (std::size_t i = 0; i < m_tabs.size(); ++i) {
        if (m_tabs[i].viewId == viewId && (!m_tabs[i].editor || m_tabs[i].editor->key() == key))
            return int(i);
    }
    return -1;
}

int EditorArea::add(Tab tab, const QString& title, const QString& iconName)
{
    m_pages->addWidget(tab.page);
    m_tabs.push_back(tab);
    const int index = m_bar->addTab(title);
    m_bar->setTabIconName(index, iconName);
    m_bar->setPreview(index, tab.preview);
    return index;
}

void EditorArea::open(const ObjectKey& key, const QString& viewId, bool preview)
{
    const EditorFactory* factory = viewId.isEmpty() ? m_context.registry().defaultView(key.kind) : m_context.registry().view(viewId);
    if (!factory || !m_context.document().object(key))
        return;
    int index = find(key, factory->viewId);
    if (index >= 0) {
        if (!preview)
            keep(index);
        m_bar->setCurrentIndex(index);
        if (!preview && m_tabs[std::size_t(index)].page)
            m_tabs[std::size_t(index)].page->setFocus();
        return;
    }
    if (preview) {
        const auto old = std::find_if(m_tabs.begin(), m_tabs.end(), [](const Tab& tab) { return tab.preview; });
        if (old != m_tabs.end())
            closeTab(int(old - m_tabs.begin()));
    }
    Editor* editor = factory->create(m_context, key);
    index = add({editor, editor, factory->viewId, preview}, editor->title(), editor->iconName());
    connect(editor, &Editor::titleChanged, this, [this, editor] {
        for (std::size_t i = 0; i < m_tabs.size(); ++i) {
            if (m_tabs[i].editor == editor) {
                m_bar->setTabText(int(i), editor->title());
                m_bar->setTabIconName(int(i), editor->iconName());
            }
        }
    });
    connect(editor, &Editor::positionChanged, this, &EditorArea::positionChanged);
    connect(editor, &Editor::abilitiesChanged, this, &EditorArea::positionChanged);
    m_bar->setCurrentIndex(index);
    becameCurrent();
    if (!preview)
        editor->setFocus();
}

void EditorArea::openPanel(const PanelFactory& factory)
{
    int index = find({}, factory.id);
    if (index < 0) {
        Panel* panel = factory.create(m_context);
        index = add({panel, nullptr, factory.id, false}, factory.name, factory.iconName);
    }
    m_bar->setCurrentIndex(index);
    becameCurrent();
}

void EditorArea::reveal(const Place& place)
{
    const int before = m_bar->currentIndex();
    open(place.object, {}, false);
    if (Editor* editor = current(); editor && editor->key() == place.object) {
        editor->reveal(place);
        if (before != m_bar->currentIndex() || !m_visiting)
            note();
    }
}

Editor* EditorArea::current() const
{
    const int index = m_bar->currentIndex();
    return index < 0 || index >= int(m_tabs.size()) ? nullptr : m_tabs[std::size_t(index)].editor;
}

Panel* EditorArea::currentPanel() const
{
    const int index = m_bar->currentIndex();
    return index < 0 || index >= int(m_tabs.size()) ? nullptr : qobject_cast<Panel*>(m_tabs[std::size_t(index)].page);
}

void EditorArea::keep(int index)
{
    if (index < 0 || index >= int(m_tabs.size()))
        return;
    m_tabs[std::size_t(index)].preview = false;
    m_bar->setPreview(index, false);
}

void EditorArea::becameCurrent()
{
    const int index = m_bar->currentIndex();
    if (m_rowWidget) {
        m_row->removeWidget(m_rowWidget);
        m_rowWidget->hide();
        m_rowWidget = nullptr;
    }
    if (index < 0 || index >= int(m_tabs.size())) {
        m_pages->setCurrentIndex(0);
        emit currentChanged();
        return;
    }
    const Tab& tab = m_tabs[std::size_t(index)];
    m_pages->setCurrentWidget(tab.page);
    m_rowWidget = tab.editor ? tab.editor->tabRowWidget() : currentPanel() ? currentPanel()->tabRowWidget() : nullptr;
    if (m_rowWidget) {
        m_row->addWidget(m_rowWidget);
        m_rowWidget->show();
    }
    note();
    emit currentChanged();
}

bool EditorArea::closeTab(int index)
{
    if (index < 0 || index >= int(m_tabs.size()))
        return true;
    const Tab tab = m_tabs[std::size_t(index)];
    if (tab.editor && m_context.document().object(tab.editor->key()) && !tab.editor->mayClose())
        return false;
    if (m_rowWidget && index == m_bar->currentIndex()) {
        // It belongs to the editor, which takes it along.
        m_row->removeWidget(m_rowWidget);
        m_rowWidget->setParent(tab.page);
        m_rowWidget = nullptr;
    }
    m_tabs.erase(m_tabs.begin() + index);
    m_pages->removeWidget(tab.page);
    m_bar->removeTab(index);
    tab.page->deleteLater();
    becameCurrent();
    return true;
}

bool EditorArea::closeCurrent()
{
    return closeTab(m_bar->currentIndex());
}

bool EditorArea::closeAll()
{
    while (!m_tabs.empty()) {
        if (!closeTab(int(m_tabs.size()) - 1))
            return false;
    }
    m_history.clear();
    m_historyAt = 0;
    return true;
}

void EditorArea::step(int direction)
{
    if (!m_tabs.empty())
        m_bar->setCurrentIndex((m_bar->currentIndex() + direction + count()) % count());
}

std::vector<EditorArea::Open> EditorArea::opened() const
{
    std::vector<Open> out;
    for (const Tab& tab : m_tabs)
        out.push_back({tab.editor ? tab.editor->key() : ObjectKey{}, tab.viewId});
    return out;
}

void EditorArea::follow(const ProjectChange& change)
{
    if (change.everything) {
        closeAll();
        return;
    }
    if (!change.listChanged)
        return;
    for (int i = int(m_tabs.size()) - 1; i >= 0; --i) {
        Editor* editor = m_tabs[std::size_t(i)].editor;
        if (!editor || m_context.document().object(editor->key()))
            continue;
        // Gone, or renamed: exactly one object of the kind went and one came.
        std::vector<ObjectKey> come;
        for (const ObjectKey& key : change.objects) {
            if (key.kind == editor->key().kind && m_context.document().object(key))
                come.push_back(key);
        }
        const bool renamed = come.size() == 1 && change.objects.size() == 2;
        if (renamed) {
            editor->setKey(come.front());
            m_bar->setTabText(i, editor->title());
        } else {
            closeTab(i);
        }
    }
}

void EditorArea::note()
{
    const Editor* editor = current();
    if (!editor || m_visiting)
        return;
    const Place place = editor->place();
    if (!m_history.empty() && m_history[m_historyAt].object == place.object && m_history[m_historyAt].field == place.field
        && m_history[m_historyAt].range.line == place.range.line)
        return;
    if (!m_history.empty())
        m_history.resize(m_historyAt + 1);
    m_history.push_back(place);
    if (m_history.size() > MaxHistory)
        m_history.erase(m_history.begin());
    m_historyAt = m_history.size() - 1;
}

void EditorArea::visit(const Place& place)
{
    m_visiting = true;
    reveal(place);
    m_visiting = false;
}

void EditorArea::goBack()
{
    note(); // where the user is now, to come back to
    if (m_historyAt > 0)
        visit(m_history[--m_historyAt]);
}

void EditorArea::goForward()
{
    if (m_historyAt + 1 < m_history.size())
        visit(m_history[++m_historyAt]);
}

} // namespace camwright
