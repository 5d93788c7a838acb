// Ways out of what is wrong with comments, networks, groups and branches.
#include "core/language/assist/fixscene.h"
#include "core/language/assist/freememory.h"
#include "core/language/exchange/groupsplitting.h"
#include "core/language/source/letters.h"

#include <algorithm>

namespace camwright {

namespace {

std::string header(std::uint32_t number)
{
    return "(* Network " + std::to_string(number) + " *)\n";
}

/// The system's bit that is on in every scan.
std::string_view alwaysOn(std::string_view family)
{
    return family == "kinco" ? "%SM0.0" : family == "invt" ? "SM0" : family == "koyo" ? "SP1" : "";
}

/// The first statement behind `found` that uses the flow, or one past the last.
std::size_t nextAction(FixScene& scene, const FixScene::Found& found)
{
    const auto& statements = scene.parsed().networks[found.network].rungs[found.rung].rung.statements;
    std::size_t at = found.statement + 1;
    while (at < statements.size() && statements[at].role != StatementRole::Output && statements[at].role != StatementRole::Block)
        ++at;
    return at;
}

/// A line put before a statement of a rung, or behind its last.
TextEdit lineBefore(FixScene& scene, const FixScene::Found& found, std::size_t statement, const std::string& line)
{
    const auto& statements = scene.parsed().networks[found.network].rungs[found.rung].rung.statements;
    if (statement < statements.size())
        return {scene.lineBegin(statements[statement].range.line), 0, line + "\n"};
    const std::uint32_t last = statements.back().range.endLine;
    return {scene.lineEnd(last), 0, "\n" + line};
}

TextRange mnemonicRange(const Statement& statement)
{
    TextRange out = statement.range;
    out.endLine = out.line;
    out.endColumn = out.column + static_cast<std::uint32_t>(statement.mnemonic.size());
    return out;
}

void append(std::vector<TextEdit>& edits, std::vector<TextEdit> more)
{
    edits.insert(edits.end(), std::make_move_iterator(more.begin()), std::make_move_iterator(more.end()));
}

} // namespace

void fixOpenComment(FixScene& scene)
{
    const std::size_t begin = scene.offsetOf(scene.range().line, scene.range().column);
    if (std::string_view(scene.source).substr(begin, 2) != "(*")
        return;
    scene.offer(CW_TEXT("QuickFix", "End the comment at the end of its line"), {}, {{scene.lineEnd(scene.range().line), 0, " *)"}});
}

void fixStatementBeforeNetwork(FixScene& scene)
{
    if (scene.parsed().networks.empty() || !scene.parsed().networks.front().header.empty())
        return;
    const std::uint32_t first = scene.context.dialect->firstNetwork;
    std::vector<TextEdit> edits{{scene.lineBegin(scene.range().line), 0, header(first)}};
    append(edits, scene.renumbered(1, first + 1));
    scene.offer(CW_TEXT("QuickFix", "Begin network %1 here"), {std::to_string(first)}, std::move(edits));
}

void fixNetworkNumber(FixScene& scene)
{
    std::vector<TextEdit> edits = scene.renumbered(0, scene.context.dialect->firstNetwork);
    if (!edits.empty())
        scene.offer(CW_TEXT("QuickFix", "Number all networks in their order"), {}, std::move(edits));
}

void fixTextAfterEnd(FixScene& scene)
{
    const std::string& epilogue = scene.parsed().epilogue;
    if (upperCase(trimmed(epilogue)).starts_with("END")) {
        const std::size_t begin = scene.source.size() - epilogue.size();
        const std::size_t next = std::min(epilogue.find('\n'), epilogue.size() - 1) + 1;
        const std::string line = epilogue.substr(0, next);
        if (upperCase(trimmed(line.substr(0, line.find_last_not_of("\r\n") + 1))) == "END")
            scene.offer(CW_TEXT("QuickFix", "Remove END, so that what follows belongs to the program"), {}, {{begin, next, {}}});
    }
}

void fixMissingLoad(FixScene& scene)
{
    const auto found = scene.statement();
    if (!found)
        return;
    const Statement& statement = scene.at(*found);
    const Dialect& dialect = *scene.context.dialect;
    const bool isContact = statement.role == StatementRole::And || statement.role == StatementRole::Or;
    const std::string_view load = isContact ? dialect.contactMnemonic(StatementRole::Load, statement.form, dialect.shapeOf(statement.mnemonic).width) : "";
    if (!load.empty()) {
        scene.replace(CW_TEXT("QuickFix", "Write %2 in place of %1"), mnemonicRange(statement), std::string(load));
        return;
    }
    const std::string_view begin = dialect.contactMnemonic(StatementRole::Load, ContactForm::NormallyOpen);
    const std::string_view bit = alwaysOn(scene.context.family->id());
    if (begin.empty() || bit.empty())
        return;
    const std::string line = std::string(begin) + " " + std::string(bit);
    scene.offer(CW_TEXT("QuickFix", "Begin the rung with %1, which is always on"), {line}, {{scene.lineBegin(statement.range.line), 0, line + "\n"}});
}

void fixSecondLoad(FixScene& scene)
{
    const auto found = scene.statement();
    if (!found || scene.at(*found).role != StatementRole::Load)
        return;
    const Statement& statement = scene.at(*found);
    const Dialect& dialect = *scene.context.dialect;
    for (const StatementRole role : {StatementRole::And, StatementRole::Or})
        if (const std::string_view word = dialect.contactMnemonic(role, statement.form); !word.empty())
            scene.replace(CW_TEXT("QuickFix", "Write %2 in place of %1"), mnemonicRange(statement), std::string(word));
    if (!dialect.networkHeaders)
        return;
    const std::uint32_t number = scene.parsed().networks[found->network].number + 1;
    std::vector<TextEdit> edits{{scene.lineBegin(statement.range.line), 0, header(number)}};
    append(edits, scene.renumbered(found->network + 1, number + 1));
    scene.offer(CW_TEXT("QuickFix", "Begin network %1 here"), {std::to_string(number)}, std::move(edits));
}

void fixUnusedJoin(FixScene& scene)
{
    if (const auto found = scene.statement(); found && scene.at(*found).operands.empty())
        scene.removeLine(CW_TEXT("QuickFix", "Remove \"%1\""), scene.range().line);
}

void fixOpenBranch(FixScene& scene)
{
    const auto found = scene.statement();
    if (!found)
        return;
    const auto& statements = scene.parsed().networks[found->network].rungs[found->rung].rung.statements;
    std::size_t depth = 1;
    const Statement* lastRead = nullptr;
    for (std::size_t i = found->statement + 1; i < statements.size(); ++i) {
        if (statements[i].role == StatementRole::PushFlow)
            ++depth;
        else if (statements[i].role == StatementRole::PopFlow && depth > 1)
            --depth;
        else if (statements[i].role == StatementRole::ReadFlow && depth == 1)
            lastRead = &statements[i];
    }
    const std::string pop(scene.context.dialect->structureMnemonic(StatementRole::PopFlow));
    if (lastRead)
        scene.replace(CW_TEXT("QuickFix", "Write %2 in place of the last %1"), mnemonicRange(*lastRead), pop);
    else
        scene.removeLine(CW_TEXT("QuickFix", "Remove \"%1\""), scene.range().line);
}

void fixOpenGroup(FixScene& scene)
{
    const auto found = scene.statement();
    if (!found)
        return;
    const std::string close(scene.context.dialect->structureMnemonic(StatementRole::CloseGroup));
    scene.offer(CW_TEXT("QuickFix", "Close the group before its output"), {}, {lineBefore(scene, *found, nextAction(scene, *found), close)});
}

void fixUnusedFlow(FixScene& scene)
{
    const auto found = scene.statement();
    if (!found)
        return;
    for (const StatementRole role : {StatementRole::AndBlock, StatementRole::OrBlock})
        if (const std::string word(scene.context.dialect->structureMnemonic(role)); !word.empty())
            scene.offer(CW_TEXT("QuickFix", "Join the two flows with %1"), {word}, {lineBefore(scene, *found, nextAction(scene, *found), word)});
}

void fixForeignGroup(FixScene& scene)
{
    const auto found = scene.statement();
    if (!found || scene.context.dialect->id != DialectId::KincoIl)
        return;
    const ParsedNetwork& network = scene.parsed().networks[found->network];
    FreeMemory memory(scene.project, scene.context);
    const MemoryArea* markers = scene.context.family->findArea("M");
    std::string bits;
    bool enough = true;
    const auto rewritten = splitGroups(network, [&] {
        const auto bit = memory.take(markers->id, DataType::Bool);
        enough = enough && bit;
        const std::string text = bit ? scene.context.family->formatAddress(*bit) : "???";
        bits += (bits.empty() ? "" : ", ") + text;
        return text;
    });
    if (!rewritten || !enough)
        return;
    std::size_t length = network.header.size() + network.tail.size();
    for (const ParsedRung& rung : network.rungs)
        length += rung.source.size();
    std::string text = *rewritten;
    if (scene.parsed().crlf)
        for (std::size_t at = text.find('\n'); at != std::string::npos; at = text.find('\n', at + 2))
            if (at == 0 || text[at - 1] != '\r')
                text.insert(at, "\r");
    std::vector<TextEdit> edits{{scene.networkOffset(found->network), length, std::move(text)}};
    const auto added = static_cast<std::uint32_t>(std::count(bits.begin(), bits.end(), ',')) + 1;
    append(edits, scene.renumbered(found->network + 1, network.number + added + 1));
    scene.offer(CW_TEXT("QuickFix", "Write the groups of this network to marker bits (%1) in networks of their own"), {bits}, std::move(edits));
}

} // namespace camwright
