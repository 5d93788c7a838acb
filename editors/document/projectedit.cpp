#include "editors/document/projectedit.h"

namespace camwright {

namespace {

Project withText(const Project& project, const TextDelta& delta)
{
    const ObjectPtr object = project.find(delta.key);
    const Program* program = object ? std::get_if<Program>(&object->content) : nullptr;
    if (!program || delta.offset + delta.removed.size() > program->source.size())
        return project;
    Object changed = *object;
    std::get<Program>(changed.content).source.replace(delta.offset, delta.removed.size(), delta.inserted);
    return project.with(delta.key, std::make_shared<const Object>(std::move(changed)));
}

bool changesNothing(const Delta& delta)
{
    if (const auto* text = std::get_if<TextDelta>(&delta))
        return text->removed == text->inserted;
    const auto& object = std::get<ObjectDelta>(delta);
    if (object.before == object.after)
        return true;
    return object.before && object.after && *object.before == *object.after;
}

} // namespace

const ObjectKey& keyOf(const Delta& delta)
{
    return std::visit([](const auto& d) -> const ObjectKey& { return d.key; }, delta);
}

Project applied(const Project& project, const std::vector<Delta>& deltas)
{
    Project out = project;
    for (const Delta& delta : deltas) {
        if (const auto* object = std::get_if<ObjectDelta>(&delta))
            out = out.with(object->key, object->after);
        else
            out = withText(out, std::get<TextDelta>(delta));
    }
    return out;
}

std::vector<Delta> reversed(const std::vector<Delta>& deltas)
{
    std::vector<Delta> out;
    out.reserve(deltas.size());
    for (auto it = deltas.rbegin(); it != deltas.rend(); ++it) {
        if (const auto* object = std::get_if<ObjectDelta>(&*it)) {
            out.push_back(ObjectDelta{object->key, object->after, object->before});
        } else {
            const auto& text = std::get<TextDelta>(*it);
            out.push_back(TextDelta{text.key, text.offset, text.inserted, text.removed});
        }
    }
    return out;
}

std::vector<Delta> withoutNoise(std::vector<Delta> deltas)
{
    std::erase_if(deltas, changesNothing);
    return deltas;
}

ProjectChange changeOf(const std::vector<Delta>& deltas, const std::set<std::string>& properties)
{
    ProjectChange out;
    out.properties = properties;
    for (const Delta& delta : deltas) {
        out.objects.insert(keyOf(delta));
        const auto* object = std::get_if<ObjectDelta>(&delta);
        if (object && (!object->before || !object->after || object->before->order != object->after->order))
            out.listChanged = true;
    }
    return out;
}

} // namespace camwright
