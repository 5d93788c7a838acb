#include "core/language/st/syntax/parser.h"

#include <algorithm>

namespace camwright::st {

// The part of Parser for expressions.

namespace {

struct Level {
    Operator op = Operator::None;
    int level = 0;
};

constexpr int TightestLevel = 8;

/// The binary operator a token is and how tightly it binds (IEC 61131-3, table 71); level 0: none.
Level levelOf(const Token& token)
{
    switch (token.kind) {
    case TokenKind::Ampersand: return {Operator::And, 3};
    case TokenKind::Equal: return {Operator::Equal, 4};
    case TokenKind::NotEqual: return {Operator::NotEqual, 4};
    case TokenKind::Less: return {Operator::Less, 5};
    case TokenKind::Greater: return {Operator::Greater, 5};
    case TokenKind::LessEqual: return {Operator::LessEqual, 5};
    case TokenKind::GreaterEqual: return {Operator::GreaterEqual, 5};
    case TokenKind::Plus: return {Operator::Add, 6};
    case TokenKind::Minus: return {Operator::Subtract, 6};
    case TokenKind::Times: return {Operator::Multiply, 7};
    case TokenKind::Divide: return {Operator::Divide, 7};
    case TokenKind::Power: return {Operator::Power, TightestLevel};
    case TokenKind::Word: break;
    default: return {};
    }
    switch (token.word) {
    case Word::OR: return {Operator::Or, 1};
    case Word::XOR: return {Operator::Xor, 2};
    case Word::AND: return {Operator::And, 3};
    case Word::MOD: return {Operator::Modulo, 7};
    default: return {};
    }
}

/// Words that are functions too: AND(a, b).
bool isFunctionWord(Word word)
{
    return word == Word::AND || word == Word::OR || word == Word::XOR || word == Word::MOD || word == Word::NOT;
}

std::uint16_t depthOf(const Expr* expr)
{
    return expr ? expr->depth : std::uint16_t{0};
}

} // namespace

Expr* Parser::node(ExprKind kind)
{
    Expr* expr = m_arena.make<Expr>();
    expr->kind = kind;
    expr->offset = m_token.offset;
    expr->end = m_token.end;
    return expr;
}

Expr* Parser::bad()
{
    return node(ExprKind::Bad);
}

/// Ends a node behind the last token, and counts how deep the tree is below it: stages walk it by recursion.
Expr* Parser::finish(Expr* expr)
{
    expr->end = m_lastEnd;
    expr->depth = static_cast<std::uint16_t>(std::max({depthOf(expr->left), depthOf(expr->right), expr->depth}) + 1);
    if (expr->depth <= LongestChain)
        return expr;
    report(Code::StTooLong, m_token, {std::to_string(LongestChain)});
    return bad();
}

Expr* Parser::parseBinary(int level)
{
    ++m_depth;
    Expr* out = parseRest(parseUnary(), level);
    --m_depth;
    return out;
}

Expr* Parser::parseRest(Expr* left, int level)
{
    for (;;) {
        const Level next = levelOf(m_token);
        if (next.level < level || next.level == 0)
            return left;
        Expr* binary = node(ExprKind::Binary);
        binary->offset = left->offset;
        binary->op = next.op;
        binary->left = left;
        advance();
        binary->right = parseBinary(next.level + 1);
        left = finish(binary);
    }
}

Expr* Parser::parseUnary()
{
    Operator op = Operator::None;
    if (m_token.is(TokenKind::Minus))
        op = Operator::Negate;
    else if (m_token.is(TokenKind::Plus))
        op = Operator::Plus;
    else if (m_token.is(Word::NOT))
        op = Operator::Not;
    if (op == Operator::None)
        return parsePostfix();
    Expr* unary = node(ExprKind::Unary);
    unary->op = op;
    ++m_depth;
    if (tooDeep()) {
        --m_depth;
        advance();
        return bad();
    }
    advance();
    unary->left = parseUnary();
    --m_depth;
    return finish(unary);
}

Expr* Parser::parsePostfix()
{
    Expr* expr = parsePrimary();
    for (;;) {
        ExprKind kind = ExprKind::Bad;
        switch (m_token.kind) {
        case TokenKind::Dot: kind = ExprKind::Member; break;
        case TokenKind::OpenBracket: kind = ExprKind::Index; break;
        case TokenKind::OpenParen: kind = ExprKind::Call; break;
        case TokenKind::Caret: kind = ExprKind::Dereference; break;
        default: return expr;
        }
        if (expr->kind == ExprKind::Literal)
            return expr;
        Expr* outer = node(kind);
        outer->offset = expr->offset;
        outer->left = expr;
        advance();
        if (kind == ExprKind::Member)
            parseMemberName(*outer);
        else if (kind == ExprKind::Index)
            parseArguments(*outer, TokenKind::CloseBracket);
        else if (kind == ExprKind::Call)
            parseArguments(*outer, TokenKind::CloseParen);
        expr = finish(outer);
    }
}

/// A name, or the number of a bit: `.3` or `.%X3`.
void Parser::parseMemberName(Expr& member)
{
    if (m_token.is(TokenKind::Integer)) {
        member.value = m_token.value;
        member.isBased = true;
        return advance();
    }
    if (m_token.is(TokenKind::Address)) {
        const std::string_view text = m_lexer.textOf(m_token);
        unsigned bit = 0;
        const bool isBit = text.size() >= 3 && text.size() <= 4 && (text[1] | 0x20) == 'x';
        for (const char c : text.substr(isBit ? 2 : text.size()))
            bit = bit * 10 + static_cast<unsigned>(c - '0');
        if (isBit && bit < 64) {
            member.value = bit;
            member.isBased = true;
            return advance();
        }
    }
    const Token* name = expectName();
    if (!name) {
        member.kind = ExprKind::Bad;
        return;
    }
    member.name = name->name;
    advance();
}

Expr* Parser::literal(TokenKind kind)
{
    Expr* expr = node(ExprKind::Literal);
    expr->literal = kind;
    expr->value = m_token.value;
    expr->isBased = m_token.isBased;
    expr->name = m_token.name;
    advance();
    return expr;
}

Expr* Parser::parsePrimary()
{
    switch (m_token.kind) {
    case TokenKind::Name: return parseName();
    case TokenKind::Integer:
    case TokenKind::Real:
    case TokenKind::Duration:
    case TokenKind::LongDuration:
    case TokenKind::Date:
    case TokenKind::LongDate:
    case TokenKind::TimeOfDay:
    case TokenKind::LongTimeOfDay:
    case TokenKind::DateTime:
    case TokenKind::LongDateTime:
    case TokenKind::Text:
    case TokenKind::WideText: return literal(m_token.kind);
    case TokenKind::Address: {
        Expr* expr = node(ExprKind::Address);
        advance();
        return expr;
    }
    case TokenKind::OpenBracket: {
        Expr* expr = node(ExprKind::Aggregate);
        advance();
        expr->isBased = true; // of an array
        parseArguments(*expr, TokenKind::CloseBracket);
        return finish(expr);
    }
    case TokenKind::OpenParen: return parseParenthesis();
    case TokenKind::Word: return parseWord();
    default: break;
    }
    unexpected(CW_TEXT("Arguments", "an expression"));
    Expr* expr = bad();
    if (m_token.is(TokenKind::Bad)) {
        advance();
        m_silentUntil = m_token.offset + 1; // what it has swallowed may be missing now
    }
    return expr;
}

/// An expression in parentheses, or the members of a structure: (a := 1, b := 2).
Expr* Parser::parseParenthesis()
{
    Expr* aggregate = node(ExprKind::Aggregate);
    if (tooDeep()) {
        aggregate->kind = ExprKind::Bad;
        advance();
        return aggregate;
    }
    advance();
    if ((m_token.is(TokenKind::Name) && m_ahead.is(TokenKind::Assign)) || m_token.is(TokenKind::CloseParen)) {
        parseArguments(*aggregate, TokenKind::CloseParen);
        return finish(aggregate);
    }
    Expr* expr = parseExpression();
    if (expr->kind != ExprKind::Bad || !(m_hasFailed && m_token.offset < m_silentUntil))
        expect(TokenKind::CloseParen);
    else
        accept(TokenKind::CloseParen);
    expr->offset = aggregate->offset;
    expr->end = m_lastEnd;
    return expr;
}

Expr* Parser::parseWord()
{
    switch (m_token.word) {
    case Word::TRUE:
    case Word::FALSE:
    case Word::NULL_: return literal(TokenKind::Word);
    case Word::THIS:
    case Word::SUPER: {
        Expr* expr = node(m_token.is(Word::THIS) ? ExprKind::This : ExprKind::Super);
        advance();
        return expr;
    }
    case Word::STRING:
    case Word::WSTRING:
        if (m_ahead.is(TokenKind::Hash))
            return parseName();
        break;
    default:
        if (isFunctionWord(m_token.word) && m_ahead.is(TokenKind::OpenParen))
            return parseName();
        break;
    }
    unexpected(CW_TEXT("Arguments", "an expression"));
    return bad();
}

/// A name, or a name in front of #: INT#5, COLOUR#RED.
Expr* Parser::parseName()
{
    Expr* expr = node(ExprKind::Name);
    expr->name = m_token.name;
    advance();
    if (!m_token.is(TokenKind::Hash))
        return expr;
    advance();
    expr->kind = ExprKind::Typed;
    const bool isNegative = m_token.is(TokenKind::Minus) || m_token.is(TokenKind::Plus);
    if (isNegative) {
        expr->left = parseUnary();
    } else if (m_token.is(TokenKind::Name)) {
        expr->left = node(ExprKind::Name);
        expr->left->name = m_token.name;
        advance();
    } else {
        expr->left = parsePrimary();
    }
    return finish(expr);
}

void Parser::parseArguments(Expr& owner, TokenKind end)
{
    ++m_depth;
    if (tooDeep()) {
        --m_depth;
        return recoverStatement();
    }
    if (!accept(end)) {
        do {
            Argument* argument = parseArgument();
            owner.arguments.add(argument);
            owner.depth = std::max({owner.depth, depthOf(argument->value), depthOf(argument->repetition)});
        } while (accept(TokenKind::Comma));
        expect(end);
    }
    --m_depth;
}

Argument* Parser::parseArgument()
{
    Argument* argument = m_arena.make<Argument>();
    argument->offset = m_token.offset;
    if (m_token.is(Word::NOT) && m_ahead.is(TokenKind::Name)) { // NOT q => x, or the expression NOT x
        const Token negation = m_token;
        advance();
        if (m_ahead.is(TokenKind::Output)) {
            argument->isNegated = true;
        } else {
            argument->value = negated(negation);
            argument->end = m_lastEnd;
            return argument;
        }
    }
    if (m_token.is(TokenKind::Name) && (m_ahead.is(TokenKind::Assign) || m_ahead.is(TokenKind::Output))) {
        argument->name = m_token.name;
        argument->isOutput = m_ahead.is(TokenKind::Output);
        advance();
        advance();
        if (m_token.is(TokenKind::Comma) || m_token.is(TokenKind::CloseParen)) {
            argument->end = m_lastEnd;
            return argument;
        }
    }
    if (m_token.is(TokenKind::Integer) && m_ahead.is(TokenKind::OpenParen)) {
        argument->repetition = literal(TokenKind::Integer);
        argument->value = node(ExprKind::Aggregate);
        argument->value->isBased = true;
        advance();
        parseArguments(*argument->value, TokenKind::CloseParen);
        finish(argument->value);
    } else {
        argument->value = parseExpression();
    }
    argument->end = m_lastEnd;
    return argument;
}

/// The rest of an expression that begins with a NOT that has been read.
Expr* Parser::negated(const Token& negation)
{
    Expr* unary = node(ExprKind::Unary);
    unary->op = Operator::Not;
    unary->offset = negation.offset;
    unary->left = parsePostfix();
    return parseRest(finish(unary), 1);
}

} // namespace camwright::st
