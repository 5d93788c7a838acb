#include "core/language/source/ilparser.h"

#include "core/language/source/koyodialect.h"

#include <algorithm>
#include <utility>

namespace camwright {

namespace {

/// A flow under construction.
struct Flow {
    std::vector<RungNode> series;
    bool rooted = false;      ///< began with LD or inside a group: not a continuation of a branch
    bool pure = true;         ///< contacts, comparisons and edges only
    unsigned depth = 1;       ///< nesting of `series`
    std::uint32_t first = 0;  ///< the statement it began with
};

/// What waits on the stack for a later statement.
struct Waiting {
    enum class Kind : std::uint8_t { Flow, Fork, Group } kind = Kind::Flow;
    Flow flow;                       ///< the flow before
    std::uint32_t statement = 0;     ///< MPS, AND( or OR(
    StatementRole role = StatementRole::OpenAnd;
    std::vector<RungNode> branches;  ///< Fork: the finished ones
    unsigned branchDepth = 0;
    bool popped = false;             ///< Fork: MPP was seen, this is its last branch
};

RungNode element(std::uint32_t statement)
{
    return {NodeKind::Element, statement, {}};
}

/// One child stands for itself.
RungNode seriesNode(std::vector<RungNode> children)
{
    if (children.size() == 1 && children.front().kind != NodeKind::Fork)
        return std::move(children.front());
    return {NodeKind::Series, 0, std::move(children)};
}

class RungDrawing {
public:
    RungDrawing(const Dialect& dialect, Rung& rung, DiagnosticSink* sink) : m_dialect(dialect), m_rung(rung), m_sink(sink) {}

    void run()
    {
        for (m_at = 0; m_at < m_rung.statements.size() && !m_abandoned; ++m_at)
            take(m_rung.statements[m_at]);
        if (!m_abandoned)
            close();
        const bool tooDeep = m_flow.depth > MaximumRungDepth;
        m_rung.drawable = m_drawable && !m_abandoned && !tooDeep && !m_rung.statements.empty();
        m_rung.tree = m_rung.drawable ? RungNode{NodeKind::Series, 0, std::move(m_flow.series)} : RungNode{};
    }

private:
    void report(Code code, std::uint32_t statement, std::vector<std::string> arguments = {})
    {
        m_drawable = false;
        if (m_sink)
            m_sink->add(code, m_rung.statements[statement].range, std::move(arguments));
    }
    void report(Code code, std::vector<std::string> arguments = {}) { report(code, m_at, std::move(arguments)); }
    const std::string& mnemonic(std::uint32_t statement) const { return m_rung.statements[statement].mnemonic; }

    void take(const Statement& statement)
    {
        using enum StatementRole;
        switch (statement.role) {
        case Load: load(); break;
        case And: case Flow: inSeries(true); break;
        case Or: orContact(); break;
        case AndBlock: case OrBlock: joinBlocks(statement.role); break;
        case PushFlow: push(); break;
        case ReadFlow: case PopFlow: nextBranch(statement.role); break;
        case OpenAnd: case OpenOr: openGroup(statement); break;
        case CloseGroup: closeGroup(); break;
        case Output: case Block: inSeries(false); break;
        case Invalid: m_drawable = false; break;
        }
    }

    /// A statement that continues a flow needs one. Says so once a rung.
    bool needsFlow()
    {
        if (m_begun)
            return true;
        if (beginsWithFlowOn()) {
            m_begun = true;
            m_drawable = false; // a text rung: its picture would need a wire from the left rail
            return true;
        }
        report(Code::RungNeedsLoad, {mnemonic(m_at), std::string(m_dialect.contactMnemonic(StatementRole::Load, ContactForm::NormallyOpen))});
        m_begun = true;
        return false;
    }

    /// Koyo: a box without a contact always runs (LDS K10, OUTW R10000 of the D2-MLINK manual; END, SBR, NEXT).
    bool beginsWithFlowOn() const
    {
        return m_dialect.id == DialectId::KoyoIl && m_rung.statements[m_at].role == StatementRole::Block;
    }

