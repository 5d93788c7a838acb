#include "core/language/check/controlrules.h"

#include "core/language/source/letters.h"

#include <set>

namespace camwright {

namespace {

bool isLabel(InstructionId id)
{
    return id == InstructionId::KincoLbl || id == InstructionId::InvtLbl;
}

bool isFor(InstructionId id)
{
    return id == InstructionId::KincoFor || id == InstructionId::InvtFor;
}

bool isNext(InstructionId id)
{
    return id == InstructionId::KincoNext || id == InstructionId::InvtNext;
}

class ControlRules {
public:
    ControlRules(const ResolvedProgram& program, DiagnosticSink& sink) : m_program(program), m_sink(sink) {}

    bool run()
    {
        forEachStatement([this](const ResolvedStatement& statement) { note(statement); });
        for (const ResolvedStatement* statement : m_openLoops)
            report(Code::LoopNotClosed, statement->range, {statement->instruction->mnemonic});
        for (const ResolvedOperand* jump : m_jumps) {
            const std::string& label = std::get<ResolvedLabel>(jump->value).name;
            if (!m_labels.contains(label))
                report(Code::UnknownLabel, jump->range, {shortened(jump->text)});
        }
        return m_ok;
    }

private:
    template <class Visitor>
    void forEachStatement(Visitor visit)
    {
        for (const ResolvedNetwork& network : m_program.networks)
            for (const ResolvedRung& rung : network.rungs)
                for (const ResolvedStatement& statement : rung.statements)
                    if (statement.instruction)
                        visit(statement);
    }

    void note(const ResolvedStatement& statement)
    {
        if (isFor(statement.instruction->id))
            m_openLoops.push_back(&statement);
        else if (isNext(statement.instruction->id))
            closeLoop(statement);
        for (const ResolvedOperand& operand : statement.operands)
            if (const auto* label = std::get_if<ResolvedLabel>(&operand.value))
                noteLabel(statement, operand, label->name);
    }

    void closeLoop(const ResolvedStatement& statement)
    {
        if (m_openLoops.empty())
            report(Code::LoopNotOpen, statement.range, {});
        else
            m_openLoops.pop_back();
    }

    void noteLabel(const ResolvedStatement& statement, const ResolvedOperand& operand, const std::string& label)
    {
        if (!isLabel(statement.instruction->id))
            m_jumps.push_back(&operand);
        else if (!m_labels.insert(label).second)
            report(Code::LabelTwice, operand.range, {shortened(operand.text)});
    }

    void report(Code code, const TextRange& range, std::vector<std::string> arguments)
    {
        m_sink.add(code, range, std::move(arguments));
        m_ok = false;
    }

    const ResolvedProgram& m_program;
    DiagnosticSink& m_sink;
    std::vector<const ResolvedStatement*> m_openLoops;
    std::vector<const ResolvedOperand*> m_jumps;
    std::set<std::string> m_labels;
    bool m_ok = true;
};

} // namespace

bool checkControl(const ResolvedProgram& program, DiagnosticSink& sink)
{
    return ControlRules(program, sink).run();
}

} // namespace camwright
