#include "core/language/st/syntax/parser.h"

namespace camwright::st {

// The part of Parser for variables, types and configurations.

namespace {

struct SectionWord {
    Word word;
    Section section;
};

constexpr SectionWord SectionWords[] = {
    {Word::VAR, Section::Local}, {Word::VAR_INPUT, Section::Input}, {Word::VAR_OUTPUT, Section::Output}, {Word::VAR_IN_OUT, Section::InOut},
    {Word::VAR_EXTERNAL, Section::External}, {Word::VAR_GLOBAL, Section::Global}, {Word::VAR_TEMP, Section::Temp},
};

} // namespace

/// One VAR … END_VAR; false if none begins here.
bool Parser::parseSection(List<Variable>& out)
{
    Variable pattern;
    bool found = false;
    for (const SectionWord& s : SectionWords) {
        if (m_token.is(s.word)) {
            pattern.section = s.section;
            found = true;
        }
    }
    if (!found)
        return false;
    advance();
    for (; !m_ahead.is(TokenKind::Colon); advance()) {
        if (m_token.is(Word::CONSTANT))
            pattern.isConstant = true;
        else if (m_token.is(Word::RETAIN))
            pattern.isRetain = true;
        else if (!m_token.is(Word::NON_RETAIN) && !m_token.is(Word::PUBLIC) && !m_token.is(Word::PRIVATE) && !m_token.is(Word::PROTECTED) && !m_token.is(Word::INTERNAL))
            break;
    }
    parseVariables(pattern, out);
    expect(Word::END_VAR);
    accept(TokenKind::Semicolon);
    return true;
}

void Parser::parseVariables(const Variable& pattern, List<Variable>& out)
{
    while (!isAtEndWord() && !startsDeclaration() && !isStatementHere()) {
        const std::uint32_t before = m_token.offset;
        parseVariableLine(pattern, out);
        if (m_token.offset == before && !isAtEndWord() && !startsDeclaration())
            advance();
    }
}

/// Whether a statement begins where a declaration should: the END_VAR before it is missing.
bool Parser::isStatementHere() const
{
    if (!m_token.startsLine)
        return false;
    if (m_token.is(TokenKind::Name))
        return m_ahead.is(TokenKind::Assign) || m_ahead.is(TokenKind::OpenParen) || m_ahead.is(TokenKind::OpenBracket) || m_ahead.is(TokenKind::Dot);
    return startsStatement() && !m_ahead.is(TokenKind::Colon);
}

/// `a, b AT %X : TYPE := value;`. After an error the rest of the line is skipped.
void Parser::parseVariableLine(const Variable& pattern, List<Variable>& out)
{
    List<Variable> line;
    do {
        const Token* name = expectName();
        if (!name)
            return skipToLineEnd(Word::END_VAR);
        Variable* variable = make<Variable>();
        *variable = pattern;
        variable->name = name->name;
        variable->offset = name->offset;
        variable->end = name->end;
        advance();
        line.add(variable);
    } while (accept(TokenKind::Comma));
    Expr* location = nullptr;
    if (accept(Word::AT)) {
        location = node(ExprKind::Address);
        if (!m_token.is(TokenKind::Address)) {
            unexpected(CW_TEXT("Arguments", "an address"));
            return skipToLineEnd(Word::END_VAR);
        }
        advance();
        finish(location);
    }
    TypeSpec* spec = nullptr;
    Expr* initial = nullptr;
    if (!expect(TokenKind::Colon))
        skipToLineEnd(Word::END_VAR);
    else if (spec = parseSpec(); spec->kind == SpecKind::Bad)
        skipToLineEnd(Word::END_VAR);
    else {
        const bool rising = accept(Word::R_EDGE);
        const bool falling = !rising && accept(Word::F_EDGE);
        for (Variable& variable : line) {
            variable.isRisingEdge = rising;
            variable.isFallingEdge = falling;
        }
        initial = accept(TokenKind::Assign) ? parseExpression() : nullptr;
        if (!expectSemicolon())
            skipToLineEnd(Word::END_VAR);
    }
    for (Variable* variable = line.first; variable;) {
        Variable* next = std::exchange(variable->next, nullptr);
        variable->location = location;
        variable->spec = spec;
        variable->initial = initial;
        out.add(variable);
        variable = next;
    }
}

/// To behind the next semicolon, or to where another line or declaration begins.
void Parser::skipToLineEnd(Word end)
{
    unsigned open = 0;
    while (!m_token.is(TokenKind::End) && !m_token.is(end) && !isAtEndWord() && !startsDeclaration()) {
        if (m_token.is(TokenKind::Semicolon) || (m_token.startsLine && open == 0))
            break;
        open += m_token.is(TokenKind::OpenParen) || m_token.is(TokenKind::OpenBracket);
        open -= open > 0 && (m_token.is(TokenKind::CloseParen) || m_token.is(TokenKind::CloseBracket));
        advance();
    }
    accept(TokenKind::Semicolon);
}

void Parser::parseTypes(Unit& unit)
{
    const Token opener = m_token;
    advance();
    while (!isAtEndWord() && !startsDeclaration()) {
        const Token* name = expectName();
        if (!name) {
            advance();
            skipToLineEnd(Word::END_TYPE);
            continue;
        }
        TypeDeclaration* type = make<TypeDeclaration>();
        type->name = name->name;
        type->offset = name->offset;
        type->end = name->end;
        advance();
        if (!expect(TokenKind::Colon)) {
            skipToLineEnd(Word::END_TYPE);
            continue;
        }
        type->spec = parseSpec();
        type->initial = accept(TokenKind::Assign) ? parseExpression() : nullptr;
        unit.types.add(type);
        if (type->spec->kind == SpecKind::Bad)
            skipToLineEnd(Word::END_TYPE);
        else if (!accept(TokenKind::Semicolon) && type->spec->kind != SpecKind::Struct && !expectSemicolon())
            skipToLineEnd(Word::END_TYPE);
    }
    if (!accept(Word::END_TYPE))
        report(Code::StNotClosed, opener, {"TYPE", "END_TYPE"});
    accept(TokenKind::Semicolon);
}

TypeSpec* Parser::parseSpec()
{
    TypeSpec* spec = make<TypeSpec>();
    spec->offset = m_token.offset;
    ++m_depth;
    if (!tooDeep()) {
        if (m_token.is(Word::ARRAY))
            parseArraySpec(*spec);
        else if (m_token.is(Word::STRUCT))
            parseStructSpec(*spec);
        else if (m_token.is(Word::STRING) || m_token.is(Word::WSTRING))
            parseTextSpec(*spec);
        else if (accept(Word::REF_TO)) {
            spec->kind = SpecKind::Reference;
            spec->element = parseSpec();
        } else if (m_token.is(TokenKind::OpenParen))
            parseEnumSpec(*spec);
        else if (m_token.is(TokenKind::Name))
            parseNamedSpec(*spec);
        else
            unexpected(CW_TEXT("Arguments", "a type"));
    }
    --m_depth;
    spec->end = m_lastEnd;
    return spec;
}

/// A name; behind it perhaps the range of a subrange or the values of an enumeration.
TypeSpec* Parser::parseNamedSpec(TypeSpec& spec)
{
    spec.kind = SpecKind::Named;
    spec.name = m_token.name;
    advance();
    if (!m_token.is(TokenKind::OpenParen))
        return &spec;
    const bool isEnum = m_ahead.is(TokenKind::Name);
    if (isEnum) {
        parseEnumSpec(spec);
        return &spec;
    }
    advance();
    spec.kind = SpecKind::Subrange;
    parseBounds(spec.bounds, TokenKind::CloseParen);
    return &spec;
}

void Parser::parseTextSpec(TypeSpec& spec)
{
    spec.kind = SpecKind::Text;
    spec.isWide = m_token.is(Word::WSTRING);
    advance();
    const bool bracket = m_token.is(TokenKind::OpenBracket);
    if (!bracket && !m_token.is(TokenKind::OpenParen))
        return;
    advance();
    spec.size = parseExpression();
    expect(bracket ? TokenKind::CloseBracket : TokenKind::CloseParen);
}

void Parser::parseBounds(List<Bounds>& out, TokenKind end)
{
    do {
        Bounds* bounds = make<Bounds>();
        bounds->low = parseExpression();
        if (!expect(TokenKind::Range))
            break;
        bounds->high = parseExpression();
        out.add(bounds);
    } while (accept(TokenKind::Comma));
    expect(end);
}

void Parser::parseArraySpec(TypeSpec& spec)
{
    spec.kind = SpecKind::Array;
    advance();
    if (expect(TokenKind::OpenBracket))
        parseBounds(spec.bounds, TokenKind::CloseBracket);
    if (!expect(Word::OF) || spec.bounds.empty()) {
        spec.kind = SpecKind::Bad;
        return;
    }
    spec.element = parseSpec();
    if (spec.element->kind == SpecKind::Bad)
        spec.kind = SpecKind::Bad;
}

void Parser::parseStructSpec(TypeSpec& spec)
{
    const Token opener = m_token;
    spec.kind = SpecKind::Struct;
    advance();
    Variable pattern;
    pattern.section = Section::Member;
    parseVariables(pattern, spec.members);
    if (!accept(Word::END_STRUCT))
        report(Code::StNotClosed, opener, {"STRUCT", "END_STRUCT"});
}

void Parser::parseEnumSpec(TypeSpec& spec)
{
    spec.kind = SpecKind::Enum;
    advance();
    do {
        const Token* name = expectName();
        if (!name)
            break;
        EnumValue* value = make<EnumValue>();
        value->name = name->name;
        value->offset = name->offset;
        value->end = name->end;
        advance();
        value->value = accept(TokenKind::Assign) ? parseExpression() : nullptr;
        spec.values.add(value);
    } while (accept(TokenKind::Comma));
    if (!expect(TokenKind::CloseParen))
        spec.kind = SpecKind::Bad;
    else if (spec.name == 0 && m_token.is(TokenKind::Name)) { // (A, B) INT, as other tools write it
        spec.name = m_token.name;
        advance();
    }
}

void Parser::parseConfiguration(Unit& unit)
{
    Configuration* configuration = make<Configuration>();
    const Token opener = m_token;
    advance();
    if (const Token* name = expectName()) {
        configuration->name = name->name;
        configuration->offset = name->offset;
        configuration->end = name->end;
        advance();
    }
    parseResourceParts(unit, *configuration, Word::END_CONFIGURATION);
    unit.configurations.add(configuration);
    if (!accept(Word::END_CONFIGURATION))
        report(Code::StNotClosed, opener, {"CONFIGURATION", "END_CONFIGURATION"});
    accept(TokenKind::Semicolon);
}

/// What a configuration holds, and a resource inside it too.
void Parser::parseResourceParts(Unit& unit, Configuration& configuration, Word end)
{
    while (!m_token.is(end) && !m_token.is(TokenKind::End)) {
        if (parseSection(unit.globals) || accept(TokenKind::Semicolon))
            continue;
        if (m_token.is(Word::TASK)) {
            parseTask(configuration);
        } else if (m_token.is(Word::PROGRAM)) {
            parseProgramInstance(configuration);
        } else if (m_token.is(Word::RESOURCE) && end == Word::END_CONFIGURATION) {
            const Token opener = m_token;
            advance();
            if (expectName())
                advance();
            if (accept(Word::ON) && expectName())
                advance();
            parseResourceParts(unit, configuration, Word::END_RESOURCE);
            if (!accept(Word::END_RESOURCE))
                report(Code::StNotClosed, opener, {"RESOURCE", "END_RESOURCE"});
        } else if (isAtEndWord() || startsDeclaration()) {
            return;
        } else {
            unexpected("TASK, PROGRAM, VAR_GLOBAL");
            advance();
            skipToLineEnd(end);
        }
    }
}

void Parser::parseTask(Configuration& configuration)
{
    TaskDeclaration* task = make<TaskDeclaration>();
    advance();
    if (const Token* name = expectName()) {
        task->name = name->name;
        task->offset = name->offset;
        task->end = name->end;
        advance();
    }
    if (expect(TokenKind::OpenParen)) {
        Expr* list = node(ExprKind::Aggregate);
        parseArguments(*list, TokenKind::CloseParen);
        for (const Argument& argument : list->arguments) {
            const std::string_view name = m_names.text(argument.name);
            (isSameName(name, "INTERVAL") ? task->interval : isSameName(name, "SINGLE") ? task->single : task->priority) = argument.value;
        }
    }
    configuration.tasks.add(task);
    expectSemicolon();
}

void Parser::parseProgramInstance(Configuration& configuration)
{
    ProgramInstance* instance = make<ProgramInstance>();
    advance();
    if (!accept(Word::RETAIN))
        accept(Word::NON_RETAIN);
    if (const Token* name = expectName()) {
        instance->name = name->name;
        instance->offset = name->offset;
        instance->end = name->end;
        advance();
    }
    if (accept(Word::WITH))
        instance->task = parseNameUse();
    if (expect(TokenKind::Colon))
        instance->type = parseNameUse();
    configuration.programs.add(instance);
    if (!expectSemicolon())
        skipToLineEnd(Word::END_CONFIGURATION);
}

} // namespace camwright::st
