#include "core/language/source/koyodialect.h"

#include "core/language/source/letters.h"
#include "core/language/source/token.h"

#include <algorithm>

namespace camwright {

namespace {

struct Synonym {
    std::string_view number, mnemonic;
};

/// The boxes have a number and a name (sheet section 11); the catalogue goes by the name.
constexpr Synonym Boxes[] = {
    {"IB-2000", "ML_NOP"},
    {"IB-2001", "ML_PRRD"},
    {"IB-2002", "ML_PRWR"},
    {"IB-2004", "ML_CONF"},
    {"IB-2005", "ML_ALRD"},
    {"IB-2006", "ML_ALCL"},
    {"IB-2011", "ML_PPWR"},
    {"IB-2012", "ML_PSET"},
    {"IB-2013", "ML_BRON"},
    {"IB-2014", "ML_BROF"},
    {"IB-2015", "ML_SEON"},
    {"IB-2016", "ML_SEOF"},
    {"IB-2017", "ML_HOLD"},
    {"IB-2020", "ML_SMON"},
    {"IB-2021", "ML_SVON"},
    {"IB-2022", "ML_SVOF"},
    {"IB-2023", "ML_POSI"},
    {"IB-2024", "ML_FEED"},
    {"IB-2025", "ML_EPOS"},
    {"IB-2026", "ML_ZRET"},
    {"IB-2027", "ML_VLCT"},
    {"IB-2028", "ML_TQCT"},
    {"IB-2040", "ML_IP11"},
    {"IB-2041", "ML_IP21"},
    {"IB-2042", "ML_IP22"},
    {"IB-2043", "ML_IP31"},
    {"IB-2044", "ML_IP32"},
    {"IB-2045", "ML_IP41"},
    {"IB-2046", "ML_IP42"},
    {"IB-2047", "ML_IP43"},
};

bool isOneOf(std::string_view word, std::initializer_list<std::string_view> words)
{
    return std::find(words.begin(), words.end(), word) != words.end();
}

bool isHexDigit(char c)
{
    return isDigit(c) || (c >= 'A' && c <= 'F') || (c >= 'a' && c <= 'f');
}

/// V1400, R1400, TA0, CTA0: a word, not a bit of one.
bool isWordAddress(std::string_view text)
{
    const std::string upper = upperCase(text);
    const std::string_view all = upper;
    const std::size_t letters = std::min(all.find_first_not_of("ABCDEFGHIJKLMNOPQRSTUVWXYZ"), all.size());
    const bool isWord = isOneOf(all.substr(0, letters), {"V", "R", "TA", "CTA"});
    return isWord && letters < all.size() && std::all_of(all.begin() + static_cast<std::ptrdiff_t>(letters), all.end(), isDigit);
}

bool comparesWords(const Statement& statement)
{
    return statement.operands.size() == 2 && (statement.form == ContactForm::NormallyOpen || statement.form == ContactForm::NormallyClosed);
}

} // namespace

void settleKoyoStatement(Statement& statement)
{
    using enum StatementRole;
    const bool isContact = statement.role == Load || statement.role == And || statement.role == Or;
    if (isContact && comparesWords(statement)) {
        statement.form = statement.form == ContactForm::NormallyOpen ? ContactForm::GreaterEqual : ContactForm::Less;
        return;
    }
    const bool hasWordForm = isOneOf(upperCase(statement.mnemonic), {"OUT", "AND", "OR"});
    const bool takesWord = statement.operands.size() == 1
        && (isWordAddress(statement.operands.front().text) || (statement.role != Output && koyoConstant(statement.operands.front().text)));
    if (hasWordForm && takesWord) {
        statement.role = Block;
        statement.form = ContactForm::None;
    }
}

std::string koyoCatalogueName(std::string_view mnemonic, StatementRole role, ContactForm form)
{
    const std::string name = upperCase(mnemonic);
    if (role == StatementRole::Block && isOneOf(name, {"OUT", "AND", "OR"}))
        return name + "W";
    if (form == ContactForm::GreaterEqual && isOneOf(name, {"STR", "AND", "OR"}))
        return name + ">=";
    if (form == ContactForm::Less && isOneOf(name, {"STRN", "ANDN", "ORN"}))
        return name.substr(0, name.size() - 1) + "<";
    return koyoCatalogueName(mnemonic);
}

std::string koyoCatalogueName(std::string_view mnemonic)
{
    const std::string name = upperCase(mnemonic);
    for (const Synonym& box : Boxes)
        if (box.number == name)
            return std::string(box.mnemonic);
    return std::string(mnemonic);
}

unsigned koyoFlowsOf(std::string_view mnemonic)
{
    const std::string name = upperCase(shortened(mnemonic, 16));
    return name == "UDC" ? 3 : isOneOf(name, {"CNT", "TMRA", "TMRAF"}) ? 2 : 1;
}

bool standsAlone(std::string_view mnemonic)
{
    return mnemonic.size() <= 4 && isOneOf(upperCase(mnemonic), {"SBR", "RT", "NEXT"});
}

std::optional<std::string> koyoConstant(std::string_view text)
{
    if (text.size() < 2)
        return std::nullopt;
    const std::string_view digits = text.substr(1);
    if ((text.front() == 'K' || text.front() == 'k') && std::all_of(digits.begin(), digits.end(), isHexDigit))
        return "16#" + std::string(digits);
    const bool isOctal = std::all_of(digits.begin(), digits.end(), [](char c) { return c >= '0' && c <= '7'; });
    if ((text.front() == 'O' || text.front() == 'o') && isOctal)
        return "8#" + std::string(digits);
    return std::nullopt;
}

std::string subroutineNumber(std::string_view text)
{
    std::vector<Token> tokens;
    LineState state = LineState::Code;
    while (!text.empty()) {
        const std::size_t end = std::min(text.find('\n'), text.size());
        std::string_view line = text.substr(0, end);
        if (line.ends_with('\r'))
            line.remove_suffix(1);
        text.remove_prefix(std::min(end + 1, text.size()));
        tokens.clear();
        state = tokenizeLine(koyoIl(), line, state, tokens);
        std::erase_if(tokens, [](const Token& token) { return token.kind == TokenKind::Comment || token.kind == TokenKind::NetworkHeader; });
        if (tokens.empty())
            continue;
        const auto word = [&](std::size_t i) { return upperCase(trimmed(line.substr(tokens[i].column, tokens[i].length))); };
        return tokens.size() > 1 && word(0) == "SBR" && koyoConstant(word(1)) ? word(1) : std::string();
    }
    return {};
}

} // namespace camwright
