#include "core/storage/textobject.h"

#include "core/storage/filenames.h"
#include "core/storage/settingsline.h"
#include "core/base/utf8.h"
#include "core/storage/variabletext.h"

#include <algorithm>
#include <charconv>
#include <optional>

namespace camwright {

namespace {

constexpr std::string_view ProgramExample = "(* camwright: role=main, order=1 *)";
constexpr std::string_view TableExample = "(* camwright: order=1 *)";

constexpr std::string_view StLanguage = "st";
constexpr std::string_view StEnding = ".st";

struct RoleName {
    ProgramRole role;
    std::string_view name;
};
constexpr RoleName RoleNames[] = {
    {ProgramRole::Main, "main"}, {ProgramRole::Subroutine, "subroutine"}, {ProgramRole::Interrupt, "interrupt"}};

std::string settingsOf(const Object& object)
{
    std::vector<std::pair<std::string, std::string>> values;
    if (isShortened(stemOf(object.key.name)))
        values.emplace_back("name", settingText(encodedName(object.key.name)));
    if (const auto* program = std::get_if<Program>(&object.content)) {
        for (const RoleName& row : RoleNames) {
            if (row.role == program->role)
                values.emplace_back("role", row.name);
        }
        if (program->language == ProgramLanguage::StructuredText)
            values.emplace_back("language", StLanguage);
    }
    values.emplace_back("order", std::to_string(object.order));
    values.insert(values.end(), object.unknown.begin(), object.unknown.end());
    return writeSettingsLine(values);
}

Diagnostics wrongSetting(Code code, const ObjectKey& key, const std::string& file, const char* setting, std::vector<std::string> arguments)
{
    return {diagnostic(code, std::move(arguments), Place{key, setting, {1, 1, 1, 1}, file})};
}

Result<ProgramRole, Diagnostics> readRole(const ObjectKey& key, const std::string& file, const std::string& text)
{
    std::string names;
    for (const RoleName& row : RoleNames) {
        if (row.name == text)
            return row.role;
        names += (names.empty() ? "" : ", ") + std::string(row.name);
    }
    return wrongSetting(Code::RoleUnknown, key, file, "role", {text, names});
}

Result<std::int64_t, Diagnostics> readOrder(const ObjectKey& key, const std::string& file, const std::string& text)
{
    std::int64_t order = 0;
    const char* end = text.data() + text.size();
    const auto result = std::from_chars(text.data(), end, order);
    if (result.ptr != end || result.ec != std::errc{})
        return wrongSetting(Code::WholeNumberExpected, key, file, "order", {"order"});
    return order;
}

std::string takeSetting(SettingsLine& line, const char* key, const char* fallback)
{
    const auto found = line.values.find(key);
    if (found == line.values.end())
        return fallback;
    const std::string out = settingValue(found->second);
    line.values.erase(found);
    return out;
}

/// A program's lines end with \n; pasted text may have brought others.
std::string withUnixLines(std::string text)
{
    for (std::size_t at = text.find("\r\n"); at != std::string::npos; at = text.find("\r\n", at))
        text.erase(at, 1);
    return text;
}

Diagnostic notUtf8(std::string_view text, std::size_t at, const std::string& file)
{
    const std::string_view head = text.substr(0, at);
    const std::size_t newline = head.rfind('\n');
    const auto line = static_cast<std::uint32_t>(std::count(head.begin(), head.end(), '\n') + 1);
    const auto column = static_cast<std::uint32_t>(newline == std::string_view::npos ? at + 1 : at - newline);
    Place place;
    place.file = file;
    place.range = {line, column, line, column + 1};
    return diagnostic(Code::NotUtf8, {}, place);
}

} // namespace

std::string writeTextObject(const Object& object)
{
    std::string out = settingsOf(object) + '\n';
    if (const auto* program = std::get_if<Program>(&object.content))
        return out + withUnixLines(validUtf8(program->source));
    for (const std::string& line : variableLines(std::get<VariableTable>(object.content)))
        out += line + '\n';
    return out;
}

Result<Object, Diagnostics> readTextObject(const ObjectKey& key, std::string_view text, const std::string& file)
{
    const bool isProgram = key.kind == ObjectKind::Program;
    if (const std::size_t bad = firstInvalidUtf8(text); bad != std::string_view::npos)
        return Diagnostics{notUtf8(text, bad, file)};
    auto line = readSettingsLine(text, file, isProgram ? ProgramExample : TableExample);
    if (!line)
        return Diagnostics{line.error()};
    const std::string_view rest = text.substr(line->length);
    const auto order = readOrder(key, file, takeSetting(*line, "order", "0"));
    if (!order)
        return order.error();
    Object out{key, *order, {}, {}};
    if (isShortened(stemOf(key.name)))
        line->values.erase("name");
    if (isProgram) {
        const auto role = readRole(key, file, takeSetting(*line, "role", ""));
        if (!role)
            return role.error();
        const bool isSt = file.ends_with(StEnding) || takeSetting(*line, "language", "") == StLanguage;
        line->values.erase("language");
        out.content = Program{*role, isSt ? ProgramLanguage::StructuredText : ProgramLanguage::InstructionList, std::string(rest)};
    } else {
        auto table = readVariables(rest, 2, file);
        if (!table)
            return table.error();
        out.content = VariableTable::of(table->rows);
    }
    out.unknown.insert(line->values.begin(), line->values.end());
    return out;
}

namespace {

/// The text cut into lines, each with its end.
std::vector<std::string_view> splitLines(std::string_view text)
{
    std::vector<std::string_view> out;
    while (!text.empty()) {
        const std::size_t newline = text.find('\n');
        const std::size_t length = newline == std::string_view::npos ? text.size() : newline + 1;
        out.push_back(text.substr(0, length));
        text.remove_prefix(length);
    }
    return out;
}

} // namespace

std::optional<std::string> patchVariables(std::string_view before, const Object& was, const Object& is)
{
    const std::vector<std::string_view> raw = splitLines(before);
    const auto read = raw.empty() ? Result<VariableText, Diagnostics>(Diagnostics{})
                                  : readVariables(before.substr(raw.front().size()), 2, {});
    const auto* oldTable = std::get_if<VariableTable>(&was.content);
    const auto* newTable = std::get_if<VariableTable>(&is.content);
    if (!read || !oldTable || !newTable)
        return std::nullopt;
    const std::vector<std::string> oldLines = variableLines(*oldTable);
    const std::vector<std::string> newLines = variableLines(*newTable);
    if (read->lines.size() != oldLines.size()) // blocks that the canonical form would join
        return std::nullopt;

    const auto same = std::mismatch(oldLines.begin(), oldLines.end(), newLines.begin(), newLines.end());
    const auto head = static_cast<std::size_t>(same.first - oldLines.begin());
    std::size_t tail = 0;
    while (tail < std::min(oldLines.size(), newLines.size()) - head
           && oldLines[oldLines.size() - 1 - tail] == newLines[newLines.size() - 1 - tail])
        ++tail;
    const std::size_t oldEnd = oldLines.size() - tail;
    const std::size_t newEnd = newLines.size() - tail;

    std::string out = settingsOf(was) == settingsOf(is) ? std::string(raw.front()) : settingsOf(is) + '\n';
    std::size_t at = 1; // next raw line, counted from 0
    const auto copyUntil = [&](std::size_t line) {
        for (; at < line && at < raw.size(); ++at)
            out += raw[at];
    };
    const auto rawLine = [&](std::size_t n) { return n < oldLines.size() ? read->lines[n] - 1 : raw.size(); };
    copyUntil(rawLine(head));
    for (std::size_t n = head; n < std::max(oldEnd, newEnd); ++n) {
        if (n < oldEnd) { // comments between changed rows stay where they were
            copyUntil(rawLine(n));
            at = rawLine(n) + 1;
        }
        if (n < newEnd)
            out += newLines[n] + '\n';
    }
    copyUntil(raw.size());
    return out;
}

} // namespace camwright
