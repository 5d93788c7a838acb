#include "core/storage/objecttext.h"

#include "core/storage/textobject.h"
#include "core/storage/tomlobject.h"

#include <algorithm>

namespace camwright {

namespace {

constexpr std::string_view ByteOrderMark = "\xEF\xBB\xBF";

/// How a file ends its lines, and whether it begins with a byte order mark: kept when the file is written again.
struct TextForm {
    bool hasMark = false;
    bool endsWithCrLf = false;
};

TextForm formOf(std::string_view text)
{
    TextForm out;
    out.hasMark = text.starts_with(ByteOrderMark);
    for (std::size_t at = text.find('\n'); at != std::string_view::npos; at = text.find('\n', at + 1)) {
        out.endsWithCrLf = at > 0 && text[at - 1] == '\r';
        if (!out.endsWithCrLf)
            break;
    }
    return out;
}

/// Without the mark, lines ended by \n.
std::string plainText(std::string_view text)
{
    if (text.starts_with(ByteOrderMark))
        text.remove_prefix(ByteOrderMark.size());
    std::string out;
    out.reserve(text.size());
    for (std::size_t at = 0; at < text.size(); ++at) {
        if (text[at] != '\r' || at + 1 >= text.size() || text[at + 1] != '\n')
            out += text[at];
    }
    return out;
}

std::string formed(std::string text, const TextForm& form)
{
    std::string out(form.hasMark ? ByteOrderMark : std::string_view());
    if (!form.endsWithCrLf)
        return out + text;
    for (char c : text) {
        if (c == '\n')
            out += '\r';
        out += c;
    }
    return out;
}

std::optional<std::string> patched(std::string_view before, const Object& was, const Object& is)
{
    if (is.key.kind == ObjectKind::VariableTable)
        return patchVariables(before, was, is);
    if (!isTomlKind(is.key.kind))
        return std::nullopt;
    const auto leaves = parseToml(before, {});
    if (!leaves)
        return std::nullopt;
    return patchToml(before, *leaves, tomlLines(was), tomlLines(is), tomlTables(is.key.kind));
}

} // namespace

std::string toText(const Object& object)
{
    return isTomlKind(object.key.kind) ? writeToml(tomlLines(object), tomlTables(object.key.kind)) : writeTextObject(object);
}

Result<Object, Diagnostics> fromText(const ObjectKey& key, std::string_view text, const std::string& file)
{
    const std::string plain = plainText(text);
    Diagnostics errors;
    if (isTomlKind(key.kind)) {
        const auto leaves = parseToml(plain, file);
        if (leaves)
            return readTomlObject(key, *leaves, file);
        errors = {leaves.error()};
    } else {
        auto object = readTextObject(key, plain, file);
        if (object)
            return object;
        errors = std::move(object).error();
    }
    for (Diagnostic& error : errors)
        error.place.object = key;
    return errors;
}

std::string toTextKeeping(const Object& object, std::string_view before)
{
    const auto was = fromText(object.key, before);
    if (was && *was == object)
        return std::string(before);
    const TextForm form = formOf(before);
    if (was) {
        auto text = patched(plainText(before), *was, object);
        const auto is = text ? fromText(object.key, *text) : Result<Object, Diagnostics>(Diagnostics{});
        if (is && *is == object)
            return formed(std::move(*text), form);
    }
    return formed(toText(object), form);
}

} // namespace camwright
