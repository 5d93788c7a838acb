#include "editors/shell/editor.h"

#include "editors/shell/panel.h"

namespace camwright {

Editor::Editor(Context& context, ObjectKey key, QWidget* parent) : QWidget(parent), m_context(context), m_key(std::move(key)) {}

QString Editor::title() const
{
    return QString::fromStdString(m_key.name);
}

Panel::Panel(Context& context, QWidget* parent) : QWidget(parent), m_context(context) {}

} // namespace camwright
