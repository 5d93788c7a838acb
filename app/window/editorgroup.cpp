#include "app/window/editorgroup.h"

#include "app/window/editortabbar.h"
#include "editors/shell/editor.h"
#include "editors/shell/panel.h"
#include "editors/shell/widgets.h"

#include <QHBoxLayout>
#include <QMouseEvent>
#include <QScopedValueRollback>
#include <QStackedWidget>
#include <QVBoxLayout>

#include <algorithm>

namespace camwright {

namespace {

constexpr int StripHeight = 32;

} // namespace

EditorGroup::EditorGroup(Maker maker, const QString& emptySentence, QWidget* parent)
    : QWidget(parent), m_maker(std::move(maker)), m_pages(new QStackedWidget(this)), m_empty(new EmptyState(QStringLiteral("programs"), emptySentence))
{
    setObjectName(QStringLiteral("editorGroup"));
    setFocusPolicy(Qt::ClickFocus);
    setMinimumSize(160, 90);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addWidget(makeStrip());
    m_pages->addWidget(m_empty);
    column->addWidget(m_pages, 1);
    paintGround();
    connect(&theme(), &Theme::changed, this, &EditorGroup::paintGround);
}

QWidget* EditorGroup::makeStrip()
{
    auto* strip = new QWidget(this);
    strip->setFixedHeight(StripHeight);
    strip->setAttribute(Qt::WA_StyledBackground);
    strip->setObjectName(QStringLiteral("editorTabRow"));
    m_row = new QHBoxLayout(strip);
    m_row->setContentsMargins(0, 0, 8, 0);
    m_row->setSpacing(8);
    m_bar = new EditorTabBar(strip);
    m_bar->setContextMenuPolicy(Qt::CustomContextMenu);
    m_row->addWidget(m_bar, 1);
    connect(m_bar, &QTabBar::currentChanged, this, [this] {
        if (!m_changing)
            becameCurrent();
    });
    connect(m_bar, &QTabBar::tabBarClicked, this, &EditorGroup::activated);
    connect(m_bar, &QTabBar::tabCloseRequested, this, &EditorGroup::closeRequested);
    connect(m_bar, &QTabBar::tabBarDoubleClicked, this, &EditorGroup::keep);
    connect(m_bar, &QTabBar::tabMoved, this, [this](int from, int to) {
        Tab tab = std::move(m_tabs[std::size_t(from)]);
        m_tabs.erase(m_tabs.begin() + from);
        m_tabs.insert(m_tabs.begin() + to, std::move(tab));
    });
    connect(m_bar, &QWidget::customContextMenuRequested, this, [this](const QPoint& position) {
        emit menuRequested(m_bar->tabAt(position), m_bar->mapToGlobal(position));
    });
    connect(m_bar, &EditorTabBar::draggedOut, this, &EditorGroup::draggedOut);
    connect(m_bar, &EditorTabBar::droppedOutside, this, &EditorGroup::droppedOutside);
    connect(m_bar, &EditorTabBar::dragEnded, this, &EditorGroup::dragEnded);
    connect(&theme(), &Theme::changed, m_bar, qOverload<>(&QWidget::update));
    return strip;
}

/// Pages in scroll areas fill themselves with the window colour: here that is the surface.
void EditorGroup::paintGround()
{
    QPalette pages = theme().palette();
    pages.setColor(QPalette::Window, theme().color(Role::Surface));
    m_pages->setPalette(pages);
    m_pages->setAutoFillBackground(true);
}

// --- what is here

int EditorGroup::find(const ObjectKey& key, const QString& viewId) const
{
    const auto found = std::find_if(m_tabs.begin(), m_tabs.end(), [&](const Tab& tab) { return tab.viewId == viewId && tab.key == key; });
    return found == m_tabs.end() ? -1 : int(found - m_tabs.begin());
}

int EditorGroup::indexOf(const Editor* editor) const
{
    const auto found = std::find_if(m_tabs.begin(), m_tabs.end(), [&](const Tab& tab) { return tab.editor == editor; });
    return found == m_tabs.end() ? -1 : int(found - m_tabs.begin());
}

int EditorGroup::previewTab() const
{
    const auto found = std::find_if(m_tabs.begin(), m_tabs.end(), [](const Tab& tab) { return tab.preview; });
    return found == m_tabs.end() ? -1 : int(found - m_tabs.begin());
}

int EditorGroup::currentIndex() const
{
    const int index = m_bar->currentIndex();
    return index < count() ? index : -1;
}

const EditorGroup::Tab* EditorGroup::current() const
{
    const int index = currentIndex();
    return index < 0 ? nullptr : &tab(index);
}

Panel* EditorGroup::currentPanel() const
{
    return current() ? qobject_cast<Panel*>(current()->page) : nullptr;
}

Arrangement::Node EditorGroup::arrangement() const
{
    Arrangement::Node out;
    for (const Tab& tab : m_tabs)
        out.tabs.push_back({tab.key, tab.viewId, tab.preview});
    out.current = std::max(0, currentIndex());
    return out;
}

// --- tabs come and go

void EditorGroup::insert(int index, Tab tab)
{
    const QScopedValueRollback<bool> quiet(m_changing, true);
    if (tab.page)
        m_pages->addWidget(tab.page);
    if (tab.editor)
        connect(tab.editor, &Editor::titleChanged, this, [this, editor = tab.editor] { refreshTitle(editor); });
    m_bar->insertTab(index, tab.title);
    m_bar->setTabIconName(index, tab.iconName);
    m_bar->setPreview(index, tab.preview);
    m_tabs.insert(m_tabs.begin() + index, std::move(tab));
}

EditorGroup::Tab EditorGroup::remove(int index)
{
    const QScopedValueRollback<bool> quiet(m_changing, true);
    if (index == currentIndex())
        takeRowWidget();
    Tab out = std::move(m_tabs[std::size_t(index)]);
    m_tabs.erase(m_tabs.begin() + index);
    if (out.page) {
        out.page->hide();
        m_pages->removeWidget(out.page);
        out.page->setParent(nullptr);
    }
    if (out.editor)
        disconnect(out.editor, nullptr, this, nullptr);
    m_bar->removeTab(index);
    return out;
}

int EditorGroup::add(Tab tab, int at)
{
    const int index = at < 0 || at > count() ? count() : at;
    insert(index, std::move(tab));
    if (count() == 1)
        becameCurrent();
    return index;
}

EditorGroup::Tab EditorGroup::take(int index)
{
    Tab out = remove(index);
    becameCurrent();
    return out;
}

void EditorGroup::setTabs(std::vector<Tab> tabs, int current)
{
    for (Tab& tab : tabs)
        insert(count(), std::move(tab));
    {
        const QScopedValueRollback<bool> quiet(m_changing, true);
        m_bar->setCurrentIndex(current);
    }
    becameCurrent();
}

std::vector<EditorGroup::Tab> EditorGroup::takeAll()
{
    std::vector<Tab> out;
    while (count() > 0)
        out.push_back(remove(0));
    becameCurrent();
    return out;
}

void EditorGroup::setCurrent(int index)
{
    if (index >= 0 && index < count())
        m_bar->setCurrentIndex(index);
}

void EditorGroup::moveCurrent(int direction)
{
    const int from = currentIndex(), to = from + direction;
    if (from >= 0 && to >= 0 && to < count())
        m_bar->moveTab(from, to);
}

void EditorGroup::keep(int index)
{
    if (index < 0 || index >= count())
        return;
    m_tabs[std::size_t(index)].preview = false;
    m_bar->setPreview(index, false);
}

void EditorGroup::setKey(int index, const ObjectKey& key)
{
    Tab& tab = m_tabs[std::size_t(index)];
    tab.key = key;
    if (tab.editor)
        tab.editor->setKey(key);
    tab.title = tab.editor ? tab.editor->title() : QString::fromStdString(key.name);
    m_bar->setTabText(index, tab.title);
}

void EditorGroup::refreshTitle(const Editor* editor)
{
    const int index = indexOf(editor);
    if (index < 0)
        return;
    Tab& tab = m_tabs[std::size_t(index)];
    tab.title = editor->title();
    tab.iconName = editor->iconName();
    m_bar->setTabText(index, tab.title);
    m_bar->setTabIconName(index, tab.iconName);
}

// --- what is shown

/// The editor's part of the strip goes back to its page, and along with it wherever that goes.
void EditorGroup::takeRowWidget()
{
    if (!m_rowWidget)
        return;
    m_row->removeWidget(m_rowWidget);
    m_rowWidget->hide();
    m_rowWidget->setParent(m_rowOwner);
    m_rowWidget = m_rowOwner = nullptr;
}

void EditorGroup::becameCurrent()
{
    takeRowWidget();
    const int index = currentIndex();
    if (index < 0) {
        m_pages->setCurrentWidget(m_empty);
        emit currentChanged();
        return;
    }
    Tab& tab = m_tabs[std::size_t(index)];
    if (!tab.page) {
        m_maker(tab);
        m_pages->addWidget(tab.page);
        if (tab.editor) {
            connect(tab.editor, &Editor::titleChanged, this, [this, editor = tab.editor] { refreshTitle(editor); });
            refreshTitle(tab.editor);
        }
    }
    m_pages->setCurrentWidget(tab.page);
    m_rowWidget = tab.editor ? tab.editor->tabRowWidget() : currentPanel() ? currentPanel()->tabRowWidget() : nullptr;
    if (m_rowWidget) {
        m_rowOwner = tab.page;
        m_row->addWidget(m_rowWidget);
        m_rowWidget->show();
    }
    emit currentChanged();
}

void EditorGroup::setEmptySentence(const QString& sentence)
{
    m_empty->setSentence(sentence);
}

void EditorGroup::setActive(bool active)
{
    m_bar->setActive(active);
}

void EditorGroup::focusPage()
{
    if (current() && current()->page)
        current()->page->setFocus();
    else
        setFocus();
}

void EditorGroup::mousePressEvent(QMouseEvent* event)
{
    emit activated();
    QWidget::mousePressEvent(event);
}

DropZone EditorGroup::dropZoneAt(const QPoint& position) const
{
    if (position.y() < StripHeight)
        return {std::nullopt, m_bar->insertionAt(m_bar->mapFrom(this, position).x()), QRect(0, 0, width(), StripHeight)};
    return dropZoneOfPage(rect().adjusted(0, StripHeight, 0, 0), position);
}

} // namespace camwright
