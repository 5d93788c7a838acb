#include "core/language/check/checkprogram.h"

#include "core/language/check/controlrules.h"
#include "core/language/check/operandtypes.h"
#include "core/language/source/letters.h"

#include <fmt/format.h>

#include <algorithm>

namespace camwright {

namespace {

bool isStructural(StatementRole role)
{
    return role >= StatementRole::AndBlock && role <= StatementRole::CloseGroup;
}

bool hasHiddenMemory(StatementRole role, ContactForm form)
{
    return role == StatementRole::Block || form == ContactForm::Rising || form == ContactForm::Falling;
}

/// What packed decimal digits mean: 16#31 is 31. A range of the catalogue is about that number.
double numberOfDigits(std::uint64_t bcd)
{
    double out = 0;
    for (int shift = 60; shift >= 0; shift -= 4)
        out = out * 10 + static_cast<double>(bcd >> shift & 0xF);
    return out;
}

/// Checks one statement: decides the types of its operands, then looks at ranges, groups and blocks.
class StatementCheck {
public:
    StatementCheck(const ResolvedStatement& statement, const LanguageContext& context, DiagnosticSink& sink)
        : m_statement(statement), m_context(context), m_family(*context.family), m_sink(sink), m_instruction(*statement.instruction)
    {
    }

    std::optional<CheckedStatement> run()
    {
        for (const ResolvedOperand& operand : m_statement.operands) {
            checkKind(operand);
            m_types.push_back(candidates(operand));
        }
        decideTypes();
        if (!m_ok)
            return std::nullopt;
        CheckedStatement out;
        out.role = m_statement.role;
        out.form = m_statement.form;
        out.instruction = &m_instruction;
        out.range = m_statement.range;
        for (std::size_t i = 0; i < m_statement.operands.size(); ++i)
            out.operands.push_back(checked(i));
        checkLinkGroups();
        checkBlocks(out);
        out.type = commonType();
        return m_ok ? std::optional(std::move(out)) : std::nullopt;
    }

private:
    void report(Code code, const ResolvedOperand& operand, std::vector<std::string> arguments)
    {
        m_sink.add(code, operand.range, std::move(arguments));
        m_ok = false;
    }

    static const ResolvedMemory* memoryOf(const ResolvedOperand& operand) { return std::get_if<ResolvedMemory>(&operand.value); }
    static const Literal* literalOf(const ResolvedOperand& operand) { return std::get_if<Literal>(&operand.value); }

    /// Whether memory or a constant may stand at the pin at all, and in which area.
    void checkKind(const ResolvedOperand& operand)
    {
        const Pin& pin = *operand.pin;
        const std::string text = shortened(operand.text);
        if (literalOf(operand)) {
            if (pin.kind == PinKind::Timer)
                report(Code::NeedsTimer, operand, {text, pin.name, m_instruction.mnemonic});
            else if (pin.kind == PinKind::Counter)
                report(Code::NeedsCounter, operand, {text, pin.name, m_instruction.mnemonic});
            else if (pin.direction != PinDirection::In && pin.kind != PinKind::Axis)
                report(Code::OutputNeedsMemory, operand, {text, pin.name, m_instruction.mnemonic});
            else if (!pin.constantAllowed && pin.kind != PinKind::Axis)
                report(Code::ConstantNotAllowed, operand, {text, pin.name, m_instruction.mnemonic, areaNames(pin, m_family)});
        } else if (const ResolvedMemory* memory = memoryOf(operand)) {
            if (pin.kind == PinKind::Timer || pin.kind == PinKind::Counter)
                checkElement(operand, *memory);
            else if (memory->index && !takesSubscript(pin))
                report(Code::SubscriptNotAllowed, operand, {text, pin.name, m_instruction.mnemonic});
            else if (pin.areas.empty())
                report(Code::ConstantOnly, operand, {text, pin.name, m_instruction.mnemonic});
            else if (!areaAllowed(pin, memory->address, m_family))
                report(Code::WrongArea, operand, {text, pin.name, m_instruction.mnemonic, areaNames(pin, m_family)});
        }
    }

    /// TS-IDX-06: blocks of elements, and what the controller's blocks do themselves, have fixed places.
    bool takesSubscript(const Pin& pin) const
    {
        static constexpr std::string_view ByBlock[] = {"block", "motion", "clock", "convert"};
        const bool runsAsBlock = std::ranges::find(ByBlock, m_instruction.group) != std::end(ByBlock) && !isPlainConversion(m_instruction.id);
        return pin.kind == PinKind::Value && !runsAsBlock && !isFunction(m_instruction.id);
    }

