#pragma once

#include "core/model/objects.h"

#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace camwright {

/// The two objects of which a project has exactly one; they have no name of their own.
inline ObjectKey projectKey() { return {ObjectKind::Project, ""}; }
inline ObjectKey controllerKey() { return {ObjectKind::Controller, ""}; }

/// A project: an immutable snapshot (CONTRACTS 1). Changing an object makes a new snapshot that shares all others, so a
/// check or a compile owns one and needs no lock.
class Project {
public:
    std::string_view name() const; ///< of the object `projectKey()`; empty if the project has none yet
    Project withName(std::string name) const;

    /// Null when there is no such object.
    ObjectPtr find(const ObjectKey& key) const;
    template <class T>
    const T* content(const ObjectKey& key) const
    {
        const ObjectPtr object = find(key);
        return object ? std::get_if<T>(&object->content) : nullptr;
    }
    /// All of a kind by order, then name.
    std::vector<ObjectPtr> objects(ObjectKind kind) const;
    const std::map<ObjectKey, ObjectPtr>& all() const { return m_objects; }
    const ControllerSettings& controller() const; ///< a default one if the project has none yet

    /// Adds or replaces by key; a null pointer removes.
    Project with(const ObjectKey& key, ObjectPtr object) const;
    /// Adds or replaces an object with this content; order and unknown keys of a former one stay, a new one goes last.
    Project withContent(const ObjectKey& key, ObjectContent content) const;
    /// One more than the highest order in use of the kind, at least 1.
    std::int64_t nextOrder(ObjectKind kind) const;

    bool operator==(const Project&) const; ///< compares values, not pointers

private:
    std::map<ObjectKey, ObjectPtr> m_objects;
};

} // namespace camwright
