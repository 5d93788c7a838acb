#pragma once

#include "core/base/diagnostic.h"
#include "core/model/project.h"

#include <cstddef>
#include <string>
#include <vector>

namespace camwright {

/// `length` bytes of a program's source at `offset` give way to `text`.
struct TextEdit {
    std::size_t offset = 0;
    std::size_t length = 0;
    std::string text;

    bool operator==(const TextEdit&) const = default;
};

/// One way out of a problem, ready to be done: edits of the program the problem stands in, and objects of the project that are
/// added or replaced. All of it is one step.
struct QuickFix {
    const char* sentence = "";           ///< what it does, English, marked with CW_TEXT("QuickFix", …); arguments as %1 …
    std::vector<std::string> arguments;
    std::vector<TextEdit> edits;         ///< in the order of the text, without overlap
    std::vector<Object> objects;

    bool operator==(const QuickFix&) const = default;
};

/// Whether there are fixes for a code at all; cheap, for marks in lists and margins.
bool hasQuickFixes(Code code);

/// The ways out of a problem of a project, the likeliest first. A problem may be older than the text: a fix is offered only
/// where the text still is what the problem says. A pure function.
std::vector<QuickFix> quickFixes(const Project& project, const Diagnostic& problem);

/// The project after a fix of a problem in `program`.
Project applied(const Project& project, const ObjectKey& program, const QuickFix& fix);
/// The text after its edits; edits outside the text are left out.
std::string applied(const std::string& source, const std::vector<TextEdit>& edits);

} // namespace camwright
