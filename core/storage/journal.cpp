#include "core/storage/journal.h"

#include "core/storage/journalrecord.h"
#include "core/storage/objecttext.h"
#include "core/storage/projectstore.h"
#include "core/storage/savetransaction.h"

#include <algorithm>
#include <charconv>

namespace camwright {

namespace {

constexpr std::string_view Prefix = "journal.";
constexpr std::uint64_t LargestSegment = std::uint64_t{1} << 30;

std::string segmentName(std::uint32_t number)
{
    return std::string(Prefix) + std::to_string(number);
}

/// The numbers of all segments, ascending.
Result<std::vector<std::uint32_t>> segments(FileSystem& files, const std::string& folder)
{
    const auto entries = files.list(folder);
    if (!entries)
        return entries.error().code == Code::FileNotFound ? Result<std::vector<std::uint32_t>>(std::vector<std::uint32_t>{})
                                                          : Result<std::vector<std::uint32_t>>(entries.error());
    std::vector<std::uint32_t> out;
    for (const DirectoryEntry& entry : *entries) {
        std::uint32_t number = 0;
        const char* end = entry.name.data() + entry.name.size();
        if (!entry.name.starts_with(Prefix))
            continue;
        const auto result = std::from_chars(entry.name.data() + Prefix.size(), end, number);
        if (result.ptr == end && result.ec == std::errc{})
            out.push_back(number);
    }
    std::sort(out.begin(), out.end());
    return out;
}

/// Replays segments one behind the other.
class Replay {
public:
    explicit Replay(const Project& saved) : m_state(hashOf(saved)) { m_out.project = saved; }

    /// False when the segment does not stand on the state reached so far; nothing was replayed then.
    bool stands(const JournalSegment& segment) const
    {
        const auto* base = segment.records.empty() ? nullptr : std::get_if<JournalBase>(&segment.records.front());
        return base && base->project == m_state;
    }

    void run(const JournalSegment& segment)
    {
        m_out.drafts.clear(); // a segment begins with those that still stand
        m_out.torn = segment.torn;
        for (const JournalRecord& record : segment.records) {
            const auto* edit = std::get_if<JournalEdit>(&record);
            if (edit && !replay(*edit)) {
                m_out.torn = true;
                break;
            }
            if (const auto* draft = std::get_if<JournalDraft>(&record))
                keep(*draft);
        }
        m_state = hashOf(m_out.project);
    }

    bool hasAnything() const { return !m_out.labels.empty() || !m_out.drafts.empty(); }
    JournalContent take() { return std::move(m_out); }

private:
    bool replay(const JournalEdit& edit)
    {
        Project project = m_out.project;
        for (const RecordedDelta& delta : edit.deltas) {
            auto next = replayed(project, delta);
            if (!next)
                return false;
            project = std::move(*next);
        }
        m_out.project = std::move(project);
        m_out.labels.push_back(edit.label);
        return true;
    }

    void keep(const JournalDraft& draft)
    {
        auto object = draft.text ? fromText(draft.key, *draft.text) : Result<Object, Diagnostics>(Diagnostics{});
        if (object)
            m_out.drafts.insert_or_assign(draft.key, std::make_shared<const Object>(std::move(*object)));
        else
            m_out.drafts.erase(draft.key);
    }