    static bool isPlainConversion(InstructionId id)
    {
        return id >= InstructionId::InvtItd && id <= InstructionId::InvtDint;
    }

    static bool isFunction(InstructionId id)
    {
        return (id >= InstructionId::InvtSin && id <= InstructionId::InvtExp) || id == InstructionId::InvtSmov || id == InstructionId::InvtFmov
            || id == InstructionId::InvtDfmov || id == InstructionId::InvtBmov || id == InstructionId::InvtZset || id == InstructionId::InvtZrst;
    }

    void checkElement(const ResolvedOperand& operand, const ResolvedMemory& memory)
    {
        const Pin& pin = *operand.pin;
        const bool timer = pin.kind == PinKind::Timer;
        const AreaKind wanted = timer ? AreaKind::TimerBits : AreaKind::CounterBits;
        if (memory.address.area == VariablesArea || m_family.area(memory.address.area).kind != wanted) {
            report(timer ? Code::NeedsTimer : Code::NeedsCounter, operand, {shortened(operand.text), pin.name, m_instruction.mnemonic});
            return;
        }
        checkRange(operand, m_family.elementNumber(memory.address));
    }

    /// Types the operand can have at its pin. Empty where types do not matter.
    TypeSet candidates(const ResolvedOperand& operand)
    {
        const Pin& pin = *operand.pin;
        if (!m_ok || pin.kind == PinKind::Timer || pin.kind == PinKind::Counter || pin.kind == PinKind::Program)
            return {};
        if (const Literal* literal = literalOf(operand)) {
            const TypeSet pinTypes = pin.kind == PinKind::Axis ? TypeSet{DataType::Int} : pin.types;
            const TypeSet out = intersection(literal->types(), pinTypes);
            if (out.isEmpty())
                reportConstantType(operand, *literal, pinTypes);
            return out;
        }
        const ResolvedMemory* memory = memoryOf(operand);
        if (!memory)
            return {};
        const TypeSet pinTypes = pin.kind == PinKind::Axis ? TypeSet{DataType::Int} : pin.types;
        if (pin.kind == PinKind::Block)
            return blockTypes(operand, *memory);
        const MemoryTypes types = typesOf(*memory, m_context);
        const TypeSet out = intersection(types.possible, pinTypes);
        if (!out.isEmpty())
            return out;
        if (types.forcing) {
            report(Code::ForcedTypeDiffers, operand, {shortened(operand.text), std::string(name(types.forcing->type)),
                types.forcing->name, typeNames(pinTypes)});
            m_sink.relate(types.forcing->place);
        } else {
            report(Code::WrongType, operand, {shortened(operand.text), typeNames(types.possible), pin.name, m_instruction.mnemonic, typeNames(pinTypes)});
        }
        return {};
    }

    /// A list may hold values of any type in its cells; only its start must lie on a place of the cell's width.
    TypeSet blockTypes(const ResolvedOperand& operand, const ResolvedMemory& memory)
    {
        const Pin& pin = *operand.pin;
        TypeSet out;
        for (const DataType type : pin.types.list())
            if (m_family.withType(memory.address, type, *m_context.model))
                out.insert(type);
        if (out.isEmpty())
            report(Code::WrongType, operand, {shortened(operand.text), typeNames(typesOf({memory.address, nullptr}, m_context).possible),
                pin.name, m_instruction.mnemonic, typeNames(pin.types)});
        return out;
    }

    void reportConstantType(const ResolvedOperand& operand, const Literal& literal, const TypeSet& pinTypes)
    {
        const bool wantsReal = pinTypes.contains(DataType::Real) && !literal.types().contains(DataType::Real) && literal.types().contains(DataType::Dint);
        const bool untyped = literal.types().list().size() > 1;
        if (wantsReal || (untyped && pinTypes.contains(DataType::Bool)) || untyped)
            report(Code::BadConstant, operand, {shortened(operand.text), typeNames(pinTypes), wantsReal ? shortened(operand.text) + ".0"
                : pinTypes.contains(DataType::Bool) ? "TRUE" : "12"});
        else
            report(Code::WrongType, operand, {shortened(operand.text), typeNames(literal.types()), operand.pin->name, m_instruction.mnemonic, typeNames(pinTypes)});
    }

    bool isTyped(std::size_t i) const { return !m_types[i].isEmpty(); }

