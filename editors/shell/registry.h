#pragma once

#include "editors/shell/editor.h"
#include "editors/shell/fixes.h"
#include "editors/shell/panel.h"

#include <vector>

namespace camwright {

/// What the window is made of. Every editor's library has one `registerXxx(Registry&, ActionCatalogue&)` function that the
/// composition calls; the main window never learns their names. Registering calls `tr()` again after a change of language.
class Registry {
public:
    void add(EditorFactory factory) { m_editors.push_back(std::move(factory)); }
    void add(PanelFactory factory) { m_panels.push_back(std::move(factory)); }
    void add(FixProvider provider) { m_fixes.push_back(std::move(provider)); }
    void clear() { m_editors.clear(); m_panels.clear(); m_fixes.clear(); }

    const std::vector<EditorFactory>& editors() const { return m_editors; }
    const std::vector<PanelFactory>& panels() const { return m_panels; }
    const std::vector<FixProvider>& fixProviders() const { return m_fixes; }
    std::vector<const EditorFactory*> viewsOf(ObjectKind kind) const;
    const EditorFactory* view(const QString& viewId) const;
    const EditorFactory* defaultView(ObjectKind kind) const;
    const PanelFactory* panel(const QString& id) const;

private:
    std::vector<EditorFactory> m_editors;
    std::vector<PanelFactory> m_panels;
    std::vector<FixProvider> m_fixes;
};

} // namespace camwright
