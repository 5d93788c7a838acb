#include "core/fieldbus/objectdictionary.h"

#include "core/fieldbus/framebytes.h"

#include <algorithm>
#include <cassert>

namespace camwright {

namespace {

/// The range a type can hold, for objects that name none of their own.
void narrowToType(ObjectInfo& info)
{
    const unsigned bits = bitWidth(info.type);
    if (bits >= 64)
        return;
    const std::int64_t span = std::int64_t{1} << (isSigned(info.type) ? bits - 1 : bits);
    info.maximum = std::min(info.maximum, span - 1);
    info.minimum = std::max(info.minimum, isSigned(info.type) ? -span : 0);
}

} // namespace

std::int64_t numberFromBytes(DataType type, const std::uint8_t* data)
{
    const unsigned size = byteWidth(type);
    const std::uint64_t raw = getLittle(data, size);
    if (!isSigned(type) || size == 8)
        return static_cast<std::int64_t>(raw);
    const unsigned shift = 64 - 8 * size;
    return static_cast<std::int64_t>(raw << shift) >> shift;
}

void ObjectDictionary::add(ObjectInfo info)
{
    narrowToType(info);
    Object object;
    object.value = info.initial;
    object.size = info.text.empty() ? byteWidth(info.type) : static_cast<unsigned>(info.text.size());
    const auto place = std::lower_bound(m_objects.begin(), m_objects.end(), info.id,
        [](const Object& left, ObjectId id) { return left.info.id < id; });
    assert(place == m_objects.end() || place->info.id != info.id);
    object.info = std::move(info);
    m_objects.insert(place, std::move(object));
}

ObjectDictionary::Slot ObjectDictionary::find(ObjectId id) const
{
    const auto place = std::lower_bound(m_objects.begin(), m_objects.end(), id,
        [](const Object& left, ObjectId wanted) { return left.info.id < wanted; });
    if (place == m_objects.end() || place->info.id != id)
        return kNone;
    return static_cast<Slot>(place - m_objects.begin());
}

bool ObjectDictionary::hasIndex(std::uint16_t index) const
{
    const auto place = std::lower_bound(m_objects.begin(), m_objects.end(), ObjectId{index, 0},
        [](const Object& left, ObjectId wanted) { return left.info.id < wanted; });
    return place != m_objects.end() && place->info.id.index == index;
}

std::int64_t ObjectDictionary::number(ObjectId id) const
{
    const Slot slot = find(id);
    assert(slot != kNone);
    return number(slot);
}

void ObjectDictionary::setNumber(ObjectId id, std::int64_t value)
{
    const Slot slot = find(id);
    assert(slot != kNone);
    setNumber(slot, value);
}

SdoAbort ObjectDictionary::missing(ObjectId id) const
{
    return hasIndex(id.index) ? SdoAbort::NoSuchSubindex : SdoAbort::NoSuchObject;
}

SdoAbort ObjectDictionary::read(ObjectId id, Bytes& out) const
{
    const Slot slot = find(id);
    if (slot == kNone)
        return missing(id);
    const Object& object = m_objects[slot];
    if (object.info.access == ObjectAccess::WriteOnly)
        return SdoAbort::WriteOnly;
    if (!object.info.text.empty()) {
        out.assign(object.info.text.begin(), object.info.text.end());
    } else {
        out.resize(object.size);
        putLittle(out.data(), static_cast<std::uint64_t>(object.value), object.size);
    }
    return SdoAbort::None;
}

SdoAbort ObjectDictionary::checkWrite(ObjectId id, ByteSpan data, Slot& slot, std::int64_t& value) const
{
    slot = find(id);
    if (slot == kNone)
        return missing(id);
    const Object& object = m_objects[slot];
    if (object.info.access == ObjectAccess::ReadOnly || object.info.access == ObjectAccess::Constant)
        return SdoAbort::ReadOnly;
    if (data.size() > object.size)
        return SdoAbort::TooLong;
    if (data.size() < object.size)
        return SdoAbort::TooShort;
    value = numberFromBytes(object.info.type, data.data());
    if (value > object.info.maximum)
        return SdoAbort::ValueTooHigh;
    if (value < object.info.minimum)
        return SdoAbort::ValueTooLow;
    return SdoAbort::None;
}

void ObjectDictionary::save(ByteWriter& writer) const
{
    writer.put(static_cast<std::uint32_t>(m_objects.size()));
    for (const Object& object : m_objects)
        writer.put(object.value);
}

void ObjectDictionary::restore(ByteReader& reader)
{
    if (reader.get<std::uint32_t>() != m_objects.size()) {
        reader.fail();
        return;
    }
    for (Object& object : m_objects)
        object.value = reader.get<std::int64_t>();
}

} // namespace camwright