    /// Pins of one group share a type; a pin without a group has its own.
    void decideTypes()
    {
        m_decided.assign(m_types.size(), DataType::Bool);
        std::vector<bool> done(m_types.size(), false);
        for (std::size_t i = 0; i < m_types.size() && m_ok; ++i) {
            if (done[i] || !isTyped(i))
                continue;
            std::vector<std::size_t> members{i};
            const std::uint8_t group = m_statement.operands[i].pin->typeGroup;
            for (std::size_t j = i + 1; group != 0 && j < m_types.size(); ++j)
                if (isTyped(j) && m_statement.operands[j].pin->typeGroup == group)
                    members.push_back(j);
            for (const std::size_t member : members)
                done[member] = true;
            decideGroup(members);
        }
    }

    void decideGroup(const std::vector<std::size_t>& members)
    {
        TypeSet common = m_types[members.front()];
        for (const std::size_t member : members) {
            const TypeSet next = intersection(common, m_types[member]);
            if (next.isEmpty()) {
                const ResolvedOperand& first = m_statement.operands[members.front()];
                const ResolvedOperand& other = m_statement.operands[member];
                report(Code::TypesDiffer, other, {shortened(first.text), typeNames(m_types[members.front()]), shortened(other.text),
                    typeNames(m_types[member]), m_instruction.mnemonic});
                return;
            }
            common = next;
        }
        const DataType type = decide(members, common);
        for (const std::size_t member : members)
            m_decided[member] = type;
    }

    /// The natural type of the first place in memory, or the preferred one; another if a constant needs it.
    DataType decide(const std::vector<std::size_t>& members, const TypeSet& common) const
    {
        DataType out = preferredType(common);
        for (const std::size_t member : members)
            if (const ResolvedMemory* memory = memoryOf(m_statement.operands[member]); memory && common.contains(memory->address.type)) {
                out = memory->address.type;
                break;
            }
        const auto fits = [&](DataType type) {
            return std::all_of(members.begin(), members.end(), [&](std::size_t member) {
                const Literal* literal = literalOf(m_statement.operands[member]);
                return !literal || literal->as(type).ok();
            });
        };
        if (!fits(out))
            for (const DataType other : common.list())
                if (fits(other))
                    return other;
        return out;
    }

    CheckedOperand checked(std::size_t i)
    {
        const ResolvedOperand& operand = m_statement.operands[i];
        CheckedOperand out{operand.pin, NoOperand{}, operand.range};
        if (const ResolvedMemory* memory = memoryOf(operand))
            out.value = checkedMemory(*operand.pin, *memory, m_decided[i]);
        else if (const Literal* literal = literalOf(operand))
            out.value = checkedConstant(operand, *literal, m_decided[i]);
        else if (const auto* program = std::get_if<ResolvedProgramName>(&operand.value))
            out.value = ProgramOperand{program->name};
        else if (const auto* label = std::get_if<ResolvedLabel>(&operand.value))
            out.value = LabelOperand{label->name};
        else if (!operand.pin->defaultValue.empty())
            if (const auto value = parseValue(preferredType(operand.pin->types), operand.pin->defaultValue))
                out.value = ConstantOperand{*value};
        return out;
    }

    OperandValue checkedMemory(const Pin& pin, const ResolvedMemory& memory, DataType type) const
    {
        const std::string symbol = memory.variable ? memory.variable->name : std::string();
        if (pin.kind == PinKind::Timer || pin.kind == PinKind::Counter) {
            const auto value = m_family.valueOf(memory.address);
            return AddressOperand{memory.address, value ? value->type : DataType::Int, symbol, 0, {}};
        }
        Address address = memory.address;
        if (address.area == VariablesArea)
            address.type = type;
        else if (const auto typed = m_family.withType(address, type, *m_context.model))
            address = *typed;
        if (pin.kind == PinKind::Block)
            return BlockOperand{address, type, pin.countPin.empty() ? std::optional<std::uint32_t>(pin.fixedCount) : std::nullopt};
        AddressOperand out{address, type, symbol, 0, {}};
        if (memory.index) {
            out.elements = memory.variable->elements;
            out.index = memory.indexAddress;
            out.index.type = memory.index->type;
        }
        return out;
    }

    OperandValue checkedConstant(const ResolvedOperand& operand, const Literal& literal, DataType type)
    {
        const auto value = literal.as(type);
        if (!value) {
            Diagnostic diagnostic = value.error();
            diagnostic.place = Place{m_sink.object(), {}, operand.range, {}};
            m_sink.add(std::move(diagnostic));
            m_ok = false;
            return NoOperand{};
        }
        checkRange(operand, operand.pin->bcd ? numberOfDigits(value->bits) : value->asDouble());
        return ConstantOperand{*value};
    }

