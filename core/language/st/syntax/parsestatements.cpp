#include "core/language/st/syntax/parser.h"

namespace camwright::st {

// The part of Parser for statements.

namespace {

bool isStatementEnd(Word word)
{
    return word == Word::END_IF || word == Word::END_CASE || word == Word::END_FOR || word == Word::END_WHILE || word == Word::END_REPEAT;
}

bool separatesBranches(Word word)
{
    return word == Word::ELSE || word == Word::ELSIF || word == Word::UNTIL;
}

} // namespace

bool Parser::startsStatement() const
{
    switch (m_token.kind) {
    case TokenKind::Name:
    case TokenKind::Address:
    case TokenKind::Semicolon: return true;
    case TokenKind::Word: break;
    default: return false;
    }
    switch (m_token.word) {
    case Word::IF:
    case Word::CASE:
    case Word::FOR:
    case Word::WHILE:
    case Word::REPEAT:
    case Word::EXIT:
    case Word::CONTINUE:
    case Word::RETURN:
    case Word::THIS:
    case Word::SUPER: return true;
    default: return false;
    }
}

/// The statements of a POU; an END_… or ELSE that belongs to nothing is reported and passed over.
void Parser::parseBody(List<Statement>& out)
{
    for (;;) {
        parseStatements(out);
        const bool isStray = m_token.is(TokenKind::Word) && (isStatementEnd(m_token.word) || separatesBranches(m_token.word));
        if (!isStray)
            return;
        m_hasFailed = false;
        report(Code::StStrayEnd, m_token, {std::string(wordText(m_token.word))});
        advance();
        if (!m_token.startsLine)
            recoverStatement();
        else
            accept(TokenKind::Semicolon);
    }
}

void Parser::parseStatements(List<Statement>& out)
{
    while (!isAtEndWord() && !startsDeclaration() && !m_token.is(Word::METHOD) && !(m_token.is(TokenKind::Word) && separatesBranches(m_token.word))) {
        if (m_awaited[static_cast<std::size_t>(Word::END_CASE)] > 0 && startsCaseLabel())
            return;
        if (accept(TokenKind::Semicolon))
            continue;
        if (!startsStatement()) {
            unexpected(CW_TEXT("Arguments", "a statement"));
            advance();
            recoverStatement();
            continue;
        }
        out.add(parseStatement());
    }
}

Statement* Parser::parseStatement()
{
    Statement* statement = make<Statement>();
    statement->offset = m_token.offset;
    ++m_depth;
    if (tooDeep()) {
        advance();
        recoverStatement();
    } else {
        switch (m_token.word) {
        case Word::IF: parseIf(*statement); break;
        case Word::CASE: parseCase(*statement); break;
        case Word::FOR: parseFor(*statement); break;
        case Word::WHILE: parseWhile(*statement); break;
        case Word::REPEAT: parseRepeat(*statement); break;
        default: parseSimple(*statement); break;
        }
    }
    --m_depth;
    statement->end = m_lastEnd;
    if (statement->headEnd == 0)
        statement->headEnd = m_lastEnd;
    return statement;
}

/// Assignments, calls, EXIT and their like, with their semicolon.
void Parser::parseSimple(Statement& statement)
{
    if (accept(Word::EXIT)) {
        statement.kind = StatementKind::Exit;
    } else if (accept(Word::CONTINUE)) {
        statement.kind = StatementKind::Continue;
    } else if (accept(Word::RETURN)) {
        statement.kind = StatementKind::Return;
    } else {
        statement.target = parsePostfix();
        const bool isBad = statement.target->kind == ExprKind::Bad;
        if (m_token.is(TokenKind::Assign) || m_token.is(TokenKind::Attempt) || (m_token.is(TokenKind::Equal) && !isBad)) {
            statement.kind = m_token.is(TokenKind::Attempt) ? StatementKind::Attempt : StatementKind::Assign;
            if (m_token.is(TokenKind::Equal))
                report(Code::StEqualsForAssign, m_token);
            advance();
            statement.value = parseExpression();
        } else if (statement.target->kind == ExprKind::Call) {
            statement.kind = StatementKind::Call;
        } else if (!isBad) {
            if (m_token.startsLine || m_token.is(TokenKind::Semicolon))
                missing("\":=\"");
            else
                unexpected("\":=\"");
        }
    }
    statement.headEnd = m_lastEnd;
    if (!expectSemicolon()) {
        recoverStatement();
        statement.kind = StatementKind::Empty; // half of it says nothing about the rest
    }
}

/// A semicolon. Where another line, a statement or an end begins it is just missing, and nothing is skipped.
bool Parser::expectSemicolon()
{
    if (accept(TokenKind::Semicolon)) {
        m_hasFailed = false;
        return true;
    }
    const bool wasSilent = m_hasFailed && m_token.offset < m_silentUntil;
    if (!m_token.startsLine && !isAtEndWord() && !startsDeclaration()) {
        if (wasSilent || !startsStatement() || m_token.is(TokenKind::Name)) {
            unexpected(std::string("\";\""));
            return false;
        }
    }
    missing("\";\"");
    return true;
}

/// To behind the next semicolon, or to where a statement begins on a line of its own, or a block ends.
void Parser::recoverStatement()
{
    while (!isAtEndWord() && !startsDeclaration() && !(m_token.startsLine && (startsStatement() || m_token.is(TokenKind::Word)))) {
        if (m_token.is(TokenKind::Word) && (separatesBranches(m_token.word) || m_token.is(Word::METHOD)))
            return;
        if (accept(TokenKind::Semicolon))
            return;
        advance();
    }
}

/// The END_… of a statement. Missing where something around it ends first; taken for it where nothing else awaits it.
void Parser::close(const Token& opener, Word end)
{
    --m_awaited[static_cast<std::size_t>(end)];
    if (accept(end)) {
        expectSemicolon();
        return;
    }
    const bool isForeign = m_token.is(TokenKind::Word) && isStatementEnd(m_token.word) && m_awaited[static_cast<std::size_t>(m_token.word)] == 0;
    if (isForeign) {
        unexpected(std::string(wordText(end)));
        advance();
        accept(TokenKind::Semicolon);
        return;
    }
    m_hasFailed = false;
    report(Code::StNotClosed, opener, {std::string(wordText(opener.word)), std::string(wordText(end))});
}

void Parser::parseIf(Statement& statement)
{
    const Token opener = m_token;
    statement.kind = StatementKind::If;
    ++m_awaited[static_cast<std::size_t>(Word::END_IF)];
    do {
        Branch* branch = make<Branch>();
        branch->offset = m_token.offset;
        advance();
        branch->condition = parseExpression();
        branch->end = m_lastEnd;
        if (statement.headEnd == 0)
            statement.headEnd = m_lastEnd;
        expect(Word::THEN);
        parseStatements(branch->body);
        statement.branches.add(branch);
    } while (m_token.is(Word::ELSIF));
    if (m_token.is(Word::ELSE)) {
        statement.otherwise = make<Branch>();
        advance();
        parseStatements(statement.otherwise->body);
    }
    close(opener, Word::END_IF);
}

/// Whether a label of a CASE begins here rather than a statement.
bool Parser::startsCaseLabel()
{
    switch (m_token.kind) {
    case TokenKind::Integer:
    case TokenKind::Minus:
    case TokenKind::OpenParen: return true;
    case TokenKind::Name:
        return m_ahead.is(TokenKind::Colon) || m_ahead.is(TokenKind::Comma) || m_ahead.is(TokenKind::Range) || m_ahead.is(TokenKind::Hash);
    case TokenKind::Word: return m_token.is(Word::TRUE) || m_token.is(Word::FALSE);
    default: return false;
    }
}

void Parser::parseCase(Statement& statement)
{
    const Token opener = m_token;
    statement.kind = StatementKind::Case;
    advance();
    statement.target = parseExpression();
    statement.headEnd = m_lastEnd;
    expect(Word::OF);
    ++m_awaited[static_cast<std::size_t>(Word::END_CASE)];
    while (!isAtEndWord() && !startsDeclaration() && !(m_token.is(TokenKind::Word) && separatesBranches(m_token.word)) && !m_token.is(Word::METHOD)) {
        if (startsCaseLabel()) {
            parseCaseBranch(statement);
            continue;
        }
        unexpected(CW_TEXT("Arguments", "a label of the CASE"));
        advance();
        recoverStatement();
    }
    if (accept(Word::ELSE)) {
        accept(TokenKind::Colon);
        statement.otherwise = make<Branch>();
        parseStatements(statement.otherwise->body);
    }
    close(opener, Word::END_CASE);
}

void Parser::parseCaseBranch(Statement& statement)
{
    Branch* branch = make<Branch>();
    branch->offset = m_token.offset;
    do {
        CaseLabel* label = make<CaseLabel>();
        label->low = parseExpression();
        label->high = accept(TokenKind::Range) ? parseExpression() : nullptr;
        branch->labels.add(label);
    } while (accept(TokenKind::Comma));
    branch->end = m_lastEnd;
    if (!expect(TokenKind::Colon))
        recoverStatement();
    parseStatements(branch->body);
    statement.branches.add(branch);
}

void Parser::parseFor(Statement& statement)
{
    const Token opener = m_token;
    statement.kind = StatementKind::For;
    advance();
    statement.target = parsePostfix();
    expect(TokenKind::Assign);
    statement.value = parseExpression();
    expect(Word::TO);
    statement.limit = parseExpression();
    statement.step = accept(Word::BY) ? parseExpression() : nullptr;
    statement.headEnd = m_lastEnd;
    if (!expect(Word::DO))
        accept(Word::THEN);
    ++m_awaited[static_cast<std::size_t>(Word::END_FOR)];
    parseStatements(statement.body);
    close(opener, Word::END_FOR);
}

void Parser::parseWhile(Statement& statement)
{
    const Token opener = m_token;
    statement.kind = StatementKind::While;
    advance();
    statement.value = parseExpression();
    statement.headEnd = m_lastEnd;
    if (!expect(Word::DO))
        accept(Word::THEN);
    ++m_awaited[static_cast<std::size_t>(Word::END_WHILE)];
    parseStatements(statement.body);
    close(opener, Word::END_WHILE);
}

void Parser::parseRepeat(Statement& statement)
{
    const Token opener = m_token;
    statement.kind = StatementKind::Repeat;
    advance();
    ++m_awaited[static_cast<std::size_t>(Word::END_REPEAT)];
    parseStatements(statement.body);
    statement.headEnd = m_token.offset;
    if (expect(Word::UNTIL))
        statement.value = parseExpression();
    else
        statement.value = bad();
    accept(TokenKind::Semicolon);
    close(opener, Word::END_REPEAT);
}

} // namespace camwright::st
