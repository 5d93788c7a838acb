#include "core/language/image/packing.h"

#include "core/language/ir/verifyprogram.h"

namespace camwright {

void putVar(ByteWriter& writer, std::uint64_t number)
{
    while (number >= 0x80) {
        writer.put(static_cast<std::uint8_t>(number | 0x80));
        number >>= 7;
    }
    writer.put(static_cast<std::uint8_t>(number));
}

std::uint64_t getVar64(ByteReader& reader)
{
    std::uint64_t number = 0;
    for (unsigned shift = 0; shift < 64; shift += 7) {
        const auto byte = reader.get<std::uint8_t>();
        if (shift == 63 && byte > 1)
            break;
        number |= std::uint64_t{byte & 0x7Fu} << shift;
        if (byte < 0x80)
            return number;
    }
    reader.fail();
    return 0;
}

std::uint32_t getVar(ByteReader& reader)
{
    const std::uint64_t number = getVar64(reader);
    if (number > 0xFFFFFFFF) {
        reader.fail();
        return 0;
    }
    return static_cast<std::uint32_t>(number);
}

void put(ByteWriter& writer, const IrAddress& address)
{
    writer.put(address.area);
    writer.put(address.bit);
    putVar(writer, address.byte);
}

IrAddress getIrAddress(ByteReader& reader)
{
    IrAddress address;
    address.area = reader.get<AreaId>();
    address.bit = reader.get<std::uint8_t>();
    address.byte = getVar(reader);
    return address;
}

void put(ByteWriter& writer, const Address& address)
{
    writer.put(address.area);
    writer.put(address.bit);
    writer.put(address.isBit);
    writer.put(address.type);
    putVar(writer, address.byte);
}

Address getAddress(ByteReader& reader)
{
    Address address;
    address.area = reader.get<AreaId>();
    address.bit = reader.get<std::uint8_t>();
    address.isBit = reader.getBool();
    address.type = getType(reader);
    address.byte = getVar(reader);
    return address;
}

void put(ByteWriter& writer, const Value& value)
{
    writer.put(value.type);
    putVar(writer, value.bits);
}

Value getValue(ByteReader& reader)
{
    Value value;
    value.type = getType(reader);
    value.bits = getVar64(reader);
    if (!isConstantOf(value.type, value.bits))
        reader.fail();
    return value;
}

DataType getType(ByteReader& reader)
{
    const auto type = reader.get<DataType>();
    if (isKnownType(type))
        return type;
    reader.fail();
    return DataType::Bool;
}

} // namespace camwright
