#include "core/language/image/imageparts.h"
#include "core/language/image/packing.h"

namespace camwright {

namespace {

void put(ByteWriter& writer, const IrInstruction& i)
{
    const IrShape& shape = shapeOf(i.op);
    writer.put(i.op);
    writer.put(i.type);
    if (shape.from)
        writer.put(i.from);
    if (shape.dest)
        putVar(writer, i.dest);
    if (shape.a)
        putVar(writer, i.a);
    if (shape.b)
        putVar(writer, i.b);
    if (shape.address)
        put(writer, i.address);
    if (shape.index != IrShape::Index::None)
        putVar(writer, i.index);
    if (shape.constant)
        putVar(writer, i.constant);
}

IrInstruction getInstruction(ByteReader& reader)
{
    IrInstruction i;
    i.op = reader.get<IrOp>();
    const IrShape& shape = shapeOf(i.op);
    if (!shape.known)
        reader.fail();
    i.type = getType(reader);
    if (shape.from)
        i.from = getType(reader);
    if (shape.dest)
        i.dest = getVar(reader);
    if (shape.a)
        i.a = getVar(reader);
    if (shape.b)
        i.b = getVar(reader);
    if (shape.address)
        i.address = getIrAddress(reader);
    if (shape.index != IrShape::Index::None)
        i.index = getVar(reader);
    if (shape.constant)
        i.constant = getVar64(reader);
    return i;
}

void put(ByteWriter& writer, const IrTimer& timer)
{
    writer.put(timer.kind);
    put(writer, timer.value);
    put(writer, timer.bit);
    putVar(writer, timer.state);
    writer.put(timer.baseNs);
}

IrTimer getTimer(ByteReader& reader)
{
    IrTimer timer;
    timer.kind = reader.get<TimerKind>();
    timer.value = getIrAddress(reader);
    timer.bit = getIrAddress(reader);
    timer.state = getVar(reader);
    timer.baseNs = reader.get<std::int64_t>();
    return timer;
}

void put(ByteWriter& writer, const IrCounter& counter)
{
    writer.put(counter.kind);
    writer.put(counter.type);
    put(writer, counter.value);
    put(writer, counter.bit);
    putVar(writer, counter.state);
}

IrCounter getCounter(ByteReader& reader)
{
    IrCounter counter;
    counter.kind = reader.get<CounterKind>();
    counter.type = getType(reader);
    counter.value = getIrAddress(reader);
    counter.bit = getIrAddress(reader);
    counter.state = getVar(reader);
    return counter;
}

void put(ByteWriter& writer, const IrPin& pin)
{
    writer.put(pin.kind);
    writer.put(pin.type);
    if (pin.kind == IrPin::Kind::Constant)
        putVar(writer, pin.constant);
    if (pin.kind == IrPin::Kind::Memory)
        put(writer, pin.address);
}

IrPin getPin(ByteReader& reader)
{
    IrPin pin;
    pin.kind = reader.get<IrPin::Kind>();
    pin.type = getType(reader);
    if (pin.kind == IrPin::Kind::Constant)
        pin.constant = getVar64(reader);
    if (pin.kind == IrPin::Kind::Memory)
        pin.address = getIrAddress(reader);
    return pin;
}

void put(ByteWriter& writer, const IrBlock& block)
{
    writer.put(block.instruction);
    putVar(writer, block.instance);
    putList(writer, block.pins, [&](const IrPin& pin) { put(writer, pin); });
}

IrBlock getBlock(ByteReader& reader)
{
    IrBlock block;
    block.instruction = reader.get<std::uint16_t>();
    block.instance = getVar(reader);
    block.pins = getList(reader, [&] { return getPin(reader); });
    return block;
}

ImagePart tablesPart(const IrProgram& program)
{
    ByteWriter writer;
    putVar(writer, program.stateBytes);
    putList(writer, program.timers, [&](const IrTimer& timer) { put(writer, timer); });
    putList(writer, program.counters, [&](const IrCounter& counter) { put(writer, counter); });
    putList(writer, program.blocks, [&](const IrBlock& block) { put(writer, block); });
    return {ImageSection::Program, {}, writer.take()};
}

ImagePart routinePart(const IrRoutine& routine)
{
    ByteWriter writer;
    writer.put(routine.kind);
    putVar(writer, routine.registers);
    if (routine.kind == RoutineKind::Block)
        putVar(writer, routine.instanceBytes);
    putList(writer, routine.code, [&](const IrInstruction& i) { put(writer, i); });
    return {ImageSection::Program, routine.name, writer.take()};
}

void readTables(ByteReader& reader, IrProgram& program)
{
    program.stateBytes = getVar(reader);
    program.timers = getList(reader, [&] { return getTimer(reader); });
    program.counters = getList(reader, [&] { return getCounter(reader); });
    program.blocks = getList(reader, [&] { return getBlock(reader); });
}

} // namespace

std::vector<ImagePart> programParts(const IrProgram& program)
{
    std::vector<ImagePart> parts{tablesPart(program)};
    for (const IrRoutine& routine : program.routines)
        parts.push_back(routinePart(routine));
    return parts;
}

bool readProgramPart(const ImagePart& part, IrProgram& program)
{
    ByteReader reader(part.bytes);
    if (part.name.empty()) {
        readTables(reader, program);
        return reader.ok() && reader.atEnd();
    }
    IrRoutine routine;
    routine.name = part.name;
    routine.kind = reader.get<RoutineKind>();
    routine.registers = getVar(reader);
    if (routine.kind == RoutineKind::Block)
        routine.instanceBytes = getVar(reader);
    routine.code = getList(reader, [&] { return getInstruction(reader); });
    if (routine.kind > RoutineKind::Block)
        reader.fail();
    program.routines.push_back(std::move(routine));
    return reader.ok() && reader.atEnd();
}

} // namespace camwright