    Hash m_state;
    JournalContent m_out;
};

bool holdsWork(const JournalSegment& segment)
{
    return segment.records.size() > 1;
}

} // namespace

Journal::Journal(FileSystem& files, std::string folder) : m_files(files), m_folder(std::move(folder)) {}

Result<std::unique_ptr<Journal>> Journal::begin(FileSystem& files, const std::string& projectPath, const Project& saved)
{
    if (auto made = makePrivateFolder(files, projectPath); !made)
        return made.error();
    std::unique_ptr<Journal> out(new Journal(files, privateFolder(projectPath)));
    const auto numbers = segments(files, out->m_folder);
    if (!numbers)
        return numbers.error();
    out->m_segment = numbers->empty() ? 0 : numbers->back();
    if (auto opened = out->openSegment(saved); !opened)
        return opened.error();
    return out;
}

Result<void> Journal::openSegment(const Project& base)
{
    auto file = m_files.openAppend(m_folder + '/' + segmentName(m_segment + 1));
    if (!file)
        return file.error();
    if (auto written = (*file)->append(writeRecord(JournalBase{hashOf(base)})); !written)
        return written;
    for (const auto& [key, draft] : m_drafts) {
        if (auto written = (*file)->append(writeRecord(JournalDraft{key, toText(*draft)})); !written)
            return written;
    }
    if (auto synced = (*file)->sync(); !synced)
        return synced;
    if (auto synced = m_files.syncDirectory(m_folder); !synced)
        return synced;
    const auto size = (*file)->size();
    if (!size)
        return size.error();
    m_file = std::move(*file);
    m_whole = *size;
    ++m_segment;
    m_entries = 0;
    return {};
}

Result<void> Journal::append(const std::string& label, const std::vector<ObjectDelta>& deltas)
{
    JournalEdit edit{label, {}};
    for (const ObjectDelta& delta : deltas)
        edit.deltas.push_back(recorded(delta));
    return write(writeRecord(edit));
}

Result<void> Journal::setDraft(const ObjectKey& key, const ObjectPtr& draft)
{
    if (draft)
        m_drafts.insert_or_assign(key, draft);
    else
        m_drafts.erase(key);
    return write(writeRecord(JournalDraft{key, draft ? std::optional(toText(*draft)) : std::nullopt}));
}

Result<void> Journal::write(const Bytes& record)
{
    m_pending.insert(m_pending.end(), record.begin(), record.end());
    ++m_entries;
    return flush();
}

/// A record written in part would hide all behind it, so what a failed write left is cut off first.
Result<void> Journal::flush()
{
    if (m_pending.empty())
        return {};
    const auto size = m_file->size();
    if (!size)
        return size.error();
    if (*size > m_whole) {
        if (auto cut = m_file->truncate(m_whole); !cut)
            return cut;
    }
    if (auto written = m_file->append(m_pending); !written)
        return written;
    m_whole += m_pending.size();
    m_pending.clear();
    return {};
}

Result<void> Journal::sync()
{
    auto flushed = flush();
    return flushed ? m_file->sync() : flushed;
}

Result<void> Journal::rotate(const Project& snapshot)
{
    if (auto flushed = flush(); !flushed)
        return flushed;
    const std::string former = segmentName(m_segment);
    auto opened = openSegment(snapshot);
    if (opened)
        m_finished.push_back(former);
    return opened;
}

Result<std::optional<JournalContent>> readJournal(FileSystem& files, const std::string& projectPath, const Project& saved)
{
    const std::string folder = privateFolder(projectPath);
    const auto numbers = segments(files, folder);
    if (!numbers)
        return numbers.error();
    Replay replay(saved);
    bool started = false, workElsewhere = false;
    std::string damaged;
    for (const std::uint32_t number : *numbers) {
        const std::string path = folder + '/' + segmentName(number);
        const auto text = files.read(path, LargestSegment);
        if (!text)
            return text.error();
        const JournalSegment segment = readSegment({reinterpret_cast<const std::uint8_t*>(text->data()), text->size()});
        if (replay.stands(segment)) {
            replay.run(segment);
            started = true;
        } else if (segment.records.empty()) {
            // A segment cut off while it was begun holds nothing; anything longer is not one that we can read.
            damaged = text->size() > writeRecord(JournalBase{}).size() ? path : damaged;
        } else {
            workElsewhere = workElsewhere || holdsWork(segment);
        }
    }
    if (started && replay.hasAnything())
        return std::optional(replay.take());
    if (!damaged.empty())
        return diagnostic(Code::JournalDamaged, {damaged});
    if (workElsewhere)
        return diagnostic(Code::JournalOfAnotherBase);
    return std::optional<JournalContent>();
}

Result<void> discardJournal(FileSystem& files, const std::string& projectPath)
{
    const std::string folder = privateFolder(projectPath);
    const auto numbers = segments(files, folder);
    if (!numbers)
        return numbers.error();
    for (const std::uint32_t number : *numbers) {
        if (auto removed = files.remove(folder + '/' + segmentName(number)); !removed)
            return removed;
    }
    return {};
}

} // namespace camwright
