#include "core/family/addresssyntax.h"
#include "core/family/invt/invtareas.h"

#include <fmt/format.h>

namespace camwright {

namespace {

constexpr unsigned WordBits = 16;

std::string written(const MemoryArea& area, std::uint32_t number)
{
    return area.octal ? fmt::format("{}{:o}", area.name, number) : fmt::format("{}{}", area.name, number);
}

class InvtAddressSyntax final : public AddressSyntax {
public:
    Result<Address> parse(const Request& request) const override;
    std::string format(const MemoryArea& area, const Address& address) const override;
    TypeSet types(const MemoryArea& area, const Address& address) const override;

private:
    Result<Address> parseBit(const Request& request, AddressScanner& scanner, const MemoryArea& area, std::uint32_t number) const;
};

Result<Address> InvtAddressSyntax::parse(const Request& request) const
{
    AddressScanner scanner(request.text);
    const std::string text(request.text);
    if (auto foreign = scanner.foreignCharacter())
        return *foreign;
    const std::string letters = scanner.letters();
    const MemoryArea* area = nullptr;
    for (const MemoryArea& candidate : request.areas) {
        if (!area && candidate.name == letters)
            area = &candidate;
    }
    if (letters.empty())
        return scanner.errorWhole(Code::AddressMalformed, {text, "D100"});
    if (!area)
        return scanner.error(Code::AddressUnknownArea, {letters, request.model.name, areaNames(request.areas, "")}, 0, letters.size());
    const std::string_view digits = scanner.digits();
    if (digits.empty())
        return scanner.errorWhole(Code::AddressMalformed, {text, area->name + "0"});
    if (const std::size_t wrong = area->octal ? digits.find_first_of("89") : std::string_view::npos; wrong != std::string_view::npos)
        return scanner.error(Code::AddressNotOctal, {text, std::string(1, digits[wrong])}, letters.size() + wrong, letters.size() + wrong + 1);
    const std::uint32_t number = numberOf(digits, area->octal ? 8 : 10);
    const std::uint32_t count = request.model.area(area->id).bytes / area->elementBytes;
    if (number >= count) {
        return scanner.error(Code::AddressOutOfRange, {text, request.model.name, written(*area, 0), written(*area, count - 1)},
            0, letters.size() + digits.size());
    }
    if (!scanner.atEnd())
        return parseBit(request, scanner, *area, number);
    if (area->kind == AreaKind::Words)
        return valueAddress(area->id, number * area->elementBytes, DataType::Int);
    return bitAddress(area->id, number * area->elementBytes);
}

/// Dn.b: bit b of a word, 0 the lowest (TS-MEM-06).
Result<Address> InvtAddressSyntax::parseBit(const Request& request, AddressScanner& scanner, const MemoryArea& area, std::uint32_t number) const
{
    const std::string text(request.text);
    if (area.id != invt::D && area.id != invt::R)
        return scanner.errorWhole(Code::AddressMalformed, {text, written(area, number)});
    const bool dot = scanner.take('.');
    const std::size_t begin = scanner.position();
    const std::string_view digits = scanner.digits();
    if (!dot || digits.empty() || !scanner.atEnd())
        return scanner.errorWhole(Code::AddressMalformed, {text, written(area, number) + ".0"});
    const std::uint32_t bit = numberOf(digits);
    if (bit >= WordBits)
        return scanner.error(Code::AddressBitOutOfRange, {text, std::string(digits), std::to_string(WordBits - 1)}, begin, begin + digits.size());
    return bitAddress(area.id, number * area.elementBytes + bit / 8, bit % 8);
}

std::string InvtAddressSyntax::format(const MemoryArea& area, const Address& address) const
{
    std::string element = written(area, address.byte / area.elementBytes);
    if (area.kind != AreaKind::Words || !address.isBit)
        return element;
    return fmt::format("{}.{}", element, address.byte % 2 * 8 + address.bit);
}

TypeSet InvtAddressSyntax::types(const MemoryArea& area, const Address& address) const
{
    using enum DataType;
    switch (area.kind) {
    case AreaKind::Words:
        if (address.isBit)
            return {Bool};
        if (area.id == invt::Z)
            return {Int, Word, Uint};
        return {Int, Word, Uint, Dint, Dword, Udint, Real};
    case AreaKind::TimerValues:
        return {Int, Word, Uint};
    case AreaKind::CounterValues:
        return address.byte / area.elementBytes >= invt::FirstWideCounter ? TypeSet{Dint, Dword, Udint} : TypeSet{Int, Word, Uint};
    default:
        return {Bool};
    }
}

} // namespace

const AddressSyntax& invtAddressSyntax()
{
    static const InvtAddressSyntax syntax;
    return syntax;
}

} // namespace camwright
