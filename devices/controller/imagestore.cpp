#include "devices/controller/imagestore.h"

#include "core/online/messages.h"
#include "core/storage/crc.h"

namespace camwright {

namespace {

constexpr std::uint32_t Magic = 0x31534943; // "CIS1"
constexpr std::uint64_t RecordLimit = 4096;

ByteSpan bytesOf(const std::string& text)
{
    return {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()};
}

void putHash(ByteWriter& writer, const Hash& hash)
{
    writer.putBytes(hash.bytes);
}

Hash getHash(ByteReader& reader)
{
    Hash out;
    const ByteSpan bytes = reader.getBytes(out.bytes.size());
    if (bytes.size() == out.bytes.size())
        std::copy(bytes.begin(), bytes.end(), out.bytes.begin());
    return out;
}

} // namespace

Result<ImageStore::Record> ImageStore::readRecord()
{
    const auto text = m_files.read(m_folder + "/active", RecordLimit);
    if (!text)
        return text.error();
    const Diagnostic damaged = diagnostic(Code::StoredProgramUnusable, {CW_TEXT("Arguments", "the record is damaged"), ""});
    const ByteSpan bytes = bytesOf(*text);
    if (bytes.size() < sizeof(std::uint32_t))
        return damaged;
    const ByteSpan content = bytes.first(bytes.size() - sizeof(std::uint32_t));
    ByteReader check(bytes.subspan(content.size()));
    ByteReader reader(content);
    Record out;
    if (check.get<std::uint32_t>() != crc32(content) || reader.get<std::uint32_t>() != Magic)
        return damaged;
    out.slot = reader.get<std::uint8_t>();
    out.image = getHash(reader);
    out.previous = getHash(reader);
    if (!reader.ok() || !reader.atEnd() || out.slot > 1 || out.image.isNull())
        return damaged;
    return out;
}

Result<Bytes> ImageStore::readSlot(std::uint8_t slot, const Hash& expected)
{
    const auto text = m_files.read(slotPath(slot), message::MaximumImage);
    if (!text)
        return text.error();
    const ByteSpan bytes = bytesOf(*text);
    if (hashOf(bytes) != expected)
        return diagnostic(Code::StoredProgramUnusable, {CW_TEXT("Arguments", "its digest does not fit"), ""});
    return Bytes(bytes.begin(), bytes.end());
}

ImageStore::Stored ImageStore::load()
{
    Stored out;
    const auto record = readRecord();
    if (!record) {
        if (record.error().code != Code::FileNotFound)
            out.trouble = CW_TEXT("Arguments", "the record of the stored program is damaged");
        return out;
    }
    if (auto image = readSlot(record->slot, record->image))
        out.image = std::move(*image);
    else
        out.trouble = CW_TEXT("Arguments", "the stored program is damaged");
    if (!record->previous.isNull())
        if (auto image = readSlot(static_cast<std::uint8_t>(1 - record->slot), record->previous))
            out.previous = std::move(*image);
    return out;
}

Result<void> ImageStore::replace(ByteSpan image)
{
    Record next;
    const auto old = readRecord();
    if (old) {
        next.slot = static_cast<std::uint8_t>(1 - old->slot);
        next.previous = old->image;
    } else if (old.error().code != Code::FileNotFound && old.error().code != Code::StoredProgramUnusable) {
        return storeFailed(old.error()); // which slot counts is not known now, so neither may be touched
    }
    next.image = hashOf(image);
    if (const auto done = m_files.writeSynced(slotPath(next.slot), image); !done)
        return storeFailed(done.error());
    return writeRecord(next);
}

Result<void> ImageStore::goBack()
{
    const auto record = readRecord();
    if (!record)
        return record.error();
    if (record->previous.isNull())
        return m_files.remove(m_folder + "/active");
    return writeRecord({static_cast<std::uint8_t>(1 - record->slot), record->previous, {}});
}

Diagnostic ImageStore::storeFailed(const Diagnostic& why) const
{
    return diagnostic(Code::StoreFailed, {m_folder, why.arguments.size() > 1 ? why.arguments[1] : englishText(why)});
}

Result<void> ImageStore::writeRecord(const Record& record)
{
    ByteWriter writer;
    writer.put(Magic);
    writer.put(record.slot);
    putHash(writer, record.image);
    putHash(writer, record.previous);
    writer.put(crc32(writer.bytes()));
    if (const auto done = m_files.writeSynced(m_folder + "/active.new", writer.bytes()); !done)
        return storeFailed(done.error());
    if (const auto done = m_files.syncDirectory(m_folder); !done)
        return storeFailed(done.error());
    if (const auto done = m_files.rename(m_folder + "/active.new", m_folder + "/active"); !done)
        return storeFailed(done.error());
    // The switch has happened; that its name may not survive a power cut yet is no reason to call it off.
    (void)m_files.syncDirectory(m_folder);
    return {};
}

} // namespace camwright
