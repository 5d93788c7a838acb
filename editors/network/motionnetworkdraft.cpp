#include "editors/network/motionnetworkdraft.h"

#include "core/checks/checkproject.h"
#include "editors/document/projectdocument.h"

#include <algorithm>

namespace camwright {

MotionNetworkDraft MotionNetworkDraft::of(const Project& project, const ObjectKey& network)
{
    MotionNetworkDraft out;
    const ObjectPtr object = project.find(network);
    out.m_network = object ? *object : Object{network, 0, Network{}, {}};
    for (const ObjectPtr& axis : project.objects(ObjectKind::Axis)) {
        out.m_axes.push_back({axis->key, *axis});
        out.m_original.insert(axis->key);
    }
    std::ranges::sort(out.m_axes, {}, [](const DraftAxis& a) { return std::pair(a.axis().number.valueOr(0), a.object.key.name); });
    return out;
}

std::int64_t MotionNetworkDraft::freeNumber() const
{
    for (std::int64_t number = 1;; ++number) {
        if (std::ranges::none_of(m_axes, [&](const DraftAxis& a) { return a.axis().number == Field<std::int64_t>(number); }))
            return number;
    }
}

std::string MotionNetworkDraft::freeName(const std::string& wanted) const
{
    const auto taken = [&](const std::string& name) {
        return std::ranges::any_of(m_axes, [&](const DraftAxis& a) { return a.object.key.name == name; });
    };
    std::string name = wanted;
    for (int number = 2; taken(name); ++number)
        name = wanted + ' ' + std::to_string(number);
    return name;
}

std::size_t MotionNetworkDraft::addAxis()
{
    Axis axis;
    axis.number = freeNumber();
    const std::string name = freeName("Axis " + std::to_string(axis.number.value()) + " name");
    m_axes.push_back({std::nullopt, Object{{ObjectKind::Axis, name}, static_cast<std::int64_t>(m_axes.size()), axis, {}}});
    return m_axes.size() - 1;
}

std::size_t MotionNetworkDraft::pasteAxis(const Object& copied)
{
    Object object = copied;
    std::get<Axis>(object.content).number = freeNumber();
    object.key.name = freeName(copied.key.name);
    object.order = static_cast<std::int64_t>(m_axes.size());
    m_axes.push_back({std::nullopt, std::move(object)});
    return m_axes.size() - 1;
}

void MotionNetworkDraft::removeAxis(std::size_t index)
{
    m_axes.erase(m_axes.begin() + static_cast<std::ptrdiff_t>(index));
}

void MotionNetworkDraft::renumber()
{
    std::int64_t number = 0;
    for (DraftAxis& axis : m_axes)
        axis.axis().number = ++number;
}

Project MotionNetworkDraft::appliedTo(const Project& project) const
{
    Project out = project.with(m_network.key, std::make_shared<const Object>(m_network));
    for (const ObjectKey& key : m_original)
        out = out.with(key, nullptr);
    for (const DraftAxis& axis : m_axes)
        out = out.with(axis.object.key, std::make_shared<const Object>(axis.object));
    return out;
}

Diagnostics MotionNetworkDraft::problems(const Project& project) const
{
    Diagnostics out;
    for (std::size_t i = 0; i < m_axes.size(); ++i) {
        const std::string& name = m_axes[i].object.key.name;
        const bool twice = std::ranges::any_of(m_axes.begin(), m_axes.begin() + static_cast<std::ptrdiff_t>(i),
            [&](const DraftAxis& a) { return a.object.key.name == name; });
        if (twice)
            out.push_back(diagnostic(Code::NameTwice, {name}, Place{m_axes[i].object.key, "name", {}, {}}));
    }
    for (Diagnostic& d : checkProject(appliedTo(project))) {
        const ObjectKind kind = d.place.object.kind;
        if (kind == ObjectKind::Axis || kind == ObjectKind::Network)
            out.push_back(std::move(d));
    }
    return out;
}

bool MotionNetworkDraft::apply(ProjectDocument& document, const QString& label) const
{
    const Project& before = document.project();
    const Project after = appliedTo(before);
    ProjectEdit edit{label, {}, {}, Place{m_network.key, {}, {}, {}}, {}};
    std::set<ObjectKey> keys{m_network.key};
    keys.insert(m_original.begin(), m_original.end());
    for (const DraftAxis& axis : m_axes)
        keys.insert(axis.object.key);
    for (const ObjectKey& key : keys) {
        const ObjectPtr was = before.find(key), is = after.find(key);
        if (was && is && *was == *is)
            continue;
        edit.deltas.push_back(ObjectDelta{key, was, is});
    }
    return document.push(std::move(edit));
}

} // namespace camwright
