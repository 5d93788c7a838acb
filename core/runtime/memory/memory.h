#pragma once

#include "core/base/bytes.h"
#include "core/base/value.h"
#include "core/family/address.h"
#include "core/language/image/controllerimage.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace camwright {

/// The memory of a controller: one little-endian byte array per area (CONTRACTS 8), laid one behind the other, then the
/// hidden state of timers, counters and edges, then scratch space of the executor. Documented overlaps are real, unaligned
/// access is legal. Not thread-safe: it belongs to the engine's thread.
class Memory {
public:
    Memory() = default;
    /// All zero. The layout is one that verify() accepts; `stateBytes` is IrProgram::stateBytes.
    Memory(const MemoryLayout& layout, std::uint32_t stateBytes);

    /// Whether the address lies wholly inside its area.
    bool contains(const Address& address) const;
    /// The value at an address; zero of its type where `contains` is false.
    Value read(const Address& address) const;
    /// Writes the value's bits, cut to the width of the address's type; false, and nothing written, where `contains` is
    /// false. REAL and LREAL NaN become the canonical NaN.
    bool write(const Address& address, const Value& value);

    /// The bytes of an area; empty if there is no such area.
    std::span<std::uint8_t> area(AreaId id);
    std::span<const std::uint8_t> area(AreaId id) const;

    /// Zeroes areas and hidden state, then writes the layout's initial values.
    void powerOn(const MemoryLayout& layout);

    /// Areas and hidden state; scratch holds nothing between scans.
    void save(ByteWriter& writer) const;
    bool restore(ByteReader& reader);

    /// For the executor: everything as one array, and where its parts begin. Scratch begins at an offset divisible by 8.
    void reserveScratch(std::uint32_t bytes);
    std::uint8_t* data() { return m_bytes.data(); }
    const std::uint8_t* data() const { return m_bytes.data(); }
    std::uint32_t offsetOf(AreaId area, std::uint32_t byte) const { return m_areas[area].offset + byte; }
    std::uint32_t stateOffset() const { return m_stateOffset; }
    std::uint32_t scratchOffset() const { return m_scratchOffset; }

private:
    struct Area {
        std::uint32_t offset = 0;
        std::uint32_t bytes = 0;
    };

    std::array<Area, 256> m_areas{}; ///< by id; no bytes: no such area
    std::uint32_t m_stateOffset = 0;
    std::uint32_t m_scratchOffset = 0;
    std::vector<std::uint8_t> m_bytes;
};

/// A value held at an address against program, terminals and writes.
struct Force {
    Address address;
    Value value;

    bool operator==(const Force&) const = default;
};

/// Writes every forced value.
void applyForces(Memory& memory, std::span<const Force> forces);

} // namespace camwright
