#pragma once

#include "core/model/project.h"
#include "editors/document/projectdocument.h"
#include "editors/shell/actions.h"
#include "editors/shell/context.h"
#include "editors/shell/registry.h"
#include "editors/shell/theme.h"
#include "tests/editors/valuelink.h"

#include <QStringList>
#include <QThreadPool>
#include <QUndoStack>
#include <QWidget>

namespace camwright {

using Said = std::vector<std::string>;

/// A window's worth of surroundings for one view, on a link that the test speaks for.
struct EditorBench {
    ValueLink link;
    ProjectDocument document;
    ActionCatalogue actions;
    Registry registry;
    QThreadPool pool;
    Context context{document, actions, registry, pool};
    QStringList notices; ///< what the user was told

    explicit EditorBench(Project project)
    {
        document.adopt(std::move(project));
        QObject::connect(&context, &Context::notified, &context, [this](Severity, const QString& sentence) { notices << sentence; });
        link.m_can.terminals = link.m_can.trace = link.m_can.write = link.m_can.force = true;
    }
    void goOnline(bool programMatches = true)
    {
        context.setLink(&link);
        context.setProgramMatches(programMatches);
        link.deliver();
    }
    /// What was ordered, without the asking for control.
    Said orders()
    {
        Said out = link.take();
        std::erase(out, "takeControl");
        return out;
    }
};

/// Undo gives the project of before to the byte, redo that of after, twice.
inline bool undoesAndRedoes(ProjectDocument& document, const Project& before)
{
    const Project after = document.project();
    for (int round = 0; round < 2; ++round) {
        document.undo();
        if (!(document.project() == before))
            return false;
        document.redo();
        if (!(document.project() == after))
            return false;
    }
    return !(before == after);
}

template <class W>
W* part(QWidget& parent, const char* name)
{
    W* found = parent.findChild<W*>(QString::fromLatin1(name));
    if (!found)
        qFatal("no widget %s", name);
    return found;
}

} // namespace camwright
