#include "core/family/cataloguereader.h"

#include "core/base/bytes.h"
#include "core/family/csv.h"

#include <algorithm>
#include <array>

namespace camwright {

namespace {

constexpr std::string_view InstructionColumns[] = {"id", "mnemonic", "group", "basis", "cr", "executes", "needs", "max_project",
    "max_axis", "motion", "simulated", "reason", "help", "sources"};
constexpr std::string_view PinColumns[] = {"mnemonic", "name", "direction", "kind", "types", "type_group", "areas", "constant",
    "optional", "default", "link", "edge", "min", "max", "element_bytes", "count_pin", "fixed_count", "private", "bcd", "unit", "help"};
constexpr std::string_view TextColumns[] = {"key", "en", "zh", "ru"};
constexpr std::string_view GroupColumns[] = {"group", "en", "zh", "ru"};

template <class T>
using Choice = std::pair<std::string_view, T>;

constexpr Choice<Basis> Bases[] = {{"manual", Basis::Manual}, {"common", Basis::CommonForm}, {"ours", Basis::Ours}};
constexpr Choice<CrEffect> CrEffects[] = {{"keeps", CrEffect::Keeps}, {"loads", CrEffect::Loads}, {"combines", CrEffect::Combines},
    {"replaces", CrEffect::Replaces}, {"stacks", CrEffect::Stacks}};
constexpr Choice<Executes> ExecuteKinds[] = {{"flow", Executes::OnFlow}, {"edge", Executes::OnEdge}, {"always", Executes::Always}};
constexpr Choice<Capability> Capabilities[] = {{"", Capability::None}, {"pulse", Capability::PulseOutputs}, {"motion", Capability::MotionAxes}};
constexpr Choice<PinDirection> Directions[] = {{"in", PinDirection::In}, {"out", PinDirection::Out}, {"inout", PinDirection::InOut}};
constexpr Choice<PinKind> PinKinds[] = {{"value", PinKind::Value}, {"block", PinKind::Block}, {"timer", PinKind::Timer},
    {"counter", PinKind::Counter}, {"program", PinKind::Program}, {"arguments", PinKind::Arguments}, {"axis", PinKind::Axis},
    {"label", PinKind::Label}, {"interrupt", PinKind::Interrupt}};

bool isBitArea(AreaKind kind)
{
    return kind == AreaKind::Bits || kind == AreaKind::TimerBits || kind == AreaKind::CounterBits;
}

bool isValueArea(AreaKind kind)
{
    return kind == AreaKind::TimerValues || kind == AreaKind::CounterValues;
}

} // namespace

/// Joins the tables; the only writer of a Catalogue.
class CatalogueReader {
public:
    CatalogueReader(const CatalogueTables& tables, std::span<const MemoryArea> areas) : m_tables(tables), m_areas(areas) {}

    Result<Catalogue, Diagnostics> read()
    {
        forEachRow("texts.csv", m_tables.texts, TextColumns, [this](CsvRow& row) { addText(row, "key", m_texts); });
        forEachRow("groups.csv", m_tables.groups, GroupColumns, [this](CsvRow& row) { addText(row, "group", m_catalogue.m_groups); });
        forEachRow("instructions.csv", m_tables.instructions, InstructionColumns, [this](CsvRow& row) { addInstruction(row); });
        forEachRow("pins.csv", m_tables.pins, PinColumns, [this](CsvRow& row) { addPin(row); });
        m_catalogue.m_hash = hashOfTables();
        if (!m_diagnostics.empty())
            return std::move(m_diagnostics);
        return std::move(m_catalogue);
    }

private:
    template <class F>
    void forEachRow(std::string_view name, std::string_view text, std::span<const std::string_view> columns, F use)
    {
        auto table = CsvTable::read(name, text, columns);
        if (!table) {
            m_diagnostics.insert(m_diagnostics.end(), table.error().begin(), table.error().end());
            return;
        }
        for (std::size_t i = 0; i < table->rowCount(); ++i) {
            CsvRow row(*table, i, m_diagnostics);
            use(row);
        }
    }

    static void addText(CsvRow& row, std::string_view key, std::map<std::string, Text, std::less<>>& texts)
    {
        if (!texts.emplace(row.text(key), Text{row.text("en"), row.text("zh"), row.text("ru")}).second)
            row.duplicate(key);
    }

    Text textOf(CsvRow& row, std::string_view column)
    {
        if (row.isEmpty(column))
            return {};
        const auto found = m_texts.find(row.text(column));
        if (found == m_texts.end()) {
            row.illegal(column, "a key of texts.csv");
            return {};
        }
        return found->second;
    }

