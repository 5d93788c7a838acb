#pragma once

#include "core/language/check/resolvedprogram.h"

#include <cstdint>
#include <map>
#include <optional>
#include <span>

namespace camwright {

/// A register that the programs set to one constant and to nothing else.
struct KnownContent {
    std::uint32_t value = 0; ///< the word as it lies in memory: LDS K10 gives 16#10
    std::size_t program = 0; ///< where it is written
    TextRange range;
};

/// What registers hold, as far as programs load a constant and store it behind (LDS K10, OUTW R10000). Keys are addresses
/// of words.
class KoyoContents {
public:
    explicit KoyoContents(std::span<const ResolvedProgram> programs);

    /// Nothing for a register that is not written, or written with different values or with what is not known.
    const KnownContent* find(const Address& word) const;

private:
    using Key = std::pair<AreaId, std::uint32_t>;
    void follow(std::size_t program, const ResolvedStatement& statement);
    void store(std::size_t program, const ResolvedOperand& operand, std::optional<std::uint32_t> value);

    std::map<Key, std::optional<KnownContent>> m_contents;
    std::optional<std::uint32_t> m_accumulator;
};

} // namespace camwright
