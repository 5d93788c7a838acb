#include "core/language/st/syntax/names.h"

namespace camwright::st {

namespace {

constexpr std::string_view WordTexts[] = {
    "",
#define CAMWRIGHT_ST_WORD(word) std::string_view(#word) == "NULL_" ? std::string_view("NULL") : std::string_view(#word),
#include "core/language/st/syntax/words.h"
#undef CAMWRIGHT_ST_WORD
};

/// Letters of names differ between upper and lower case in this bit; digits have it, and of _ it makes no other letter.
constexpr unsigned CaseBit = 0x20;

std::uint32_t hashOf(std::string_view text)
{
    std::uint64_t hash = 0xcbf29ce484222325u;
    for (const char c : text)
        hash = (hash ^ (static_cast<unsigned char>(c) | CaseBit)) * 0x100000001b3u;
    return static_cast<std::uint32_t>(hash ^ hash >> 32);
}

} // namespace

std::string_view wordText(Word word)
{
    return WordTexts[static_cast<unsigned>(word)];
}

bool isSameName(std::string_view a, std::string_view b)
{
    if (a.size() != b.size())
        return false;
    for (std::size_t i = 0; i < a.size(); ++i) {
        if ((static_cast<unsigned char>(a[i]) | CaseBit) != (static_cast<unsigned char>(b[i]) | CaseBit))
            return false;
    }
    return true;
}

Names::Names() : m_slots(4096)
{
    m_texts.reserve(2048);
    m_texts.emplace_back();
    for (unsigned word = 1; word < static_cast<unsigned>(Word::Count); ++word)
        intern(WordTexts[word]);
}

NameId Names::intern(std::string_view text)
{
    const std::uint32_t hash = hashOf(text);
    const std::size_t mask = m_slots.size() - 1;
    std::size_t at = hash & mask;
    for (; m_slots[at].name != 0; at = (at + 1) & mask) {
        if (m_slots[at].hash == hash && isSameName(m_texts[m_slots[at].name], text))
            return m_slots[at].name;
    }
    const auto name = static_cast<NameId>(m_texts.size());
    m_texts.push_back(m_arena.copy(text));
    m_slots[at] = {hash, name};
    if (m_texts.size() * 2 > m_slots.size())
        grow();
    return name;
}

void Names::grow()
{
    std::vector<Slot> larger(m_slots.size() * 4);
    const std::size_t mask = larger.size() - 1;
    for (const Slot& slot : m_slots) {
        if (slot.name == 0)
            continue;
        std::size_t at = slot.hash & mask;
        while (larger[at].name != 0)
            at = (at + 1) & mask;
        larger[at] = slot;
    }
    m_slots = std::move(larger);
}

} // namespace camwright::st
