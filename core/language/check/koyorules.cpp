#include "core/language/check/koyorules.h"

#include "core/family/koyo/koyoareas.h"
#include "core/language/check/koyocontents.h"
#include "core/language/source/letters.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace camwright {

namespace {

constexpr unsigned MaximumStations = 15, ShortestCycleUs = 1000, LongestCycleUs = 8000;
constexpr unsigned StationWord = 0, CycleWord = 1, FirstCommandWord = 020, StationStride = 040;

/// D2-REG-04, with one C2 channel and three retries: a cycle is longer than this.
constexpr unsigned leastCycleUs(unsigned stations) { return 44 + (stations + 1 + 3 + 1) * 95; }

/// Commands a program does not send (D2-PRG-06).
constexpr std::array<std::uint32_t, 5> ForbiddenCommands{0x34, 0x1B, 0x38, 0x3E, 0x3F};

std::optional<unsigned> fromBcd(std::uint32_t word)
{
    unsigned out = 0;
    for (int shift = 12; shift >= 0; shift -= 4) {
        const std::uint32_t digit = word >> shift & 0xF;
        if (digit > 9)
            return std::nullopt;
        out = out * 10 + digit;
    }
    return out;
}

/// Bytes of the memory an operand takes. Registers of two words hold 32-bit values.
struct Extent {
    AreaId area = 0;
    std::uint32_t begin = 0, end = 0;
    bool overlaps(const Extent& other) const { return area == other.area && begin < other.end && other.begin < end; }
    bool operator==(const Extent&) const = default;
};

std::optional<Extent> extentOf(const ResolvedOperand& operand)
{
    const auto* memory = std::get_if<ResolvedMemory>(&operand.value);
    if (!memory)
        return std::nullopt;
    const Address& address = memory->address;
    const Pin& pin = *operand.pin;
    const std::uint32_t bytes = address.isBit ? 1 : pin.kind == PinKind::Block ? pin.elementBytes * pin.fixedCount : byteWidth(pin.mainType);
    return Extent{address.area, address.byte, address.byte + std::max(1u, bytes)};
}

/// The registers of one module, known from the constant in its pointer register.
struct ModuleBlock {
    unsigned slot = 0;
    Extent extent;
    std::uint32_t firstWord = 0;
};

struct WorkArea {
    Extent extent;
    std::size_t program = 0;
    const ResolvedStatement* box = nullptr;
    const ResolvedOperand* operand = nullptr;
};

class KoyoRules {
public:
    KoyoRules(std::span<const ResolvedProgram> programs, const LanguageContext& context, std::span<Diagnostics> diagnostics)
        : m_programs(programs), m_context(context), m_diagnostics(diagnostics), m_contents(programs)
    {
    }

    void run()
    {
        checkSubroutines();
        findModules();
        for (std::size_t i = 0; i < m_programs.size(); ++i) {
            checkLoops(i);
            forEachStatement(i, [&](const ResolvedStatement& statement) { noteWorkAreas(i, statement); });
        }
        std::ranges::sort(m_work, {}, [](const WorkArea& area) { return std::pair(area.extent.area, area.extent.begin); });
        for (std::size_t i = 0; i < m_programs.size(); ++i)
            forEachStatement(i, [&](const ResolvedStatement& statement) { checkStatement(i, statement); });
    }

private:
    /// Statements with a known mnemonic, whatever is wrong with their operands.
    template <class Visitor>
    void forEachInstruction(std::size_t program, Visitor visit)
    {
        for (const ResolvedNetwork& network : m_programs[program].networks)
            for (const ResolvedRung& rung : network.rungs)
                for (const ResolvedStatement& statement : rung.statements)
                    if (statement.instruction)
                        visit(statement);
    }

    template <class Visitor>
    void forEachStatement(std::size_t program, Visitor visit)
    {
        forEachInstruction(program, [&](const ResolvedStatement& statement) {
            if (statement.isComplete)
                visit(statement);
        });
    }

    void report(std::size_t program, Code code, const TextRange& range, std::vector<std::string> arguments)
    {
        DiagnosticSink(m_diagnostics[program], m_programs[program].key).add(code, range, std::move(arguments));
    }

    static bool isBox(const ResolvedStatement& statement) { return statement.instruction->id >= InstructionId::KoyoMlNop; }

    void checkSubroutines()
    {
        std::map<std::string, std::string> owners;
        for (std::size_t i = 0; i < m_programs.size(); ++i) {
            bool isFirst = true;
            const bool isSubroutine = m_programs[i].role == ProgramRole::Subroutine;
            forEachStatement(i, [&](const ResolvedStatement& statement) {
                const InstructionId id = statement.instruction->id;
                const bool isReturn = id == InstructionId::KoyoRt || id == InstructionId::KoyoRtc;
                if ((id == InstructionId::KoyoSbr && !(isSubroutine && isFirst)) || (isReturn && !isSubroutine))
                    report(i, Code::SubroutineMarkMisplaced, statement.range, {statement.instruction->mnemonic});
                else if (id == InstructionId::KoyoSbr)
                    noteNumber(i, statement, owners);
                isFirst = false;
            });
        }
    }

