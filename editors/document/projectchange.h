#pragma once

#include "core/base/place.h"

#include <set>
#include <string>

namespace camwright {

/// What one step changed. Views refresh what it names and nothing else.
struct ProjectChange {
    std::set<ObjectKey> objects;       ///< changed, added or removed
    std::set<std::string> properties;  ///< keys of core/model/fieldlist.h ("guard_time_ms"), "source", "rows"; empty: any of them
    bool listChanged = false;          ///< objects were added, removed, renamed or reordered
    bool everything = false;           ///< another project stands in the document

    bool touches(const ObjectKey& key) const { return everything || objects.contains(key); }
    bool touches(ObjectKind kind) const
    {
        if (everything)
            return true;
        for (const ObjectKey& key : objects) {
            if (key.kind == kind)
                return true;
        }
        return false;
    }
    bool touchesProperty(const std::string& name) const { return everything || properties.empty() || properties.contains(name); }
};

} // namespace camwright
