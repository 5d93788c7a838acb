#include "core/online/imagemanifest.h"

#include "core/language/image/controllerimage.h"
#include "core/language/image/imageparts.h"

#include <algorithm>
#include <tuple>

namespace camwright {

namespace {

void put(ByteWriter& writer, const IrAddress& address)
{
    writer.put(address.area);
    writer.put(address.bit);
    writer.put(address.byte);
}

/// What an instruction points to, by content: a new timer or block elsewhere shifts numbers and must not count as a change.
void putTarget(ByteWriter& writer, const IrProgram& program, const IrInstruction& instruction)
{
    const std::uint32_t index = instruction.index;
    switch (shapeOf(instruction.op).index) {
    case IrShape::Index::None:
    case IrShape::Index::EdgeState:
        break;
    case IrShape::Index::Target:
    case IrShape::Index::Register:
        writer.put(index);
        break;
    case IrShape::Index::Routine:
        writer.putText(program.routines[index].name);
        break;
    case IrShape::Index::Timer: {
        const IrTimer& timer = program.timers[index];
        writer.put(timer.kind);
        put(writer, timer.value);
        put(writer, timer.bit);
        writer.put(timer.baseNs);
        break;
    }
    case IrShape::Index::Counter: {
        const IrCounter& counter = program.counters[index];
        writer.put(counter.kind);
        writer.put(counter.type);
        put(writer, counter.value);
        put(writer, counter.bit);
        break;
    }
    case IrShape::Index::Block: {
        const IrBlock& block = program.blocks[index];
        writer.put(block.instruction);
        for (const IrPin& pin : block.pins) {
            writer.put(pin.kind);
            writer.put(pin.type);
            writer.put(pin.constant);
            put(writer, pin.address);
        }
        break;
    }
    }
}

Hash hashOfRoutine(const IrProgram& program, const IrRoutine& routine)
{
    ByteWriter writer;
    writer.put(routine.kind);
    for (const IrInstruction& instruction : routine.code) {
        writer.put(instruction.op);
        writer.put(instruction.type);
        writer.put(instruction.from);
        writer.put(instruction.dest);
        writer.put(instruction.a);
        writer.put(instruction.b);
        put(writer, instruction.address);
        writer.put(instruction.constant);
        putTarget(writer, program, instruction);
    }
    return hashOf(writer.bytes());
}

void addConfiguration(const ControllerImage& image, Manifest& out)
{
    static constexpr std::string_view AxisPrefix = "axis ";
    ByteWriter controller;
    for (const ImagePart& part : configurationParts(image.configuration)) {
        if (part.name.starts_with(AxisPrefix))
            out.parts.push_back({PartKind::Axis, part.name.substr(AxisPrefix.size()), hashOf(part.bytes)});
        else if (part.name == "network")
            out.parts.push_back({PartKind::Network, {}, hashOf(part.bytes)});
        else
            controller.putBlob(part.bytes);
    }
    controller.putBlob(targetPart(image.target).bytes);
    for (const ImageArea& area : image.layout.areas) {
        controller.put(area.id);
        controller.put(area.bytes);
    }
    out.parts.push_back({PartKind::Controller, {}, hashOf(controller.bytes())});
}

void addVariables(const ControllerImage& image, Manifest& out)
{
    ByteWriter variables;
    variables.putBlob(symbolsPart(image.symbols).bytes);
    for (const InitialValue& initial : image.layout.initialValues) {
        variables.put(initial.address.area);
        variables.put(initial.address.byte);
        variables.put(initial.address.bit);
        variables.put(initial.value.type);
        variables.put(initial.value.bits);
    }
    out.parts.push_back({PartKind::Variables, {}, hashOf(variables.bytes())});
    const auto retain = [&out](const std::string& name, auto... content) {
        ByteWriter writer;
        (writer.put(content), ...);
        out.parts.push_back({PartKind::Retained, name, hashOf(writer.bytes())});
    };
    // Keys of CONTRACTS 13: areas by address, variables by path and type.
    for (const ImageArea& area : image.layout.areas)
        if (area.retainedTo > area.retainedFrom)
            retain(area.name, area.retainedFrom, area.retainedTo);
    for (const Symbol& symbol : image.symbols)
        if (symbol.retain)
            retain(symbol.name, symbol.address.type);
}

} // namespace

Manifest manifestOf(ByteSpan bytes)
{
    const auto image = readImage(bytes);
    if (!image)
        return {};
    Manifest out;
    out.program = programHash(*image);
    out.family = image->target.family;
    out.model = image->target.model;
    for (const IrRoutine& routine : image->program.routines)
        out.parts.push_back({PartKind::Program, routine.name, hashOfRoutine(image->program, routine)});
    addConfiguration(*image, out);
    addVariables(*image, out);
    std::sort(out.parts.begin(), out.parts.end(),
        [](const ManifestPart& a, const ManifestPart& b) { return std::tie(a.kind, a.name) < std::tie(b.kind, b.name); });
    return out;
}

} // namespace camwright
