#include "core/language/check/projectrules.h"

#include "core/language/source/letters.h"

#include <algorithm>
#include <map>
#include <set>

namespace camwright {

namespace {

const Literal* literalAt(const ResolvedStatement& statement, std::string_view pin)
{
    for (const ResolvedOperand& operand : statement.operands)
        if (operand.pin->name == pin)
            return std::get_if<Literal>(&operand.value);
    return nullptr;
}

std::optional<std::uint32_t> numberAt(const ResolvedStatement& statement, std::string_view pin)
{
    const Literal* literal = literalAt(statement, pin);
    const auto value = literal && literal->types().contains(DataType::Int) ? std::optional(literal->as(DataType::Int)) : std::nullopt;
    if (!value || !value->ok() || (**value).asInteger() < 0)
        return std::nullopt;
    return static_cast<std::uint32_t>((**value).asInteger());
}

class ProjectRules {
public:
    ProjectRules(std::span<const ResolvedProgram> programs, const LanguageContext& context, std::span<Diagnostics> diagnostics)
        : m_programs(programs), m_context(context), m_diagnostics(diagnostics)
    {
        m_size.instructionsMax = context.model->programInstructionsMax;
        m_size.motionInstructionsMax = context.model->motionInstructionsMax;
    }

    ProgramSize run()
    {
        forEachStatement([this](std::size_t program, const ResolvedRung& rung, const ResolvedStatement& statement) {
            count(program, statement);
            noteCall(program, statement);
            noteElements(program, statement);
            noteOutputs(program, rung, statement);
        });
        checkSize();
        checkRecursion();
        checkCallDepth();
        checkInterrupts();
        forEachStatement([this](std::size_t program, const ResolvedRung&, const ResolvedStatement& statement) {
            checkAxis(program, statement);
            checkList(program, statement);
        });
        return m_size;
    }

private:
    template <class Visitor>
    void forEachStatement(Visitor visit)
    {
        for (std::size_t i = 0; i < m_programs.size(); ++i)
            for (const ResolvedNetwork& network : m_programs[i].networks)
                for (const ResolvedRung& rung : network.rungs)
                    for (const ResolvedStatement& statement : rung.statements)
                        if (statement.isComplete)
                            visit(i, rung, statement);
    }

    void report(std::size_t program, Code code, const TextRange& range, std::vector<std::string> arguments, std::optional<Place> related = {})
    {
        DiagnosticSink sink(m_diagnostics[program], m_programs[program].key);
        sink.add(code, range, std::move(arguments));
        if (related)
            sink.relate(std::move(*related));
    }

    Place placeOf(std::size_t program, const TextRange& range) const { return {m_programs[program].key, {}, range, {}}; }

    static bool isStructural(const ResolvedStatement& statement)
    {
        return statement.role >= StatementRole::AndBlock && statement.role <= StatementRole::CloseGroup;
    }

    /// KS-CPU-02, KS-MC-01.
    void count(std::size_t program, const ResolvedStatement& statement)
    {
        const Instruction& instruction = *statement.instruction;
        const bool hasOperand = !statement.operands.empty() && !statement.operands.front().text.empty();
        if (!isStructural(statement) || hasOperand)
            ++m_size.instructions;
        if (m_size.instructions == m_size.instructionsMax + 1)
            m_tooLarge = placeOf(program, statement.range);
        if (instruction.isMotion && ++m_size.motionInstructions == m_size.motionInstructionsMax + 1)
            m_tooManyMotion = std::pair(program, statement.range);
        if (instruction.maxPerProject > 0 && ++m_perInstruction[&instruction] > instruction.maxPerProject)
            report(program, Code::TooManyOfInstruction, statement.range, {instruction.mnemonic, std::to_string(instruction.maxPerProject)});
        const auto axis = numberAt(statement, "AXIS");
        if (instruction.maxPerAxis > 0 && axis && ++m_perAxis[{&instruction, *axis}] > instruction.maxPerAxis)
            report(program, Code::TooManyPerAxis, statement.range, {instruction.mnemonic, std::to_string(*axis)});
    }

    void checkSize()
    {
        if (m_tooLarge && m_size.instructionsMax > 0) {
            const auto program = static_cast<std::size_t>(std::find_if(m_programs.begin(), m_programs.end(),
                [this](const ResolvedProgram& p) { return p.key == m_tooLarge->object; }) - m_programs.begin());
            report(program, Code::ProgramTooLarge, m_tooLarge->range, {std::to_string(m_size.instructions), m_context.model->name,
                std::to_string(m_size.instructionsMax)});
        }
        if (m_tooManyMotion && m_size.motionInstructionsMax > 0)
            report(m_tooManyMotion->first, Code::TooManyMotionInstructions, m_tooManyMotion->second,
                {std::to_string(m_size.motionInstructions), m_context.model->name, std::to_string(m_size.motionInstructionsMax)});
    }

