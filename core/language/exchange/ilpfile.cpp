#include "core/language/exchange/ilpfile.h"

#include "core/language/source/headers.h"
#include "core/language/source/ilwriter.h"
#include "core/language/source/letters.h"

#include <algorithm>

namespace camwright {

namespace {

std::string withUnixLines(std::string_view text)
{
    if (text.starts_with("\xEF\xBB\xBF"))
        text.remove_prefix(3);
    std::string out;
    out.reserve(text.size());
    for (std::size_t i = 0; i < text.size(); ++i)
        if (text[i] != '\r')
            out += text[i];
        else if (i + 1 == text.size() || text[i + 1] != '\n')
            out += '\n';
    return out;
}

Diagnostic atLine(Code code, const std::string& file, std::uint32_t line, std::vector<std::string> arguments = {})
{
    return diagnostic(code, std::move(arguments), Place{{}, {}, {line, 1, line, 1}, file});
}

/// Networks the text heads.
std::uint32_t headedNetworks(const ParsedProgram& program)
{
    return static_cast<std::uint32_t>(std::count_if(program.networks.begin(), program.networks.end(),
        [](const ParsedNetwork& network) { return !network.header.empty(); }));
}

/// Takes the first line that is not blank if it is a count.
std::optional<std::uint32_t> takeCount(std::string& text)
{
    std::size_t begin = 0;
    while (begin < text.size() && (text[begin] == '\n' || isBlank(text[begin])))
        ++begin;
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    const auto count = ilpCount(std::string_view(text).substr(begin, end - begin));
    if (count)
        text.erase(0, std::min(end + 1, text.size()));
    return count;
}

/// Takes the END line; what follows it stays.
bool takeEnd(std::string& text, const ParsedProgram& program)
{
    if (program.epilogue.empty())
        return false;
    const std::size_t begin = text.size() - program.epilogue.size();
    const std::size_t line = std::min(text.find('\n', begin), text.size());
    text.erase(begin, line == text.size() ? std::string::npos : line + 1 - begin);
    return true;
}

} // namespace

IlpImport importIlp(std::string_view text, const std::string& name)
{
    IlpImport out;
    out.source = withUnixLines(text);
    const auto count = takeCount(out.source);
    const ParsedProgram program = parseIl(kincoIl(), out.source);
    const std::uint32_t found = headedNetworks(program);
    const bool ended = takeEnd(out.source, program);
    if (!count)
        out.diagnostics.push_back(atLine(Code::IlpWithoutCount, name, 1));
    else if (*count != found)
        out.diagnostics.push_back(atLine(Code::IlpCountDiffers, name, 1, {std::to_string(*count), std::to_string(found)}));
    if (!ended)
        out.diagnostics.push_back(atLine(Code::IlpWithoutEnd, name, static_cast<std::uint32_t>(std::count(text.begin(), text.end(), '\n')) + 1));
    return out;
}

std::string exportIlp(std::string_view source)
{
    const std::string plain = withUnixLines(source);
    const ParsedProgram program = parseIl(kincoIl(), plain);
    std::string body = plain.substr(0, plain.size() - program.epilogue.size());
    if (!body.empty() && !body.ends_with('\n'))
        body += '\n';
    takeCount(body);
    std::string out;
    for (const char c : "(*" + std::to_string(headedNetworks(program)) + "*)\n" + body + "END\n") {
        if (c == '\n')
            out += '\r';
        out += c;
    }
    return out;
}

} // namespace camwright
