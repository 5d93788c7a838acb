#pragma once

#include "core/language/assist/quickfix.h"
#include "core/language/check/context.h"
#include "core/language/check/resolvedprogram.h"
#include "core/language/source/ilparser.h"
#include "core/language/source/token.h"

#include <optional>
#include <string_view>

namespace camwright {

/// Where a problem stands and what may be done about it: the fixes of quickfix.cpp and flowfixes.cpp work on it.
class FixScene {
public:
    FixScene(const Project& project, const LanguageContext& context, const Diagnostic& problem);

    const Project& project;
    const LanguageContext& context;
    const Diagnostic& problem;
    std::string source;                ///< empty where the problem is not in a program
    std::vector<QuickFix> fixes;

    const std::string& argument(std::size_t n) const; ///< from 1, as in the sentences; empty if there is none
    const TextRange& range() const { return problem.place.range; }

    std::size_t offsetOf(std::uint32_t line, std::uint32_t column) const; ///< both from 1; clamped to the text
    std::size_t lineBegin(std::uint32_t line) const { return offsetOf(line, 1); }
    std::size_t lineEnd(std::uint32_t line) const;    ///< before the line's end
    std::size_t nextLine(std::uint32_t line) const;   ///< behind the line's end
    std::string_view textAt(const TextRange& range) const;
    std::string_view lineText(std::uint32_t line) const { return std::string_view(source).substr(lineBegin(line), lineEnd(line) - lineBegin(line)); }
    /// The tokens of a line, as the lexer sees it after all lines before.
    std::vector<Token> tokensOf(std::uint32_t line) const;

    const ParsedProgram& parsed();
    /// The statement whose range is the problem's, or begins there.
    struct Found {
        std::size_t network = 0, rung = 0, statement = 0;
    };
    std::optional<Found> statement();
    const Statement& at(const Found& found);
    std::size_t networkOffset(std::size_t network);   ///< where its header, or its first rung, begins
    /// The operand whose range is the problem's, with its statement; null if there is none.
    struct FoundOperand {
        const ResolvedStatement* statement = nullptr;
        const ResolvedOperand* operand = nullptr;
    };
    FoundOperand operand();

    void offer(const char* sentence, std::vector<std::string> arguments, std::vector<TextEdit> edits, std::vector<Object> objects = {});
    void replace(const char* sentence, const TextRange& range, std::string with);
    void removeLine(const char* sentence, std::uint32_t line);
    /// Edits that number the networks from `network` on, its first one `number`.
    std::vector<TextEdit> renumbered(std::size_t network, std::uint32_t number);

private:
    std::optional<ParsedProgram> m_parsed;
    std::optional<ResolvedProgram> m_resolved;
};

// One function a kind of trouble with the flow; each offers what it can.
void fixOpenComment(FixScene& scene);
void fixStatementBeforeNetwork(FixScene& scene);
void fixNetworkNumber(FixScene& scene);
void fixTextAfterEnd(FixScene& scene);
void fixMissingLoad(FixScene& scene);
void fixSecondLoad(FixScene& scene);
void fixUnusedJoin(FixScene& scene);
void fixOpenBranch(FixScene& scene);
void fixOpenGroup(FixScene& scene);
void fixUnusedFlow(FixScene& scene);
void fixForeignGroup(FixScene& scene);

} // namespace camwright
