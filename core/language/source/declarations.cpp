#include "core/language/source/declarations.h"

#include "core/language/source/letters.h"

#include <algorithm>

namespace camwright {

namespace {

struct Section {
    std::string_view word;
    ParameterKind kind;
};
constexpr Section Sections[] = {{"VAR_INPUT", ParameterKind::In}, {"VAR_OUTPUT", ParameterKind::Out},
                                {"VAR_IN_OUT", ParameterKind::InOut}, {"VAR_TEMP", ParameterKind::Temp}};

constexpr DataType Types[] = {DataType::Bool, DataType::Int, DataType::Dint, DataType::Word, DataType::Dword, DataType::Real};

constexpr std::string_view Example = "IN1 : INT;";

std::string_view firstWord(std::string_view text)
{
    return text.substr(0, std::min(text.find_first_of(" \t"), text.size()));
}

/// TS-VAR-03, without the words that only the project knows.
bool isName(std::string_view text)
{
    if (text.empty() || isDigit(text.front()) || text.front() == '_')
        return false;
    return std::all_of(text.begin(), text.end(), [](char c) { return !isAscii(c) || isAsciiLetter(c) || isDigit(c) || c == '_'; });
}

} // namespace

void DeclarationReader::report(Code code, std::string_view line, std::uint32_t number, std::vector<std::string> arguments)
{
    if (!m_sink)
        return;
    const std::size_t begin = line.find_first_not_of(" \t");
    const auto column = static_cast<std::uint32_t>(begin + 1);
    const auto end = static_cast<std::uint32_t>(begin + trimmed(line).size() + 1);
    m_sink->add(code, {number, column, number, end}, std::move(arguments));
}

bool DeclarationReader::read(std::string_view line, std::uint32_t number)
{
    const std::string_view text = trimmed(line);
    if (m_dialect.id != DialectId::Ts600Il || text.empty())
        return false;
    if (!m_section)
        return begin(line, number);
    const std::string word = upperCase(firstWord(text));
    if (word == "END_VAR" || word == "END_VAR;") {
        m_section.reset();
        return true;
    }
    if (readParameter(line, number))
        return true;
    report(Code::BadParameter, line, number, {shortened(text), std::string(Example)});
    if (m_dialect.shapeOf(word).role != StatementRole::Load)
        return true;
    m_section.reset(); // END_VAR was forgotten: what follows is the program
    return false;
}

bool DeclarationReader::begin(std::string_view line, std::uint32_t number)
{
    const std::string_view text = trimmed(line);
    const std::string word = upperCase(firstWord(text));
    for (const Section& section : Sections)
        if (word == section.word) {
            m_section = section.kind;
            if (const std::string_view rest = trimmed(text.substr(word.size())); !rest.empty())
                report(Code::BadParameter, line, number, {shortened(text), std::string(section.word)});
            return true;
        }
    if (word != "EVENT")
        return false;
    const auto column = static_cast<std::uint32_t>(line.find_first_not_of(" \t") + 1);
    m_out.event = EventText{std::string(trimmed(text.substr(word.size()))), {number, column, number, column + static_cast<std::uint32_t>(text.size())}};
    return true;
}

bool DeclarationReader::readParameter(std::string_view line, std::uint32_t number)
{
    std::string_view text = trimmed(line);
    if (text.ends_with(';'))
        text = trimmed(text.substr(0, text.size() - 1));
    const std::size_t colon = text.find(':');
    if (colon == std::string_view::npos)
        return false;
    const std::string_view name = trimmed(text.substr(0, colon));
    const auto type = dataTypeByName(upperCase(trimmed(text.substr(colon + 1))));
    if (!isName(name) || !type || std::find(std::begin(Types), std::end(Types), *type) == std::end(Types))
        return false;
    if (std::ranges::find(m_out.parameters, name, &Parameter::name) != m_out.parameters.end())
        return false;
    const auto column = static_cast<std::uint32_t>(line.find_first_not_of(" \t") + 1);
    m_out.parameters.push_back({std::string(name), *m_section, *type, {number, column, number, column + static_cast<std::uint32_t>(name.size())}});
    return true;
}

std::string withoutComments(std::string_view line, const std::vector<Token>& tokens)
{
    std::string out(line);
    for (const Token& token : tokens)
        if (token.kind == TokenKind::Comment)
            std::fill_n(out.begin() + token.column, token.length, ' ');
    return out;
}

Declarations declarationsOf(const Dialect& dialect, std::string_view text)
{
    Declarations out;
    DeclarationReader reader(dialect, out, nullptr);
    LineState state = LineState::Code;
    std::uint32_t number = 0;
    while (!text.empty() && dialect.id == DialectId::Ts600Il) {
        const std::size_t end = std::min(text.find('\n'), text.size());
        std::string_view line = text.substr(0, end);
        text.remove_prefix(std::min(end + 1, text.size()));
        if (line.ends_with('\r'))
            line.remove_suffix(1);
        std::vector<Token> tokens;
        state = tokenizeLine(dialect, line, state, tokens);
        const std::string plain = withoutComments(line, tokens);
        if (!reader.read(plain, ++number) && !trimmed(plain).empty())
            return out;
    }
    return out;
}

} // namespace camwright
