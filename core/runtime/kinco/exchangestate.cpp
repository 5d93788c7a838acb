#include "core/runtime/kinco/exchangestate.h"

namespace camwright::kinco {

namespace {

void saveList(ByteWriter& writer, const ParameterList& list)
{
    writer.putBytes(list.numbers);
    for (const std::uint32_t value : list.values)
        writer.put(value);
}

void restoreList(ByteReader& reader, ParameterList& list)
{
    for (std::uint8_t& number : list.numbers)
        number = reader.get<std::uint8_t>();
    for (std::uint32_t& value : list.values)
        value = reader.get<std::uint32_t>();
}

void saveView(ByteWriter& writer, const AxisView& view)
{
    for (const bool flag : {view.reached, view.homed, view.forward, view.backward, view.running, view.fault, view.limit, view.online})
        writer.put(flag);
    writer.put(view.inputs);
    writer.put(view.errorCode);
    writer.put(view.position);
    writer.put(view.velocity);
}

void restoreView(ByteReader& reader, AxisView& view)
{
    for (bool* flag : {&view.reached, &view.homed, &view.forward, &view.backward, &view.running, &view.fault, &view.limit, &view.online})
        *flag = reader.getBool();
    view.inputs = reader.get<std::uint16_t>();
    view.errorCode = reader.get<std::uint16_t>();
    view.position = reader.get<float>();
    view.velocity = reader.get<float>();
}

} // namespace

void saveCommands(ByteWriter& writer, const ScanCommands& commands)
{
    for (const CallInputs& call : commands.calls) {
        writer.put(call.execution);
        writer.put(call.enabled);
        writer.put(call.exec);
        writer.put(call.axis);
        writer.put(call.mode);
        writer.put(call.count);
        writer.put(call.timeMs);
        writer.put(call.position);
        writer.put(call.velocity);
    }
    for (const ParameterList& list : commands.lists)
        saveList(writer, list);
}

void restoreCommands(ByteReader& reader, ScanCommands& commands)
{
    for (CallInputs& call : commands.calls) {
        call.execution = reader.get<std::uint32_t>();
        call.enabled = reader.getBool();
        call.exec = reader.getBool();
        call.axis = reader.get<std::int16_t>();
        call.mode = reader.get<std::int16_t>();
        call.count = reader.get<std::int16_t>();
        call.timeMs = reader.get<std::uint32_t>();
        call.position = reader.get<float>();
        call.velocity = reader.get<float>();
    }
    for (ParameterList& list : commands.lists)
        restoreList(reader, list);
}

void saveReports(ByteWriter& writer, const MotionReports& reports)
{
    for (const CallResult& call : reports.calls) {
        writer.put(call.execution);
        writer.put(call.done);
        writer.put(call.error);
        writer.put(call.active);
        writer.put(call.errorId);
        writer.put(call.valid);
    }
    for (const ParameterList& list : reports.lists)
        saveList(writer, list);
    for (const AxisView& view : reports.axes)
        saveView(writer, view);
}

void restoreReports(ByteReader& reader, MotionReports& reports)
{
    for (CallResult& call : reports.calls) {
        call.execution = reader.get<std::uint32_t>();
        call.done = reader.getBool();
        call.error = reader.getBool();
        call.active = reader.getBool();
        call.errorId = reader.get<std::uint32_t>();
        call.valid = reader.get<std::uint32_t>();
    }
    for (ParameterList& list : reports.lists)
        restoreList(reader, list);
    for (AxisView& view : reports.axes)
        restoreView(reader, view);
}

} // namespace camwright::kinco