    struct Call {
        std::size_t target;
        TextRange range;
    };

    void noteCall(std::size_t program, const ResolvedStatement& statement)
    {
        for (const ResolvedOperand& operand : statement.operands)
            if (const auto* name = std::get_if<ResolvedProgramName>(&operand.value); name && operand.pin->kind == PinKind::Interrupt)
                m_attached.insert(name->name);
            else if (name)
                for (std::size_t i = 0; i < m_programs.size(); ++i)
                    if (m_programs[i].key.name == name->name)
                        m_calls[program].push_back({i, operand.range});
    }

    /// Reports each call that closes a cycle, once. Depth-first with a stack of its own: chains may be long.
    void checkRecursion()
    {
        enum class Mark : std::uint8_t { New, Open, Done };
        std::vector<Mark> marks(m_programs.size(), Mark::New);
        for (std::size_t root = 0; root < m_programs.size(); ++root) {
            if (marks[root] != Mark::New)
                continue;
            std::vector<std::pair<std::size_t, std::size_t>> path{{root, 0}}; // program, next call
            marks[root] = Mark::Open;
            while (!path.empty()) {
                auto& [program, next] = path.back();
                if (next == m_calls[program].size()) {
                    marks[program] = Mark::Done;
                    path.pop_back();
                    continue;
                }
                const Call call = m_calls[program][next++];
                if (marks[call.target] == Mark::Open)
                    reportCycle(path, call);
                if (marks[call.target] == Mark::New) {
                    marks[call.target] = Mark::Open;
                    path.emplace_back(call.target, 0);
                }
            }
        }
    }

    /// TS-SBR-01: at most 64 subroutines, at most 6 levels with the main program's call as the first.
    void checkCallDepth()
    {
        if (m_context.family->id() != "invt" || m_hasCycle)
            return;
        std::size_t subroutines = 0;
        for (std::size_t i = 0; i < m_programs.size(); ++i) {
            const bool isSubroutine = m_programs[i].role == ProgramRole::Subroutine;
            if (isSubroutine && ++subroutines == MaximumSubroutines + 1)
                report(i, Code::TooManySubroutines, {1, 1, 1, 1}, {std::to_string(countSubroutines()), m_context.model->name, std::to_string(MaximumSubroutines)});
            if (m_programs[i].role == ProgramRole::Main)
                descend({i}, m_programs[i].key.name);
        }
    }

    std::size_t countSubroutines() const
    {
        return static_cast<std::size_t>(std::ranges::count(m_programs, ProgramRole::Subroutine, &ResolvedProgram::role));
    }

    /// Follows the calls as deep as is allowed and one further: there are at most that many on a path, and each call is
    /// reported once.
    void descend(const std::vector<std::size_t>& path, const std::string& chain)
    {
        for (const Call& call : m_calls[path.back()]) {
            if (path.size() > MaximumCallLevels) {
                if (m_tooDeep.insert({path.back(), call.target}).second)
                    report(path.back(), Code::CallsTooDeepHere, call.range, {std::to_string(path.size()),
                        shortened(chain + " > " + m_programs[call.target].key.name, 200), m_context.model->name, std::to_string(MaximumCallLevels)});
                continue;
            }
            if (!m_reached.insert({call.target, path.size()}).second)
                continue;
            std::vector<std::size_t> deeper = path;
            deeper.push_back(call.target);
            descend(deeper, chain + " > " + m_programs[call.target].key.name);
        }
    }

    /// A routine without an event never runs.
    void checkInterrupts()
    {
        for (std::size_t i = 0; i < m_programs.size(); ++i) {
            const ResolvedProgram& program = m_programs[i];
            if (program.role == ProgramRole::Interrupt && !program.event && !m_attached.contains(program.key.name))
                report(i, Code::NothingStartsInterrupt, {1, 1, 1, 1}, {program.key.name});
        }
    }

    void reportCycle(const std::vector<std::pair<std::size_t, std::size_t>>& path, const Call& call)
    {
        m_hasCycle = true;
        const std::string& name = m_programs[call.target].key.name;
        std::string chain;
        bool inside = false;
        for (const auto& [program, next] : path) {
            inside = inside || program == call.target;
            if (inside)
                chain += m_programs[program].key.name + " > ";
        }
        report(path.back().first, Code::RecursiveCall, call.range, {name, shortened(chain + name, 200)});
    }

    /// A timer or counter element belongs to one instruction.
    void noteElements(std::size_t program, const ResolvedStatement& statement)
    {
        for (const ResolvedOperand& operand : statement.operands) {
            const auto* memory = std::get_if<ResolvedMemory>(&operand.value);
            if (!memory || (operand.pin->kind != PinKind::Timer && operand.pin->kind != PinKind::Counter))
                continue;
            const auto [first, isNew] = m_elements.emplace(std::pair(memory->address.area, memory->address.byte), placeOf(program, operand.range));
            if (!isNew)
                report(program, Code::TimerUsedTwice, operand.range, {m_context.family->formatAddress(memory->address)}, first->second);
        }
    }

