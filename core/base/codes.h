#pragma once

#include <cstdint>
#include <span>
#include <string_view>

// Marks a text for translation in files that know no Qt; lupdate is told of it as an alias of QT_TRANSLATE_NOOP.
#define CW_TEXT(context, text) text

namespace camwright {

enum class Severity : std::uint8_t { Information, Warning, Error };

/// Every message Camwright can give, one name each. The texts stand in core/base/codes/*.h, a file an area; the page that
/// explains a code and its way out is resources/diagnostics/<language>/<id>.md, the language being en, zh or ru.
#ifdef Q_MOC_RUN
enum class Code : std::uint16_t; // moc cannot read an #include inside an enumeration
#else
enum class Code : std::uint16_t {
#define CAMWRIGHT_CODE(name, id, severity, text) name,
#include "core/base/codes/all.h"
#undef CAMWRIGHT_CODE
};
#endif

struct CodeInfo {
    Code code;
    std::string_view id;   ///< stable, printed: "CW3001"
    Severity severity;
    std::string_view text; ///< English template, arguments as %1 … %9
};

const CodeInfo& codeInfo(Code code);
std::span<const CodeInfo> allCodes();

} // namespace camwright
