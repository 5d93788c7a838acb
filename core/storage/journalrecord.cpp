#include "core/storage/journalrecord.h"

#include "core/storage/crc.h"
#include "core/storage/objecttext.h"

#include <algorithm>

namespace camwright {

namespace {

enum class Tag : std::uint8_t { Base = 1, Edit = 2, Draft = 3 };

void putKey(ByteWriter& out, const ObjectKey& key)
{
    out.put(key.kind);
    out.putText(key.name);
}

ObjectKey getKey(ByteReader& in)
{
    const auto kind = in.get<std::uint8_t>();
    if (kind > static_cast<std::uint8_t>(ObjectKind::WatchTable))
        in.fail();
    std::string name = in.getText();
    return {static_cast<ObjectKind>(kind), std::move(name)};
}

struct RecordWriter {
    ByteWriter& out;

    void operator()(const JournalBase& base) const
    {
        out.put(Tag::Base);
        out.putBytes(base.project.bytes);
    }
    void operator()(const JournalEdit& edit) const
    {
        out.put(Tag::Edit);
        out.putText(edit.label);
        out.put(static_cast<std::uint32_t>(edit.deltas.size()));
        for (const RecordedDelta& delta : edit.deltas) {
            putKey(out, delta.key);
            out.put(delta.form);
            out.put(delta.first);
            out.put(delta.removed);
            out.putText(delta.text);
        }
    }
    void operator()(const JournalDraft& draft) const
    {
        out.put(Tag::Draft);
        putKey(out, draft.key);
        out.put(draft.text.has_value());
        out.putText(draft.text.value_or(""));
    }
};

JournalEdit getEdit(ByteReader& in)
{
    JournalEdit out;
    out.label = in.getText();
    const auto count = in.get<std::uint32_t>();
    for (std::uint32_t n = 0; n < count && in.ok(); ++n) {
        RecordedDelta delta;
        delta.key = getKey(in);
        const auto form = in.get<std::uint8_t>();
        if (form > static_cast<std::uint8_t>(RecordedDelta::Form::TableRows))
            in.fail();
        delta.form = static_cast<RecordedDelta::Form>(form);
        delta.first = in.get<std::uint64_t>();
        delta.removed = in.get<std::uint64_t>();
        delta.text = in.getText();
        out.deltas.push_back(std::move(delta));
    }
    return out;
}

std::optional<JournalRecord> readPayload(ByteSpan payload)
{
    ByteReader in(payload);
    JournalRecord out;
    switch (in.get<Tag>()) {
    case Tag::Base: {
        JournalBase base;
        const ByteSpan bytes = in.getBytes(base.project.bytes.size());
        std::copy(bytes.begin(), bytes.end(), base.project.bytes.begin());
        out = base;
        break;
    }
    case Tag::Edit: out = getEdit(in); break;
    case Tag::Draft: {
        JournalDraft draft;
        draft.key = getKey(in);
        const bool there = in.getBool();
        std::string text = in.getText();
        if (there)
            draft.text = std::move(text);
        out = std::move(draft);
        break;
    }
    default: return std::nullopt;
    }
    return in.ok() && in.atEnd() ? std::optional(std::move(out)) : std::nullopt;
}

RecordedDelta sourceStretch(RecordedDelta delta, std::string_view before, std::string_view after)
{
    const auto head = static_cast<std::size_t>(std::mismatch(before.begin(), before.end(), after.begin(), after.end()).first - before.begin());
    std::size_t tail = 0;
    while (tail < std::min(before.size(), after.size()) - head && before[before.size() - 1 - tail] == after[after.size() - 1 - tail])
        ++tail;
    delta.form = RecordedDelta::Form::SourceStretch;
    delta.first = head;
    delta.removed = before.size() - head - tail;
    delta.text = after.substr(head, after.size() - head - tail);
    return delta;
}

/// Rows of a table in turn, skipping whole chunks that both tables share.
std::size_t equalRowsAtBegin(const VariableTable& a, const VariableTable& b)
{
    std::size_t chunk = 0, rows = 0;
    while (chunk < a.chunks.size() && chunk < b.chunks.size() && a.chunks[chunk] == b.chunks[chunk])
        rows += a.chunks[chunk++]->size();
    const std::size_t most = std::min(a.rowCount(), b.rowCount());
    while (rows < most && a.row(rows) == b.row(rows))
        ++rows;
    return rows;
}

std::size_t equalRowsAtEnd(const VariableTable& a, const VariableTable& b, std::size_t most)
{
    std::size_t chunk = 1, rows = 0;
    while (chunk <= a.chunks.size() && chunk <= b.chunks.size() && a.chunks[a.chunks.size() - chunk] == b.chunks[b.chunks.size() - chunk]
           && rows + a.chunks[a.chunks.size() - chunk]->size() <= most)
        rows += a.chunks[a.chunks.size() - chunk++]->size();
    const std::size_t countA = a.rowCount(), countB = b.rowCount();
    while (rows < most && a.row(countA - 1 - rows) == b.row(countB - 1 - rows))
        ++rows;
    return rows;
}

RecordedDelta tableRows(RecordedDelta delta, const VariableTable& before, const VariableTable& after)
{
    const std::size_t head = equalRowsAtBegin(before, after);
    const std::size_t countBefore = before.rowCount(), countAfter = after.rowCount();
    const std::size_t tail = equalRowsAtEnd(before, after, std::min(countBefore, countAfter) - head);
    std::vector<Variable> inserted;
    for (std::size_t row = head; row < countAfter - tail; ++row)
        inserted.push_back(after.row(row));
    delta.form = RecordedDelta::Form::TableRows;
    delta.first = head;
    delta.removed = countBefore - head - tail;
    delta.text = toText({{ObjectKind::VariableTable, ""}, 0, VariableTable::of(inserted), {}});
    return delta;
}

std::optional<ObjectContent> changedContent(const Object& object, const RecordedDelta& delta)
{
    if (delta.form == RecordedDelta::Form::SourceStretch) {
        const auto* program = std::get_if<Program>(&object.content);
        if (!program || delta.first > program->source.size() || delta.removed > program->source.size() - delta.first)
            return std::nullopt;
        Program out = *program;
        out.source.replace(delta.first, delta.removed, delta.text);
        return out;
    }
    const auto* table = std::get_if<VariableTable>(&object.content);
    const auto rows = fromText({ObjectKind::VariableTable, ""}, delta.text);
    if (!table || !rows || delta.first > table->rowCount() || delta.removed > table->rowCount() - delta.first)
        return std::nullopt;
    return table->replaced(delta.first, delta.removed, std::get<VariableTable>(rows->content).rows());
}

} // namespace

RecordedDelta recorded(const ObjectDelta& delta)
{
    RecordedDelta out;
    out.key = delta.key;
    if (!delta.after)
        return out;
    if (delta.before && delta.before->order == delta.after->order && delta.before->unknown == delta.after->unknown) {
        const auto* before = std::get_if<Program>(&delta.before->content);
        const auto* after = std::get_if<Program>(&delta.after->content);
        if (before && after && before->role == after->role && before->language == after->language)
            return sourceStretch(std::move(out), before->source, after->source);
        const auto* tableBefore = std::get_if<VariableTable>(&delta.before->content);
        const auto* tableAfter = std::get_if<VariableTable>(&delta.after->content);
        if (tableBefore && tableAfter)
            return tableRows(std::move(out), *tableBefore, *tableAfter);
    }
    out.form = RecordedDelta::Form::Whole;
    out.text = toText(*delta.after);
    return out;
}

std::optional<Project> replayed(const Project& project, const RecordedDelta& delta)
{
    if (delta.form == RecordedDelta::Form::Removed)
        return project.with(delta.key, nullptr);
    if (delta.form == RecordedDelta::Form::Whole) {
        auto object = fromText(delta.key, delta.text);
        return object ? std::optional(project.with(delta.key, std::make_shared<const Object>(std::move(*object)))) : std::nullopt;
    }
    const ObjectPtr object = project.find(delta.key);
    auto content = object ? changedContent(*object, delta) : std::nullopt;
    return content ? std::optional(project.withContent(delta.key, std::move(*content))) : std::nullopt;
}

Bytes writeRecord(const JournalRecord& record)
{
    ByteWriter payload;
    std::visit(RecordWriter{payload}, record);
    ByteWriter out;
    out.put(static_cast<std::uint32_t>(payload.bytes().size()));
    out.put(crc32(payload.bytes()));
    out.putBytes(payload.bytes());
    return out.take();
}

JournalSegment readSegment(ByteSpan bytes)
{
    JournalSegment out;
    ByteReader in(bytes);
    while (!in.atEnd()) {
        const auto length = in.get<std::uint32_t>();
        const auto crc = in.get<std::uint32_t>();
        const ByteSpan payload = in.getBytes(length);
        auto record = in.ok() && crc32(payload) == crc ? readPayload(payload) : std::nullopt;
        if (!record) {
            out.torn = true;
            break;
        }
        out.records.push_back(std::move(*record));
    }
    return out;
}

} // namespace camwright
