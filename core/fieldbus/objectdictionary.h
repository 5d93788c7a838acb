#pragma once

#include "core/base/bytes.h"
#include "core/base/datatype.h"
#include "core/fieldbus/sdo.h"

#include <compare>
#include <cstdint>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

namespace camwright {

struct ObjectId {
    std::uint16_t index = 0;
    std::uint8_t sub = 0;
    auto operator<=>(const ObjectId&) const = default;
};

enum class ObjectAccess : std::uint8_t { ReadOnly, WriteOnly, ReadWrite, Constant };

/// What an object is. Numbers have a type and a range; a text has `text` and is read in segments.
struct ObjectInfo {
    ObjectId id;
    DataType type = DataType::Udint;
    ObjectAccess access = ObjectAccess::ReadWrite;
    bool mappable = false;
    std::int64_t initial = 0;
    std::int64_t minimum = std::numeric_limits<std::int64_t>::min();
    std::int64_t maximum = std::numeric_limits<std::int64_t>::max();
    std::string text{}; ///< not empty: a visible string, constant
};

/// The objects of a device with their values, sorted by index and sub-index. Add all objects first; slots found after
/// that stay good. Reading and writing by slot costs no search and is for the device itself; the checked functions are for
/// what comes from the bus.
class ObjectDictionary {
public:
    using Slot = std::uint16_t;
    static constexpr Slot kNone = 0xFFFF;

    void add(ObjectInfo info);
    Slot find(ObjectId id) const; ///< kNone if there is none
    bool hasIndex(std::uint16_t index) const;
    std::size_t size() const { return m_objects.size(); }
    const ObjectInfo& info(Slot slot) const { return m_objects[slot].info; }
    unsigned byteSize(Slot slot) const { return m_objects[slot].size; }

    std::int64_t number(Slot slot) const { return m_objects[slot].value; }
    /// Unchecked; the value must fit the object's type.
    void setNumber(Slot slot, std::int64_t value) { m_objects[slot].value = value; }
    std::int64_t number(ObjectId id) const;             ///< the object must exist
    void setNumber(ObjectId id, std::int64_t value);    ///< the object must exist

    /// The bytes as the bus carries them, little-endian; a text without its end.
    SdoAbort read(ObjectId id, Bytes& out) const;
    /// Access, length and range, in this order. `slot` is kNone when the object does not exist.
    SdoAbort checkWrite(ObjectId id, ByteSpan data, Slot& slot, std::int64_t& value) const;

    /// Values only; the objects themselves are the device's program.
    void save(ByteWriter& writer) const;
    void restore(ByteReader& reader);

private:
    struct Object {
        ObjectInfo info;
        std::int64_t value = 0;
        unsigned size = 0;
    };
    SdoAbort missing(ObjectId id) const;

    std::vector<Object> m_objects;
};

/// Little-endian bytes to a number of this type, sign-extended where the type is signed. `data` has byteWidth(type) bytes.
std::int64_t numberFromBytes(DataType type, const std::uint8_t* data);

} // namespace camwright
