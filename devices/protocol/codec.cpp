#include "devices/protocol/codec.h"

#include "devices/protocol/cborreader.h"
#include "devices/protocol/cborwriter.h"

namespace camwright {

namespace {

using wire::CborReader;
using wire::CborWriter;

struct Codec {
    message::Type type;
    void (*encode)(CborWriter&, const Message&);
    bool (*decode)(CborReader&, Message&);
};

template <class M>
constexpr Codec codecOf()
{
    return {M::type,
            [](CborWriter& writer, const Message& message) { writer.write(*std::get_if<M>(&message)); },
            [](CborReader& reader, Message& message) { return reader.read(message.emplace<M>()); }};
}

template <std::size_t... I>
constexpr auto codecs(std::index_sequence<I...>)
{
    return std::array<Codec, sizeof...(I)>{codecOf<std::variant_alternative_t<I, Message>>()...};
}

constexpr auto Codecs = codecs(std::make_index_sequence<std::variant_size_v<Message>>{});

} // namespace

Bytes encode(const Envelope& envelope)
{
    QByteArray out;
    CborWriter writer(out);
    const Codec& codec = Codecs[envelope.message.index()];
    writer.stream().startArray(3);
    writer.write(codec.type);
    writer.write(envelope.request);
    codec.encode(writer, envelope.message);
    writer.stream().endArray();
    return Bytes(out.begin(), out.end());
}

Result<Envelope, std::string> decode(ByteSpan body)
{
    if (body.empty() || body.size() > message::MaximumFrame)
        return std::string("a message of no length or beyond the limit");
    CborReader reader(QByteArray(reinterpret_cast<const char*>(body.data()), static_cast<qsizetype>(body.size())));
    Envelope out;
    std::uint16_t type = 0;
    if (!reader.enterArray(3) || !reader.read(type) || !reader.read(out.request))
        return reader.reason();
    for (const Codec& codec : Codecs) {
        if (static_cast<std::uint16_t>(codec.type) != type)
            continue;
        if (!codec.decode(reader, out.message) || !reader.leaveArray())
            return reader.reason() + ", in message " + std::to_string(type);
        if (!reader.atEnd())
            return "bytes after message " + std::to_string(type);
        return out;
    }
    return "a message with the unknown number " + std::to_string(type);
}

} // namespace camwright
