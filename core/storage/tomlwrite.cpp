#include "core/storage/tomltext.h"

#include <algorithm>
#include <tuple>

namespace camwright {

namespace {

/// Which of the tables a path belongs to; empty for the root.
std::string_view tableOf(std::string_view path, const std::vector<std::string>& tables)
{
    for (const std::string& table : tables) {
        if (path.size() > table.size() && path.starts_with(table) && path[table.size()] == '.')
            return table;
    }
    return {};
}

std::string lineOf(const std::string& path, const std::string& value, std::string_view table)
{
    return (table.empty() ? path : path.substr(table.size() + 1)) + " = " + value + '\n';
}

/// A change of `before`: the bytes [begin, end) become `text`. Changes do not overlap.
struct Splice {
    std::size_t begin;
    std::size_t end;
    std::string text;
    std::size_t index; ///< in the order they were asked for; decides where two insert at one place
};

std::string spliced(std::string_view before, std::vector<Splice> splices)
{
    std::sort(splices.begin(), splices.end(),
              [](const Splice& a, const Splice& b) { return std::tie(a.begin, a.index) < std::tie(b.begin, b.index); });
    std::string out;
    std::size_t at = 0;
    for (const Splice& splice : splices) {
        out += before.substr(at, splice.begin - at);
        out += splice.text;
        at = splice.end;
    }
    return out += before.substr(at);
}

class TomlPatch {
public:
    TomlPatch(std::string_view before, const std::vector<TomlLeaf>& leaves, const TomlLines& is,
              const std::vector<std::string>& tables)
        : m_before(before), m_is(is), m_tables(tables)
    {
        for (const TomlLeaf& leaf : leaves)
            m_leaves.emplace(leaf.path, &leaf.value);
    }

    void replace(const std::string& path, const std::string& text)
    {
        if (const TomlValue* value = editable(path))
            splice(value->begin, value->end, text);
    }
    void erase(const std::string& path)
    {
        if (const TomlValue* value = editable(path))
            splice(lineBegin(value->begin), lineEnd(value->end), "");
    }
    /// Behind the last of the lines before it that has a place, in the same table.
    void insert(std::size_t index)
    {
        const auto& [path, text] = m_is[index];
        const std::string_view table = tableOf(path, m_tables);
        for (std::size_t n = index; n-- > 0;) {
            const auto found = m_leaves.find(m_is[n].first);
            if (found != m_leaves.end() && !found->second->hasHeaders && tableOf(found->first, m_tables) == table) {
                const std::size_t at = lineEnd(found->second->end);
                const bool open = at == 0 || m_before[at - 1] != '\n';
                splice(at, at, (open ? "\n" : "") + lineOf(path, text, table));
                return;
            }
        }
        m_possible = false;
    }
    std::optional<std::string> result()
    {
        return m_possible ? std::optional(spliced(m_before, std::move(m_splices))) : std::nullopt;
    }

private:
    void splice(std::size_t begin, std::size_t end, std::string text)
    {
        m_splices.push_back({begin, end, std::move(text), m_splices.size()});
    }
    const TomlValue* editable(const std::string& path)
    {
        const auto found = m_leaves.find(path);
        if (found != m_leaves.end() && !found->second->hasHeaders)
            return found->second;
        m_possible = false;
        return nullptr;
    }
    std::size_t lineBegin(std::size_t at) const
    {
        const std::size_t newline = at == 0 ? std::string_view::npos : m_before.rfind('\n', at - 1);
        return newline == std::string_view::npos ? 0 : newline + 1;
    }
    std::size_t lineEnd(std::size_t at) const
    {
        const std::size_t newline = m_before.find('\n', at);
        return newline == std::string_view::npos ? m_before.size() : newline + 1;
    }

    std::string_view m_before;
    const TomlLines& m_is;
    const std::vector<std::string>& m_tables;
    std::map<std::string, const TomlValue*> m_leaves;
    std::vector<Splice> m_splices;
    bool m_possible = true;
};

const std::string* valueAt(const TomlLines& lines, const std::string& path)
{
    const auto found = std::find_if(lines.begin(), lines.end(), [&](const auto& line) { return line.first == path; });
    return found == lines.end() ? nullptr : &found->second;
}

} // namespace

std::string writeToml(const TomlLines& lines, const std::vector<std::string>& tables)
{
    std::string out;
    for (const auto& [path, value] : lines) {
        if (tableOf(path, tables).empty())
            out += lineOf(path, value, {});
    }
    for (const std::string& table : tables) {
        bool headed = false;
        for (const auto& [path, value] : lines) {
            if (tableOf(path, tables) != table)
                continue;
            if (!headed)
                out += (out.empty() ? "[" : "\n[") + table + "]\n";
            headed = true;
            out += lineOf(path, value, table);
        }
    }
    return out;
}

std::optional<std::string> patchToml(std::string_view before, const std::vector<TomlLeaf>& leaves, const TomlLines& was,
                                     const TomlLines& is, const std::vector<std::string>& tables)
{
    TomlPatch patch(before, leaves, is, tables);
    const auto inFile = [&](const std::string& path) {
        return std::any_of(leaves.begin(), leaves.end(), [&](const TomlLeaf& leaf) { return leaf.path == path; });
    };
    for (std::size_t n = 0; n < is.size(); ++n) {
        const auto& [path, text] = is[n];
        const std::string* old = valueAt(was, path);
        if (old && *old == text)
            continue; // also a default that the file leaves out
        if (inFile(path))
            patch.replace(path, text);
        else
            patch.insert(n);
    }
    for (const TomlLeaf& leaf : leaves) {
        if (!valueAt(is, leaf.path))
            patch.erase(leaf.path);
    }
    return patch.result();
}

} // namespace camwright
