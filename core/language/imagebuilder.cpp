#include "core/language/imagebuilder.h"

#include "core/language/lowering/memorylayout.h"
#include "core/storage/objecttext.h"

#include <algorithm>

namespace camwright {

namespace {

AxisConfiguration configurationOf(const ValidAxis& axis)
{
    AxisConfiguration out;
    out.name = axis.name;
    out.number = axis.number;
    out.rotary = axis.type == AxisType::Rotary;
    out.encoderResolution = static_cast<std::uint32_t>(std::min<std::int64_t>(axis.encoderResolution, 0xFFFFFFFF));
    out.mechanicalEquivalent = axis.mechanicalEquivalent;
    out.guardTimeMs = axis.guardTimeMs;
    out.lifeFactor = axis.lifeFactor;
    out.inhibitTimeMs = axis.inhibitTimeMs;
    out.eventTimerMs = axis.eventTimerMs;
    out.homeSwitch = axis.homeSwitch;
    out.lowerLimitSwitch = axis.lowerLimitSwitch;
    out.upperLimitSwitch = axis.upperLimitSwitch;
    out.startPosition = axis.startPosition;
    out.inertiaRatio = axis.inertiaRatio;
    return out;
}

Configuration configurationOf(const ValidProject& project)
{
    Configuration out;
    out.scanPeriod = project.scanPeriod();
    out.watchdog = project.watchdog();
    if (const auto& network = project.network())
        out.network = {true, network->baudrate, static_cast<std::uint32_t>(network->sdoTimeout / 1ms)};
    for (const ValidAxis& axis : project.axes())
        out.axes.push_back(configurationOf(axis));
    return out;
}

/// Elements of an array that watch tables and traces know by name.
constexpr std::uint32_t MostNamedElements = 4096;

Address elementAt(const KnownVariable& variable, std::uint32_t number)
{
    Address out = *variable.address;
    out.byte += number * byteWidth(variable.type);
    return out;
}

/// The variables of the tables, and those the programs declare. Of two with one name the table's counts.
std::vector<Symbol> symbolsOf(const LanguageContext& context, std::vector<Symbol> declared)
{
    std::vector<Symbol> symbols;
    for (const KnownVariable& variable : context.variables) {
        if (variable.address && variable.elements == 0)
            symbols.push_back({variable.name, *variable.address, variable.retain});
        for (std::uint32_t i = 0; variable.address && i < std::min(variable.elements, MostNamedElements); ++i)
            symbols.push_back({variable.name + "[" + std::to_string(i) + "]", elementAt(variable, i), variable.retain});
    }
    for (Symbol& symbol : declared) {
        if (!context.findVariable(symbol.name))
            symbols.push_back(std::move(symbol));
    }
    std::ranges::sort(symbols, {}, &Symbol::name);
    symbols.erase(std::unique(symbols.begin(), symbols.end(), [](const Symbol& a, const Symbol& b) { return a.name == b.name; }), symbols.end());
    return symbols;
}

std::vector<InitialValue> initialValuesOf(const ValidProject& project, const LanguageContext& context)
{
    std::vector<InitialValue> values;
    for (const ValidVariable& variable : project.variables()) {
        const KnownVariable* known = variable.initial ? context.findVariable(variable.name) : nullptr;
        for (std::uint32_t i = 0; known && known->address && i < std::max(known->elements, 1u); ++i)
            values.push_back({elementAt(*known, i), *variable.initial});
    }
    return values;
}

std::vector<ArchivedFile> archiveOf(const Project& project)
{
    std::vector<ArchivedFile> files;
    for (const auto& [key, object] : project.all())
        files.push_back({fileOf(key, project), toText(*object)});
    return files;
}

/// A routine whose calls nest as deep as is allowed, or deeper, seen from the main program.
std::string deepestRoutine(const IrProgram& program)
{
    std::vector<unsigned> depth(program.routines.size(), 0);
    for (unsigned round = 0; round <= MaximumCallDepth; ++round) {
        for (std::size_t r = 0; r < program.routines.size(); ++r) {
            for (const IrInstruction& i : program.routines[r].code) {
                if (!isCall(i.op))
                    continue;
                depth[i.index] = std::max(depth[i.index], depth[r] + 1);
                if (depth[i.index] > MaximumCallDepth)
                    return program.routines[i.index].name;
            }
        }
    }
    return {};
}

} // namespace

ControllerImage buildImage(const ValidProject& project, const LanguageContext& context, LoweredPrograms lowered, const BuildOptions& options)
{
    ControllerImage image;
    image.target = {project.family().id(), project.model().name, project.family().catalogue().hash()};
    image.layout = memoryLayout(project.family(), project.model(), std::max(context.variableBytes, lowered.variableBytes), lowered.blocksWithLocals);
    image.layout.initialValues = initialValuesOf(project, context);
    image.layout.initialValues.insert(image.layout.initialValues.end(), lowered.initialValues.begin(), lowered.initialValues.end());
    image.program = std::move(lowered.program);
    image.debug = std::move(lowered.debug);
    image.debug.projectName = project.name();
    image.configuration = configurationOf(project);
    image.configuration.interrupts = std::move(lowered.interrupts);
    image.symbols = symbolsOf(context, std::move(lowered.symbols));
    image.source = options.archive.empty() ? archiveOf(project.project()) : options.archive;
    return image;
}

Diagnostic whyNotSafe(const ControllerImage& image, const Diagnostic& reason)
{
    const std::string routine = deepestRoutine(image.program);
    if (routine.empty())
        return diagnostic(Code::InternalError, {englishText(reason)});
    return diagnostic(Code::CallsTooDeep, {std::to_string(MaximumCallDepth), routine}, {{ObjectKind::Program, routine}, {}, {}, {}});
}

} // namespace camwright
