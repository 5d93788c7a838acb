#include "core/runtime/engineinput.h"

namespace camwright {

namespace {

void put(ByteWriter& writer, const ValueRef& ref)
{
    writer.put(ref.source);
    writer.put(ref.type);
    writer.put(ref.image);
    writer.put(ref.area);
    writer.put(ref.isBit);
    writer.put(ref.bit);
    writer.put(ref.byte);
    writer.put(ref.axis);
    writer.put(ref.field);
}

ValueRef getRef(ByteReader& reader)
{
    ValueRef ref;
    ref.source = reader.get<ValueRef::Source>();
    ref.type = reader.get<DataType>();
    ref.image = reader.get<std::uint32_t>();
    ref.area = reader.get<std::uint8_t>();
    ref.isBit = reader.getBool();
    ref.bit = reader.get<std::uint8_t>();
    ref.byte = reader.get<std::uint32_t>();
    ref.axis = reader.get<std::uint16_t>();
    ref.field = reader.get<AxisField>();
    if (ref.source > ValueRef::Source::Plant || ref.field > AxisField::Error || ref.bit > 7 || name(ref.type).empty())
        reader.fail();
    return ref;
}

void put(ByteWriter& writer, const Value& value)
{
    writer.put(value.type);
    writer.put(value.bits);
}

Value getValue(ByteReader& reader)
{
    Value value;
    value.type = reader.get<DataType>();
    value.bits = reader.get<std::uint64_t>();
    if (name(value.type).empty())
        reader.fail();
    return value;
}

struct Put {
    ByteWriter& writer;

    void operator()(const input::Run&) const {}
    void operator()(const input::Stop&) const {}
    void operator()(const input::RunSwitch& i) const { writer.put(i.run); }
    void operator()(const input::Write& i) const { put(writer, i.target); put(writer, i.value); }
    void operator()(const input::Force& i) const { put(writer, i.target); put(writer, i.value); }
    void operator()(const input::Release& i) const { put(writer, i.target); }
    void operator()(const input::ReleaseAll&) const {}
    void operator()(const input::Panel& i) const
    {
        writer.put(i.axis);
        writer.put(i.kind);
        writer.put(i.position);
        writer.put(i.velocity);
        writer.put(i.acceleration);
    }
    void operator()(const input::Heartbeat& i) const { writer.put(i.seenCycle); }
    void operator()(const input::StopAllAxes&) const {}
    void operator()(const input::LoadImage& i) const { writer.putBlob(i.image); }
    void operator()(const input::PowerCycle&) const {}
    void operator()(const input::InjectFault& i) const { writer.put(i.axis); writer.put(i.fault); }
};

input::Panel getPanel(ByteReader& reader)
{
    input::Panel out;
    out.axis = reader.get<std::uint16_t>();
    out.kind = reader.get<AxisCommandKind>();
    out.position = reader.get<double>();
    out.velocity = reader.get<double>();
    out.acceleration = reader.get<double>();
    if (out.kind > AxisCommandKind::Stop)
        reader.fail();
    return out;
}

template <class T>
T getTargetAndValue(ByteReader& reader)
{
    T out;
    out.target = getRef(reader);
    out.value = getValue(reader);
    return out;
}

EngineInputContent getContent(ByteReader& reader)
{
    switch (reader.get<std::uint8_t>()) {
    case 0: return input::Run{};
    case 1: return input::Stop{};
    case 2: return input::RunSwitch{reader.getBool()};
    case 3: return getTargetAndValue<input::Write>(reader);
    case 4: return getTargetAndValue<input::Force>(reader);
    case 5: return input::Release{getRef(reader)};
    case 6: return input::ReleaseAll{};
    case 7: return getPanel(reader);
    case 8: return input::Heartbeat{reader.get<std::uint64_t>()};
    case 9: return input::StopAllAxes{};
    case 10: {
        const ByteSpan image = reader.getBlob();
        return input::LoadImage{{image.begin(), image.end()}};
    }
    case 11: return input::PowerCycle{};
    case 12: {
        input::InjectFault out;
        out.axis = reader.get<std::uint16_t>();
        out.fault = reader.get<input::InjectedFault>();
        if (out.fault > input::InjectedFault::DriveAlarm)
            reader.fail();
        return out;
    }
    default:
        reader.fail();
        return input::Stop{};
    }
}

} // namespace

void write(ByteWriter& writer, const EngineInput& input)
{
    writer.put(input.cycle);
    writer.put(static_cast<std::uint8_t>(input.content.index()));
    std::visit(Put{writer}, input.content);
}

EngineInput readEngineInput(ByteReader& reader)
{
    EngineInput out;
    out.cycle = reader.get<std::uint64_t>();
    out.content = getContent(reader);
    return out;
}

} // namespace camwright
