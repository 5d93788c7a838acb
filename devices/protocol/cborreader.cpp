#include "devices/protocol/cborreader.h"

#include <map>
#include <string_view>

namespace camwright::wire {

namespace {

/// Codes travel by their printed number; one that this release does not know keeps its number and arguments.
void setCode(Diagnostic& diagnostic, const std::string& id)
{
    static const std::map<std::string_view, Code> byId = [] {
        std::map<std::string_view, Code> out;
        for (const CodeInfo& info : allCodes())
            out[info.id] = info.code;
        return out;
    }();
    const auto found = byId.find(id);
    if (found != byId.end()) {
        diagnostic.code = found->second;
        return;
    }
    std::string all;
    for (const std::string& argument : diagnostic.arguments)
        all += (all.empty() ? "" : ", ") + argument;
    diagnostic.code = Code::ControllerReports;
    diagnostic.arguments = {id, all};
}

struct WireDiagnostic {
    std::string id;
    std::vector<std::string> arguments;
    Place place;
};

} // namespace

template <>
struct Fields<WireDiagnostic> {
    using S = WireDiagnostic;
    static constexpr auto list = std::make_tuple(must(1, &S::id), must(2, &S::arguments), may(3, &S::place));
};

bool CborReader::enterArray(std::size_t length)
{
    if (!m_stream.isArray() || !m_stream.isLengthKnown() || m_stream.length() != length)
        return fail(CW_TEXT("Arguments", "no list of the right length where one is due"));
    return m_stream.enterContainer() || fail(CW_TEXT("Arguments", "a broken list"));
}

bool CborReader::leaveArray()
{
    return m_stream.leaveContainer() || fail(CW_TEXT("Arguments", "a broken list"));
}

bool CborReader::read(bool& value)
{
    if (!m_stream.isBool())
        return fail(CW_TEXT("Arguments", "no true or false where one is due"));
    value = m_stream.toBool();
    return m_stream.next() || fail(CW_TEXT("Arguments", "a broken value"));
}

bool CborReader::read(double& value)
{
    if (m_stream.isDouble()) {
        value = m_stream.toDouble();
        return m_stream.next() || fail(CW_TEXT("Arguments", "a broken number"));
    }
    if (m_stream.isFloat()) {
        value = static_cast<double>(m_stream.toFloat());
        return m_stream.next() || fail(CW_TEXT("Arguments", "a broken number"));
    }
    std::int64_t whole = 0;
    if (!read(whole))
        return false;
    value = static_cast<double>(whole);
    return true;
}

bool CborReader::read(std::string& value)
{
    if (!m_stream.isString() || !m_stream.isLengthKnown())
        return fail(CW_TEXT("Arguments", "no text of known length where one is due"));
    const qsizetype size = m_stream.currentStringChunkSize();
    if (size < 0 || static_cast<std::size_t>(size) > m_size - static_cast<std::size_t>(m_stream.currentOffset()))
        return fail(CW_TEXT("Arguments", "a text that is longer than the message"));
    const auto part = m_stream.readString();
    if (part.status != QCborStreamReader::Ok)
        return fail(CW_TEXT("Arguments", "a text that is no UTF-8"));
    const QByteArray utf8 = part.data.toUtf8();
    value.assign(utf8.constData(), static_cast<std::size_t>(utf8.size()));
    return m_stream.readString().status == QCborStreamReader::EndOfString || fail(CW_TEXT("Arguments", "a broken text"));
}

bool CborReader::readBlob(QByteArray& out)
{
    if (!m_stream.isByteArray() || !m_stream.isLengthKnown())
        return fail(CW_TEXT("Arguments", "no bytes of known length where they are due"));
    const qsizetype size = m_stream.currentStringChunkSize();
    if (size < 0 || static_cast<std::size_t>(size) > m_size - static_cast<std::size_t>(m_stream.currentOffset()))
        return fail(CW_TEXT("Arguments", "bytes that are longer than the message"));
    auto part = m_stream.readByteArray();
    if (part.status != QCborStreamReader::Ok)
        return fail(CW_TEXT("Arguments", "broken bytes"));
    out = std::move(part.data);
    return m_stream.readByteArray().status == QCborStreamReader::EndOfString || fail(CW_TEXT("Arguments", "broken bytes"));
}

bool CborReader::read(Time& value)
{
    std::int64_t nanoseconds = 0;
    if (!read(nanoseconds))
        return false;
    value = Time(nanoseconds);
    return true;
}

bool CborReader::read(Bytes& value)
{
    QByteArray blob;
    if (!readBlob(blob))
        return false;
    value.assign(blob.begin(), blob.end());
    return true;
}

bool CborReader::read(Hash& value)
{
    QByteArray blob;
    if (!readBlob(blob))
        return false;
    value = {};
    if (blob.isEmpty())
        return true;
    if (static_cast<std::size_t>(blob.size()) != value.bytes.size())
        return fail(CW_TEXT("Arguments", "a digest that has neither 0 nor 32 bytes"));
    std::memcpy(value.bytes.data(), blob.constData(), value.bytes.size());
    return true;
}

bool CborReader::read(Value& value)
{
    if (!enterArray(2) || !read(value.type) || !read(value.bits))
        return false;
    if (bitWidth(value.type) < 64 && value.bits >> bitWidth(value.type) != 0)
        return fail(CW_TEXT("Arguments", "a value wider than its type"));
    return leaveArray();
}

bool CborReader::read(message::IndexedValue& value)
{
    if (!enterArray(4) || !read(value.index) || !read(value.value.type) || !read(value.value.bits) || !read(value.forced))
        return false;
    if (bitWidth(value.value.type) < 64 && value.value.bits >> bitWidth(value.value.type) != 0)
        return fail(CW_TEXT("Arguments", "a value wider than its type"));
    return leaveArray();
}

bool CborReader::read(std::vector<double>& value)
{
    QByteArray blob;
    if (!readBlob(blob))
        return false;
    if (static_cast<std::size_t>(blob.size()) % sizeof(double) != 0)
        return fail(CW_TEXT("Arguments", "samples that are no multiple of 8 bytes"));
    value.resize(static_cast<std::size_t>(blob.size()) / sizeof(double));
    if (!value.empty())
        std::memcpy(value.data(), blob.constData(), static_cast<std::size_t>(blob.size()));
    return true;
}

bool CborReader::read(Diagnostic& value)
{
    WireDiagnostic wire;
    if (!read<WireDiagnostic>(wire))
        return false;
    value.arguments = std::move(wire.arguments);
    value.place = std::move(wire.place);
    setCode(value, wire.id);
    return true;
}

} // namespace camwright::wire
