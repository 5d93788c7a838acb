#include "core/family/cataloguereader.h"
#include "core/family/csv.h"
#include "core/family/errorreader.h"
#include "core/family/familydata.h"

#include <algorithm>

namespace camwright {

namespace {

constexpr std::string_view FamilyColumns[] = {"key", "value"};
constexpr std::string_view AreaColumns[] = {"id", "name", "kind", "element_bytes", "forms", "octal", "read", "write", "local", "terminal", "en", "zh", "ru"};
constexpr std::string_view LayoutColumns[] = {"model", "area", "bytes", "retained_first", "retained_end"};
constexpr std::string_view ModelColumns[] = {"name", "series", "selectable", "digital_inputs", "digital_outputs", "analog_inputs",
    "analog_outputs", "expansion_modules", "ethernet_ports", "can_ports", "pulse_outputs", "high_speed_counters", "axes",
    "motion_instructions", "restart_instructions", "program_instructions"};
constexpr std::string_view PlaceColumns[] = {"address", "en", "zh", "ru"};
constexpr std::string_view TimerColumns[] = {"first", "last", "base_us"};
constexpr std::string_view ParameterColumns[] = {"number", "symbol", "index", "subindex", "object_bits", "type", "process_bits", "unit_linear",
    "unit_rotary", "min", "max", "only_value", "en", "zh", "ru", "sources"};
constexpr std::string_view StateColumns[] = {"number", "id", "en", "zh", "ru", "sources"};

constexpr std::pair<std::string_view, AreaKind> AreaKinds[] = {{"bytes", AreaKind::Bytes}, {"bits", AreaKind::Bits},
    {"words", AreaKind::Words}, {"timer_bits", AreaKind::TimerBits}, {"timer_values", AreaKind::TimerValues},
    {"counter_bits", AreaKind::CounterBits}, {"counter_values", AreaKind::CounterValues}};

const std::pair<std::string_view, const AddressSyntax*> AddressSyntaxes[] = {{"kinco", &kincoAddressSyntax()},
    {"invt", &invtAddressSyntax()}, {"koyo", &koyoAddressSyntax()}};

enum class CellType : std::uint8_t { Signed, Unsigned, Real };
constexpr std::pair<std::string_view, CellType> CellTypes[] = {{"real", CellType::Real}, {"signed", CellType::Signed}, {"unsigned", CellType::Unsigned}};

Text textOf(const CsvRow& row)
{
    return {row.text("en"), row.text("zh"), row.text("ru")};
}

/// Reads the tables of one family into a FamilyData.
class FamilyReader {
public:
    explicit FamilyReader(const FamilyFiles& files) : m_files(files) {}

    Result<FamilyData, Diagnostics> read()
    {
        forEachRow("family.csv", FamilyColumns, &FamilyReader::addSetting);
        forEachRow("areas.csv", AreaColumns, &FamilyReader::addArea);
        forEachRow("models.csv", ModelColumns, &FamilyReader::addModel);
        forEachRow("layouts.csv", LayoutColumns, &FamilyReader::addLayout);
        forEachRow("places.csv", PlaceColumns, &FamilyReader::addPlace);
        forEachRow("timers.csv", TimerColumns, &FamilyReader::addTimers);
        if (!m_files("drive_parameters.csv").empty())
            forEachRow("drive_parameters.csv", ParameterColumns, &FamilyReader::addParameter);
        if (!m_files("axis_states.csv").empty())
            forEachRow("axis_states.csv", StateColumns, &FamilyReader::addState);
        readErrors(m_files, m_out, m_diagnostics);
        readInstructions();
        if (!m_diagnostics.empty())
            return std::move(m_diagnostics);
        return std::move(m_out);
    }

private:
    void forEachRow(std::string_view name, std::span<const std::string_view> columns, void (FamilyReader::*use)(CsvRow&))
    {
        auto table = CsvTable::read(name, m_files(name), columns);
        if (!table) {
            m_diagnostics.insert(m_diagnostics.end(), table.error().begin(), table.error().end());
            return;
        }
        for (std::size_t i = 0; i < table->rowCount(); ++i) {
            CsvRow row(*table, i, m_diagnostics);
            (this->*use)(row);
        }
    }

