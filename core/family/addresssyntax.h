#pragma once

#include "core/family/family.h"

namespace camwright {

/// How one family writes its addresses. Stateless; the areas and the model are passed in.
class AddressSyntax {
public:
    struct Request {
        std::string_view text;
        std::span<const MemoryArea> areas;
        const ControllerModel& model;
        AddressMode mode;
    };

    virtual ~AddressSyntax() = default;
    virtual Result<Address> parse(const Request& request) const = 0;
    virtual std::string format(const MemoryArea& area, const Address& address) const = 0;
    /// Types the place may be used as, by its area and (Kinco) the size it was written with.
    virtual TypeSet types(const MemoryArea& area, const Address& address) const = 0;
    /// Byte behind the last one that a value beginning at the address may take; its area ends at `areaBytes`.
    virtual std::uint32_t endOf(const Address& address, std::uint32_t areaBytes) const;
    /// Whether the name of a timer's or counter's value, where a bit is wanted, means its bit.
    virtual bool valuesNameBits() const { return true; }
    /// Type of a 16-bit timer or counter value: a signed number, or a word of BCD digits.
    virtual DataType elementValueType() const { return DataType::Int; }
};

const AddressSyntax& kincoAddressSyntax();
const AddressSyntax& invtAddressSyntax();
const AddressSyntax& koyoAddressSyntax();

/// Reads the pieces of an address from the left and makes located errors about them.
class AddressScanner {
public:
    explicit AddressScanner(std::string_view text) : m_text(text) {}

    /// The first character no address may hold, or nothing.
    std::optional<Diagnostic> foreignCharacter() const;
    bool take(char c);
    std::string letters();      ///< a run of letters, made upper case; may be empty
    std::string_view digits();  ///< a run of digits; may be empty
    bool atEnd() const { return m_at == m_text.size(); }
    std::size_t position() const { return m_at; }

    /// An error about the characters [begin, end) of the text.
    Diagnostic error(Code code, std::vector<std::string> arguments, std::size_t begin, std::size_t end) const;
    Diagnostic errorWhole(Code code, std::vector<std::string> arguments) const { return error(code, std::move(arguments), 0, m_text.size()); }

private:
    std::string_view m_text;
    std::size_t m_at = 0;
};

/// Digits as a number in `base`; what does not fit 32 bits becomes the largest number.
std::uint32_t numberOf(std::string_view digits, unsigned base = 10);

/// "I, Q, M": each name once.
std::string areaNames(std::span<const MemoryArea> areas, std::string_view prefix);

} // namespace camwright
