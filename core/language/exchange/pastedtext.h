#pragma once

#include "core/base/diagnostic.h"
#include "core/language/source/dialect.h"

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace camwright {

/// One thing mended in a text that went through a document, a translator or a scanner.
struct PasteRepair {
    Code code = Code::StrayText; ///< the diagnostic the text would have had
    std::uint32_t line = 0;      ///< in the text as it was pasted, from 1
    std::string before;          ///< the line as it was
    std::string after;           ///< as it is now; empty if the line was removed

    bool operator==(const PasteRepair&) const = default;
};

struct RepairedText {
    std::string text;                 ///< with the repairs
    std::vector<PasteRepair> repairs; ///< in the order of the lines; empty: nothing to mend
};

/// Offers a mended copy of pasted program text: Markdown fences and escapes, Cyrillic letters in operands, blanks inside
/// constants, a missing %, stray characters behind comments, comments that lost their end, characters that cannot be seen.
/// It never changes what is legal, and it is only an offer: the editor shows the repairs before it takes the text.
RepairedText repairPastedText(const Dialect& dialect, std::string_view text);

} // namespace camwright
