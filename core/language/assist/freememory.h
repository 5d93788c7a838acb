#pragma once

#include "core/language/check/context.h"

#include <map>
#include <optional>
#include <vector>

namespace camwright {

/// Memory of the controller that no program, variable or watch table of a project uses, for names that need a place. What a
/// list of unknown length covers counts with its first element only.
class FreeMemory {
public:
    FreeMemory(const Project& project, const LanguageContext& context);

    /// The lowest free place for a value of the type; bits come from bytes that are wholly free as long as there are any. Each
    /// call gives another. Nothing when the area is full or has no such values.
    std::optional<Address> take(AreaId area, DataType type);
    /// The area new names of the type go to (Kinco M and V, TS600 M and D, Koyo C and V) if `pin` takes it, else the first one it takes.
    std::optional<Address> takeFor(const Pin* pin, DataType type);

private:
    std::optional<Address> takeBit(AreaId area);
    bool isFree(AreaId area, std::uint64_t bit, std::uint64_t bits) const;
    void mark(AreaId area, std::uint64_t bit, std::uint64_t bits);
    bool isUsable(const Address& address) const;

    const LanguageContext& m_context;
    std::map<AreaId, std::vector<bool>> m_used; ///< by bit, as long as the area on the model
    std::map<AreaId, std::uint64_t> m_openByte; ///< the byte whose bits are being given out
};

} // namespace camwright
