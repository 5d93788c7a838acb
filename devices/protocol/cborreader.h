#pragma once

#include "devices/protocol/fields.h"

#include <QByteArray>
#include <QCborStreamReader>

#include <cmath>
#include <cstring>
#include <limits>
#include <string>
#include <type_traits>

namespace camwright::wire {

/// Reads what CborWriter wrote. After the first thing that does not fit, failed() is true, everything else is skipped and
/// reason() says in English what it was. No memory is asked for before the bytes for it are known to be there.
class CborReader {
public:
    static constexpr int MaximumDepth = 16;
    static constexpr std::size_t MaximumElements = 4096; ///< of one array

    explicit CborReader(const QByteArray& bytes) : m_size(static_cast<std::size_t>(bytes.size())), m_stream(bytes) {}

    bool failed() const { return !m_reason.empty(); }
    const std::string& reason() const { return m_reason; }
    bool fail(const char* reason)
    {
        if (m_reason.empty())
            m_reason = reason;
        return false;
    }
    bool atEnd() const { return static_cast<std::size_t>(m_stream.currentOffset()) == m_size; }

    bool enterArray(std::size_t length);
    bool leaveArray();
    bool skip() { return m_stream.next(MaximumDepth) || fail("a value that cannot be read"); }

    bool read(bool& value);
    bool read(double& value);
    bool read(std::string& value);
    bool read(Time& value);
    bool read(Bytes& value);
    bool read(Hash& value);
    bool read(Value& value);
    bool read(message::IndexedValue& value);
    bool read(std::vector<double>& value);
    bool read(Diagnostic& value);

    template <class T>
        requires std::is_integral_v<T>
    bool read(T& value)
    {
        using Limits = std::numeric_limits<T>;
        if (m_stream.isUnsignedInteger()) {
            const quint64 number = m_stream.toUnsignedInteger();
            if (number > static_cast<quint64>(Limits::max()))
                return fail("a number out of range");
            value = static_cast<T>(number);
            return m_stream.next() || fail("a broken number");
        }
        if (std::is_signed_v<T> && m_stream.isNegativeInteger()) {
            // The stream gives −n as n; −2^64 comes as 0.
            const quint64 magnitude = static_cast<quint64>(m_stream.toNegativeInteger());
            if (magnitude == 0 || magnitude - 1 > static_cast<quint64>(Limits::max()))
                return fail("a number out of range");
            value = static_cast<T>(-static_cast<std::int64_t>(magnitude - 1) - 1);
            return m_stream.next() || fail("a broken number");
        }
        return fail("no whole number where one is due");
    }

    template <class T>
        requires std::is_enum_v<T>
    bool read(T& value)
    {
        std::uint16_t number = 0;
        if (!read(number))
            return false;
        if (number < static_cast<std::uint16_t>(FirstOf<T>) || number > static_cast<std::uint16_t>(LastOf<T>))
            return fail("a choice that does not exist");
        value = static_cast<T>(number);
        return true;
    }

    template <class T>
    bool read(std::vector<T>& values)
    {
        if (!m_stream.isArray() || !m_stream.isLengthKnown())
            return fail("no list of known length where one is due");
        const quint64 length = m_stream.length();
        // Each element takes at least a byte: a length beyond what is left is a lie.
        if (length > MaximumElements || length > m_size - static_cast<std::size_t>(m_stream.currentOffset()))
            return fail("a list that is too long");
        if (!m_stream.enterContainer())
            return fail("a broken list");
        values.clear();
        for (quint64 i = 0; i < length; ++i)
            if (!read(values.emplace_back()))
                return false;
        return m_stream.leaveContainer() || fail("a broken list");
    }

    template <class T>
        requires requires { Fields<T>::list; }
    bool read(T& value)
    {
        if (!m_stream.isMap() || !m_stream.isLengthKnown())
            return fail("no map of known length where one is due");
        const quint64 length = m_stream.length();
        if (length > MaximumElements || !m_stream.enterContainer())
            return fail("a broken map");
        std::uint64_t seen = 0;
        for (quint64 i = 0; i < length; ++i) {
            std::uint32_t key = 0;
            if (!read(key))
                return false;
            if (key < 64 && (seen >> key & 1) != 0)
                return fail("a field that stands twice");
            if (key < 64)
                seen |= std::uint64_t{1} << key;
            if (!readField(key, value))
                return false;
        }
        if (!m_stream.leaveContainer())
            return fail("a broken map");
        bool complete = true;
        std::apply([&](const auto&... field) { ((complete = complete && (!field.required || (seen >> field.key & 1) != 0)), ...); },
                   Fields<T>::list);
        return complete || fail("a missing field");
    }

private:
    template <class T>
    bool readField(std::uint32_t key, T& value)
    {
        bool found = false, good = true;
        std::apply(
            [&](const auto&... field) {
                ((field.key == key && !found ? (found = true, good = read(value.*(field.member))) : false), ...);
            },
            Fields<T>::list);
        return found ? good : skip();
    }
    bool readBlob(QByteArray& out);

    std::size_t m_size;
    QCborStreamReader m_stream;
    std::string m_reason;
};

} // namespace camwright::wire
