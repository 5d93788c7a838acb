#include "devices/controller/retainedstore.h"

#include "core/storage/crc.h"

#include <optional>

namespace camwright {

namespace {

constexpr std::uint32_t Magic = 0x31524943; // "CIR1"
constexpr std::uint64_t Limit = 64 * 1024 * 1024;

struct Set {
    std::uint64_t number = 0;
    Bytes data;
};

std::optional<Set> parse(const std::string& text)
{
    const ByteSpan bytes{reinterpret_cast<const std::uint8_t*>(text.data()), text.size()};
    if (bytes.size() < sizeof(std::uint32_t))
        return std::nullopt;
    const ByteSpan content = bytes.first(bytes.size() - sizeof(std::uint32_t));
    ByteReader check(bytes.subspan(content.size()));
    if (check.get<std::uint32_t>() != crc32(content))
        return std::nullopt;
    ByteReader reader(content);
    Set out;
    const auto magic = reader.get<std::uint32_t>();
    out.number = reader.get<std::uint64_t>();
    const ByteSpan data = reader.getBlob();
    if (!reader.ok() || !reader.atEnd() || magic != Magic)
        return std::nullopt;
    out.data.assign(data.begin(), data.end());
    return out;
}

} // namespace

RetainedStore::Stored RetainedStore::load()
{
    Stored out;
    bool any = false, found = false;
    for (std::uint64_t i = 0; i < 2; ++i) {
        const auto text = m_files.read(path(i), Limit);
        if (!text)
            continue;
        any = true;
        auto set = parse(*text);
        if (!set || (found && set->number < m_number))
            continue;
        found = true;
        m_number = set->number;
        out.data = std::move(set->data);
    }
    out.damaged = any && !found;
    m_last = out.data;
    m_hasLast = found;
    return out;
}

Result<void> RetainedStore::save(ByteSpan data)
{
    if (m_hasLast && std::equal(data.begin(), data.end(), m_last.begin(), m_last.end()))
        return {};
    ByteWriter writer;
    writer.put(Magic);
    writer.put(m_number + 1);
    writer.putBlob(data);
    writer.put(crc32(writer.bytes()));
    if (const auto done = m_files.writeSynced(path(m_number + 1), writer.bytes()); !done)
        return done.error();
    if (m_number < 2)
        (void)m_files.syncDirectory(m_folder);
    ++m_number;
    m_last.assign(data.begin(), data.end());
    m_hasLast = true;
    return {};
}

} // namespace camwright
