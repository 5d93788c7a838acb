#pragma once

#include "core/family/addresssyntax.h"
#include "core/family/catalogue.h"
#include "core/family/family.h"

#include <functional>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace camwright {

/// Timers [first, last] count in steps of `base`.
struct TimerRange {
    std::uint32_t first = 0, last = 0;
    Time base{};
};

/// Everything a Family knows, as read from its tables.
struct FamilyData {
    std::string id, displayName, defaultModel;
    Time modelledScanTime{};
    std::uint32_t firstWideCounter = 0xFFFFFFFF; ///< counters from here on are 32 bits wide
    std::vector<MemoryArea> areas;
    std::map<Address, Text> places; ///< system flags with a meaning of their own
    std::vector<ControllerModel> models;
    std::vector<TimerRange> timers;
    std::vector<DriveParameter> driveParameters;
    std::vector<AxisState> axisStates;
    std::vector<ErrorText> errors;
    std::map<std::pair<std::string, std::uint32_t>, std::size_t> errorCodes; ///< whole codes by scope and code
    std::vector<ErrorCategory> errorCategories;
    Catalogue catalogue;
    const AddressSyntax* syntax = nullptr;
};

/// Gives the bytes of one of the family's tables by its name ("models.csv"); empty for one it does not have.
using FamilyFiles = std::function<std::string_view(std::string_view name)>;

/// Reads a family from its tables, or says everything that is wrong with them.
Result<FamilyData, Diagnostics> readFamily(const FamilyFiles& files);

} // namespace camwright
