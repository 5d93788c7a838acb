#pragma once

#include "core/language/ir/ir.h"
#include "core/runtime/executor/scratch.h"

#include <array>
#include <asmjit/x86.h>
#include <cstdint>
#include <vector>

namespace camwright::native {

namespace x86 = asmjit::x86;

// Machine registers with a task of their own. All others hold values.
inline const x86::Gp Base = x86::rbx;     ///< memory areas, hidden state and scratch, one array
inline const x86::Gp Budget = x86::r12;   ///< operations the scan may still do, less those of the running segment
inline const x86::Gp FramePointer = x86::r13;
inline const x86::Gp Instance = x86::r14; ///< of the running function block: its first byte

/// A machine register by number: 0 to 15 the general ones, 16 to 31 the xmm registers.
using Unit = unsigned;
inline constexpr Unit FirstFloat = 16;
enum class Bank : std::uint8_t { General, Float };

constexpr std::uint32_t bitOf(Unit unit)
{
    return std::uint32_t{1} << unit;
}
inline constexpr std::uint32_t FloatUnits = 0xFFFF0000u;
/// Without the stack pointer and the four of above.
inline constexpr std::uint32_t GeneralUnits = 0xFFFFu & ~(bitOf(x86::Gp::kIdBx) | bitOf(x86::Gp::kIdSp) | bitOf(12) | bitOf(13) | bitOf(14));

/// Offsets from here on count from `Instance`, those below from `Base`.
inline constexpr std::uint32_t InstanceOffset = 0x80000000;

/// Bytes in the array at `Base`, or in the instance.
struct Range {
    std::uint32_t offset = 0;
    std::uint32_t bytes = 0;
    bool overlaps(const Range& other) const
    {
        return offset < other.offset + other.bytes && other.offset < offset + bytes;
    }
    bool operator==(const Range&) const = default;
};

/// Where a virtual register is, and how its bits lie there. A BOOL is one bit of a machine register whose other bits mean
/// nothing; an integer narrower than 32 bits is the low end of one. So no instruction is spent on cleaning up what nobody
/// looks at.
struct Value {
    enum class Where : std::uint8_t { Nowhere, Constant, Memory, Register, Slot };
    static constexpr std::uint32_t NoSlot = 0xFFFFFFFF;
    static constexpr std::uint8_t WholeByte = 0xFF;

    std::uint64_t content = 0;       ///< Constant: its bits; Memory: offset
    std::uint32_t uses = 0;          ///< still to come
    std::uint32_t slot = NoSlot;     ///< holds the value too, in the form it has in a register
    IrRegister next = NoRegister;    ///< next value in the same machine register
    Where where = Where::Nowhere;
    DataType type = DataType::Bool;
    std::uint8_t unit = 0;           ///< Register
    std::uint8_t bit = 0;            ///< BOOL: which bit it is. In memory: of the byte, or WholeByte
    bool inverted : 1 = false;       ///< BOOL: the bit says the opposite
    bool clean : 1 = false;          ///< BOOL: all other bits are 0; float: never a NaN
    bool extended : 1 = false;       ///< 8 and 16 bit integers: extended to 32 bits as their type wants
    bool keep : 1 = false;           ///< Memory: read or written again soon, so worth a register
};

/// What all machine registers hold of memory at one place of the program, to be compared with another way there.
struct Snapshot {
    std::array<Range, 32> memory{};
};

/// Decides where the values of one routine live, one instruction after the other: in machine registers within a straight
/// line, in slots of the scratch space across labels and calls. Remembers which bytes of memory a register equals, so they
/// are not read again; bytes whose bits are stored one by one stay in a register until the line ends. Memory operands of
/// different offsets are known not to overlap, for their addresses are constants that the verifier has checked; only the
/// instance of a function block may be anywhere among the variables.
class RegisterAllocator {
public:
    /// `variables`: what computed addresses and instances may touch.
    RegisterAllocator(x86::Assembler& assembler, SlotAllocator& slots, const ConstantPool& constants, const Range& variables)
        : m_asm(assembler), m_slots(slots), m_constants(constants), m_variables(variables)
    {
    }

    void beginRoutine(const IrRoutine& routine);
    /// Operands of the instruction may be overwritten from now on.
    void endInstruction();

    const Value& operator[](IrRegister number) const { return m_values[number]; }
    bool isUsed(IrRegister number) const { return m_values[number].uses > 0; }
    /// Nobody but the instruction at hand wants the value.
    bool isLastUse(IrRegister number) const { return m_values[number].uses == 1; }

    // Operands. Each call is one use, and the register stays as it is until endInstruction().
    enum class Width : std::uint8_t { Any, Extended };
    x86::Gp general(IrRegister number, Width width = Width::Any);
    x86::Xmm floating(IrRegister number);
    /// A register that holds the value and may be changed.
    x86::Gp ownGeneral(IrRegister number, Width width = Width::Any);
    x86::Xmm ownFloating(IrRegister number);
    /// Whether ownGeneral() costs no instruction.
    bool isOwnable(IrRegister number) const;
    /// What an instruction of the value's own width may take as its source: register, memory, or a constant of 32 bits.
    asmjit::Operand source(IrRegister number);
    asmjit::Operand floatSource(IrRegister number);
    /// One use of a value that is in no register, such as a constant.
    void use(IrRegister number);
    /// Brings a BOOL into a machine register, without using it.
    Unit bringBool(IrRegister number);
    /// Takes over the register of a BOOL that was brought, after its use, or copies it.
    Unit takeOver(Unit unit);
    bool mayTakeOver(Unit unit) const;