    void addSetting(CsvRow& row)
    {
        const std::string key = row.text("key");
        if (key == "id")
            m_out.id = row.text("value");
        else if (key == "name")
            m_out.displayName = row.text("value");
        else if (key == "default_model")
            m_out.defaultModel = row.text("value");
        else if (key == "modelled_scan_us")
            m_out.modelledScanTime = std::chrono::microseconds(row.integer("value", 1, 1'000'000));
        else if (key == "first_wide_counter")
            m_out.firstWideCounter = row.count<std::uint32_t>("value");
        else if (key == "catalogue_format")
            row.integer("value", CatalogueFormatVersion, CatalogueFormatVersion);
        else if (key == "addresses")
            m_out.syntax = row.choice<const AddressSyntax*>("value", AddressSyntaxes);
        else
            row.illegal("key", "a known setting");
    }

    void addArea(CsvRow& row)
    {
        MemoryArea area;
        area.id = static_cast<AreaId>(row.integer("id", 0, VariablesArea - 1));
        area.name = row.text("name");
        area.kind = row.choice<AreaKind>("kind", AreaKinds);
        area.elementBytes = static_cast<unsigned>(row.integer("element_bytes", 1, 4));
        area.sizeLetters = row.text("forms");
        area.octal = row.flag("octal");
        area.readable = row.flag("read");
        readWritable(row, area);
        area.local = row.flag("local");
        area.isInput = row.text("terminal") == "in";
        area.isOutput = row.text("terminal") == "out";
        area.meaning = textOf(row);
        if (area.id != m_out.areas.size())
            row.illegal("id", "the row's own number, from 0");
        m_out.areas.push_back(std::move(area));
    }

    /// "yes", "no", or the elements that may be written: "31-34".
    static void readWritable(CsvRow& row, MemoryArea& area)
    {
        const std::string range = row.text("write");
        const std::size_t dash = range.find('-');
        area.writable = dash != std::string::npos || row.flag("write");
        if (dash == std::string::npos)
            return;
        area.writableFirst = numberOf(std::string_view(range).substr(0, dash));
        area.writableLast = numberOf(std::string_view(range).substr(dash + 1));
        if (area.writableFirst > area.writableLast || area.writableLast == 0xFFFFFFFF)
            row.illegal("write", "yes, no or a range such as 31-34");
    }

    void addModel(CsvRow& row)
    {
        ControllerModel model;
        model.name = row.text("name");
        model.series = row.text("series");
        model.selectable = row.flag("selectable");
        model.digitalInputs = row.count<unsigned>("digital_inputs");
        model.digitalOutputs = row.count<unsigned>("digital_outputs");
        model.analogInputs = row.count<unsigned>("analog_inputs");
        model.analogOutputs = row.count<unsigned>("analog_outputs");
        model.expansionModulesMax = row.count<unsigned>("expansion_modules");
        model.ethernetPorts = row.count<unsigned>("ethernet_ports");
        model.canPorts = row.count<unsigned>("can_ports");
        model.pulseOutputs = row.count<unsigned>("pulse_outputs");
        model.highSpeedCounters = row.count<unsigned>("high_speed_counters");
        model.axesMax = row.count<unsigned>("axes");
        model.motionInstructionsMax = row.count<unsigned>("motion_instructions");
        model.restartInstructionsMax = row.count<unsigned>("restart_instructions");
        model.programInstructionsMax = row.count<unsigned>("program_instructions");
        model.areas.resize(m_out.areas.size());
        m_out.models.push_back(std::move(model));
    }

