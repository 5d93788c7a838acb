#include "core/language/source/rungsplitting.h"

#include <iterator>
#include <utility>

namespace camwright {

namespace {

/// Whether a rung joins a block to a flow it does not have itself, before it drives anything.
bool needsFlowBefore(const Rung& rung)
{
    unsigned open = 0;
    for (const Statement& statement : rung.statements) {
        switch (statement.role) {
        case StatementRole::Load:
            ++open;
            break;
        case StatementRole::AndBlock:
        case StatementRole::OrBlock:
            if (open <= 1)
                return true;
            --open;
            break;
        case StatementRole::Output:
        case StatementRole::Block:
            return false;
        default:
            break;
        }
    }
    return false;
}

void append(ParsedRung& rung, ParsedRung next)
{
    rung.source += next.source;
    std::move(next.rung.statements.begin(), next.rung.statements.end(), std::back_inserter(rung.rung.statements));
    rung.rung.range.endLine = next.rung.range.endLine;
    rung.rung.range.endColumn = next.rung.range.endColumn;
}

bool isDerived(const ParsedNetwork& network)
{
    return network.header.empty();
}

} // namespace

void RungSplitter::follow(StatementRole role)
{
    if (startsRung(role))
        m_hasAction = false;
    switch (role) {
    case StatementRole::Output:
    case StatementRole::Block:
        m_hasAction = true;
        break;
    case StatementRole::PushFlow:
        ++m_branches;
        m_hasAction = false;
        break;
    case StatementRole::PopFlow:
        m_branches -= m_branches > 0 ? 1 : 0;
        m_hasAction = false;
        break;
    default:
        break;
    }
}

void joinSplitRungs(ParsedProgram& program, std::uint32_t firstNetwork)
{
    std::vector<ParsedNetwork> out;
    for (ParsedNetwork& network : program.networks) {
        const bool derived = isDerived(network);
        std::vector<ParsedRung> rungs = std::exchange(network.rungs, {});
        const bool mayJoinBefore = derived && !out.empty() && isDerived(out.back()) && !out.back().rungs.empty();
        if (mayJoinBefore && rungs.size() == 1 && needsFlowBefore(rungs.front().rung)) {
            append(out.back().rungs.back(), std::move(rungs.front()));
            out.back().tail += network.tail;
            continue;
        }
        for (ParsedRung& rung : rungs)
            if (!network.rungs.empty() && needsFlowBefore(rung.rung))
                append(network.rungs.back(), std::move(rung));
            else
                network.rungs.push_back(std::move(rung));
        if (derived)
            network.number = out.empty() ? firstNetwork : out.back().number + 1;
        out.push_back(std::move(network));
    }
    program.networks = std::move(out);
}

} // namespace camwright
