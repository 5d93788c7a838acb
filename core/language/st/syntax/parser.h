#pragma once

#include "core/language/st/syntax/lexer.h"
#include "core/language/st/syntax/tree.h"

#include <array>
#include <string>
#include <string_view>

namespace camwright::st {

inline constexpr unsigned DeepestNesting = 120;    ///< statements, expressions and types inside each other; ours
inline constexpr unsigned LongestChain = 1000;     ///< depth of the tree of an expression, as a + b + c + … makes it; ours

/// Reads a text into a tree, in one pass. After an error it goes on where it makes sense again: one mistake, one message.
class Parser {
public:
    Parser(const TextLines& lines, Names& names, Arena& arena, DiagnosticSink& sink);

    Unit parse();

private:
    // Tokens
    void advance();
    bool accept(TokenKind kind);
    bool accept(Word word);
    bool expect(TokenKind kind);
    bool expect(Word word);
    bool expectSemicolon();
    const Token* expectName();
    TextRange rangeOf(const Token& token) const { return m_lines.range(token.offset, token.end); }
    std::string found() const;
    void unexpected(std::string expected);
    void missing(std::string what);
    void report(Code code, const Token& token, std::vector<std::string> arguments = {});
    bool tooDeep();
    bool startsStatement() const;
    bool startsDeclaration() const;
    bool isAtEndWord() const;

    // Declarations
    void parseDeclaration(Unit& unit);
    void skipToDeclaration();
    Pou* parsePou(PouKind kind, Word end);
    void parsePouHead(Pou& pou);
    void parsePouParts(Pou& pou);
    void parseModifiers(Pou& pou);
    Pou* parseMethod(bool isPrototype);
    NameUse* parseNameUse();
    void parseNameList(List<NameUse>& list);
    void closePou(Pou& pou, Word end);
    bool parseSection(List<Variable>& out);
    void parseVariables(const Variable& pattern, List<Variable>& out);
    void parseVariableLine(const Variable& pattern, List<Variable>& out);
    void skipToLineEnd(Word end);
    bool isStatementHere() const;
    void parseTypes(Unit& unit);
    TypeSpec* parseSpec();
    TypeSpec* parseNamedSpec(TypeSpec& spec);
    void parseTextSpec(TypeSpec& spec);
    void parseArraySpec(TypeSpec& spec);
    void parseStructSpec(TypeSpec& spec);
    void parseEnumSpec(TypeSpec& spec);
    void parseBounds(List<Bounds>& out, TokenKind end);
    void parseConfiguration(Unit& unit);
    void parseResourceParts(Unit& unit, Configuration& configuration, Word end);
    void parseTask(Configuration& configuration);
    void parseProgramInstance(Configuration& configuration);

    // Statements
    void parseBody(List<Statement>& out);
    void parseStatements(List<Statement>& out);
    Statement* parseStatement();
    void parseSimple(Statement& statement);
    void parseIf(Statement& statement);
    void parseCase(Statement& statement);
    void parseCaseBranch(Statement& statement);
    bool startsCaseLabel();
    void parseFor(Statement& statement);
    void parseWhile(Statement& statement);
    void parseRepeat(Statement& statement);
    void close(const Token& opener, Word end);
    void recoverStatement();

    // Expressions
    Expr* parseExpression() { return parseBinary(1); }
    Expr* parseBinary(int level);
    Expr* parseRest(Expr* left, int level);
    Expr* parseUnary();
    Expr* parsePostfix();
    void parseMemberName(Expr& member);
    Expr* parsePrimary();
    Expr* parseParenthesis();
    Expr* parseWord();
    Expr* parseName();
    void parseArguments(Expr& owner, TokenKind end);
    Argument* parseArgument();
    Expr* negated(const Token& negation);
    Expr* literal(TokenKind kind);
    Expr* node(ExprKind kind);
    Expr* bad();
    Expr* finish(Expr* expr);

    template <class T>
    T* make() { return m_arena.make<T>(); }

    const TextLines& m_lines;
    Names& m_names;
    Arena& m_arena;
    DiagnosticSink& m_sink;
    Lexer m_lexer;
    Token m_token;
    Token m_ahead;
    std::uint32_t m_lastEnd = 0;                   ///< end of the token before m_token
    std::uint32_t m_silentUntil = 0;               ///< an error before this offset would be the consequence of another
    bool m_hasFailed = false;
    unsigned m_depth = 0;
    std::array<unsigned, static_cast<std::size_t>(Word::Count)> m_awaited{}; ///< how many open statements end with the word
};

} // namespace camwright::st
