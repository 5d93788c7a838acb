#include "core/language/assist/crossreference.h"

#include "core/language/assist/spot.h"
#include "core/language/check/operandtypes.h"
#include "core/language/check/resolvedprogram.h"
#include "core/language/source/letters.h"

#include <algorithm>
#include <charconv>

namespace camwright {

namespace {

std::uint64_t bitsOf(const Address& address)
{
    return address.isBit ? 1 : std::uint64_t{byteWidth(address.type)} * 8;
}

std::uint64_t firstBit(const Address& address)
{
    return std::uint64_t{address.byte} * 8 + (address.isBit ? address.bit : 0);
}

MemoryTarget memoryTarget(const LanguageContext& context, Address address, const std::string& program)
{
    if (address.area == VariablesArea)
        return {address, bitsOf(address), {}};
    if (const auto bit = context.family->bitOf(address))
        address = *bit;
    return {address, bitsOf(address), context.family->area(address.area).local ? program : std::string()};
}

bool takesAxis(const Pin& pin, const Instruction& instruction)
{
    return pin.kind == PinKind::Axis || (pin.name == "AXIS" && instruction.needs == Capability::MotionAxes);
}

std::optional<std::uint32_t> numberOf(const Literal& literal)
{
    const auto value = literal.as(DataType::Dint);
    return value && value->asInteger() >= 0 ? std::optional(static_cast<std::uint32_t>(value->asInteger())) : std::nullopt;
}

/// How many elements a list has where that is known, else one.
std::uint64_t elementsOf(const Pin& pin, const ResolvedStatement& statement)
{
    if (pin.countPin.empty())
        return std::max(1u, pin.fixedCount);
    for (const ResolvedOperand& operand : statement.operands)
        if (const auto* count = std::get_if<Literal>(&operand.value); count && operand.pin->name == pin.countPin)
            return std::max(1u, numberOf(*count).value_or(1));
    return 1;
}

UseKind kindOf(PinDirection direction)
{
    return direction == PinDirection::In ? UseKind::Reads : direction == PinDirection::Out ? UseKind::Writes : UseKind::ReadsAndWrites;
}

std::vector<std::string_view> linesOf(std::string_view text)
{
    std::vector<std::string_view> out;
    for (std::size_t begin = 0; begin <= text.size();) {
        const std::size_t end = std::min(text.find('\n', begin), text.size());
        out.push_back(text.substr(begin, end - begin));
        begin = end + 1;
    }
    return out;
}

std::string_view withoutLineEnd(std::string_view line)
{
    line = trimmed(line);
    while (!line.empty() && line.back() == '\r')
        line.remove_suffix(1);
    return line;
}

class UseCollector {
public:
    UseCollector(const Project& project, const LanguageContext& context) : m_project(project), m_context(context) {}

    std::vector<SymbolUse> run()
    {
        declarations();
        for (const ObjectPtr& object : m_project.objects(ObjectKind::Program))
            if (const auto* source = std::get_if<Program>(&object->content); source && source->language == ProgramLanguage::InstructionList)
                program(object->key, *source);
        for (const ObjectPtr& object : m_project.objects(ObjectKind::WatchTable))
            if (const auto* table = std::get_if<WatchTable>(&object->content))
                watches(object->key, *table);
        return std::move(m_uses);
    }

private:
    void declare(ReferenceTarget target, Place place, const std::string& text)
    {
        m_uses.push_back({UseKind::Declares, std::move(target), std::move(place), text, {}, {}, 0});
    }

    void declarations()
    {
        for (const KnownVariable& variable : m_context.variables)
            if (variable.address)
                declare(memoryTarget(m_context, *variable.address, {}), variable.place, variable.name);
        for (const KnownAxis& axis : m_context.axes)
            declare(AxisTarget{axis.number}, Place{{ObjectKind::Axis, axis.name}, {}, {}, {}}, axis.name);
        for (const KnownProgram& program : m_context.programs)
            declare(ProgramTarget{program.name}, Place{{ObjectKind::Program, program.name}, "source", {1, 1, 1, 1}, {}}, program.name);
    }

