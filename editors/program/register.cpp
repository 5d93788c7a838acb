#include "editors/program/register.h"

#include "editors/program/programeditor.h"
#include "editors/program/programfixes.h"
#include "editors/program/referencespanel.h"
#include "editors/shell/actions.h"
#include "editors/shell/registry.h"

namespace camwright {

void registerProgramEditor(Registry& registry, ActionCatalogue& actions)
{
    if (!actions.action(QStringLiteral("edit.findNext"))) {
        actions.add({
            {"edit.findNext", QT_TRANSLATE_NOOP("Actions", "Find &Next"), QT_TRANSLATE_NOOP("Actions", "Goes to the next hit."), "arrow-down", "F3", Availability::Editor},
            {"edit.findPrevious", QT_TRANSLATE_NOOP("Actions", "Find Pre&vious"), QT_TRANSLATE_NOOP("Actions", "Goes to the hit before."), "arrow-up", "Shift+F3", Availability::Editor},
            {"edit.comment", QT_TRANSLATE_NOOP("Actions", "Co&mment Lines"), QT_TRANSLATE_NOOP("Actions", "Puts the selected lines into comments, or takes them out."), "", "Ctrl+/", Availability::Editor},
            {"edit.complete", QT_TRANSLATE_NOOP("Actions", "Complete &Word"), QT_TRANSLATE_NOOP("Actions", "Lists what may be typed here."), "", "Ctrl+Space", Availability::Editor},
            {"program.import", QT_TRANSLATE_NOOP("Actions", "&Import Kinco Program Text..."), QT_TRANSLATE_NOOP("Actions", "Replaces this program by the text of a KincoBuilder .ilp file."), "open", "", Availability::Editor},
        });
    }
    registry.add(EditorFactory{QStringLiteral("program"), ObjectKind::Program, ProgramEditor::tr("Program"), QStringLiteral("program"),
        [](Context& context, const ObjectKey& key) -> Editor* { return new ProgramEditor(context, key); }, false});
    registry.add(PanelFactory{QStringLiteral("references"), ReferencesPanel::tr("References"), QStringLiteral("references"), PanelArea::Bottom, 15,
        [](Context& context) -> Panel* { return new ReferencesPanel(context); }});
    registry.add(programFixProvider());
}

} // namespace camwright
