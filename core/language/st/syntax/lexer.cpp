#include "core/language/st/syntax/lexer.h"

#include "core/language/source/letters.h"
#include "core/language/st/syntax/timeliterals.h"

#include <array>
#include <charconv>

namespace camwright::st {

namespace {

enum class Class : std::uint8_t { Other, Letter, Digit, Blank, LineEnd, Foreign };

constexpr std::array<Class, 256> Classes = [] {
    std::array<Class, 256> out{};
    for (unsigned c = 0; c < 256; ++c) {
        const bool letter = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_';
        out[c] = letter ? Class::Letter
            : c >= '0' && c <= '9' ? Class::Digit
            : c == ' ' || c == '\t' || c == '\r' ? Class::Blank
            : c == '\n' ? Class::LineEnd
            : c >= 0x80 || c < 0x20 || c == 0x7F ? Class::Foreign
            : Class::Other;
    }
    return out;
}();

Class classOf(char c)
{
    return Classes[static_cast<unsigned char>(c)];
}

bool isWordByte(char c)
{
    return classOf(c) == Class::Letter || classOf(c) == Class::Digit;
}

int digitOf(char c)
{
    return c >= '0' && c <= '9' ? c - '0' : c >= 'a' && c <= 'f' ? c - 'a' + 10 : c >= 'A' && c <= 'F' ? c - 'A' + 10 : 99;
}

} // namespace

void Lexer::report(Code code, std::size_t from, std::size_t to, std::vector<std::string> arguments)
{
    m_sink.add(code, m_lines.range(static_cast<std::uint32_t>(from), static_cast<std::uint32_t>(to)), std::move(arguments));
}

Token Lexer::next()
{
    while (skipBlanks()) {
    }
    Token token;
    token.offset = static_cast<std::uint32_t>(m_at);
    token.startsLine = std::exchange(m_startsLine, false);
    if (m_at < m_text.size()) {
        switch (classOf(m_text[m_at])) {
        case Class::Letter: readWord(token); break;
        case Class::Digit: readNumber(token); break;
        case Class::Foreign: readForeign(token); break;
        default: readSymbol(token); break;
        }
    }
    token.end = static_cast<std::uint32_t>(m_at);
    return token;
}

/// Skips blanks, or one comment or pragma; false when a token begins.
bool Lexer::skipBlanks()
{
    for (; m_at < m_text.size(); ++m_at) {
        const Class c = classOf(m_text[m_at]);
        if (c == Class::LineEnd)
            m_startsLine = true;
        else if (c != Class::Blank)
            break;
    }
    return m_at < m_text.size() && skipComment();
}

bool Lexer::skipComment()
{
    const char first = m_text[m_at];
    const char second = at(m_at + 1);
    if (first == '{') {
        skipPragma();
    } else if (first == '(' && second == '*') {
        skipNested("(*", "*)");
    } else if (first == '/' && second == '*') {
        skipNested("/*", "*/");
    } else if (first == '/' && second == '/') {
        for (; m_at < m_text.size() && m_text[m_at] != '\n'; ++m_at)
            checkForeign();
    } else {
        return false;
    }
    return true;
}

void Lexer::skipNested(std::string_view open, std::string_view close)
{
    const std::size_t begin = m_at;
    std::size_t depth = 0;
    while (m_at < m_text.size()) {
        if (startsWith(open)) {
            ++depth;
            m_at += 2;
        } else if (startsWith(close)) {
            m_at += 2;
            if (--depth == 0)
                return;
        } else {
            m_startsLine |= m_text[m_at] == '\n';
            checkForeign();
            ++m_at;
        }
    }
    m_endsEarly = true;
    report(Code::CommentOpenAtEnd, begin, begin + 2);
}

void Lexer::skipPragma()
{
    const std::size_t begin = m_at;
    for (; m_at < m_text.size() && m_text[m_at] != '}'; ++m_at) {
        m_startsLine |= m_text[m_at] == '\n';
        checkForeign();
    }
    m_endsEarly = m_at >= m_text.size();
    if (!m_endsEarly)
        ++m_at;
    else
        report(Code::StPragmaOpen, begin, begin + 1);
}

/// Inside comments and strings: text that is not UTF-8, cannot be seen, or turns the reading direction. Leaves m_at at the
/// last byte of the character.
void Lexer::checkForeign()
{
    if (classOf(m_text[m_at]) != Class::Foreign)
        return;
    const Utf8Character character = characterAt(m_text, m_at);
    if (!character.legal)
        report(Code::SourceNotUtf8, m_at, m_at + 1, {codePointName(static_cast<unsigned char>(m_text[m_at])).substr(4)});
    else if (isOddCharacter(character.code) && !(m_at == 0 && character.code == 0xFEFF))
        report(Code::OddCharacter, m_at, m_at + character.length, {codePointName(character.code)});
    m_at += character.length - 1;
}

void Lexer::readWord(Token& token)
{
    const std::size_t begin = m_at;
    while (m_at < m_text.size() && isWordByte(m_text[m_at]))
        ++m_at;
    const std::string_view text = m_text.substr(begin, m_at - begin);
    if (at(m_at) == '#' && text.size() <= 13 && readPrefixed(token))
        return;
    token.kind = TokenKind::Name;
    if (text.size() > LongestName) {
        report(Code::StBadName, begin, m_at, {shortened(text), std::to_string(LongestName)});
        token.name = m_names.intern(text.substr(0, LongestName));
        return;
    }
    token.name = m_names.intern(text);
    token.word = Names::wordOf(token.name);
    if (token.word != Word::None)
        token.kind = TokenKind::Word;
    else if (text.back() == '_' || text.find("__") != std::string_view::npos)
        report(Code::StBadName, begin, m_at, {shortened(text), std::to_string(LongestName)});
    if (m_at < m_text.size() && classOf(m_text[m_at]) == Class::Foreign && static_cast<unsigned char>(m_text[m_at]) >= 0x80)
        readForeign(token);
}

/// T#…, DATE#… and their like; false if the word is not one of them.
bool Lexer::readPrefixed(Token& token)
{
    const std::string_view prefix = m_text.substr(token.offset, m_at - token.offset);
    const std::optional<TokenKind> kind = timeLiteralKind(prefix);
    if (!kind)
        return false;
    const std::size_t begin = ++m_at;
    const bool isDuration = *kind == TokenKind::Duration || *kind == TokenKind::LongDuration;
    const bool isDate = *kind == TokenKind::Date || *kind == TokenKind::LongDate;
    skipLiteral(isDuration ? "." : isDate ? "-" : "-:.");
    const std::string_view text = m_text.substr(begin, m_at - begin);
    const std::optional<std::int64_t> value = isDuration ? parseDuration(text) : parseDate(*kind, text);
    token.kind = *kind;
    token.value = static_cast<std::uint64_t>(value.value_or(0));
    if (!value) {
        token.kind = TokenKind::Bad;
        const std::string whole = shortened(m_text.substr(token.offset, m_at - token.offset));
        report(isDuration ? Code::StBadDuration : Code::StBadDate, token.offset, m_at, {whole, std::string(exampleOf(*kind))});
    }
    return true;
}

void Lexer::skipLiteral(std::string_view allowed)
{
    if (at(m_at) == '-' || at(m_at) == '+')
        ++m_at;
    while (m_at < m_text.size()) {
        const bool range = m_text[m_at] == '.' && at(m_at + 1) == '.';
        if (range || (!isWordByte(m_text[m_at]) && allowed.find(m_text[m_at]) == std::string_view::npos))
            return;
        ++m_at;
    }
}

void Lexer::skipDigits()
{
    while (classOf(at(m_at)) == Class::Digit || (at(m_at) == '_' && classOf(at(m_at + 1)) == Class::Digit))
        ++m_at;
}

void Lexer::readNumber(Token& token)
{
    const std::size_t begin = m_at;
    token.kind = TokenKind::Integer;
    bool tooLarge = false;
    for (; m_at < m_text.size(); ++m_at) {
        const char c = m_text[m_at];
        if (c == '_' && classOf(at(m_at + 1)) == Class::Digit)
            continue;
        if (classOf(c) != Class::Digit)
            break;
        const unsigned digit = static_cast<unsigned>(c - '0');
        tooLarge |= token.value > (UINT64_MAX - digit) / 10;
        token.value = token.value * 10 + digit;
    }
    if (at(m_at) == '#' && (token.value == 2 || token.value == 8 || token.value == 16))
        return readBased(token, static_cast<unsigned>(token.value));
    const bool isReal = at(m_at) == '.' && classOf(at(m_at + 1)) == Class::Digit;
    if (isReal || ((at(m_at) | 0x20) == 'e' && (classOf(at(m_at + 1)) == Class::Digit || ((at(m_at + 1) == '-' || at(m_at + 1) == '+') && classOf(at(m_at + 2)) == Class::Digit))))
        return readReal(token);
    if (isWordByte(at(m_at))) {
        while (isWordByte(at(m_at)))
            ++m_at;
        token.kind = TokenKind::Bad;
        return report(Code::StBadNumber, begin, m_at, {shortened(m_text.substr(begin, m_at - begin)), "1000, 16#3E8, 10.5"});
    }
    if (tooLarge) {
        token.kind = TokenKind::Bad;
        report(Code::StNumberTooLarge, begin, m_at, {shortened(m_text.substr(begin, m_at - begin), 40)});
    }
}

void Lexer::readBased(Token& token, unsigned base)
{
    const std::size_t digits = ++m_at;
    bool isBad = false;
    bool tooLarge = false;
    token.value = 0;
    token.isBased = true;
    for (; isWordByte(at(m_at)); ++m_at) {
        if (m_text[m_at] == '_' && m_at > digits && isWordByte(at(m_at + 1)) && at(m_at + 1) != '_')
            continue;
        const auto digit = static_cast<unsigned>(digitOf(m_text[m_at]));
        isBad |= digit >= base;
        tooLarge |= token.value > (UINT64_MAX - digit) / base;
        token.value = token.value * base + digit;
    }
    const std::string text = shortened(m_text.substr(token.offset, m_at - token.offset), 40);
    if (isBad || m_at == digits) {
        token.kind = TokenKind::Bad;
        report(Code::StBadNumber, token.offset, m_at, {text, base == 16 ? "16#3E8" : base == 8 ? "8#1750" : "2#1010"});
    } else if (tooLarge) {
        token.kind = TokenKind::Bad;
        report(Code::StNumberTooLarge, token.offset, m_at, {text});
    }
}

void Lexer::readReal(Token& token)
{
    token.kind = TokenKind::Real;
    if (at(m_at) == '.') {
        ++m_at;
        skipDigits();
    }
    if ((at(m_at) | 0x20) == 'e') {
        m_at += at(m_at + 1) == '-' || at(m_at + 1) == '+' ? 2 : 1;
        skipDigits();
    }
    std::string digits(m_text.substr(token.offset, m_at - token.offset));
    std::erase(digits, '_');
    double value = 0;
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
    if (error == std::errc::result_out_of_range) {
        token.kind = TokenKind::Bad;
        report(Code::StNumberTooLarge, token.offset, m_at, {shortened(digits, 40)});
    }
    if (isWordByte(at(m_at))) {
        while (isWordByte(at(m_at)))
            ++m_at;
        report(Code::StBadNumber, token.offset, m_at, {shortened(m_text.substr(token.offset, m_at - token.offset)), "10.5, 1.5E3"});
        token.kind = TokenKind::Bad;
    }
    token.value = std::bit_cast<std::uint64_t>(value);
}

/// Strings end on their line. Escapes are only passed over here; their meaning is looked up where the value is needed.
void Lexer::readText(Token& token)
{
    const char quote = m_text[m_at++];
    token.kind = quote == '\'' ? TokenKind::Text : TokenKind::WideText;
    for (; m_at < m_text.size() && m_text[m_at] != '\n'; ++m_at) {
        if (m_text[m_at] == quote) {
            ++m_at;
            return;
        }
        if (m_text[m_at] == '$' && m_at + 1 < m_text.size() && m_text[m_at + 1] != '\n')
            ++m_at;
        checkForeign();
    }
    token.kind = TokenKind::Bad;
    report(Code::StTextOpen, token.offset, token.offset + 1);
}

void Lexer::readAddress(Token& token)
{
    ++m_at;
    while (isWordByte(at(m_at)) || (at(m_at) == '.' && isWordByte(at(m_at + 1))) || at(m_at) == '*')
        ++m_at;
    token.kind = TokenKind::Address;
    if (m_at != token.offset + 1u)
        return;
    token.kind = TokenKind::Bad;
    report(Code::StBadAddress, token.offset, m_at, {"%"});
}

/// A letter that is not of the alphabet of names, at the beginning or inside of a word.
void Lexer::readForeign(Token& token)
{
    const std::size_t begin = token.offset;
    const Utf8Character first = characterAt(m_text, m_at);
    const bool isOdd = !first.legal || isOddCharacter(first.code) || isOddBlank(first.code);
    if (isOdd) {
        checkForeign();
        if (isOddBlank(first.code) && first.legal)
            report(Code::OddCharacter, begin, m_at + 1, {codePointName(first.code)});
        ++m_at;
    } else {
        while (m_at < m_text.size() && (isWordByte(m_text[m_at]) || static_cast<unsigned char>(m_text[m_at]) >= 0x80)) {
            const Utf8Character character = characterAt(m_text, m_at);
            if (!character.legal || isOddCharacter(character.code))
                break;
            m_at += character.length;
        }
        const std::string_view word = m_text.substr(begin, m_at - begin);
        const std::string latin = withLatinLetters(word);
        const std::string lookalike = firstLookalike(word);
        if (lookalike.empty())
            report(Code::StBadName, begin, m_at, {shortened(word), std::to_string(LongestName)});
        else
            report(Code::LookalikeLetters, begin, m_at, {shortened(word), lookalike, shortened(latin)});
    }
    if (token.kind != TokenKind::Name)
        token.kind = TokenKind::Bad;
}

void Lexer::readSymbol(Token& token)
{
    const char first = m_text[m_at];
    const char second = at(m_at + 1);
    const auto one = [&](TokenKind kind) { token.kind = kind; ++m_at; };
    const auto two = [&](TokenKind kind) { token.kind = kind; m_at += 2; };
    switch (first) {
    case ';': return one(TokenKind::Semicolon);
    case ':': return second == '=' ? two(TokenKind::Assign) : one(TokenKind::Colon);
    case '?': if (second == '=') return two(TokenKind::Attempt); break;
    case '=': return second == '>' ? two(TokenKind::Output) : one(TokenKind::Equal);
    case '<': return second == '>' ? two(TokenKind::NotEqual) : second == '=' ? two(TokenKind::LessEqual) : one(TokenKind::Less);
    case '>': return second == '=' ? two(TokenKind::GreaterEqual) : one(TokenKind::Greater);
    case '+': return one(TokenKind::Plus);
    case '-': return one(TokenKind::Minus);
    case '*': return second == '*' ? two(TokenKind::Power) : one(TokenKind::Times);
    case '/': return one(TokenKind::Divide);
    case '&': return one(TokenKind::Ampersand);
    case '(': return one(TokenKind::OpenParen);
    case ')': return one(TokenKind::CloseParen);
    case '[': return one(TokenKind::OpenBracket);
    case ']': return one(TokenKind::CloseBracket);
    case ',': return one(TokenKind::Comma);
    case '.': return second == '.' ? two(TokenKind::Range) : one(TokenKind::Dot);
    case '^': return one(TokenKind::Caret);
    case '#': return one(TokenKind::Hash);
    case '%': return readAddress(token);
    case '\'':
    case '"': return readText(token);
    default: break;
    }
    one(TokenKind::Bad);
    report(Code::StStrayCharacter, token.offset, m_at, {std::string(1, first)});
}

} // namespace camwright::st