    void noteNumber(std::size_t program, const ResolvedStatement& statement, std::map<std::string, std::string>& owners)
    {
        const std::string number = upperCase(statement.operands.front().text);
        const auto [owner, isNew] = owners.emplace(number, m_programs[program].key.name);
        if (!isNew)
            report(program, Code::SubroutineNumberTwice, statement.operands.front().range, {number, owner->second});
    }

    void checkLoops(std::size_t program)
    {
        std::vector<TextRange> open;
        forEachInstruction(program, [&](const ResolvedStatement& statement) {
            if (statement.instruction->id == InstructionId::KoyoFor)
                open.push_back(statement.range);
            if (statement.instruction->id != InstructionId::KoyoNext)
                return;
            if (open.empty())
                report(program, Code::LoopNotOpen, statement.range, {});
            else
                open.pop_back();
        });
        for (const TextRange& range : open)
            report(program, Code::LoopNotClosed, range, {});
    }

    /// D2-REG-01 … 04: what the pointer registers hold, and what stands in the blocks they point to.
    void findModules()
    {
        for (unsigned slot = 1; slot <= koyo::LastSlot; ++slot) {
            const KnownContent* pointer = m_contents.find(valueAddress(koyo::V, (koyo::FirstPointer + slot - 1) * 2, DataType::Word));
            if (!pointer || pointer->value == 0)
                continue;
            const auto start = m_context.family->parseAddress(fmt::format("V{:o}", pointer->value), *m_context.model);
            if (!start || !m_context.family->blockFits(*start, koyo::BlockWords * 2, *m_context.model)) {
                report(pointer->program, Code::ModuleBlockOutside, pointer->range, {std::to_string(slot), fmt::format("R{:o}", pointer->value)});
                continue;
            }
            const Extent extent{start->area, start->byte, start->byte + koyo::BlockWords * 2};
            for (const ModuleBlock& other : m_modules)
                if (extent.overlaps(other.extent))
                    reportBlock(pointer->program, pointer->range, fmt::format("R{:o}", pointer->value), other);
            m_modules.push_back({slot, extent, pointer->value});
            checkModule(m_modules.back());
        }
    }

    void reportBlock(std::size_t program, const TextRange& range, const std::string& what, const ModuleBlock& block)
    {
        report(program, Code::ModuleBlockShared, range, {what, fmt::format("R{:o}", block.firstWord),
            fmt::format("R{:o}", block.firstWord + koyo::BlockWords - 1), std::to_string(block.slot)});
    }

    const KnownContent* contentAt(const ModuleBlock& block, unsigned word) const
    {
        return m_contents.find(valueAddress(block.extent.area, block.extent.begin + word * 2, DataType::Word));
    }

    void checkModule(const ModuleBlock& block)
    {
        const KnownContent* count = contentAt(block, StationWord);
        const KnownContent* cycle = contentAt(block, CycleWord);
        const auto stations = count ? fromBcd(count->value) : std::nullopt;
        const auto microseconds = cycle ? fromBcd(cycle->value) : std::nullopt;
        const bool countIsLegal = stations && *stations >= 1 && *stations <= MaximumStations;
        const bool cycleIsLegal = microseconds && *microseconds >= ShortestCycleUs && *microseconds <= LongestCycleUs;
        if (count && !countIsLegal)
            report(count->program, Code::StationCountIllegal, count->range, {fmt::format("{:X}", count->value)});
        if (cycle && !cycleIsLegal)
            report(cycle->program, Code::CycleIllegal, cycle->range, {fmt::format("{:X}", cycle->value)});
        if (countIsLegal && cycleIsLegal && *microseconds <= leastCycleUs(*stations))
            report(cycle->program, Code::CycleTooShort, cycle->range, {std::to_string(*microseconds), std::to_string(*stations),
                std::to_string(leastCycleUs(*stations))});
        for (unsigned station = 0; station < MaximumStations; ++station) {
            const KnownContent* command = contentAt(block, FirstCommandWord + StationStride * station + 1);
            if (command && std::ranges::find(ForbiddenCommands, command->value & 0xFF) != ForbiddenCommands.end())
                report(command->program, Code::CommandNotForPrograms, command->range, {fmt::format("{:02X}", command->value & 0xFF)});
        }
    }

    void noteWorkAreas(std::size_t program, const ResolvedStatement& statement)
    {
        for (const ResolvedOperand& operand : statement.operands)
            if (operand.pin->isPrivate)
                if (const auto extent = extentOf(operand))
                    m_work.push_back({*extent, program, &statement, &operand});
    }

