#pragma once

#include "core/base/diagnostic.h"
#include "core/checks/validproject.h"
#include "core/model/project.h"

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

namespace camwright {

/// Everything that keeps the project from being built, and what looks wrong but does not, sorted by place. Looks at the
/// project's settings, not into the text of programs; that is the language's work.
Diagnostics checkProject(const Project& project);

struct Validation {
    std::optional<ValidProject> project; ///< set when no diagnostic is an error
    Diagnostics diagnostics;             ///< warnings and notes too
};

/// The project as compiler, engine and download take it (CONTRACTS 3).
Validation validate(const Project& project);

/// The baud rates a CANopen motion network offers, in bit/s, ascending: those of CiA 301 (KS-MCN prints no list).
std::span<const std::int64_t> offeredBaudrates();

/// The SDO time-out proposed for a baud rate, in ms. Ours: the manual says that one is proposed, not which.
std::int64_t proposedSdoTimeoutMs(std::int64_t baudrate);

/// The legal range of an integer or number field, as the checks apply it; `field` is a key of core/model/fieldlist.h.
struct FieldRange {
    double low = 0;
    double high = 0;
};
std::optional<FieldRange> fieldRange(ObjectKind kind, std::string_view field);

} // namespace camwright
