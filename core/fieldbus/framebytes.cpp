#include "core/fieldbus/framebytes.h"

namespace camwright {

void write(ByteWriter& writer, const CanFrame& frame)
{
    writer.put(frame.id);
    writer.put(frame.extended);
    writer.put(frame.remote);
    writer.put(frame.length);
    writer.putBytes(frame.data);
}

CanFrame readCanFrame(ByteReader& reader)
{
    CanFrame frame;
    frame.id = reader.get<std::uint32_t>();
    frame.extended = reader.getBool();
    frame.remote = reader.getBool();
    frame.length = reader.get<std::uint8_t>();
    for (std::uint8_t& byte : frame.data)
        byte = reader.get<std::uint8_t>();
    if (frame.length > 8 || frame.id > (frame.extended ? 0x1FFFFFFFU : 0x7FFU))
        reader.fail();
    return reader.ok() ? frame : CanFrame{};
}

} // namespace camwright