    void program(const ObjectKey& key, const Program& source)
    {
        Diagnostics ignored; // the checks tell them
        const ResolvedProgram resolved = resolve(parseIl(*m_context.dialect, source.source, key), source.role, m_context, ignored);
        m_key = key;
        m_lines = linesOf(source.source);
        for (const ResolvedNetwork& network : resolved.networks) {
            m_network = network.number;
            for (const ResolvedRung& rung : network.rungs)
                for (const ResolvedStatement& statement : rung.statements)
                    for (const ResolvedOperand& operand : statement.operands)
                        use(statement, operand);
        }
    }

    void use(const ResolvedStatement& statement, const ResolvedOperand& operand)
    {
        const Pin& pin = *operand.pin;
        if (const auto* called = std::get_if<ResolvedProgramName>(&operand.value)) {
            add(UseKind::Calls, ProgramTarget{called->name}, statement, operand);
        } else if (const auto* literal = std::get_if<Literal>(&operand.value)) {
            const auto number = takesAxis(pin, *statement.instruction) ? numberOf(*literal) : std::nullopt;
            if (number)
                add(UseKind::Commands, AxisTarget{*number}, statement, operand);
        } else if (const auto* memory = std::get_if<ResolvedMemory>(&operand.value)) {
            MemoryTarget target = memoryTarget(m_context, addressAtPin(*memory, pin, m_context), m_key.name);
            if (pin.kind == PinKind::Block)
                target.bits = std::max<std::uint64_t>(target.bits, elementsOf(pin, statement) * pin.elementBytes * 8);
            add(kindOf(pin.direction), std::move(target), statement, operand);
        }
    }

    void add(UseKind kind, ReferenceTarget target, const ResolvedStatement& statement, const ResolvedOperand& operand)
    {
        const std::size_t line = operand.range.line;
        m_uses.push_back({kind, std::move(target), Place{m_key, "source", operand.range, {}}, operand.text,
            std::string(line > 0 && line <= m_lines.size() ? withoutLineEnd(m_lines[line - 1]) : std::string_view()),
            statement.instruction->mnemonic, m_network});
    }

    void watches(const ObjectKey& key, const WatchTable& table)
    {
        for (std::size_t row = 0; row < table.rows.size(); ++row)
            if (auto target = targetNamed(m_context, table.rows[row].expression))
                m_uses.push_back({UseKind::Watches, std::move(*target), Place{key, "rows[" + std::to_string(row) + "]", {}, {}},
                    table.rows[row].expression, {}, {}, 0});
    }

