#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <memory>
#include <new>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

namespace camwright::st {

/// Memory for the nodes of one compilation: given out in order, freed all at once. Nodes have no destructors.
class Arena {
public:
    Arena() = default;
    Arena(Arena&&) noexcept = default;
    Arena& operator=(Arena&&) noexcept = default;

    template <class T, class... Arguments>
    T* make(Arguments&&... arguments)
    {
        static_assert(std::is_trivially_destructible_v<T>);
        return new (take(sizeof(T), alignof(T))) T{std::forward<Arguments>(arguments)...};
    }

    std::string_view copy(std::string_view text)
    {
        if (text.empty())
            return {};
        auto* out = static_cast<char*>(take(text.size(), 1));
        std::memcpy(out, text.data(), text.size());
        return {out, text.size()};
    }

    void* take(std::size_t bytes, std::size_t alignment)
    {
        const std::size_t begin = (m_used + alignment - 1) / alignment * alignment;
        if (m_chunks.empty() || begin + bytes > m_size)
            return takeFromNewChunk(bytes);
        m_used = begin + bytes;
        return m_chunks.back().get() + begin;
    }

private:
    void* takeFromNewChunk(std::size_t bytes)
    {
        m_size = bytes > ChunkBytes ? bytes : ChunkBytes;
        m_chunks.push_back(std::make_unique_for_overwrite<std::byte[]>(m_size));
        m_used = bytes;
        return m_chunks.back().get();
    }

    static constexpr std::size_t ChunkBytes = 256 * 1024;

    std::vector<std::unique_ptr<std::byte[]>> m_chunks;
    std::size_t m_size = 0; ///< of the last chunk
    std::size_t m_used = 0;
};

/// A list of nodes linked by their `next`, filled at its end.
template <class T>
struct List {
    T* first = nullptr;
    T* last = nullptr;

    void add(T* node)
    {
        (last ? last->next : first) = node;
        last = node;
    }
    bool empty() const { return first == nullptr; }

    struct Iterator {
        T* node;
        T& operator*() const { return *node; }
        Iterator& operator++() { node = static_cast<T*>(node->next); return *this; }
        bool operator!=(const Iterator& other) const { return node != other.node; }
    };
    Iterator begin() const { return {first}; }
    Iterator end() const { return {nullptr}; }
};

} // namespace camwright::st