    void checkStatement(std::size_t program, const ResolvedStatement& statement)
    {
        for (const ResolvedOperand& operand : statement.operands) {
            const auto extent = extentOf(operand);
            if (!extent)
                continue;
            checkWorkAreas(program, statement, operand, *extent);
            if (!isBox(statement))
                continue;
            if (!operand.pin->types.contains(DataType::Bool))
                checkModules(program, operand, *extent);
            checkContent(statement, operand);
        }
        if (isBox(statement)) {
            checkOverlaps(program, statement);
            checkAxes(program, statement);
        }
    }

    /// Work areas are at most 50 bytes long, so few of them can begin before the operand and reach it.
    void checkWorkAreas(std::size_t program, const ResolvedStatement& statement, const ResolvedOperand& operand, const Extent& extent)
    {
        constexpr std::uint32_t LongestWorkArea = 50;
        const std::uint32_t from = extent.begin >= LongestWorkArea ? extent.begin - LongestWorkArea : 0;
        auto at = std::ranges::lower_bound(m_work, std::pair(extent.area, from), {}, [](const WorkArea& area) { return std::pair(area.extent.area, area.extent.begin); });
        for (; at != m_work.end() && at->extent.area == extent.area && at->extent.begin < extent.end; ++at) {
            if (at->box == &statement || !at->extent.overlaps(extent))
                continue;
            DiagnosticSink sink(m_diagnostics[program], m_programs[program].key);
            sink.add(Code::WorkAreaShared, operand.range, {shortened(operand.text), at->box->instruction->mnemonic, shortened(at->operand->text)});
            sink.relate({m_programs[at->program].key, {}, at->operand->range, {}});
            return;
        }
    }

    void checkModules(std::size_t program, const ResolvedOperand& operand, const Extent& extent)
    {
        for (const ModuleBlock& block : m_modules)
            if (extent.overlaps(block.extent))
                return reportBlock(program, operand.range, shortened(operand.text), block);
    }

    /// D2-IBC-03 and the ranges of the sheet, where a register holds a constant.
    void checkContent(const ResolvedStatement& statement, const ResolvedOperand& operand)
    {
        const Pin& pin = *operand.pin;
        const auto* memory = std::get_if<ResolvedMemory>(&operand.value);
        const KnownContent* content = pin.maximum && memory && pin.mainType == DataType::Word ? m_contents.find(memory->address) : nullptr;
        if (!content)
            return;
        const auto value = pin.bcd ? fromBcd(content->value) : std::optional<unsigned>(content->value);
        if (!value || *value < pin.minimum.value_or(0) || *value > *pin.maximum)
            report(content->program, Code::ContentOutOfRange, content->range, {shortened(operand.text), fmt::format("{:X}", content->value), pin.name,
                statement.instruction->mnemonic, fmt::format("{}", pin.minimum.value_or(0)), fmt::format("{}", *pin.maximum)});
    }

    /// D2-AMB-14: boxes of the manual print operands that run into each other. Two inputs may be the same registers.
    void checkOverlaps(std::size_t program, const ResolvedStatement& statement)
    {
        for (std::size_t i = 0; i < statement.operands.size(); ++i)
            for (std::size_t j = i + 1; j < statement.operands.size(); ++j) {
                const ResolvedOperand &first = statement.operands[i], &second = statement.operands[j];
                const auto a = extentOf(first), b = extentOf(second);
                const bool areBits = first.pin->types.contains(DataType::Bool) && second.pin->types.contains(DataType::Bool);
                const bool areInputs = first.pin->direction == PinDirection::In && second.pin->direction == PinDirection::In;
                if (!a || !b || (areInputs && *a == *b) || !(areBits ? isSameBit(first, second) : a->overlaps(*b)))
                    continue;
                report(program, Code::OperandsOverlap, second.range, {first.pin->name, second.pin->name, statement.instruction->mnemonic, shortened(second.text)});
            }
    }

    static bool isSameBit(const ResolvedOperand& a, const ResolvedOperand& b)
    {
        return std::get<ResolvedMemory>(a.value).address == std::get<ResolvedMemory>(b.value).address;
    }

    /// D2-IBC-12.
    void checkAxes(std::size_t program, const ResolvedStatement& statement)
    {
        const ResolvedOperand* first = nullptr;
        for (const ResolvedOperand& operand : statement.operands) {
            if (operand.pin->name == "Axis1")
                first = &operand;
            if (operand.pin->name == "Axis2" && first && extentOf(*first) == extentOf(operand))
                report(program, Code::AxesAlike, operand.range, {statement.instruction->mnemonic, shortened(operand.text)});
        }
    }

    std::span<const ResolvedProgram> m_programs;
    const LanguageContext& m_context;
    std::span<Diagnostics> m_diagnostics;
    KoyoContents m_contents;
    std::vector<ModuleBlock> m_modules;
    std::vector<WorkArea> m_work;
};

} // namespace

void checkKoyoTogether(std::span<const ResolvedProgram> programs, const LanguageContext& context, std::span<Diagnostics> diagnostics)
{
    if (context.family->id() == "koyo")
        KoyoRules(programs, context, diagnostics).run();
}

} // namespace camwright
