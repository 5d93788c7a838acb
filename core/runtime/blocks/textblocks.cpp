#include "core/runtime/blocks/datablocks.h"

#include <array>
#include <vector>

namespace camwright::datablocks {

namespace {

constexpr std::uint32_t KeepEndFlag = 31;    // BINDA
constexpr std::uint32_t OneCharacterFlag = 32; // one character a word (TS-MEM-09)
constexpr std::int64_t MostCharacters = 256;

/// BINDA S D: "-00042" in three words, then a word of 0 unless SM31 is on.
void decimalText(PinValues& pins)
{
    const bool keepsEnd = isModeOn(pins, KeepEndFlag);
    if (!hasElements(pins, 1, keepsEnd ? 3 : 4))
        return reportIllegalParameter(pins);
    const std::int64_t value = pins.read(0).asInteger();
    std::array<std::uint8_t, 6> text{};
    text[0] = value < 0 ? '-' : ' ';
    std::int64_t rest = value < 0 ? -value : value;
    for (std::size_t i = text.size() - 1; i > 0; --i) {
        text[i] = static_cast<std::uint8_t>('0' + rest % 10);
        rest /= 10;
    }
    for (std::uint32_t word = 0; word < 3; ++word)
        setElement(pins, 1, word, static_cast<std::uint64_t>(text[2 * word]) | static_cast<std::uint64_t>(text[2 * word + 1]) << 8);
    if (!keepsEnd)
        setElement(pins, 1, 3, 0);
}

/// Where character `i` stands: in a word of its own, or in the low and high bytes of shared words.
struct Characters {
    bool oneAWord = false;

    std::uint32_t words(std::uint32_t count) const { return oneAWord ? count : (count + 1) / 2; }

    std::uint8_t at(PinValues& pins, std::size_t pin, std::uint32_t i) const
    {
        const std::uint64_t word = elementBits(pins, pin, oneAWord ? i : i / 2);
        return static_cast<std::uint8_t>(!oneAWord && i % 2 == 1 ? word >> 8 : word);
    }

    void set(PinValues& pins, std::size_t pin, std::uint32_t i, std::uint8_t character) const
    {
        if (oneAWord)
            return setElement(pins, pin, i, character);
        const std::uint64_t word = elementBits(pins, pin, i / 2);
        const bool high = i % 2 == 1;
        setElement(pins, pin, i / 2, high ? (word & 0xFF) | static_cast<std::uint64_t>(character) << 8 : (word & 0xFF00) | character);
    }
};

/// The count and whether source and destination hold it.
std::optional<std::uint32_t> legalCount(PinValues& pins, std::size_t textPin, std::size_t numberPin, const Characters& characters)
{
    const auto count = countAt(pins, 2, MostCharacters);
    if (!count)
        return std::nullopt;
    if (hasElements(pins, textPin, characters.words(*count)) && hasElements(pins, numberPin, (*count + 3) / 4))
        return count;
    reportIllegalParameter(pins);
    return std::nullopt;
}

/// ITA S D N.
void toHexadecimalText(PinValues& pins)
{
    const Characters characters{isModeOn(pins, OneCharacterFlag)};
    const auto count = legalCount(pins, 1, 0, characters);
    if (!count)
        return;
    std::vector<std::uint8_t> digits(*count);
    for (std::uint32_t i = 0; i < *count; ++i) {
        const std::uint32_t place = *count - 1 - i; // of the digit, from the lowest
        digits[i] = static_cast<std::uint8_t>("0123456789ABCDEF"[elementBits(pins, 0, place / 4) >> (4 * (place % 4)) & 0xF]);
    }
    for (std::uint32_t i = 0; i < *count; ++i)
        characters.set(pins, 1, i, digits[i]);
}

std::optional<unsigned> digitOf(std::uint8_t character)
{
    if (character >= '0' && character <= '9')
        return character - '0';
    if (character >= 'A' && character <= 'F')
        return character - 'A' + 10;
    if (character >= 'a' && character <= 'f')
        return character - 'a' + 10;
    return std::nullopt;
}

/// ATI S D N.
void fromHexadecimalText(PinValues& pins)
{
    const Characters characters{isModeOn(pins, OneCharacterFlag)};
    const auto count = legalCount(pins, 0, 1, characters);
    if (!count)
        return;
    std::vector<std::uint64_t> words((*count + 3) / 4);
    for (std::uint32_t i = 0; i < *count; ++i) {
        const auto digit = digitOf(characters.at(pins, 0, i));
        if (!digit)
            return reportIllegalParameter(pins);
        const std::uint32_t place = *count - 1 - i;
        words[place / 4] |= std::uint64_t{*digit} << (4 * (place % 4));
    }
    for (std::uint32_t i = 0; i < words.size(); ++i)
        setElement(pins, 1, i, words[i]);
}

} // namespace

bool runText(InstructionId instruction, PinValues& pins)
{
    switch (instruction) {
    case InstructionId::InvtBinda: decimalText(pins); return true;
    case InstructionId::InvtIta: toHexadecimalText(pins); return true;
    case InstructionId::InvtAti: fromHexadecimalText(pins); return true;
    default: return false;
    }
}

} // namespace camwright::datablocks
