#pragma once

#include <cstdint>
#include <string>

namespace camwright::bench {

/// Numbers that look random and are the same everywhere.
class Sequence {
public:
    std::uint32_t next(std::uint32_t below)
    {
        m_state = m_state * 6364136223846793005u + 1442695040888963407u;
        return static_cast<std::uint32_t>((m_state >> 33) % below);
    }

private:
    std::uint64_t m_state = 1;
};

/// A Kinco IL program of so many networks, mixed as in machines: 65 % contacts (2 to 6 and a coil), 12 % DINT additions,
/// 10 % comparisons to a coil, 8 % REAL products, 5 % additions behind a contact.
inline std::string generateIl(unsigned networks)
{
    Sequence random;
    const auto bit = [&] { return "%M" + std::to_string(random.next(1000)) + "." + std::to_string(random.next(8)); };
    const auto coil = [](unsigned n) { return "%M" + std::to_string(500 + n / 8 % 1500) + "." + std::to_string(n % 8); };
    const auto word = [&](const char* letter) { return std::string("%V") + letter + std::to_string(4 * random.next(1000)); };
    std::string out;
    for (unsigned n = 0; n < networks; ++n) {
        out += "(* Network " + std::to_string(n) + " *)\n";
        const std::uint32_t kind = random.next(100);
        if (kind < 65) {
            out += "LD " + bit() + "\n";
            static const char* const Contacts[] = {"AND ", "ANDN ", "OR ", "ORN "};
            for (std::uint32_t i = 0, count = 1 + random.next(5); i < count; ++i)
                out += Contacts[random.next(4)] + bit() + "\n";
            out += "ST " + coil(n) + "\n";
        } else if (kind < 77) {
            out += "LD %SM0.0\nADD " + word("D") + ", " + word("D") + ", " + word("D") + "\n";
        } else if (kind < 87) {
            out += "LD %SM0.0\nGT " + word("D") + ", " + word("D") + "\nST " + coil(n) + "\n";
        } else if (kind < 95) {
            out += "LD %SM0.0\nMUL " + word("R") + ", 1.0001, " + word("R") + "\n";
        } else {
            out += "LD " + bit() + "\nADD " + word("D") + ", DI#1, " + word("D") + "\n";
        }
    }
    return out;
}

} // namespace camwright::bench
