#include "core/family/addresssyntax.h"
#include "core/family/koyo/koyoareas.h"

#include <fmt/format.h>

#include <algorithm>

namespace camwright {

namespace {

constexpr unsigned WordBits = 16;

/// What stands before the number: a bit element, the current value of one, or a word.
enum class Prefix : std::uint8_t { Bit, Value, Word, BitOfWord, Accumulator };

struct Name {
    std::string_view text;
    Prefix prefix;
    AreaId area;
};

/// DL205 names, and those of the D2-MLINK manual for the same memory (D2-AMB-21).
constexpr Name Names[] = {
    {"X", Prefix::Bit, koyo::X},     {"I", Prefix::Bit, koyo::X},   {"Y", Prefix::Bit, koyo::Y},   {"Q", Prefix::Bit, koyo::Y},
    {"C", Prefix::Bit, koyo::C},     {"M", Prefix::Bit, koyo::C},   {"S", Prefix::Bit, koyo::S},   {"SP", Prefix::Bit, koyo::SP},
    {"GX", Prefix::Bit, koyo::GX},   {"GI", Prefix::Bit, koyo::GX}, {"GY", Prefix::Bit, koyo::GY}, {"GQ", Prefix::Bit, koyo::GY},
    {"T", Prefix::Bit, koyo::TimerBit},      {"CT", Prefix::Bit, koyo::CounterBit},
    {"TA", Prefix::Value, koyo::TimerValue}, {"CTA", Prefix::Value, koyo::CounterValue},
    {"V", Prefix::Word, koyo::V},    {"R", Prefix::Word, koyo::V},  {"B", Prefix::BitOfWord, koyo::V},
    {"ACC", Prefix::Accumulator, koyo::Accumulator},
};

/// The place of a word: an area, and the byte in it. Nothing where DL205 has no memory.
struct WordPlace {
    AreaId area;
    std::uint32_t byte;
};

std::optional<WordPlace> placeOfWord(std::uint32_t word, const ControllerModel& model)
{
    for (const koyo::Window& window : koyo::Windows)
        if (word >= window.first && word < window.first + window.words)
            return WordPlace{window.area, (word - window.first) * 2};
    if (std::uint64_t{word} * 2 < model.area(koyo::V).bytes)
        return WordPlace{koyo::V, word * 2};
    return std::nullopt;
}

std::uint32_t wordOf(AreaId area, std::uint32_t byte)
{
    for (const koyo::Window& window : koyo::Windows)
        if (window.area == area)
            return window.first + byte / 2;
    return byte / 2;
}

class KoyoAddressSyntax final : public AddressSyntax {
public:
    Result<Address> parse(const Request& request) const override;
    std::string format(const MemoryArea& area, const Address& address) const override;
    TypeSet types(const MemoryArea& area, const Address& address) const override;
    std::uint32_t endOf(const Address& address, std::uint32_t areaBytes) const override;
    bool valuesNameBits() const override { return false; }
    DataType elementValueType() const override { return DataType::Word; }

private:
    static Result<Address> parseElement(const Request& request, AddressScanner& scanner, const Name& name, std::string_view digits);
    static Result<Address> parseWord(const Request& request, AddressScanner& scanner, const Name& name, std::string_view digits);
    static Result<Address> parseBit(const Request& request, AddressScanner& scanner, const WordPlace& place, std::string_view element);
};

Result<Address> KoyoAddressSyntax::parse(const Request& request) const
{
    AddressScanner scanner(request.text);
    const std::string text(request.text);
    if (auto foreign = scanner.foreignCharacter())
        return *foreign;
    const std::string letters = scanner.letters();
    if (letters.empty())
        return scanner.errorWhole(Code::AddressMalformed, {text, "X0"});
    const auto name = std::ranges::find(Names, std::string_view(letters), &Name::text);
    if (name == std::end(Names))
        return scanner.error(Code::AddressUnknownArea, {letters, request.model.name, areaNames(request.areas, "")}, 0, letters.size());
    const std::string_view digits = scanner.digits();
    if (digits.empty())
        return scanner.errorWhole(Code::AddressMalformed, {text, letters + (name->prefix == Prefix::BitOfWord ? "1400.0" : "0")});
    if (const std::size_t wrong = digits.find_first_of("89"); wrong != std::string_view::npos)
        return scanner.error(Code::AddressNotOctal, {text, std::string(1, digits[wrong])}, letters.size() + wrong, letters.size() + wrong + 1);
    const bool isWord = name->prefix == Prefix::Word || name->prefix == Prefix::BitOfWord;
    return isWord ? parseWord(request, scanner, *name, digits) : parseElement(request, scanner, *name, digits);
}

Result<Address> KoyoAddressSyntax::parseElement(const Request& request, AddressScanner& scanner, const Name& name, std::string_view digits)
{
    const std::string text(request.text);
    const std::uint32_t number = numberOf(digits, 8);
    const std::uint32_t bytes = request.model.area(name.area).bytes;
    const std::uint32_t count = name.prefix == Prefix::Bit ? bytes * 8 : name.prefix == Prefix::Value ? bytes / 2 : koyo::LoadedByte / 4;
    if (number >= count)
        return scanner.error(Code::AddressOutOfRange, {text, request.model.name, std::string(name.text) + "0", fmt::format("{}{:o}", name.text, count - 1)},
            0, name.text.size() + digits.size());
    if (name.prefix == Prefix::Value)
        return scanner.take('.') || !scanner.atEnd() ? parseBit(request, scanner, {name.area, number * 2}, request.text.substr(0, name.text.size() + digits.size()))
                                                    : Result<Address>(valueAddress(name.area, number * 2, DataType::Word));
    if (!scanner.atEnd())
        return scanner.errorWhole(Code::AddressMalformed, {text, fmt::format("{}{:o}", name.text, number)});
    if (name.prefix == Prefix::Accumulator)
        return valueAddress(name.area, number * 4, DataType::Dword);
    return bitAddress(name.area, number / 8, number % 8);
}

Result<Address> KoyoAddressSyntax::parseWord(const Request& request, AddressScanner& scanner, const Name& name, std::string_view digits)
{
    const std::string text(request.text);
    const std::string_view element = request.text.substr(0, name.text.size() + digits.size());
    const auto place = placeOfWord(numberOf(digits, 8), request.model);
    if (!place)
        return scanner.error(Code::AddressOutOfRange, {text, request.model.name, std::string(name.text) + "0", fmt::format("{}{:o}", name.text, request.model.area(koyo::V).bytes / 2 - 1)},
            0, element.size());
    if (scanner.take('.') || !scanner.atEnd() || name.prefix == Prefix::BitOfWord)
        return parseBit(request, scanner, *place, element);
    return valueAddress(place->area, place->byte, DataType::Word);
}

/// B1400.3, V1400.3: bit of a word, 0 the lowest, counted in decimal.
Result<Address> KoyoAddressSyntax::parseBit(const Request& request, AddressScanner& scanner, const WordPlace& place, std::string_view element)
{
    const std::string text(request.text);
    const std::size_t begin = scanner.position();
    const std::string_view digits = scanner.digits();
    if (digits.empty() || !scanner.atEnd() || begin <= element.size())
        return scanner.errorWhole(Code::AddressMalformed, {text, std::string(element) + ".0"});
    const std::uint32_t bit = numberOf(digits);
    if (bit >= WordBits)
        return scanner.error(Code::AddressBitOutOfRange, {text, std::string(digits), std::to_string(WordBits - 1)}, begin, begin + digits.size());
    return bitAddress(place.area, place.byte + bit / 8, bit % 8);
}

std::string KoyoAddressSyntax::format(const MemoryArea& area, const Address& address) const
{
    if (area.id == koyo::Accumulator)
        return fmt::format("ACC{:o}", address.byte / 4);
    const bool isElement = area.id != koyo::V && area.id != koyo::TimerValue && area.id != koyo::CounterValue;
    if (address.isBit && isElement)
        return fmt::format("{}{:o}", area.name, address.byte * 8 + address.bit);
    const std::uint32_t word = wordOf(area.id, address.byte);
    return address.isBit ? fmt::format("B{:o}.{}", word, address.byte % 2 * 8 + address.bit) : fmt::format("V{:o}", word);
}

TypeSet KoyoAddressSyntax::types(const MemoryArea& area, const Address& address) const
{
    using enum DataType;
    if (address.isBit)
        return {Bool};
    if (area.id == koyo::Accumulator)
        return {Dword, Udint, Dint};
    return {Word, Uint, Int, Dword, Udint, Dint, Real};
}

/// V1000 is no part of the area V: what begins before it ends there, and nothing begins in the stretch itself.
std::uint32_t KoyoAddressSyntax::endOf(const Address& address, std::uint32_t areaBytes) const
{
    std::uint32_t end = areaBytes;
    if (address.area == koyo::V)
        for (const koyo::Window& window : koyo::Windows) {
            if (window.first * 2 > address.byte)
                end = std::min(end, window.first * 2);
            else if (address.byte < (window.first + window.words) * 2)
                return 0;
        }
    return address.area == koyo::Accumulator ? std::min(end, koyo::LoadedByte) : end;
}

} // namespace

const AddressSyntax& koyoAddressSyntax()
{
    static const KoyoAddressSyntax syntax;
    return syntax;
}

} // namespace camwright
