#pragma once

#include "core/base/diagnostic.h"
#include "core/base/result.h"
#include "core/model/objects.h"

#include <string>
#include <string_view>
#include <vector>

namespace camwright {

/// A table of variables read from VAR_GLOBAL text.
struct VariableText {
    std::vector<Variable> rows;
    std::vector<TextRange> rowRanges;      ///< of each row, name to semicolon
    std::vector<std::uint32_t> lines;      ///< of each VAR_GLOBAL, row and END_VAR in the order written: its first line
};

/// Reads the blocks in `text`, whose first line is line `firstLine` of `file`. After an error it goes on with the next line.
Result<VariableText, Diagnostics> readVariables(std::string_view text, std::uint32_t firstLine, const std::string& file);

/// One line a row, one block for each run of rows that are equally retained.
std::vector<std::string> variableLines(const VariableTable& table);

} // namespace camwright
