#include "editors/document/projectstep.h"

namespace camwright {

namespace {

/// Typing on, or deleting back, becomes one delta; false when the two do not touch.
bool joined(TextDelta& first, const TextDelta& second)
{
    if (first.key != second.key)
        return false;
    if (second.offset == first.offset + first.inserted.size()) {
        first.inserted += second.inserted;
        first.removed += second.removed;
        return true;
    }
    if (second.inserted.empty() && second.offset + second.removed.size() == first.offset + first.inserted.size()
        && second.offset >= first.offset) {
        first.inserted.resize(first.inserted.size() - second.removed.size());
        return true;
    }
    if (first.inserted.empty() && second.inserted.empty() && second.offset + second.removed.size() == first.offset) {
        first.offset = second.offset;
        first.removed = second.removed + first.removed;
        return true;
    }
    return false;
}

bool joined(Delta& first, const Delta& second)
{
    if (first.index() != second.index())
        return false;
    if (auto* text = std::get_if<TextDelta>(&first))
        return joined(*text, std::get<TextDelta>(second));
    auto& object = std::get<ObjectDelta>(first);
    const auto& next = std::get<ObjectDelta>(second);
    if (object.key != next.key)
        return false;
    object.after = next.after;
    return true;
}

} // namespace

ProjectStep::ProjectStep(ProjectDocument& document, ProjectEdit edit, int mergeEpoch)
    : QUndoCommand(edit.label), m_document(document), m_edit(std::move(edit)), m_epoch(mergeEpoch)
{
}

void ProjectStep::undo()
{
    m_document.apply(reversed(m_edit.deltas), m_edit.properties, text());
}

void ProjectStep::redo()
{
    m_document.apply(m_edit.deltas, m_edit.properties, text());
}

bool ProjectStep::mergeWith(const QUndoCommand* other)
{
    const auto& next = static_cast<const ProjectStep&>(*other);
    if (next.m_epoch != m_epoch || next.m_edit.mergeKey != m_edit.mergeKey)
        return false;
    for (const Delta& delta : next.m_edit.deltas) {
        if (m_edit.deltas.empty() || !joined(m_edit.deltas.back(), delta))
            m_edit.deltas.push_back(delta);
    }
    m_edit.properties.insert(next.m_edit.properties.begin(), next.m_edit.properties.end());
    m_edit.place = next.m_edit.place;
    m_edit.deltas = withoutNoise(std::move(m_edit.deltas));
    setObsolete(m_edit.deltas.empty());
    return true;
}

Place placeOf(const QUndoCommand* command)
{
    if (!command)
        return {};
    if (command->childCount() > 0)
        return placeOf(command->child(command->childCount() - 1));
    const auto* step = dynamic_cast<const ProjectStep*>(command);
    return step ? step->place() : Place{};
}

std::vector<Delta> deltasBetween(const Project& before, const Project& after)
{
    std::vector<Delta> out;
    for (const auto& [key, object] : before.all()) {
        const ObjectPtr other = after.find(key);
        if (!other || (other != object && !(*other == *object)))
            out.push_back(ObjectDelta{key, object, other});
    }
    for (const auto& [key, object] : after.all()) {
        if (!before.find(key))
            out.push_back(ObjectDelta{key, nullptr, object});
    }
    return out;
}

} // namespace camwright
