#include "core/language/exchange/groupsplitting.h"

#include "core/language/source/ilwriter.h"

#include <utility>
#include <vector>

namespace camwright {

namespace {

/// Takes the groups out of one rung, innermost first: each becomes a rung that ends in ST of its marker.
class GroupSplitter {
public:
    explicit GroupSplitter(const std::function<std::string()>& freeMarker) : m_freeMarker(freeMarker) {}

    /// The rungs that run before the last one, then the last one. Empty if a group could not be taken out.
    std::vector<Rung> split(const Rung& rung)
    {
        std::vector<Open> stack(1);
        for (const Statement& statement : rung.statements) {
            using enum StatementRole;
            if (statement.role == OpenAnd || statement.role == OpenOr) {
                stack.push_back({statement.role, {}, statement});
                if (!statement.operands.empty())
                    append(stack.back().statements, contact(statement.operands.front(), ContactForm::NormallyOpen));
            } else if (statement.role == CloseGroup) {
                if (stack.size() < 2)
                    return {};
                Open group = std::move(stack.back());
                stack.pop_back();
                stack.back().statements.push_back(close(std::move(group), statement));
            } else {
                if (stack.size() > 1 && statement.role != And && statement.role != Or && statement.role != Load)
                    return {};
                append(stack.back().statements, statement);
            }
        }
        if (stack.size() != 1)
            return {};
        Rung last;
        last.statements = std::move(stack.front().statements);
        last.closingComments = rung.closingComments;
        m_rungs.push_back(std::move(last));
        return std::move(m_rungs);
    }

private:
    struct Open {
        StatementRole role = StatementRole::OpenAnd;
        std::vector<Statement> statements;
        Statement opening;
    };

    static Statement contact(Operand operand, ContactForm form)
    {
        Statement out;
        out.role = StatementRole::And;
        out.form = form;
        out.mnemonic = kincoIl().contactMnemonic(out.role, form);
        operand.pin.clear();
        out.operands.push_back(std::move(operand));
        return out;
    }

    static Operand marker(const std::string& address)
    {
        Operand out;
        out.text = address;
        return out;
    }

    /// The first contact of a rung of its own is written as LD; a comparison gets LD %SM0.0 before it.
    static void append(std::vector<Statement>& statements, Statement statement)
    {
        const std::string_view load = kincoIl().contactMnemonic(StatementRole::Load, statement.form);
        if (statements.empty() && statement.role == StatementRole::And) {
            if (load.empty()) {
                Statement always = contact(marker("%SM0.0"), ContactForm::NormallyOpen);
                always.role = StatementRole::Load;
                always.mnemonic = kincoIl().contactMnemonic(StatementRole::Load, ContactForm::NormallyOpen);
                statements.push_back(std::move(always));
            } else {
                statement.role = StatementRole::Load;
                statement.mnemonic = load;
            }
        }
        statements.push_back(std::move(statement));
    }

    /// Ends a group: its rung stores to a marker, and the contact of the marker takes its place.
    Statement close(Open group, const Statement& closing)
    {
        const std::string address = m_freeMarker();
        Statement use = contact(marker(address), ContactForm::NormallyOpen);
        if (group.role == StatementRole::OpenOr) {
            use.role = StatementRole::Or;
            use.mnemonic = kincoIl().contactMnemonic(use.role, use.form);
        }
        use.leadingComments = group.opening.leadingComments;
        for (const std::string& comment : closing.leadingComments)
            use.leadingComments.push_back(comment);
        use.trailingComment = group.opening.trailingComment;
        if (!closing.trailingComment.empty())
            use.trailingComment += (use.trailingComment.empty() ? "" : " ") + closing.trailingComment;
        Statement store;
        store.role = StatementRole::Output;
        store.mnemonic = "ST";
        store.operands.push_back(marker(address));
        Rung rung;
        rung.statements = std::move(group.statements);
        rung.statements.push_back(std::move(store));
        m_rungs.push_back(std::move(rung));
        return use;
    }

    const std::function<std::string()>& m_freeMarker;
    std::vector<Rung> m_rungs;
};

} // namespace

std::optional<std::string> splitGroups(const ParsedNetwork& network, const std::function<std::string()>& freeMarker)
{
    if (network.rungs.size() != 1)
        return std::nullopt;
    const std::vector<Rung> rungs = GroupSplitter(freeMarker).split(network.rungs.front().rung);
    if (rungs.size() < 2)
        return std::nullopt;
    std::string out;
    for (std::size_t i = 0; i < rungs.size(); ++i)
        out += "(* Network " + std::to_string(network.number + i) + " *)\n" + writeRung(kincoIl(), rungs[i]);
    return out + network.tail;
}

} // namespace camwright
