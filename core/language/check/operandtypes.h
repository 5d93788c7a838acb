#pragma once

#include "core/language/check/resolvedprogram.h"

#include <optional>
#include <string>
#include <vector>

namespace camwright {

/// Types a place in memory can be used as: what its form allows, and only the declared one where a variable names the place
/// or forces its type (KS-MEM-06). `forcing` is that variable, if it is not the one written.
struct MemoryTypes {
    TypeSet possible;
    const KnownVariable* forcing = nullptr;
};
MemoryTypes typesOf(const ResolvedMemory& memory, const LanguageContext& context);

/// The place with a type its pin takes: D100 is two words where the pin is a DINT. As it is where nothing fits. What pins of
/// a common type group decide together is not looked at.
Address addressAtPin(const ResolvedMemory& memory, const Pin& pin, const LanguageContext& context);

TypeSet intersection(const TypeSet& a, const TypeSet& b);
std::string typeNames(const TypeSet& types); ///< "INT/WORD"

/// The type taken where several are possible and nothing decides: signed before unsigned, narrow before wide.
DataType preferredType(const TypeSet& types);

/// Names of the memory areas a pin takes: "V, M, L".
std::string areaNames(const Pin& pin, const Family& family);
/// Whether the pin takes the area; of timers and counters bit and value count as one.
bool areaAllowed(const Pin& pin, const Address& address, const Family& family);

} // namespace camwright
