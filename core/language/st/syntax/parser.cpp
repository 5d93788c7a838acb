#include "core/language/st/syntax/parser.h"

#include "core/language/source/letters.h"

namespace camwright::st {

namespace {

std::string symbolText(TokenKind kind)
{
    switch (kind) {
    case TokenKind::Semicolon: return "\";\"";
    case TokenKind::Colon: return "\":\"";
    case TokenKind::Assign: return "\":=\"";
    case TokenKind::Comma: return "\",\"";
    case TokenKind::OpenParen: return "\"(\"";
    case TokenKind::CloseParen: return "\")\"";
    case TokenKind::OpenBracket: return "\"[\"";
    case TokenKind::CloseBracket: return "\"]\"";
    case TokenKind::Range: return "\"..\"";
    case TokenKind::Hash: return "\"#\"";
    default: return "\"=>\"";
    }
}

} // namespace

Parser::Parser(const TextLines& lines, Names& names, Arena& arena, DiagnosticSink& sink)
    : m_lines(lines), m_names(names), m_arena(arena), m_sink(sink), m_lexer(lines, names, sink), m_token(m_lexer.next()), m_ahead(m_lexer.next())
{
}

void Parser::advance()
{
    m_lastEnd = m_token.end;
    m_token = m_ahead;
    m_ahead = m_lexer.next();
}

bool Parser::accept(TokenKind kind)
{
    if (m_token.kind != kind)
        return false;
    advance();
    return true;
}

bool Parser::accept(Word word)
{
    if (!m_token.is(word))
        return false;
    advance();
    return true;
}

std::string Parser::found() const
{
    return m_token.is(TokenKind::End) ? std::string(CW_TEXT("Arguments", "the end of the text")) : "\"" + shortened(m_lexer.textOf(m_token), 40) + "\"";
}

/// Reports unless the token is part of what is wrong already: reported by the lexer, or where the last message stands.
void Parser::report(Code code, const Token& token, std::vector<std::string> arguments)
{
    const bool isCut = m_token.is(TokenKind::End) && m_lexer.endsEarly();
    const bool isSilent = token.is(TokenKind::Bad) || isCut || (m_hasFailed && token.offset < m_silentUntil);
    if (!isSilent)
        m_sink.add(code, rangeOf(token), std::move(arguments));
    m_hasFailed = true;
    m_silentUntil = token.offset + 1;
}

void Parser::unexpected(std::string expected)
{
    report(Code::StExpected, m_token, {found(), std::move(expected)});
}

/// Something is missing behind the token before this one.
void Parser::missing(std::string what)
{
    if (m_token.is(TokenKind::Bad) || (m_token.is(TokenKind::End) && m_lexer.endsEarly()) || (m_hasFailed && m_token.offset < m_silentUntil))
        return;
    m_sink.add(Code::StMissing, m_lines.range(m_lastEnd, m_lastEnd), {std::move(what)});
    m_hasFailed = true;
    m_silentUntil = m_token.offset + 1;
}

bool Parser::expect(TokenKind kind)
{
    if (accept(kind))
        return true;
    if (m_token.startsLine || m_token.is(TokenKind::End))
        missing(symbolText(kind));
    else
        unexpected(symbolText(kind));
    return false;
}

bool Parser::expect(Word word)
{
    if (accept(word))
        return true;
    if (m_token.startsLine || startsStatement())
        missing(std::string(wordText(word)));
    else
        unexpected(std::string(wordText(word)));
    return false;
}

const Token* Parser::expectName()
{
    if (m_token.is(TokenKind::Name))
        return &m_token;
    if (m_token.is(TokenKind::Word) && !startsDeclaration() && !isAtEndWord()) {
        report(Code::StWordAsName, m_token, {std::string(wordText(m_token.word))});
        return &m_token;
    }
    unexpected(CW_TEXT("Arguments", "a name"));
    return nullptr;
}

/// Whether nesting has become too deep; said once, at the innermost.
bool Parser::tooDeep()
{
    if (m_depth <= DeepestNesting)
        return false;
    report(Code::StTooDeep, m_token, {std::to_string(DeepestNesting)});
    return true;
}

bool Parser::isAtEndWord() const
{
    return m_token.is(TokenKind::End) || (m_token.is(TokenKind::Word) && wordText(m_token.word).starts_with("END_"));
}

bool Parser::startsDeclaration() const
{
    switch (m_token.word) {
    case Word::PROGRAM:
    case Word::FUNCTION:
    case Word::FUNCTION_BLOCK:
    case Word::INTERFACE:
    case Word::TYPE:
    case Word::CONFIGURATION:
    case Word::VAR_GLOBAL: return true;
    default: return m_token.is(TokenKind::End);
    }
}

Unit Parser::parse()
{
    Unit unit;
    while (!m_token.is(TokenKind::End)) {
        parseDeclaration(unit);
        m_depth = 0;
        m_awaited.fill(0);
    }
    return unit;
}

void Parser::parseDeclaration(Unit& unit)
{
    switch (m_token.word) {
    case Word::PROGRAM: return unit.pous.add(parsePou(PouKind::Program, Word::END_PROGRAM));
    case Word::FUNCTION: return unit.pous.add(parsePou(PouKind::Function, Word::END_FUNCTION));
    case Word::FUNCTION_BLOCK: return unit.pous.add(parsePou(PouKind::FunctionBlock, Word::END_FUNCTION_BLOCK));
    case Word::INTERFACE: return unit.pous.add(parsePou(PouKind::Interface, Word::END_INTERFACE));
    case Word::TYPE: return parseTypes(unit);
    case Word::CONFIGURATION: return parseConfiguration(unit);
    case Word::VAR_GLOBAL: parseSection(unit.globals); return;
    default: break;
    }
    if (accept(TokenKind::Semicolon))
        return;
    report(Code::StOutside, m_token, {found()});
    skipToDeclaration();
}

void Parser::skipToDeclaration()
{
    do {
        advance();
    } while (!startsDeclaration());
    m_hasFailed = false;
}

Pou* Parser::parsePou(PouKind kind, Word end)
{
    Pou* pou = make<Pou>();
    pou->kind = kind;
    advance();
    parseModifiers(*pou);
    parsePouHead(*pou);
    parsePouParts(*pou);
    closePou(*pou, end);
    return pou;
}

void Parser::parseModifiers(Pou& pou)
{
    for (;; advance()) {
        if (m_token.is(Word::ABSTRACT))
            pou.isAbstract = true;
        else if (m_token.is(Word::FINAL))
            pou.isFinal = true;
        else if (m_token.is(Word::OVERRIDE))
            pou.isOverride = true;
        else if (m_token.is(Word::PRIVATE) || m_token.is(Word::PROTECTED))
            pou.isPrivate = true;
        else if (!m_token.is(Word::PUBLIC) && !m_token.is(Word::INTERNAL))
            return;
    }
}

void Parser::parsePouHead(Pou& pou)
{
    if (const Token* name = expectName()) {
        pou.name = name->name;
        pou.offset = name->offset;
        pou.end = name->end;
        advance();
    }
    if (accept(TokenKind::Colon))
        pou.result = parseSpec();
    if (accept(Word::EXTENDS)) {
        if (pou.kind == PouKind::Interface)
            parseNameList(pou.implements);
        else
            pou.extends = parseNameUse();
    }
    if (accept(Word::IMPLEMENTS))
        parseNameList(pou.implements);
    accept(TokenKind::Semicolon);
}

void Parser::parsePouParts(Pou& pou)
{
    for (;;) {
        if (parseSection(pou.variables))
            continue;
        if (!m_token.is(Word::METHOD))
            break;
        pou.methods.add(parseMethod(pou.kind == PouKind::Interface));
    }
    if (pou.kind != PouKind::Interface)
        parseBody(pou.body);
    while (m_token.is(Word::METHOD)) // allowed behind the body too
        pou.methods.add(parseMethod(false));
}

Pou* Parser::parseMethod(bool isPrototype)
{
    Pou* method = make<Pou>();
    method->kind = PouKind::Method;
    advance();
    parseModifiers(*method);
    parsePouHead(*method);
    while (parseSection(method->variables)) {
    }
    if (!isPrototype && !method->isAbstract)
        parseBody(method->body);
    closePou(*method, Word::END_METHOD);
    return method;
}

NameUse* Parser::parseNameUse()
{
    const Token* token = expectName();
    if (!token)
        return nullptr;
    NameUse* use = make<NameUse>();
    use->name = token->name;
    use->offset = token->offset;
    use->end = token->end;
    advance();
    return use;
}

void Parser::parseNameList(List<NameUse>& list)
{
    do {
        if (NameUse* use = parseNameUse())
            list.add(use);
    } while (accept(TokenKind::Comma));
}

/// The END_… of a POU. One of another kind is taken for it; where a new declaration begins, it is missing.
void Parser::closePou(Pou& pou, Word end)
{
    pou.bodyEnd = m_token.offset;
    if (accept(end)) {
        accept(TokenKind::Semicolon);
        return;
    }
    Token name = m_token;
    name.kind = TokenKind::Name;
    name.offset = pou.offset;
    name.end = pou.end;
    if (startsDeclaration() || m_token.is(Word::METHOD)) {
        m_hasFailed = false;
        return report(Code::StNotClosed, name, {std::string(m_names.text(pou.name)), std::string(wordText(end))});
    }
    unexpected(std::string(wordText(end)));
    if (isAtEndWord())
        advance();
    else
        skipToDeclaration();
}

} // namespace camwright::st
