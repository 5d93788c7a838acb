#pragma once

#include "core/family/catalogue.h"
#include "core/family/family.h"

#include <span>
#include <string_view>

namespace camwright {

/// The four tables a catalogue is made of, as bytes. The columns are described in docs/families.md.
struct CatalogueTables {
    std::string_view instructions, pins, texts, groups;
};

/// Reads a catalogue, or says everything that is wrong with its tables. `areas` gives the names that pins use.
Result<Catalogue, Diagnostics> readCatalogue(const CatalogueTables& tables, std::span<const MemoryArea> areas);

} // namespace camwright
