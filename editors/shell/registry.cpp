#include "editors/shell/registry.h"

#include <algorithm>

namespace camwright {

std::vector<const EditorFactory*> Registry::viewsOf(ObjectKind kind) const
{
    std::vector<const EditorFactory*> out;
    for (const EditorFactory& factory : m_editors) {
        if (factory.kind == kind)
            out.push_back(&factory);
    }
    return out;
}

const EditorFactory* Registry::view(const QString& viewId) const
{
    const auto it = std::find_if(m_editors.begin(), m_editors.end(), [&](const EditorFactory& f) { return f.viewId == viewId; });
    return it == m_editors.end() ? nullptr : &*it;
}

const EditorFactory* Registry::defaultView(ObjectKind kind) const
{
    const auto views = viewsOf(kind);
    return views.empty() ? nullptr : views.front();
}

const PanelFactory* Registry::panel(const QString& id) const
{
    const auto it = std::find_if(m_panels.begin(), m_panels.end(), [&](const PanelFactory& f) { return f.id == id; });
    return it == m_panels.end() ? nullptr : &*it;
}

} // namespace camwright
