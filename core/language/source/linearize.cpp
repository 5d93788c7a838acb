#include "core/language/source/ilwriter.h"

#include "core/language/source/letters.h"

#include <algorithm>
#include <utility>

namespace camwright {

namespace {

/// Where in the flow an element stands.
enum class Spot : std::uint8_t { Load, Series, Branch };

class Linearizer {
public:
    Linearizer(const Dialect& dialect, const Rung& rung) : m_dialect(dialect), m_rung(rung) {}

    std::optional<Rung> run()
    {
        Rung out;
        out.range = m_rung.range;
        if (!series(m_rung.tree.children, Spot::Load))
            return std::nullopt;
        takeSkippedComments(static_cast<std::uint32_t>(m_rung.statements.size()));
        out.statements = std::move(m_out);
        out.closingComments = std::move(m_comments);
        for (const std::string& comment : m_rung.closingComments)
            out.closingComments.push_back(comment);
        drawRung(m_dialect, out);
        return out;
    }

private:
    bool hasBlocks() const { return !m_dialect.structureMnemonic(StatementRole::AndBlock).empty(); }

    void structure(StatementRole role, std::vector<Operand> operands = {})
    {
        Statement out;
        out.role = role;
        out.form = role == StatementRole::OpenAnd || role == StatementRole::OpenOr ? ContactForm::NormallyOpen : ContactForm::None;
        out.mnemonic = m_dialect.structureMnemonic(role);
        out.operands = std::move(operands);
        m_out.push_back(std::move(out));
    }

    /// Comments of structural statements between the last element written and this one.
    void takeSkippedComments(std::uint32_t statement)
    {
        for (; m_nextComment < statement; ++m_nextComment)
            if (isStructural(m_rung.statements[m_nextComment]))
                keepComments(m_rung.statements[m_nextComment]);
        m_nextComment = std::max(m_nextComment, statement + 1);
    }

    static bool isStructural(const Statement& statement)
    {
        return statement.role >= StatementRole::AndBlock && statement.role <= StatementRole::CloseGroup;
    }

    void keepComments(const Statement& statement)
    {
        for (const std::string& comment : statement.leadingComments)
            m_comments.push_back(comment);
        if (!statement.trailingComment.empty())
            m_comments.push_back(statement.trailingComment);
    }

    bool isContact(const Statement& statement) const
    {
        using enum StatementRole;
        return statement.role == Load || statement.role == And || statement.role == Or || statement.role == OpenAnd || statement.role == OpenOr;
    }

    /// The statement of an element as it is written at a spot; nothing if the dialect has no word for it there.
    bool element(std::uint32_t index, Spot spot)
    {
        Statement out = m_rung.statements[index];
        if (isContact(out)) {
            const StatementRole role = spot == Spot::Load ? StatementRole::Load : spot == Spot::Series ? StatementRole::And : StatementRole::Or;
            const std::string_view word = m_dialect.contactMnemonic(role, out.form, m_dialect.shapeOf(out.mnemonic).width);
            if (word.empty())
                return false;
            out.mnemonic = word;
            out.role = role;
        } else if (spot != Spot::Series) {
            return false;
        }
        takeSkippedComments(index);
        out.leadingComments.insert(out.leadingComments.begin(), m_comments.begin(), m_comments.end());
        m_comments.clear();
        m_out.push_back(std::move(out));
        return true;
    }

    bool series(const std::vector<RungNode>& nodes, Spot first)
    {
        Spot spot = first;
        for (const RungNode& node : nodes) {
            if (!this->node(node, spot))
                return false;
            spot = Spot::Series;
        }
        return !nodes.empty() || first == Spot::Series;
    }

    bool node(const RungNode& node, Spot spot)
    {
        switch (node.kind) {
        case NodeKind::Element: return element(node.statement, spot);
        case NodeKind::Series: return series(node.children, spot);
        case NodeKind::Parallel: return parallel(node, spot);
        case NodeKind::Fork: return fork(node);
        }
        return false;
    }

    bool parallel(const RungNode& node, Spot spot)
    {
        if (node.children.empty())
            return false;
        const bool inside = spot == Spot::Series;
        if (inside && !hasBlocks())
            return group(StatementRole::OpenAnd, [&] { return branches(node, Spot::Series); });
        if (!branches(node, Spot::Load))
            return false;
        if (inside)
            structure(StatementRole::AndBlock);
        return true;
    }

    bool branches(const RungNode& node, Spot first)
    {
        if (!this->node(node.children.front(), first))
            return false;
        for (std::size_t i = 1; i < node.children.size(); ++i)
            if (!orBranch(node.children[i]))
                return false;
        return true;
    }

    bool orBranch(const RungNode& branch)
    {
        if (branch.kind == NodeKind::Element && element(branch.statement, Spot::Branch))
            return true;
        if (!hasBlocks())
            return group(StatementRole::OpenOr, [&] { return node(branch, Spot::Series); });
        if (!node(branch, Spot::Load))
            return false;
        structure(StatementRole::OrBlock);
        return true;
    }

    /// AND( or OR( around what `inside` writes. A group begins with flow on, so its first contact is in series with that.
    template <class Inside>
    bool group(StatementRole role, Inside inside)
    {
        structure(role);
        if (!inside())
            return false;
        structure(StatementRole::CloseGroup);
        return true;
    }

    bool fork(const RungNode& node)
    {
        if (m_dialect.structureMnemonic(StatementRole::PushFlow).empty() || node.children.size() < 2)
            return false;
        for (std::size_t i = 0; i < node.children.size(); ++i) {
            using enum StatementRole;
            structure(i == 0 ? PushFlow : i + 1 == node.children.size() ? PopFlow : ReadFlow);
            if (!this->node(node.children[i], Spot::Series))
                return false;
        }
        return true;
    }

    const Dialect& m_dialect;
    const Rung& m_rung;
    std::vector<Statement> m_out;
    std::vector<std::string> m_comments;
    std::uint32_t m_nextComment = 0;
};

} // namespace

std::optional<Rung> linearize(const Dialect& dialect, const Rung& rung)
{
    if (!rung.drawable)
        return rung;
    return Linearizer(dialect, rung).run();
}

} // namespace camwright