    // Results.
    Unit take(Bank bank);
    x86::Gp takeGeneral() { return x86::gpd(take(Bank::General)); }
    x86::Xmm takeFloat() { return x86::xmm(take(Bank::Float) - FirstFloat); }
    /// Empties a certain register and holds it until endInstruction().
    void takeFixed(Unit unit);
    void define(IrRegister number, DataType type, Unit unit, bool extended = false, bool clean = false);
    void defineBool(IrRegister number, Unit unit, unsigned bit, bool inverted, bool clean);
    void defineConstant(IrRegister number, DataType type, std::uint64_t bits);
    /// `number` is the same as another value, perhaps inverted; both become readable where the other is.
    void defineAlias(IrRegister number, IrRegister other, bool invert);
    void defineLoad(IrRegister number, DataType type, std::uint32_t offset, unsigned bit, bool keep);

    // Memory.
    /// Somebody is about to write these bytes: who wanted the old ones gets them now.
    void beforeStore(const Range& range);
    /// Somebody may write them or not, or read them.
    void beforeAccess(const Range& range);
    /// The same for everything that a computed address may touch.
    void beforeComputedStore() { beforeAccess(m_variables); }
    void beforeComputedLoad() { beforeLoad(m_variables); }
    /// The register holds what was just stored there.
    void remember(Unit unit, const Range& range);
    /// The register that holds a byte one of whose bits is about to change; memory gets it when the line ends. NoUnit if
    /// it is in no register and need not be.
    Unit byteForBits(std::uint32_t offset, bool mustHave);
    static constexpr Unit NoUnit = 0xFF;

    // Control flow.
    /// Everything that is needed later lies in memory or in slots; registers keep what they have. May change flags.
    void settle();
    /// As after settle(), and nothing is in a register any more.
    void forget();
    Snapshot snapshot() const;
    void restrictTo(const Snapshot& snapshot);
    void restore(const Snapshot& snapshot);

    x86::Mem at(std::uint32_t offset, unsigned bytes) const
    {
        return offset >= InstanceOffset ? x86::ptr(Instance, static_cast<std::int32_t>(offset - InstanceOffset), bytes)
                                        : x86::ptr(Base, static_cast<std::int32_t>(offset), bytes);
    }

    /// Reads a value of the type into a register; returns what it says of the bits.
    Value loadInto(Unit unit, DataType type, const x86::Mem& source, bool isWholeByte);

private:
    struct Register {
        Range memory;                 ///< bytes 0: equals no memory
        IrRegister first = NoRegister;
        std::uint32_t touched = 0;
        bool dirty = false;           ///< memory has not got the byte yet
        bool keep = false;            ///< the memory is looked at again soon
        bool isEmpty() const { return first == NoRegister && memory.bytes == 0; }
    };

    bool mayOverlap(const Range& a, const Range& b) const;
    void beforeLoad(const Range& range);
    void consume(IrRegister number);
    void link(IrRegister number, Unit unit);
    void unlink(IrRegister number);
    void hold(Unit unit);
    void release(Unit unit);
    void setMemory(Unit unit, const Range& range, bool keep);
    void dropMemory(Unit unit);
    Unit find(const Range& range, Bank bank) const;

    Unit bring(IrRegister number);
    void bringLoad(IrRegister number, Unit unit);
    void bringConstant(const Value& value, Unit unit);
    void extend(Unit from, Unit to, DataType type);
    void copy(Unit from, Unit to);
    Unit freeGeneral(Unit unit, DataType type, bool mustExtend);
    void spill(IrRegister number);
    void writeBack(Unit unit);
    void detachValues(Unit unit);
    void evict(Unit unit);
    void evictValue(IrRegister number, const Register& from);
    Unit evictOne(std::uint32_t candidates);
    void addPending(IrRegister number);
    void bringPending(IrRegister number);
    template <class Function>
    void forPending(Function function);

    x86::Assembler& m_asm;
    SlotAllocator& m_slots;
    const ConstantPool& m_constants;
    Range m_variables;
    std::vector<Value> m_values;
    std::vector<IrRegister> m_pending;  ///< values that are still in memory
    std::array<Register, 32> m_registers;
    std::uint32_t m_free = 0;           ///< one bit for each unit
    std::uint32_t m_held = 0;
    std::uint32_t m_cached = 0;         ///< equal some memory
    std::uint32_t m_clock = 0;
    bool m_mayGoBack = true;            ///< evicted values may wait in memory again
};

Bank bankOf(DataType type);
inline x86::Gp generalRegister(Unit unit, unsigned bytes)
{
    return bytes == 8 ? x86::Gp(x86::gpq(unit)) : bytes == 2 ? x86::Gp(x86::gpw(unit)) : bytes == 1 ? x86::Gp(x86::gpb(unit)) : x86::Gp(x86::gpd(unit));
}
inline x86::Xmm floatRegister(Unit unit) { return x86::xmm(unit - FirstFloat); }

} // namespace camwright::native
