#include "core/model/objects.h"

#include <algorithm>
#include <cassert>

namespace camwright {

namespace {

constexpr std::size_t ChunkRows = 256;

void appendChunks(std::vector<VariableTable::Chunk>& out, const std::vector<Variable>& rows)
{
    for (std::size_t at = 0; at < rows.size(); at += ChunkRows) {
        const auto begin = rows.begin() + static_cast<std::ptrdiff_t>(at);
        const auto end = rows.begin() + static_cast<std::ptrdiff_t>(std::min(at + ChunkRows, rows.size()));
        out.push_back(std::make_shared<const std::vector<Variable>>(begin, end));
    }
}

} // namespace

VariableTable VariableTable::of(const std::vector<Variable>& rows)
{
    VariableTable out;
    appendChunks(out.chunks, rows);
    return out;
}

std::size_t VariableTable::rowCount() const
{
    std::size_t count = 0;
    for (const Chunk& chunk : chunks)
        count += chunk->size();
    return count;
}

const Variable& VariableTable::row(std::size_t index) const
{
    auto chunk = chunks.begin();
    for (; index >= (*chunk)->size(); ++chunk) {
        index -= (*chunk)->size();
        assert(chunk + 1 != chunks.end());
    }
    return (**chunk)[index];
}

std::vector<Variable> VariableTable::rows() const
{
    std::vector<Variable> out;
    out.reserve(rowCount());
    for (const Chunk& chunk : chunks)
        out.insert(out.end(), chunk->begin(), chunk->end());
    return out;
}

VariableTable VariableTable::replaced(std::size_t first, std::size_t removed, const std::vector<Variable>& inserted) const
{
    assert(first + removed <= rowCount());
    const std::size_t last = first + removed;
    std::size_t head = 0, headRows = 0; // chunks wholly before the change
    while (head < chunks.size() && headRows + chunks[head]->size() <= first)
        headRows += chunks[head++]->size();
    if (head > 0 && chunks[head - 1]->size() < ChunkRows) // rows appended one by one fill a chunk
        headRows -= chunks[--head]->size();
    std::size_t tail = head, tailRow = headRows; // first chunk wholly behind the change
    while (tail < chunks.size() && tailRow < last)
        tailRow += chunks[tail++]->size();

    std::vector<Variable> changed;
    std::size_t row = headRows;
    for (std::size_t n = head; n < tail; ++n) {
        for (const Variable& variable : *chunks[n]) {
            if (row < first)
                changed.push_back(variable);
            ++row;
        }
    }
    changed.insert(changed.end(), inserted.begin(), inserted.end());
    row = headRows;
    for (std::size_t n = head; n < tail; ++n) {
        for (const Variable& variable : *chunks[n]) {
            if (row >= last)
                changed.push_back(variable);
            ++row;
        }
    }
    VariableTable out;
    out.chunks.assign(chunks.begin(), chunks.begin() + static_cast<std::ptrdiff_t>(head));
    appendChunks(out.chunks, changed);
    out.chunks.insert(out.chunks.end(), chunks.begin() + static_cast<std::ptrdiff_t>(tail), chunks.end());
    return out;
}

bool VariableTable::operator==(const VariableTable& other) const
{
    if (chunks == other.chunks)
        return true;
    const std::size_t count = rowCount();
    if (count != other.rowCount())
        return false;
    std::size_t mine = 0, theirs = 0, inMine = 0, inTheirs = 0;
    for (std::size_t n = 0; n < count; ++n) {
        if (inMine == chunks[mine]->size())
            inMine = 0, ++mine;
        if (inTheirs == other.chunks[theirs]->size())
            inTheirs = 0, ++theirs;
        if (inMine == 0 && inTheirs == 0 && chunks[mine] == other.chunks[theirs]) {
            n += chunks[mine]->size() - 1;
            inMine = inTheirs = chunks[mine]->size();
        } else if (!((*chunks[mine])[inMine++] == (*other.chunks[theirs])[inTheirs++])) {
            return false;
        }
    }
    return true;
}

ObjectKind kindOf(const ObjectContent& content)
{
    struct Kind {
        ObjectKind operator()(const ProjectSettings&) const { return ObjectKind::Project; }
        ObjectKind operator()(const ControllerSettings&) const { return ObjectKind::Controller; }
        ObjectKind operator()(const Axis&) const { return ObjectKind::Axis; }
        ObjectKind operator()(const Network&) const { return ObjectKind::Network; }
        ObjectKind operator()(const Program&) const { return ObjectKind::Program; }
        ObjectKind operator()(const VariableTable&) const { return ObjectKind::VariableTable; }
        ObjectKind operator()(const WatchTable&) const { return ObjectKind::WatchTable; }
    };
    return std::visit(Kind{}, content);
}

} // namespace camwright
