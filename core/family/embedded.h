#pragma once

#include <string_view>

namespace camwright {

/// The bytes of a file under resources/families, made part of the program by the build: "kinco/models.csv".
/// Empty if there is no such file.
std::string_view embeddedFamilyFile(std::string_view path);

} // namespace camwright