    void addInstruction(CsvRow& row)
    {
        Instruction out;
        out.id = static_cast<InstructionId>(row.integer("id", 1, 0xFFFF));
        out.mnemonic = row.text("mnemonic");
        out.group = row.text("group");
        out.basis = row.choice<Basis>("basis", Bases);
        out.crEffect = row.choice<CrEffect>("cr", CrEffects);
        out.executes = row.choice<Executes>("executes", ExecuteKinds);
        out.needs = row.choice<Capability>("needs", Capabilities);
        out.maxPerProject = row.count<unsigned>("max_project");
        out.maxPerAxis = row.count<unsigned>("max_axis");
        out.isMotion = row.flag("motion");
        out.simulated = row.flag("simulated");
        out.whyNotSimulated = textOf(row, "reason");
        out.help = textOf(row, "help");
        out.sources = row.text("sources");
        if (!m_catalogue.m_groups.contains(out.group))
            row.illegal("group", "a key of groups.csv");
        if (!out.simulated && !out.whyNotSimulated.isComplete())
            row.illegal("reason", "a text where simulated is no");
        const std::size_t index = m_catalogue.m_instructions.size();
        if (!m_catalogue.m_byId.emplace(out.id, index).second)
            row.duplicate("id");
        if (!m_catalogue.m_byMnemonic.emplace(upper(out.mnemonic), index).second)
            row.duplicate("mnemonic");
        m_catalogue.m_instructions.push_back(std::move(out));
    }

    void addPin(CsvRow& row)
    {
        const auto owner = m_catalogue.m_byMnemonic.find(upper(row.text("mnemonic")));
        if (owner == m_catalogue.m_byMnemonic.end())
            return row.illegal("mnemonic", "a mnemonic of instructions.csv");
        Instruction& instruction = m_catalogue.m_instructions[owner->second];
        Pin out;
        out.name = row.text("name");
        out.direction = row.choice<PinDirection>("direction", Directions);
        out.kind = row.choice<PinKind>("kind", PinKinds);
        out.types = typesOf(row, out.mainType);
        out.typeGroup = row.count<std::uint8_t>("type_group", 9);
        out.areas = areasOf(row, out);
        out.constantAllowed = row.flag("constant");
        out.optional = row.flag("optional");
        out.defaultValue = row.text("default");
        out.linkGroup = row.isEmpty("link") ? '\0' : row.text("link").front();
        out.risingEdge = row.flag("edge");
        out.minimum = row.number("min");
        out.maximum = row.number("max");
        out.elementBytes = row.count<unsigned>("element_bytes");
        out.countPin = row.text("count_pin");
        out.fixedCount = row.count<unsigned>("fixed_count");
        out.isPrivate = row.flag("private");
        out.bcd = row.flag("bcd");
        out.unit = row.text("unit");
        out.help = textOf(row, "help");
        if (instruction.findPin(out.name))
            row.duplicate("name");
        if (out.kind == PinKind::Block && (out.elementBytes == 0 || out.constantAllowed))
            row.illegal("element_bytes", "a size, and no constant, for a block");
        instruction.pins.push_back(std::move(out));
    }

    TypeSet typesOf(CsvRow& row, DataType& mainType)
    {
        TypeSet out;
        for (const std::string& word : row.words("types")) {
            const auto type = dataTypeByName(word);
            if (!type) {
                row.illegal("types", "names of elementary types");
                continue;
            }
            if (out.isEmpty())
                mainType = *type;
            out.insert(*type);
        }
        return out;
    }

    /// A name that two areas share (T, C) means the bits where BOOL is among the types, and the values where another type is.
    std::vector<AreaId> areasOf(CsvRow& row, const Pin& pin)
    {
        const bool bits = pin.types.contains(DataType::Bool);
        const bool values = !(pin.types == TypeSet{DataType::Bool});
        std::vector<AreaId> out;
        for (const std::string& word : row.words("areas")) {
            bool known = false;
            for (const MemoryArea& area : m_areas) {
                if (area.name != word)
                    continue;
                known = true;
                const bool element = pin.kind == PinKind::Timer || pin.kind == PinKind::Counter;
                if (isBitArea(area.kind) ? bits || element : !isValueArea(area.kind) || (values && !element))
                    out.push_back(area.id);
            }
            if (!known)
                row.illegal("areas", "names of memory areas");
        }
        std::ranges::sort(out);
        return out;
    }

    Hash hashOfTables() const
    {
        ByteWriter writer;
        writer.put(static_cast<std::uint32_t>(CatalogueFormatVersion));
        writer.putText(m_tables.instructions);
        writer.putText(m_tables.pins);
        return hashOf(writer.bytes());
    }

    static std::string upper(std::string text)
    {
        for (char& c : text)
            c = c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
        return text;
    }

    const CatalogueTables& m_tables;
    std::span<const MemoryArea> m_areas;
    std::map<std::string, Text, std::less<>> m_texts;
    Catalogue m_catalogue;
    Diagnostics m_diagnostics;
};

Result<Catalogue, Diagnostics> readCatalogue(const CatalogueTables& tables, std::span<const MemoryArea> areas)
{
    return CatalogueReader(tables, areas).read();
}

} // namespace camwright
