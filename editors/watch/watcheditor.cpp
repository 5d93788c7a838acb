#include "editors/watch/watcheditor.h"

#include "editors/shell/actions.h"
#include "editors/shell/context.h"
#include "editors/watch/watchview.h"

#include <QVBoxLayout>

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

void WatchEditor::reveal(const Place&)
{
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
