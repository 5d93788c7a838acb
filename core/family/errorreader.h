#pragma once

#include "core/family/familydata.h"

namespace camwright {

/// Reads errors.csv and, where the family has it, error_categories.csv into `out`.
void readErrors(const FamilyFiles& files, FamilyData& out, Diagnostics& diagnostics);

} // namespace camwright
