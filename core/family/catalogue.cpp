#include "core/family/catalogue.h"

#include <algorithm>

namespace camwright {

namespace {

std::string upperCase(std::string_view text)
{
    std::string out(text);
    for (char& c : out)
        c = c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
    return out;
}

constexpr std::size_t ReplaceCost = 3, InsertCost = 2; ///< a forgotten letter is likelier than a wrong one

/// Weighted edit distance.
std::size_t distance(std::string_view a, std::string_view b)
{
    std::vector<std::size_t> row(b.size() + 1);
    for (std::size_t j = 0; j <= b.size(); ++j)
        row[j] = j * InsertCost;
    for (std::size_t i = 1; i <= a.size(); ++i) {
        std::size_t diagonal = row[0];
        row[0] = i * InsertCost;
        for (std::size_t j = 1; j <= b.size(); ++j) {
            const std::size_t replace = diagonal + (a[i - 1] == b[j - 1] ? 0 : ReplaceCost);
            diagonal = row[j];
            row[j] = std::min({replace, row[j] + InsertCost, row[j - 1] + InsertCost});
        }
    }
    return row.back();
}

} // namespace

std::vector<DataType> TypeSet::list() const
{
    std::vector<DataType> out;
    for (unsigned i = static_cast<unsigned>(DataType::Bool); i <= static_cast<unsigned>(DataType::Lword); ++i) {
        if (contains(static_cast<DataType>(i)))
            out.push_back(static_cast<DataType>(i));
    }
    return out;
}

std::uint64_t OperandSpan::bytes() const
{
    return pin->kind == PinKind::Block ? pin->elementBytes * count : byteWidth(start.type);
}

bool collide(const OperandSpan& a, const OperandSpan& b)
{
    if (!(a.pin->isPrivate || b.pin->isPrivate) || a.start.area != b.start.area)
        return false;
    return a.start.byte < b.start.byte + b.bytes() && b.start.byte < a.start.byte + a.bytes();
}

const Pin* Instruction::findPin(std::string_view name) const
{
    const auto found = std::ranges::find(pins, name, &Pin::name);
    return found == pins.end() ? nullptr : &*found;
}

unsigned Instruction::requiredPins() const
{
    unsigned out = 0;
    for (std::size_t i = 0; i < pins.size(); ++i) {
        if (!pins[i].optional && pins[i].kind != PinKind::Arguments)
            out = static_cast<unsigned>(i + 1);
    }
    return out;
}

const Instruction* Catalogue::find(std::string_view mnemonic) const
{
    const auto found = m_byMnemonic.find(upperCase(mnemonic));
    return found == m_byMnemonic.end() ? nullptr : &m_instructions[found->second];
}

const Instruction* Catalogue::find(InstructionId id) const
{
    const auto found = m_byId.find(id);
    return found == m_byId.end() ? nullptr : &m_instructions[found->second];
}

Text Catalogue::groupName(std::string_view group) const
{
    const auto found = m_groups.find(group);
    return found == m_groups.end() ? Text{std::string(group), {}, {}} : found->second;
}

std::string Catalogue::nearest(std::string_view mnemonic) const
{
    const std::string wanted = upperCase(mnemonic);
    std::size_t best = wanted.size() < 4 ? ReplaceCost + 1 : 2 * ReplaceCost + 1;
    std::string out;
    for (const auto& [known, index] : m_byMnemonic) {
        const std::size_t cost = distance(wanted, known);
        if (cost < best) {
            best = cost;
            out = m_instructions[index].mnemonic;
        }
    }
    return out;
}

} // namespace camwright
