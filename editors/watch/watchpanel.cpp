#include "editors/watch/watchpanel.h"

#include "editors/document/editcommands.h"
#include "editors/shell/actions.h"
#include "editors/shell/context.h"
#include "editors/shell/icons.h"
#include "editors/shell/widgets.h"
#include "editors/watch/watchmodel.h"
#include "editors/watch/watchview.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QStackedLayout>
#include <QToolButton>

#include <algorithm>

namespace camwright {

WatchPanel::WatchPanel(Context& context, QWidget* parent)
    : Panel(context, parent), m_view(new WatchView(context, ObjectKey{ObjectKind::WatchTable, {}}, this)), m_tools(new QWidget(this)),
      m_lists(new QComboBox(m_tools)), m_layers(new QStackedLayout(this))
{
    auto* empty = new EmptyState(QStringLiteral("watch"), tr("A watch list keeps the values you look at together."), this);
    connect(empty->addButton(tr("Make a Watch List"), true), &QPushButton::clicked, this, &WatchPanel::addList);
    m_layers->addWidget(empty);
    m_layers->addWidget(m_view);

    describe(m_lists, "watchLists", tr("Watch list"), tr("The list shown here"));
    auto* add = new QToolButton(m_tools);
    describe(add, "addWatchList", tr("New watch list"), tr("Make another watch list"));
    add->setIcon(icon(QStringLiteral("plus")));
    add->setAutoRaise(true);
    auto* row = new QHBoxLayout(m_tools);
    row->setContentsMargins(0, 0, 0, 0);
    row->addWidget(m_lists);
    row->addWidget(add);
    connect(add, &QToolButton::clicked, this, &WatchPanel::addList);
    connect(m_lists, &QComboBox::activated, this, &WatchPanel::choose);
    connect(&context.document(), &ProjectDocument::changed, this, &WatchPanel::documentChanged);
    context.actions().on(QStringLiteral("watch.force"), this, [this] {
        WatchView* const focused = WatchView::focused();
        if (!focused || focused == m_view) // a list in a tab forces its own
            m_view->forceSelected();
    });
    refreshLists();
}

QWidget* WatchPanel::tabRowWidget()
{
    return m_tools;
}

void WatchPanel::documentChanged(const ProjectChange& change)
{
    if (change.everything || (change.listChanged && change.touches(ObjectKind::WatchTable)))
        refreshLists();
}

void WatchPanel::refreshLists()
{
    const QString shown = QString::fromStdString(m_view->model().key().name);
    const int place = m_lists->currentIndex(); // where a renamed list still stands
    m_lists->clear();
    for (const ObjectPtr& list : context().document().project().objects(ObjectKind::WatchTable))
        m_lists->addItem(QString::fromStdString(list->key.name));
    const int found = m_lists->findText(shown);
    const int index = found >= 0 ? found : std::clamp(place, 0, std::max(0, m_lists->count() - 1));
    m_layers->setCurrentIndex(m_lists->count() > 0 ? 1 : 0);
    m_tools->setVisible(m_lists->count() > 0);
    if (m_lists->count() > 0)
        choose(index);
}

void WatchPanel::choose(int index)
{
    m_lists->setCurrentIndex(index);
    m_view->setKey({ObjectKind::WatchTable, m_lists->itemText(index).toStdString()});
}

void WatchPanel::addList()
{
    Object list = newObject(context().document().project(), ObjectKind::WatchTable);
    const ObjectKey key = addObject(context().document(), std::move(list));
    refreshLists();
    choose(m_lists->findText(QString::fromStdString(key.name)));
}

bool WatchPanel::can(const QString& id) const
{
    return m_view->can(id);
}

void WatchPanel::perform(const QString& id)
{
    m_view->perform(id);
}

} // namespace camwright