    const Project& m_project;
    const LanguageContext& m_context;
    std::vector<SymbolUse> m_uses;
    ObjectKey m_key;
    std::vector<std::string_view> m_lines;
    std::uint32_t m_network = 0;
};

/// The axis in `axis.NAME.field`, NAME plain, quoted, or the number.
std::optional<ReferenceTarget> axisOfValue(const LanguageContext& context, std::string_view rest)
{
    const bool quoted = rest.starts_with('"');
    const std::size_t begin = quoted ? 1 : 0;
    const std::size_t end = std::min(rest.find(quoted ? '"' : '.', begin), rest.size());
    const std::string_view word = rest.substr(begin, end - begin);
    if (const KnownAxis* axis = context.findAxis(word))
        return AxisTarget{axis->number};
    std::uint32_t number = 0;
    const auto [last, error] = std::from_chars(word.data(), word.data() + word.size(), number);
    if (quoted || error != std::errc{} || last != word.data() + word.size() || !context.findAxis(number))
        return std::nullopt;
    return AxisTarget{number};
}

} // namespace

std::vector<SymbolUse> crossReference(const Project& project)
{
    const auto context = contextOf(project);
    return context ? UseCollector(project, *context).run() : std::vector<SymbolUse>();
}

std::optional<ReferenceTarget> targetAt(const LanguageContext& context, const std::string& program, std::string_view text, std::size_t offset)
{
    const Spot spot = spotAt(context, text, offset);
    if (spot.word.empty() || spot.isMnemonic || spot.isComment)
        return std::nullopt;
    if (spot.pin && spot.pin->kind == PinKind::Program)
        return context.findProgram(spot.word) ? std::optional<ReferenceTarget>(ProgramTarget{spot.word}) : std::nullopt;
    if (spot.pin && spot.instruction && takesAxis(*spot.pin, *spot.instruction)) {
        if (const KnownAxis* axis = context.findAxis(std::string_view(spot.word)))
            return AxisTarget{axis->number};
        if (const auto literal = Literal::read(spot.word))
            if (const auto number = numberOf(*literal))
                return AxisTarget{*number};
    }
    ResolvedMemory memory;
    if (const KnownVariable* variable = context.findVariable(spot.word); variable && variable->address)
        memory = {*variable->address, variable};
    else if (const auto address = context.family->parseAddress(spot.word, *context.model))
        memory = {*address, nullptr};
    else
        return std::nullopt;
    return memoryTarget(context, spot.pin ? addressAtPin(memory, *spot.pin, context) : memory.address, program);
}

std::optional<ReferenceTarget> targetNamed(const LanguageContext& context, std::string_view name)
{
    for (const std::string_view prefix : {"axis.", "plant."})
        if (name.starts_with(prefix))
            return axisOfValue(context, name.substr(prefix.size()));
    if (const KnownVariable* variable = context.findVariable(name); variable && variable->address)
        return memoryTarget(context, *variable->address, {});
    if (const auto address = context.family->parseAddress(name, *context.model, AddressMode::Typed))
        return memoryTarget(context, *address, {});
    if (const KnownAxis* axis = context.findAxis(name))
        return AxisTarget{axis->number};
    if (context.findProgram(name))
        return ProgramTarget{std::string(name)};
    return std::nullopt;
}

std::string nameOf(const LanguageContext& context, const ReferenceTarget& target)
{
    if (const auto* program = std::get_if<ProgramTarget>(&target))
        return program->name;
    if (const auto* axis = std::get_if<AxisTarget>(&target)) {
        const KnownAxis* known = context.findAxis(axis->number);
        return known ? known->name + " (" + std::to_string(axis->number) + ")" : std::to_string(axis->number);
    }
    const Address& address = std::get<MemoryTarget>(target).address;
    if (address.area == VariablesArea) {
        for (const KnownVariable& variable : context.variables)
            if (variable.address == address)
                return variable.name;
        return {};
    }
    const std::string text = context.family->formatAddress(address);
    const KnownVariable* variable = context.variableAt(address);
    return variable ? variable->name + " (" + text + ")" : text;
}

ReferenceMatch match(const ReferenceTarget& sought, const ReferenceTarget& used)
{
    const auto* a = std::get_if<MemoryTarget>(&sought);
    const auto* b = std::get_if<MemoryTarget>(&used);
    if (!a || !b)
        return sought == used ? ReferenceMatch::Same : ReferenceMatch::None;
    // A watch table says no program: it may mean the local memory of any.
    const bool otherBlock = !a->program.empty() && !b->program.empty() && a->program != b->program;
    if (a->address.area != b->address.area || otherBlock)
        return ReferenceMatch::None;
    const std::uint64_t first = firstBit(a->address), other = firstBit(b->address);
    if (first >= other + b->bits || other >= first + a->bits)
        return ReferenceMatch::None;
    return first == other && a->bits == b->bits ? ReferenceMatch::Same : ReferenceMatch::Overlap;
}

std::vector<Reference> referencesTo(const ReferenceTarget& target, const std::vector<SymbolUse>& uses)
{
    std::vector<Reference> out;
    for (const SymbolUse& use : uses)
        if (const ReferenceMatch found = match(target, use.target); found != ReferenceMatch::None)
            out.push_back({use, found == ReferenceMatch::Overlap});
    return out;
}

} // namespace camwright
