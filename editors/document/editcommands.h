#pragma once

#include "editors/document/projectdocument.h"

#include <functional>
#include <span>

namespace camwright {

/// Changes the content of several objects in one step: `change` gets a copy of each content of type T. Objects that are
/// missing or of another type are left alone. `property` names the field as Place::field does. Returns whether anything changed.
template <class T, class Change>
bool editObjects(ProjectDocument& document, std::span<const ObjectKey> keys, const QString& label, const std::string& property,
    Change change, const QString& mergeKey = {})
{
    ProjectEdit edit{label, {}, {}, {}, mergeKey};
    if (!property.empty())
        edit.properties.insert(property);
    for (const ObjectKey& key : keys) {
        const ObjectPtr before = document.object(key);
        if (!before || !std::holds_alternative<T>(before->content))
            continue;
        Object after = *before;
        change(std::get<T>(after.content));
        edit.deltas.push_back(ObjectDelta{key, before, std::make_shared<const Object>(std::move(after))});
        edit.place = Place{key, property, {}, {}};
    }
    return document.push(std::move(edit));
}

/// The same for one object.
template <class T, class Change>
bool editObject(ProjectDocument& document, const ObjectKey& key, const QString& label, const std::string& property, Change change,
    const QString& mergeKey = {})
{
    return editObjects<T>(document, std::span(&key, 1), label, property, std::move(change), mergeKey);
}

/// Replaces `length` bytes of a program's source at `offset`. Consecutive typing merges.
bool editText(ProjectDocument& document, const ObjectKey& program, std::size_t offset, std::size_t length, std::string inserted);

/// Adds an object at the end of its kind. The name is made free if it is taken; returns the key it got.
ObjectKey addObject(ProjectDocument& document, Object object);
bool removeObjects(ProjectDocument& document, std::span<const ObjectKey> keys);
/// Copies with the next free name; an axis also gets the next free number. Returns the new key.
ObjectKey duplicateObject(ProjectDocument& document, const ObjectKey& key);
/// Fails with a diagnostic when the name is empty, not a legal identifier, or taken.
Result<void> renameObject(ProjectDocument& document, const ObjectKey& key, const std::string& name);
Result<void> checkName(const Project& project, const ObjectKey& key, const std::string& name);

/// "Feed" -> "Feed2" -> "Feed3": the first free name that continues `wanted`.
std::string freeName(const Project& project, ObjectKind kind, const std::string& wanted);
std::int64_t freeAxisNumber(const Project& project);
/// A new object with the defaults of its kind and a free name.
Object newObject(const Project& project, ObjectKind kind);

} // namespace camwright
