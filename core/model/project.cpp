#include "core/model/project.h"

#include <algorithm>
#include <tuple>

namespace camwright {

std::string_view Project::name() const
{
    const auto it = m_objects.find(projectKey());
    const auto* settings = it == m_objects.end() ? nullptr : std::get_if<ProjectSettings>(&it->second->content);
    return settings ? std::string_view(settings->name) : std::string_view();
}

Project Project::withName(std::string name) const
{
    const ProjectSettings* old = content<ProjectSettings>(projectKey());
    ProjectSettings settings = old ? *old : ProjectSettings{};
    settings.name = std::move(name);
    return withContent(projectKey(), std::move(settings));
}

ObjectPtr Project::find(const ObjectKey& key) const
{
    const auto it = m_objects.find(key);
    return it == m_objects.end() ? nullptr : it->second;
}

std::vector<ObjectPtr> Project::objects(ObjectKind kind) const
{
    std::vector<ObjectPtr> out;
    for (auto it = m_objects.lower_bound(ObjectKey{kind, ""}); it != m_objects.end() && it->first.kind == kind; ++it)
        out.push_back(it->second);
    std::sort(out.begin(), out.end(), [](const ObjectPtr& a, const ObjectPtr& b) {
        return std::tie(a->order, a->key) < std::tie(b->order, b->key);
    });
    return out;
}

const ControllerSettings& Project::controller() const
{
    static const ControllerSettings Default;
    const auto* settings = content<ControllerSettings>(controllerKey());
    return settings ? *settings : Default;
}

Project Project::with(const ObjectKey& key, ObjectPtr object) const
{
    Project out = *this;
    if (object)
        out.m_objects.insert_or_assign(key, std::move(object));
    else
        out.m_objects.erase(key);
    return out;
}

Project Project::withContent(const ObjectKey& key, ObjectContent content) const
{
    Object object{key, 0, std::move(content), {}};
    if (const ObjectPtr old = find(key)) {
        object.order = old->order;
        object.unknown = old->unknown;
    } else if (key.kind != ObjectKind::Project && key.kind != ObjectKind::Controller) {
        object.order = nextOrder(key.kind);
    }
    return with(key, std::make_shared<const Object>(std::move(object)));
}

std::int64_t Project::nextOrder(ObjectKind kind) const
{
    std::int64_t highest = 0;
    for (const auto& [key, object] : m_objects) {
        if (key.kind == kind)
            highest = std::max(highest, object->order);
    }
    return highest == INT64_MAX ? highest : highest + 1;
}

bool Project::operator==(const Project& other) const
{
    return std::equal(m_objects.begin(), m_objects.end(), other.m_objects.begin(), other.m_objects.end(),
                      [](const auto& a, const auto& b) {
                          return a.first == b.first && (a.second == b.second || *a.second == *b.second);
                      });
}

} // namespace camwright