    void checkRange(const ResolvedOperand& operand, double value)
    {
        const Pin& pin = *operand.pin;
        const bool low = pin.minimum && value < *pin.minimum;
        const bool high = pin.maximum && value > *pin.maximum;
        if (!low && !high)
            return;
        const auto show = [](const std::optional<double>& limit) { return limit ? fmt::format("{}", *limit) : std::string("..."); };
        report(Code::ConstantOutOfRange, operand, {shortened(operand.text), pin.name, m_instruction.mnemonic, show(pin.minimum), show(pin.maximum)});
    }

    /// KS-MEM-08: the pins of one group are all constants or all memory.
    void checkLinkGroups()
    {
        std::string seen;
        for (const ResolvedOperand& operand : m_statement.operands) {
            const char group = operand.pin->linkGroup;
            if (group == 0 || seen.find(group) != std::string::npos)
                continue;
            seen += group;
            std::string names;
            const ResolvedOperand* odd = nullptr;
            for (const ResolvedOperand& other : m_statement.operands) {
                if (other.pin->linkGroup != group)
                    continue;
                names += (names.empty() ? "" : ", ") + other.pin->name;
                if (!odd && other.value.index() != operand.value.index())
                    odd = &other;
            }
            if (odd)
                report(Code::MixedConstants, *odd, {names, m_instruction.mnemonic});
        }
    }

    /// KS-MEM-07: a list lies wholly inside its area where its length is known.
    void checkBlocks(CheckedStatement& out)
    {
        for (std::size_t i = 0; i < out.operands.size(); ++i) {
            auto* block = std::get_if<BlockOperand>(&out.operands[i].value);
            const Pin& pin = *out.operands[i].pin;
            if (!block)
                continue;
            for (const CheckedOperand& other : out.operands)
                if (const auto* count = std::get_if<ConstantOperand>(&other.value); count && other.pin->name == pin.countPin)
                    block->elements = static_cast<std::uint32_t>(std::max<std::int64_t>(0, count->value.asInteger()));
            if (!block->elements || block->start.area == VariablesArea)
                continue;
            const std::uint64_t bytes = std::uint64_t{*block->elements} * pin.elementBytes;
            if (m_family.blockFits(block->start, bytes, *m_context.model))
                continue;
            const std::uint32_t left = m_context.model->area(block->start.area).bytes - block->start.byte;
            report(Code::BlockOutsideArea, m_statement.operands[i], {std::to_string(*block->elements), shortened(m_statement.operands[i].text),
                std::to_string(bytes), std::to_string(left)});
        }
    }

    /// The type of the group, or of the first operand that is more than a bit.
    DataType commonType() const
    {
        for (std::size_t i = 0; i < m_decided.size(); ++i)
            if (isTyped(i) && m_statement.operands[i].pin->typeGroup != 0)
                return m_decided[i];
        for (std::size_t i = 0; i < m_decided.size(); ++i)
            if (isTyped(i) && m_statement.operands[i].pin->kind == PinKind::Value)
                return m_decided[i];
        return DataType::Bool;
    }

    const ResolvedStatement& m_statement;
    const LanguageContext& m_context;
    const Family& m_family;
    DiagnosticSink& m_sink;
    const Instruction& m_instruction;
    std::vector<TypeSet> m_types;
    std::vector<DataType> m_decided;
    bool m_ok = true;
};

} // namespace

std::optional<CheckedProgram> checkProgram(const ResolvedProgram& program, const LanguageContext& context, Diagnostics& diagnostics)
{
    DiagnosticSink sink(diagnostics, program.key);
    CheckedProgram out{program.key, program.role, program.dialect, {}, 0, program.parameters, program.event};
    bool ok = checkControl(program, sink) && program.isComplete;
    for (const ResolvedNetwork& network : program.networks) {
        CheckedNetwork checkedNetwork{network.number, {}, network.range};
        for (const ResolvedRung& rung : network.rungs) {
            CheckedRung checkedRung{{}, rung.drawable, rung.tree, rung.range};
            for (const ResolvedStatement& statement : rung.statements) {
                auto checked = statement.isComplete ? StatementCheck(statement, context, sink).run() : std::nullopt;
                ok = ok && checked;
                if (!checked)
                    continue;
                if (hasHiddenMemory(checked->role, checked->form) && !isStructural(checked->role))
                    checked->instance = out.instances++;
                checkedRung.statements.push_back(std::move(*checked));
            }
            checkedNetwork.rungs.push_back(std::move(checkedRung));
        }
        out.networks.push_back(std::move(checkedNetwork));
    }
    return ok ? std::optional(std::move(out)) : std::nullopt;
}

} // namespace camwright