    static bool isCoil(const ResolvedStatement& statement)
    {
        return statement.role == StatementRole::Output && statement.instruction->executes == Executes::Always;
    }

    void noteOutputs(std::size_t program, const ResolvedRung& rung, const ResolvedStatement& statement)
    {
        for (const ResolvedOperand& operand : statement.operands) {
            const auto* memory = std::get_if<ResolvedMemory>(&operand.value);
            if (!memory || operand.pin->direction == PinDirection::In)
                continue;
            const Address& address = memory->address;
            markWritten(address);
            if (!isCoil(statement))
                continue;
            const auto key = std::tuple(program, address.area, std::uint64_t{address.byte} * 8 + address.bit);
            const auto [first, isNew] = m_coils.emplace(key, std::pair(&rung, placeOf(program, operand.range)));
            if (!isNew && first->second.first != &rung)
                report(program, Code::OutputWrittenTwice, operand.range, {shortened(operand.text)}, first->second.second);
        }
    }

    void checkAxis(std::size_t program, const ResolvedStatement& statement)
    {
        if (statement.instruction->needs != Capability::MotionAxes)
            return;
        const auto axis = numberAt(statement, "AXIS");
        if (!axis || m_context.findAxis(*axis))
            return;
        for (const ResolvedOperand& operand : statement.operands)
            if (operand.pin->name == "AXIS" && *axis >= operand.pin->minimum.value_or(0) && *axis <= operand.pin->maximum.value_or(*axis))
                report(program, Code::AxisNotConfigured, operand.range, {std::to_string(*axis)});
    }

    /// A list of parameter numbers of which only the first ones are ever written (the printed EX2 asks for 8 and prepares 3).
    void checkList(std::size_t program, const ResolvedStatement& statement)
    {
        for (const ResolvedOperand& operand : statement.operands) {
            const auto* memory = std::get_if<ResolvedMemory>(&operand.value);
            const Pin& pin = *operand.pin;
            if (!memory || pin.kind != PinKind::Block || pin.direction != PinDirection::In || pin.elementBytes != 1)
                continue;
            const auto count = numberAt(statement, pin.countPin);
            const std::uint32_t prepared = count ? writtenFrom(memory->address, *count) : 0;
            if (count && prepared > 0 && prepared < *count)
                report(program, Code::ListNotPrepared, operand.range, {statement.instruction->mnemonic, std::to_string(*count),
                    shortened(operand.text), std::to_string(prepared)});
        }
    }

    void markWritten(const Address& address)
    {
        std::vector<bool>& bytes = m_written[address.area];
        const std::size_t end = std::size_t{address.byte} + byteWidth(address.type);
        if (bytes.size() < end)
            bytes.resize(end);
        std::fill(bytes.begin() + address.byte, bytes.begin() + static_cast<std::ptrdiff_t>(end), true);
    }

    /// How many bytes from an address on are written by the programs, at most `limit`.
    std::uint32_t writtenFrom(const Address& address, std::uint32_t limit)
    {
        const std::vector<bool>& bytes = m_written[address.area];
        std::uint32_t n = 0;
        while (n < limit && address.byte + n < bytes.size() && bytes[address.byte + n])
            ++n;
        return n;
    }

    std::span<const ResolvedProgram> m_programs;
    const LanguageContext& m_context;
    std::span<Diagnostics> m_diagnostics;
    ProgramSize m_size;
    std::optional<Place> m_tooLarge;
    std::optional<std::pair<std::size_t, TextRange>> m_tooManyMotion;
    std::map<const Instruction*, unsigned> m_perInstruction;
    std::map<std::pair<const Instruction*, std::uint32_t>, unsigned> m_perAxis;
    static constexpr std::size_t MaximumSubroutines = 64;
    static constexpr std::size_t MaximumCallLevels = 6;

    std::map<std::size_t, std::vector<Call>> m_calls;
    bool m_hasCycle = false;
    std::set<std::string> m_attached;                              ///< interrupt routines an instruction attaches
    std::set<std::pair<std::size_t, std::size_t>> m_tooDeep;       ///< caller and callee
    std::set<std::pair<std::size_t, std::size_t>> m_reached;       ///< program and level
    std::map<std::pair<AreaId, std::uint32_t>, Place> m_elements;
    std::map<std::tuple<std::size_t, AreaId, std::uint64_t>, std::pair<const ResolvedRung*, Place>> m_coils;
    std::map<AreaId, std::vector<bool>> m_written; ///< by byte
};

} // namespace

ProgramSize checkTogether(std::span<const ResolvedProgram> programs, const LanguageContext& context, std::span<Diagnostics> diagnostics)
{
    return ProjectRules(programs, context, diagnostics).run();
}

} // namespace camwright
