#pragma once

#include "editors/document/projectdocument.h"

#include <QUndoCommand>

namespace camwright {

/// One step on the document's stack. Undo applies the edit backwards; redo forwards.
class ProjectStep : public QUndoCommand {
public:
    ProjectStep(ProjectDocument& document, ProjectEdit edit, int mergeEpoch);

    void undo() override;
    void redo() override;
    int id() const override { return m_edit.mergeKey.isEmpty() ? -1 : 1; }
    bool mergeWith(const QUndoCommand* other) override;
    const Place& place() const { return m_edit.place; }

private:
    ProjectDocument& m_document;
    ProjectEdit m_edit;
    int m_epoch;
};

/// The place of a step, or of the last one in a group; an empty place for a null pointer.
Place placeOf(const QUndoCommand* command);
/// What turns one project into the other, object by object.
std::vector<Delta> deltasBetween(const Project& before, const Project& after);

} // namespace camwright
