#include "editors/shell/explain.h"

#include "editors/shell/context.h"
#include "editors/shell/icons.h"

#include <QAbstractItemView>
#include <QKeyEvent>
#include <QMenu>

namespace camwright {

Explain::Explain(Context& context, QAbstractItemView* list, CodeOfRow codeOfRow)
    : QObject(list), m_context(context), m_list(list), m_codeOfRow(std::move(codeOfRow))
{
    list->installEventFilter(this);
    list->setContextMenuPolicy(Qt::CustomContextMenu);
    connect(list, &QWidget::customContextMenuRequested, this, &Explain::showMenu);
}

std::optional<Code> Explain::current() const
{
    const QModelIndex index = m_list->currentIndex();
    return index.isValid() ? m_codeOfRow(index.row()) : std::nullopt;
}

void Explain::explain()
{
    if (const auto code = current())
        m_context.explain(*code);
}

bool Explain::eventFilter(QObject* watched, QEvent* event)
{
    if (event->type() != QEvent::ShortcutOverride && event->type() != QEvent::KeyPress)
        return QObject::eventFilter(watched, event);
    const auto* key = static_cast<const QKeyEvent*>(event);
    const bool wanted = key->key() == Qt::Key_F1 && key->modifiers() == Qt::NoModifier;
    if (!wanted || m_context.isArmed() || !can()) // F1 of an armed panel jogs (CONTRACTS 23)
        return QObject::eventFilter(watched, event);
    event->accept(); // the window's own F1 does not see it; the key press follows
    if (event->type() == QEvent::KeyPress)
        explain();
    return true;
}

void Explain::showMenu(const QPoint& point)
{
    if (!can())
        return;
    QMenu menu(m_list);
    menu.setObjectName(QStringLiteral("messageMenu"));
    if (m_fillMenu)
        m_fillMenu(menu);
    QAction* explain = menu.addAction(icon(QStringLiteral("help")), tr("Explain This Message") + QStringLiteral("\tF1"), this, &Explain::explain);
    explain->setObjectName(QStringLiteral("explainMessage"));
    menu.exec(m_list->viewport()->mapToGlobal(point));
}

} // namespace camwright
