#pragma once

#include "core/base/bytes.h"
#include "core/base/value.h"
#include "core/family/address.h"
#include "core/language/ir/ir.h"

#include <algorithm>
#include <concepts>
#include <vector>

namespace camwright {

// How the pieces of an image lie in bytes. Unsigned numbers that are mostly small take 7 bits a byte, lowest first, the
// top bit telling that more follow.

void putVar(ByteWriter& writer, std::uint64_t number);
/// Fails the reader on a number that does not fit into `T`.
std::uint64_t getVar64(ByteReader& reader);
std::uint32_t getVar(ByteReader& reader);

void put(ByteWriter& writer, const IrAddress& address);
IrAddress getIrAddress(ByteReader& reader);
void put(ByteWriter& writer, const Address& address);
Address getAddress(ByteReader& reader);
void put(ByteWriter& writer, const Value& value);
Value getValue(ByteReader& reader);

/// Reads a data type; fails the reader on a number that is none, and gives BOOL then.
DataType getType(ByteReader& reader);

template <class T, class Put>
void putList(ByteWriter& writer, const std::vector<T>& list, Put putOne)
{
    putVar(writer, list.size());
    for (const T& item : list)
        putOne(item);
}

/// Reads as many as the list says, and stops at the first failure. Every item takes at least a byte, so a huge count in a
/// short part costs nothing.
template <class GetOne>
auto getList(ByteReader& reader, GetOne getOne)
{
    std::vector<decltype(getOne())> list;
    const std::uint32_t count = getVar(reader);
    list.reserve(std::min<std::size_t>(count, reader.remaining()));
    for (std::uint32_t i = 0; i < count && reader.ok(); ++i)
        list.push_back(getOne());
    return list;
}

} // namespace camwright
