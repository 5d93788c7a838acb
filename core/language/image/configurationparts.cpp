#include "core/language/image/imageparts.h"
#include "core/language/image/packing.h"

namespace camwright {

namespace {

constexpr std::string_view AxisPrefix = "axis ";
constexpr std::string_view InterruptsName = "interrupts";

ImagePart controllerPart(const Configuration& configuration)
{
    ByteWriter writer;
    writer.put(configuration.scanPeriod.count());
    writer.put(configuration.watchdog.count());
    return {ImageSection::Configuration, "controller", writer.take()};
}

ImagePart networkPart(const NetworkConfiguration& network)
{
    ByteWriter writer;
    writer.put(network.present);
    writer.put(network.baudrate);
    writer.put(network.sdoTimeoutMs);
    return {ImageSection::Configuration, "network", writer.take()};
}

ImagePart axisPart(const AxisConfiguration& axis)
{
    ByteWriter writer;
    writer.put(axis.number);
    writer.put(axis.rotary);
    writer.put(axis.encoderResolution);
    writer.put(axis.mechanicalEquivalent);
    writer.put(axis.guardTimeMs);
    writer.put(axis.lifeFactor);
    writer.put(axis.inhibitTimeMs);
    writer.put(axis.eventTimerMs);
    writer.put(axis.homeSwitch);
    writer.put(axis.lowerLimitSwitch);
    writer.put(axis.upperLimitSwitch);
    writer.put(axis.startPosition);
    writer.put(axis.inertiaRatio);
    return {ImageSection::Configuration, std::string(AxisPrefix) + axis.name, writer.take()};
}

ImagePart interruptsPart(const std::vector<InterruptSource>& interrupts)
{
    ByteWriter writer;
    putList(writer, interrupts, [&](const InterruptSource& source) {
        putVar(writer, source.routine);
        writer.put(source.cause);
        put(writer, source.input);
        writer.put(source.period.count());
    });
    return {ImageSection::Configuration, std::string(InterruptsName), writer.take()};
}

std::vector<InterruptSource> getInterrupts(ByteReader& reader)
{
    return getList(reader, [&] {
        InterruptSource source;
        source.routine = getVar(reader);
        source.cause = reader.get<InterruptCause>();
        source.input = getAddress(reader);
        source.period = Time(reader.get<std::int64_t>());
        return source;
    });
}

AxisConfiguration getAxis(ByteReader& reader)
{
    AxisConfiguration axis;
    axis.number = reader.get<std::uint8_t>();
    axis.rotary = reader.getBool();
    axis.encoderResolution = reader.get<std::uint32_t>();
    axis.mechanicalEquivalent = reader.get<double>();
    axis.guardTimeMs = reader.get<std::uint16_t>();
    axis.lifeFactor = reader.get<std::uint8_t>();
    axis.inhibitTimeMs = reader.get<std::uint16_t>();
    axis.eventTimerMs = reader.get<std::uint16_t>();
    axis.homeSwitch = reader.get<double>();
    axis.lowerLimitSwitch = reader.get<double>();
    axis.upperLimitSwitch = reader.get<double>();
    axis.startPosition = reader.get<double>();
    axis.inertiaRatio = reader.get<double>();
    return axis;
}

} // namespace

std::vector<ImagePart> configurationParts(const Configuration& configuration)
{
    std::vector<ImagePart> parts{controllerPart(configuration), networkPart(configuration.network)};
    for (const AxisConfiguration& axis : configuration.axes)
        parts.push_back(axisPart(axis));
    if (!configuration.interrupts.empty())
        parts.push_back(interruptsPart(configuration.interrupts));
    return parts;
}

bool readConfigurationPart(const ImagePart& part, Configuration& configuration)
{
    ByteReader reader(part.bytes);
    if (part.name == "controller") {
        configuration.scanPeriod = Time(reader.get<std::int64_t>());
        configuration.watchdog = Time(reader.get<std::int64_t>());
    } else if (part.name == "network") {
        configuration.network.present = reader.getBool();
        configuration.network.baudrate = reader.get<std::uint32_t>();
        configuration.network.sdoTimeoutMs = reader.get<std::uint32_t>();
    } else if (part.name.starts_with(AxisPrefix)) {
        AxisConfiguration axis = getAxis(reader);
        axis.name = part.name.substr(AxisPrefix.size());
        configuration.axes.push_back(std::move(axis));
    } else if (part.name == InterruptsName) {
        configuration.interrupts = getInterrupts(reader);
    } else {
        return false;
    }
    return reader.ok() && reader.atEnd();
}

} // namespace camwright