    /// CNT and its like take flows that wait on the stack. Ladder has no picture for it: the rung is text.
    void takeFlows()
    {
        const unsigned flows = m_dialect.id == DialectId::KoyoIl ? koyoFlowsOf(mnemonic(m_at)) : 1;
        for (unsigned i = 1; i < flows; ++i) {
            if (m_stack.empty() || m_stack.back().kind != Waiting::Kind::Flow) {
                report(Code::FlowsMissing, {mnemonic(m_at), std::to_string(flows)});
                return;
            }
            m_stack.pop_back();
            m_drawable = false;
        }
    }

    bool mayNest()
    {
        if (m_stack.size() < MaximumRungDepth)
            return true;
        report(Code::NestedTooDeep, {std::to_string(MaximumRungDepth)});
        m_abandoned = true;
        return false;
    }

    void load()
    {
        const bool startsGroup = !m_stack.empty() && m_stack.back().kind == Waiting::Kind::Group && m_flow.series.empty();
        if (m_begun && !startsGroup) {
            if (m_dialect.structureMnemonic(StatementRole::AndBlock).empty()) {
                report(Code::SecondLoad, {"LD"});
                return;
            }
            if (!mayNest())
                return;
            m_stack.push_back({Waiting::Kind::Flow, std::exchange(m_flow, {}), m_at, {}, {}, 0, false});
        }
        m_begun = true;
        m_flow.rooted = true;
        m_flow.first = m_at;
        m_flow.series.push_back(element(m_at));
    }

    void inSeries(bool pure)
    {
        if (m_rung.statements[m_at].role == StatementRole::Block && Dialect::standsAlone(mnemonic(m_at))) {
            m_drawable = m_drawable && m_begun; // ladder has no picture of a rung without a flow
            m_begun = true;
        }
        needsFlow();
        if (m_rung.statements[m_at].role == StatementRole::Block)
            takeFlows();
        m_hasAction = m_hasAction || !pure;
        m_flow.pure = m_flow.pure && pure;
        m_flow.series.push_back(element(m_at));
    }

    /// Joins another flow to this one by OR. Both begin at the left rail and hold contacts only, else ladder has no picture.
    void joinParallel(std::vector<RungNode> other, bool rooted, bool pure, unsigned depth)
    {
        if (!m_flow.rooted || !m_flow.pure || !rooted || !pure || m_flow.series.empty() || other.empty())
            m_drawable = false;
        const bool extends = m_flow.series.size() == 1 && m_flow.series.front().kind == NodeKind::Parallel;
        if (!extends) {
            RungNode parallel{NodeKind::Parallel, 0, {}};
            parallel.children.push_back(seriesNode(std::move(m_flow.series)));
            m_flow.series.clear();
            m_flow.series.push_back(std::move(parallel));
            ++m_flow.depth;
        }
        m_flow.series.front().children.push_back(seriesNode(std::move(other)));
        m_flow.depth = std::max(m_flow.depth, depth + 1);
        limitDepth();
    }

    /// A picture that is too deep is given up at once, so that its tree stays small.
    void limitDepth()
    {
        if (m_flow.depth <= MaximumRungDepth)
            return;
        m_drawable = false;
        m_flow.series.assign(1, element(m_flow.first));
        m_flow.depth = 1;
    }

    void orContact()
    {
        if (needsFlow())
            joinParallel({element(m_at)}, true, true, 1);
    }

    void joinBlocks(StatementRole role)
    {
        if (m_stack.empty() || m_stack.back().kind != Waiting::Kind::Flow) {
            report(Code::NothingToJoin, {mnemonic(m_at)});
            return;
        }
        Flow right = std::exchange(m_flow, std::move(m_stack.back().flow));
        m_stack.pop_back();
        if (role == StatementRole::OrBlock) {
            joinParallel(std::move(right.series), right.rooted, right.pure, right.depth);
            return;
        }
        appendFlow(std::move(right));
    }

    void appendFlow(Flow right)
    {
        m_drawable = m_drawable && right.pure;
        m_flow.depth = std::max(m_flow.depth, right.depth);
        for (RungNode& node : right.series)
            m_flow.series.push_back(std::move(node));
    }

