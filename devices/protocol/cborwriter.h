#pragma once

#include "devices/protocol/fields.h"

#include <QByteArray>
#include <QCborStreamWriter>

#include <bit>
#include <cstring>
#include <type_traits>

namespace camwright::wire {

/// Writes plain values as CBOR, field lists as maps of definite length.
class CborWriter {
public:
    explicit CborWriter(QByteArray& out) : m_stream(&out) {}

    QCborStreamWriter& stream() { return m_stream; }

    void write(bool value) { m_stream.append(value); }
    void write(double value) { m_stream.append(value); }
    void write(const std::string& value) { m_stream.appendTextString(value.data(), static_cast<qsizetype>(value.size())); }
    void write(Time value) { write(value.count()); }
    void write(const Bytes& value) { bytes(value.data(), value.size()); }
    void write(const Hash& value) { bytes(value.bytes.data(), value.isNull() ? 0 : value.bytes.size()); }
    void write(const Value& value)
    {
        m_stream.startArray(2);
        write(value.type);
        write(value.bits);
        m_stream.endArray();
    }
    void write(const message::IndexedValue& value)
    {
        m_stream.startArray(4);
        write(value.index);
        write(value.value.type);
        write(value.value.bits);
        write(value.forced);
        m_stream.endArray();
    }
    void write(const std::vector<double>& value) { bytes(value.data(), value.size() * sizeof(double)); }
    void write(const Diagnostic& value)
    {
        m_stream.startMap(value.place == Place{} ? 2 : 3);
        m_stream.append(quint64(1));
        write(std::string(codeInfo(value.code).id));
        m_stream.append(quint64(2));
        write(value.arguments);
        if (value.place != Place{}) {
            m_stream.append(quint64(3));
            write(value.place);
        }
        m_stream.endMap();
    }

    template <class T>
        requires std::is_integral_v<T>
    void write(T value)
    {
        if constexpr (std::is_signed_v<T>)
            m_stream.append(static_cast<qint64>(value));
        else
            m_stream.append(static_cast<quint64>(value));
    }

    template <class T>
        requires std::is_enum_v<T>
    void write(T value) { m_stream.append(static_cast<quint64>(value)); }

    template <class T>
    void write(const std::vector<T>& values)
    {
        m_stream.startArray(values.size());
        for (const T& value : values)
            write(value);
        m_stream.endArray();
    }

    template <class T>
        requires requires { Fields<T>::list; }
    void write(const T& value)
    {
        std::apply(
            [&](const auto&... field) {
                m_stream.startMap(sizeof...(field));
                (writeField(field.key, value.*(field.member)), ...);
                m_stream.endMap();
            },
            Fields<T>::list);
    }

private:
    template <class T>
    void writeField(unsigned key, const T& value)
    {
        m_stream.append(static_cast<quint64>(key));
        write(value);
    }
    void bytes(const void* data, std::size_t size)
    {
        m_stream.appendByteString(static_cast<const char*>(data), static_cast<qsizetype>(size));
    }

    QCborStreamWriter m_stream;
};

} // namespace camwright::wire
