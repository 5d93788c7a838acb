#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

namespace camwright {

using Bytes = std::vector<std::uint8_t>;
using ByteSpan = std::span<const std::uint8_t>;

static_assert(std::endian::native == std::endian::little, "memory areas and saved bytes are little-endian");

/// Appends plain values, little-endian. The counterpart of ByteReader; both are used for images and saved state.
class ByteWriter {
public:
    template <class T>
        requires std::is_arithmetic_v<T> || std::is_enum_v<T>
    void put(T value)
    {
        const auto old = m_bytes.size();
        m_bytes.resize(old + sizeof value);
        std::memcpy(m_bytes.data() + old, &value, sizeof value);
    }
    void put(bool value) { put<std::uint8_t>(value ? 1 : 0); }
    void putBytes(ByteSpan bytes) { m_bytes.insert(m_bytes.end(), bytes.begin(), bytes.end()); }
    void putBlob(ByteSpan bytes) { put(static_cast<std::uint32_t>(bytes.size())); putBytes(bytes); }
    void putText(std::string_view text) { putBlob({reinterpret_cast<const std::uint8_t*>(text.data()), text.size()}); }

    const Bytes& bytes() const { return m_bytes; }
    Bytes take() { return std::move(m_bytes); }

private:
    Bytes m_bytes;
};

/// Reads what ByteWriter wrote, never past the end: after the first failure every read gives zero and `ok()` is false.
class ByteReader {
public:
    explicit ByteReader(ByteSpan bytes) : m_bytes(bytes) {}

    template <class T>
        requires std::is_arithmetic_v<T> || std::is_enum_v<T>
    T get()
    {
        T value{};
        if (!has(sizeof value))
            return value;
        std::memcpy(&value, m_bytes.data() + m_position, sizeof value);
        m_position += sizeof value;
        return value;
    }
    bool getBool() { return get<std::uint8_t>() != 0; }
    ByteSpan getBytes(std::size_t size)
    {
        if (!has(size))
            return {};
        const ByteSpan out = m_bytes.subspan(m_position, size);
        m_position += size;
        return out;
    }
    ByteSpan getBlob() { return getBytes(get<std::uint32_t>()); }
    std::string getText()
    {
        const ByteSpan blob = getBlob();
        return {reinterpret_cast<const char*>(blob.data()), blob.size()};
    }

    bool ok() const { return m_ok; }
    bool atEnd() const { return m_position == m_bytes.size(); }
    std::size_t remaining() const { return m_ok ? m_bytes.size() - m_position : 0; }
    void fail() { m_ok = false; }

private:
    bool has(std::size_t size)
    {
        if (!m_ok || m_bytes.size() - m_position < size)
            m_ok = false;
        return m_ok;
    }

    ByteSpan m_bytes;
    std::size_t m_position = 0;
    bool m_ok = true;
};

} // namespace camwright