    void push()
    {
        if (!needsFlow() || !mayNest())
            return;
        m_stack.push_back({Waiting::Kind::Fork, std::exchange(m_flow, {}), m_at, {}, {}, 0, false});
        m_flow.first = m_at;
    }

    /// Ends the branch that runs and puts the fork into the flow before it.
    void closeFork()
    {
        Waiting fork = std::move(m_stack.back());
        m_stack.pop_back();
        fork.branchDepth = std::max(fork.branchDepth, m_flow.depth);
        fork.branches.push_back({NodeKind::Series, 0, std::move(m_flow.series)});
        const bool pure = m_flow.pure && fork.flow.pure;
        m_flow = std::move(fork.flow);
        m_flow.pure = pure;
        m_flow.series.push_back({NodeKind::Fork, 0, std::move(fork.branches)});
        m_flow.depth = std::max(m_flow.depth, fork.branchDepth + 1);
        limitDepth();
    }

    void reportLeftOver(const Waiting& waiting)
    {
        using Kind = Waiting::Kind;
        if (waiting.kind == Kind::Flow)
            report(Code::FlowLeftOver, waiting.statement);
        else if (waiting.kind == Kind::Group)
            report(Code::GroupNotClosed, waiting.statement, {mnemonic(waiting.statement)});
        else
            report(Code::BranchNotClosed, waiting.statement);
    }

    void nextBranch(StatementRole role)
    {
        while (!m_stack.empty()) {
            const Waiting& top = m_stack.back();
            if (top.kind == Waiting::Kind::Fork && !top.popped)
                break;
            if (top.kind == Waiting::Kind::Fork) {
                closeFork();
                continue;
            }
            reportLeftOver(top);
            m_stack.pop_back();
        }
        if (m_stack.empty()) {
            report(Code::BranchNotOpen, {mnemonic(m_at)});
            m_abandoned = true; // what follows would only be reported for the same reason
            return;
        }
        Waiting& fork = m_stack.back();
        fork.branchDepth = std::max(fork.branchDepth, m_flow.depth);
        fork.branches.push_back({NodeKind::Series, 0, std::move(m_flow.series)});
        fork.popped = role == StatementRole::PopFlow;
        const bool pure = m_flow.pure;
        m_flow = {};
        m_flow.pure = pure;
        m_flow.first = m_at;
    }

    void openGroup(const Statement& statement)
    {
        if (!needsFlow() || !mayNest())
            return;
        m_stack.push_back({Waiting::Kind::Group, std::exchange(m_flow, {}), m_at, statement.role, {}, 0, false});
        m_flow.rooted = true;
        m_flow.first = m_at;
        if (!statement.operands.empty())
            m_flow.series.push_back(element(m_at));
    }

    void closeGroup()
    {
        if (m_stack.empty() || m_stack.back().kind != Waiting::Kind::Group) {
            report(Code::GroupNotOpen);
            return;
        }
        const StatementRole role = m_stack.back().role;
        Flow group = std::exchange(m_flow, std::move(m_stack.back().flow));
        m_stack.pop_back();
        if (role == StatementRole::OpenOr)
            joinParallel(std::move(group.series), group.rooted, group.pure, group.depth);
        else
            appendFlow(std::move(group));
    }

    void close()
    {
        while (!m_stack.empty()) {
            if (m_stack.back().kind == Waiting::Kind::Fork && m_stack.back().popped) {
                closeFork();
                continue;
            }
            reportLeftOver(m_stack.back());
            m_stack.pop_back();
        }
        if (m_begun && !m_hasAction && m_drawable && m_sink)
            m_sink->add(Code::RungDoesNothing, m_rung.range);
    }

    const Dialect& m_dialect;
    Rung& m_rung;
    DiagnosticSink* m_sink;
    std::uint32_t m_at = 0;
    Flow m_flow;
    std::vector<Waiting> m_stack;
    bool m_begun = false;
    bool m_hasAction = false;
    bool m_drawable = true;
    bool m_abandoned = false;
};

} // namespace

void drawRung(const Dialect& dialect, Rung& rung, DiagnosticSink* sink)
{
    RungDrawing(dialect, rung, sink).run();
}

} // namespace camwright
