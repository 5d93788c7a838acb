#include "core/language/image/controllerimage.h"
#include "core/language/ir/verifyprogram.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace camwright {

namespace {

constexpr std::uint64_t MaximumMemoryBytes = 64u << 20;

Diagnostic unsafe(std::string what)
{
    return diagnostic(Code::ImageUnsafe, {std::move(what)});
}

bool fits(const AreaSizes& areas, const Address& address)
{
    if (address.isBit != (address.type == DataType::Bool) || address.bit > 7 || (address.bit != 0 && !address.isBit))
        return false;
    return fits(areas, IrAddress{address.area, IrAddress::WholeByte, address.byte}, std::uint64_t{byteWidth(address.type)});
}

Result<AreaSizes> areaSizes(const MemoryLayout& layout)
{
    AreaSizes sizes{};
    std::uint64_t total = 0;
    for (std::size_t i = 0; i < layout.areas.size(); ++i) {
        const ImageArea& area = layout.areas[i];
        if (i > 0 && area.id <= layout.areas[i - 1].id)
            return unsafe(CW_TEXT("Arguments", "the memory areas are not in order"));
        if (area.id == InstanceArea)
            return unsafe("a memory area has the number of the instances");
        if (area.retainedFrom > area.retainedTo || area.retainedTo > area.bytes)
            return unsafe(CW_TEXT("Arguments", "the retained range of an area lies outside it"));
        sizes[area.id] = area.bytes;
        total += area.bytes;
    }
    if (total > MaximumMemoryBytes)
        return unsafe(CW_TEXT("Arguments", "the memory areas are too large"));
    return sizes;
}

Result<void> verifyLayout(const MemoryLayout& layout, const AreaSizes& sizes)
{
    for (const InitialValue& initial : layout.initialValues) {
        if (!fits(sizes, initial.address) || initial.value.type != initial.address.type)
            return unsafe(CW_TEXT("Arguments", "an initial value lies outside its area"));
    }
    if (layout.instructionErrorFlag && (!fits(sizes, *layout.instructionErrorFlag) || !layout.instructionErrorFlag->isBit))
        return unsafe(CW_TEXT("Arguments", "the flag of failed instructions lies outside its area"));
    return {};
}

Result<void> verifySymbols(const std::vector<Symbol>& symbols, const AreaSizes& sizes)
{
    for (std::size_t i = 0; i < symbols.size(); ++i) {
        if (i > 0 && symbols[i].name <= symbols[i - 1].name)
            return unsafe(CW_TEXT("Arguments", "the variables are not in order"));
        if (!fits(sizes, symbols[i].address))
            return unsafe("variable " + symbols[i].name + " lies outside its area");
    }
    return {};
}

bool isSane(const AxisConfiguration& axis)
{
    const double finite = axis.homeSwitch + axis.lowerLimitSwitch + axis.upperLimitSwitch + axis.startPosition;
    return axis.number >= 1 && axis.number <= 127 && axis.encoderResolution > 0 && std::isfinite(axis.mechanicalEquivalent)
        && axis.mechanicalEquivalent > 0 && std::isfinite(finite) && std::isfinite(axis.inertiaRatio) && axis.inertiaRatio >= 0
        && !axis.name.empty();
}

Result<void> verifyConfiguration(const Configuration& configuration)
{
    if (configuration.scanPeriod < Time{} || configuration.watchdog < Time{})
        return unsafe(CW_TEXT("Arguments", "a negative scan period or watchdog time"));
    std::set<std::string_view> names;
    for (std::size_t i = 0; i < configuration.axes.size(); ++i) {
        const AxisConfiguration& axis = configuration.axes[i];
        if (!isSane(axis))
            return unsafe("axis " + axis.name + " has an impossible parameter");
        if (!names.insert(axis.name).second || (i > 0 && axis.number <= configuration.axes[i - 1].number))
            return unsafe(CW_TEXT("Arguments", "the axes are not in order"));
    }
    return {};
}

Result<void> verifyNames(const IrProgram& program)
{
    std::set<std::string_view> names;
    for (const IrRoutine& routine : program.routines) {
        if (routine.name.empty() || !names.insert(routine.name).second)
            return unsafe(CW_TEXT("Arguments", "a routine has no name, or two have the same"));
    }
    return {};
}

/// Every interrupt has a routine of its own kind and something that can start it.
Result<void> verifyInterrupts(const ControllerImage& image, const AreaSizes& sizes)
{
    for (const InterruptSource& source : image.configuration.interrupts) {
        const auto& routines = image.program.routines;
        if (source.routine >= routines.size() || routines[source.routine].kind != RoutineKind::Interrupt)
            return unsafe("an event starts what is no interrupt routine");
        const bool isTimed = source.cause == InterruptCause::Timed;
        const bool hasInput = source.input.isBit && fits(sizes, source.input);
        if (source.cause > InterruptCause::Falling || (isTimed ? source.period < 1ms : !hasInput))
            return unsafe("an interrupt has an event that cannot come");
    }
    return {};
}

} // namespace

Result<void> verify(const ControllerImage& image)
{
    const Result<AreaSizes> sizes = areaSizes(image.layout);
    if (!sizes)
        return sizes.error();
    for (Result<void> part : {verifyLayout(image.layout, *sizes), verifySymbols(image.symbols, *sizes),
                              verifyConfiguration(image.configuration), verifyNames(image.program),
                              verifyInterrupts(image, *sizes)}) {
        if (!part)
            return part;
    }
    return verifyProgram(image.program, *sizes);
}

} // namespace camwright