    /// A row for model "*" is for all of them; a later row for one model replaces it.
    void addLayout(CsvRow& row)
    {
        const auto id = static_cast<std::size_t>(row.integer("area", 0, static_cast<std::int64_t>(m_out.areas.size()) - 1));
        const AreaLayout layout{row.count<std::uint32_t>("bytes"), row.count<std::uint32_t>("retained_first"), row.count<std::uint32_t>("retained_end")};
        if (layout.retainedFirst > layout.retainedEnd || layout.retainedEnd > layout.bytes)
            row.illegal("retained_end", "a byte inside the area");
        const std::string name = row.text("model");
        bool known = false;
        for (ControllerModel& model : m_out.models) {
            if (id < model.areas.size() && (name == "*" || name == model.name)) {
                model.areas[id] = layout;
                known = true;
            }
        }
        if (!known)
            row.illegal("model", "a model of models.csv, or *");
    }

    void addPlace(CsvRow& row)
    {
        if (!m_out.syntax || m_out.models.empty())
            return row.illegal("address", "an address, after a syntax and a model");
        const std::string text = row.text("address");
        const auto address = m_out.syntax->parse({text, m_out.areas, m_out.models.front(), AddressMode::Program});
        if (!address)
            row.illegal("address", "an address of the family");
        else if (!m_out.places.emplace(*address, textOf(row)).second)
            row.duplicate("address");
    }

    void addTimers(CsvRow& row)
    {
        m_out.timers.push_back({row.count<std::uint32_t>("first"), row.count<std::uint32_t>("last"),
            std::chrono::microseconds(row.integer("base_us", 1, 1'000'000))});
    }

    void addParameter(CsvRow& row)
    {
        DriveParameter out;
        out.number = row.count<unsigned>("number");
        out.symbol = row.text("symbol");
        out.index = static_cast<std::uint16_t>(row.integer("index", 1, 0xFFFF));
        out.subindex = static_cast<std::uint8_t>(row.integer("subindex", 0, 0xFF));
        out.objectBits = static_cast<std::uint8_t>(row.integer("object_bits", 8, 32));
        const CellType type = row.choice<CellType>("type", CellTypes);
        out.isReal = type == CellType::Real;
        out.isSigned = type != CellType::Unsigned;
        out.processBits = static_cast<std::uint8_t>(row.integer("process_bits", 8, 32));
        out.unitLinear = row.text("unit_linear");
        out.unitRotary = row.text("unit_rotary");
        out.minimum = row.isEmpty("min") ? 0 : row.integer("min", INT32_MIN, UINT32_MAX);
        out.maximum = row.isEmpty("max") ? 0 : row.integer("max", INT32_MIN, UINT32_MAX);
        if (!row.isEmpty("only_value"))
            out.onlyValue = row.count<std::uint32_t>("only_value");
        out.name = textOf(row);
        out.sources = row.text("sources");
        if (out.number != m_out.driveParameters.size())
            row.illegal("number", "the row's own number, from 0");
        m_out.driveParameters.push_back(std::move(out));
    }

    void addState(CsvRow& row)
    {
        m_out.axisStates.push_back({row.count<int>("number"), row.text("id"), textOf(row), row.text("sources")});
    }

    void readInstructions()
    {
        auto catalogue = readCatalogue({m_files("instructions.csv"), m_files("pins.csv"), m_files("texts.csv"), m_files("groups.csv")}, m_out.areas);
        if (catalogue)
            m_out.catalogue = std::move(catalogue).value();
        else
            m_diagnostics.insert(m_diagnostics.end(), catalogue.error().begin(), catalogue.error().end());
    }

    const FamilyFiles& m_files;
    FamilyData m_out;
    Diagnostics m_diagnostics;
};

} // namespace

Result<FamilyData, Diagnostics> readFamily(const FamilyFiles& files)
{
    return FamilyReader(files).read();
}

} // namespace camwright
