#include "core/language/assist/fixscene.h"

#include <algorithm>

namespace camwright {

FixScene::FixScene(const Project& all, const LanguageContext& known, const Diagnostic& what)
    : project(all), context(known), problem(what)
{
    if (const auto* program = all.content<Program>(what.place.object); program && program->language == ProgramLanguage::InstructionList)
        source = program->source;
}

const std::string& FixScene::argument(std::size_t n) const
{
    static const std::string none;
    return n >= 1 && n <= problem.arguments.size() ? problem.arguments[n - 1] : none;
}

std::size_t FixScene::offsetOf(std::uint32_t line, std::uint32_t column) const
{
    std::size_t begin = 0;
    for (std::uint32_t n = 1; n < line; ++n) {
        const std::size_t end = source.find('\n', begin);
        if (end == std::string::npos)
            return source.size();
        begin = end + 1;
    }
    const std::size_t end = std::min(source.find('\n', begin), source.size());
    return std::min(begin + (column == 0 ? 0 : column - 1), end);
}

std::size_t FixScene::lineEnd(std::uint32_t line) const
{
    const std::size_t begin = lineBegin(line);
    std::size_t end = std::min(source.find('\n', begin), source.size());
    if (end > begin && source[end - 1] == '\r')
        --end;
    return end;
}

std::size_t FixScene::nextLine(std::uint32_t line) const
{
    const std::size_t end = source.find('\n', lineBegin(line));
    return end == std::string::npos ? source.size() : end + 1;
}

std::string_view FixScene::textAt(const TextRange& range) const
{
    if (!range.isValid())
        return {};
    const std::size_t begin = offsetOf(range.line, range.column), end = offsetOf(range.endLine, range.endColumn);
    return end < begin ? std::string_view() : std::string_view(source).substr(begin, end - begin);
}

std::vector<Token> FixScene::tokensOf(std::uint32_t line) const
{
    std::vector<Token> tokens;
    LineState state = LineState::Code;
    std::size_t begin = 0;
    for (std::uint32_t n = 1; n <= line; ++n) {
        tokens.clear();
        const std::size_t end = std::min(source.find('\n', begin), source.size());
        std::string_view text = std::string_view(source).substr(begin, end - begin);
        if (text.ends_with('\r'))
            text.remove_suffix(1);
        state = tokenizeLine(*context.dialect, text, state, tokens);
        if (end == source.size())
            return n == line ? tokens : std::vector<Token>();
        begin = end + 1;
    }
    return tokens;
}

const ParsedProgram& FixScene::parsed()
{
    if (!m_parsed)
        m_parsed = parseIl(*context.dialect, source, problem.place.object);
    return *m_parsed;
}

std::optional<FixScene::Found> FixScene::statement()
{
    const auto& networks = parsed().networks;
    for (std::size_t n = 0; n < networks.size(); ++n)
        for (std::size_t r = 0; r < networks[n].rungs.size(); ++r) {
            const auto& statements = networks[n].rungs[r].rung.statements;
            for (std::size_t s = 0; s < statements.size(); ++s)
                if (statements[s].range.line == range().line && statements[s].range.column == range().column)
                    return Found{n, r, s};
        }
    return std::nullopt;
}

const Statement& FixScene::at(const Found& found)
{
    return parsed().networks[found.network].rungs[found.rung].rung.statements[found.statement];
}

std::size_t FixScene::networkOffset(std::size_t network)
{
    std::size_t out = parsed().prologue.size();
    for (std::size_t n = 0; n < network; ++n) {
        const ParsedNetwork& before = parsed().networks[n];
        out += before.header.size() + before.tail.size();
        for (const ParsedRung& rung : before.rungs)
            out += rung.source.size();
    }
    return out;
}

FixScene::FoundOperand FixScene::operand()
{
    if (!m_resolved) {
        const auto* program = project.content<Program>(problem.place.object);
        Diagnostics ignored;
        m_resolved = resolve(parsed(), program ? program->role : ProgramRole::Main, context, ignored);
    }
    for (const ResolvedNetwork& network : m_resolved->networks)
        for (const ResolvedRung& rung : network.rungs)
            for (const ResolvedStatement& statement : rung.statements)
                for (const ResolvedOperand& operand : statement.operands)
                    if (operand.range.isValid() && operand.range == range())
                        return {&statement, &operand};
    return {};
}

void FixScene::offer(const char* sentence, std::vector<std::string> arguments, std::vector<TextEdit> edits, std::vector<Object> objects)
{
    fixes.push_back({sentence, std::move(arguments), std::move(edits), std::move(objects)});
}

void FixScene::replace(const char* sentence, const TextRange& where, std::string with)
{
    const std::size_t begin = offsetOf(where.line, where.column);
    offer(sentence, {std::string(textAt(where)), with}, {{begin, textAt(where).size(), with}});
}

void FixScene::removeLine(const char* sentence, std::uint32_t line)
{
    const std::size_t begin = lineBegin(line);
    offer(sentence, {std::string(lineText(line))}, {{begin, nextLine(line) - begin, {}}});
}

std::vector<TextEdit> FixScene::renumbered(std::size_t network, std::uint32_t number)
{
    std::vector<TextEdit> out;
    for (std::size_t n = network; n < parsed().networks.size(); ++n, ++number) {
        const std::string& header = parsed().networks[n].header;
        const std::size_t begin = header.find_first_of("0123456789");
        if (begin == std::string::npos || parsed().networks[n].number == number)
            continue;
        const std::size_t end = std::min(header.find_first_not_of("0123456789", begin), header.size());
        out.push_back({networkOffset(n) + begin, end - begin, std::to_string(number)});
    }
    return out;
}

} // namespace camwright
