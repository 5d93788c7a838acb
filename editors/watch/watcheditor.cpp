#include "editors/watch/watcheditor.h"

#include "editors/shell/actions.h"
#include "editors/shell/context.h"
#include "editors/watch/watchview.h"

#include <QTableView>
#include <QVBoxLayout>

#include <charconv>

namespace camwright {

WatchEditor::WatchEditor(Context& context, ObjectKey key, QWidget* parent)
    : Editor(context, std::move(key), parent), m_view(new WatchView(context, this->key(), this))
{
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(16, 12, 16, 12);
    layout->addWidget(m_view);
    setFocusProxy(m_view);
    connect(m_view, &WatchView::abilitiesChanged, this, &Editor::abilitiesChanged);
    context.actions().on(QStringLiteral("watch.force"), this, [this] {
        if (WatchView::focused() == m_view)
            m_view->forceSelected();
    });
}

void WatchEditor::setKey(const ObjectKey& key)
{
    Editor::setKey(key);
    m_view->setKey(key);
}

void WatchEditor::reveal(const Place& place)
{
    constexpr std::string_view Prefix = "rows[";
    int row = 0;
    const char* end = place.field.data() + place.field.size();
    if (place.field.starts_with(Prefix) && std::from_chars(place.field.data() + Prefix.size(), end, row).ec == std::errc{}) {
        m_view->table()->selectRow(row);
        m_view->table()->scrollTo(m_view->table()->currentIndex());
    }
    m_view->setFocus();
}

bool WatchEditor::can(const QString& id) const
{
    return m_view->can(id);
}

void WatchEditor::perform(const QString& id)
{
    m_view->perform(id);
}

} // namespace camwright
