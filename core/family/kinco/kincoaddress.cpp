#include "core/family/addresssyntax.h"

#include <fmt/format.h>

namespace camwright {

namespace {

/// Bytes that a size letter stands for; X is the bit form, which is written without a letter.
unsigned widthOf(char letter)
{
    return letter == 'W' ? 2 : letter == 'D' || letter == 'R' ? 4 : 1;
}

DataType typeOf(char letter)
{
    switch (letter) {
    case 'B': return DataType::Byte;
    case 'W': return DataType::Int;
    case 'D': return DataType::Dint;
    case 'R': return DataType::Real;
    default: return DataType::Bool;
    }
}

char letterOf(const Address& address)
{
    if (address.isBit)
        return 'X';
    if (isFloat(address.type))
        return 'R';
    const unsigned width = byteWidth(address.type);
    return width == 1 ? 'B' : width == 2 ? 'W' : 'D';
}

std::string written(const MemoryArea& area, char letter, std::uint32_t byte, unsigned bit)
{
    if (letter == 'X')
        return fmt::format("%{}{}.{}", area.name, byte, bit);
    return fmt::format("%{}{}{}", area.name, letter, byte);
}

/// "%MB0", "%MW0": every form of the area, for messages.
std::string forms(const MemoryArea& area)
{
    std::string out;
    for (char letter : area.sizeLetters)
        out += (out.empty() ? "" : ", ") + written(area, letter, 0, 0);
    return out;
}

struct Match {
    const MemoryArea* area = nullptr;
    char letter = 'X';
};

/// "SMD" is area SM and letter D; "T" is the timers.
Match match(std::string_view letters, std::span<const MemoryArea> areas)
{
    for (const MemoryArea& area : areas) {
        if (area.name == letters)
            return {&area, 'X'};
        const bool sized = area.kind == AreaKind::Bytes && letters.size() == area.name.size() + 1 && letters.starts_with(area.name);
        if (sized && std::string_view("BWDR").find(letters.back()) != std::string_view::npos)
            return {&area, letters.back()};
    }
    return {};
}

class KincoAddressSyntax final : public AddressSyntax {
public:
    Result<Address> parse(const Request& request) const override;
    std::string format(const MemoryArea& area, const Address& address) const override;
    TypeSet types(const MemoryArea& area, const Address& address) const override;

private:
    Result<Address> parseElement(const Request& request, AddressScanner& scanner, const MemoryArea& area) const;
    Result<Address> parseBytes(const Request& request, AddressScanner& scanner, const Match& found) const;
};

Result<Address> KincoAddressSyntax::parse(const Request& request) const
{
    AddressScanner scanner(request.text);
    const std::string text(request.text);
    if (auto foreign = scanner.foreignCharacter())
        return *foreign;
    const bool percent = scanner.take('%');
    const std::string letters = scanner.letters();
    if (letters.empty())
        return scanner.errorWhole(Code::AddressMalformed, {text, "%VW304"});
    const Match found = match(letters, request.areas);
    if (!found.area) {
        const std::size_t begin = percent ? 1 : 0;
        return scanner.error(Code::AddressUnknownArea, {letters, request.model.name, areaNames(request.areas, "%")}, begin, begin + letters.size());
    }
    if (found.area->kind != AreaKind::Bytes)
        return parseElement(request, scanner, *found.area);
    if (found.area->sizeLetters.find(found.letter) == std::string::npos)
        return scanner.errorWhole(Code::AddressFormNotAllowed, {text, found.area->name, forms(*found.area)});
    Result<Address> address = parseBytes(request, scanner, found);
    if (address && !percent && request.mode == AddressMode::Program)
        return scanner.errorWhole(Code::AddressMissingPercent, {text, "%" + text});
    return address;
}

/// T and C: counted elements.
Result<Address> KincoAddressSyntax::parseElement(const Request& request, AddressScanner& scanner, const MemoryArea& area) const
{
    const std::string text(request.text);
    const std::string_view digits = scanner.digits();
    if (digits.empty() || !scanner.atEnd())
        return scanner.errorWhole(Code::AddressMalformed, {text, area.name + "0"});
    const std::uint32_t number = numberOf(digits);
    const std::uint32_t count = request.model.area(area.id).bytes / area.elementBytes;
    if (number >= count)
        return scanner.errorWhole(Code::AddressOutOfRange, {text, request.model.name, area.name + "0", fmt::format("{}{}", area.name, count - 1)});
    return bitAddress(area.id, number * area.elementBytes);
}

Result<Address> KincoAddressSyntax::parseBytes(const Request& request, AddressScanner& scanner, const Match& found) const
{
    const std::string text(request.text);
    const MemoryArea& area = *found.area;
    const std::string_view digits = scanner.digits();
    const std::uint32_t byte = numberOf(digits);
    unsigned bit = 0;
    bool complete = !digits.empty();
    if (found.letter == 'X') {
        complete = complete && scanner.take('.');
        const std::size_t begin = scanner.position();
        const std::string_view bits = scanner.digits();
        complete = complete && !bits.empty() && scanner.atEnd();
        bit = numberOf(bits);
        if (complete && bit > 7)
            return scanner.error(Code::AddressBitOutOfRange, {text, std::string(bits), "7"}, begin, begin + bits.size());
    }
    if (!complete || !scanner.atEnd())
        return scanner.errorWhole(Code::AddressMalformed, {text, written(area, found.letter, digits.empty() ? 0 : byte, 0)});
    const unsigned width = widthOf(found.letter);
    const std::uint32_t size = request.model.area(area.id).bytes;
    if (size < width || byte > size - width) {
        const std::uint32_t last = size < width ? 0 : (size - width) & (width > 1 ? ~1u : ~0u);
        return scanner.errorWhole(Code::AddressOutOfRange,
            {text, request.model.name, written(area, found.letter, 0, 0), written(area, found.letter, last, 7)});
    }
    if (width > 1 && byte % 2 != 0) {
        return scanner.errorWhole(Code::AddressOddByte,
            {text, written(area, found.letter, byte - 1, 0), written(area, found.letter, byte + 1, 0)});
    }
    return found.letter == 'X' ? bitAddress(area.id, byte, bit) : valueAddress(area.id, byte, typeOf(found.letter));
}

std::string KincoAddressSyntax::format(const MemoryArea& area, const Address& address) const
{
    if (area.kind != AreaKind::Bytes)
        return fmt::format("{}{}", area.name, address.byte / area.elementBytes);
    return written(area, letterOf(address), address.byte, address.bit);
}

TypeSet KincoAddressSyntax::types(const MemoryArea& area, const Address& address) const
{
    if (area.kind != AreaKind::Bytes)
        return address.isBit ? TypeSet{DataType::Bool} : TypeSet{DataType::Int, DataType::Word, DataType::Uint};
    switch (letterOf(address)) {
    case 'B': return {DataType::Byte, DataType::Usint, DataType::Sint};
    case 'W': return {DataType::Int, DataType::Word, DataType::Uint};
    case 'D': return {DataType::Dint, DataType::Dword, DataType::Udint, DataType::Time};
    case 'R': return {DataType::Real};
    default: return {DataType::Bool};
    }
}

} // namespace

const AddressSyntax& kincoAddressSyntax()
{
    static const KincoAddressSyntax syntax;
    return syntax;
}

} // namespace camwright
