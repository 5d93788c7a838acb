#pragma once

#include "core/runtime/executor/bytecode.h"
#include "core/runtime/executor/scratch.h"

#include <cstdint>
#include <vector>

namespace camwright {

/// Turns one routine into steps, in one pass. Loads and boolean operations are not written when they are met but kept
/// pending until something uses them: a load then becomes the operand of its user, and a chain of contacts one network.
/// What is pending is written before anything that may change memory or leave the straight line, so it is computed from
/// the same memory as the IR says.
class RoutineDecoder {
public:
    RoutineDecoder(const IrRoutine& routine, const Memory& memory, const ConstantPool& constants, SlotAllocator& slots, Bytecode& out)
        : m_routine(routine), m_memory(memory), m_constants(constants), m_slots(slots), m_out(out)
    {
    }

    void run();

private:
    struct Operand {
        enum class State : std::uint8_t { Unknown, Slot, Memory, Constant, Network };
        State state = State::Unknown;
        DataType type = DataType::Bool;
        std::uint8_t mask = 1;           ///< Memory: of a BOOL
        std::uint32_t offset = 0;        ///< Slot, Memory, Constant
        std::uint32_t uses = 0;          ///< still to come
        std::vector<Contact> contacts;   ///< Network
    };

    void countUses();
    void findLabels();
    void decode(const IrInstruction& i);
    void decodeLoad(const IrInstruction& i);
    void decodeBool(const IrInstruction& i);
    void decodeComputing(const IrInstruction& i);
    void decodeStore(const IrInstruction& i);
    void decodeJump(const IrInstruction& i);
    void decodeElement(const IrInstruction& i);
    bool decodePlace(const IrInstruction& i);
    void decodeCall(const IrInstruction& i);
    void decodeGuard(const IrInstruction& i);
    void decodeLoadAccess(const IrInstruction& i);
    void decodeStoreAccess(const IrInstruction& i);
    void decodeEdge(const IrInstruction& i);

    // Operands. Each call is one use.
    std::uint32_t offsetOf(IrRegister number);
    std::vector<Contact> chainOf(IrRegister number);
    bool isSingleContact(IrRegister number) const;
    void used(Operand& operand);

    void define(IrRegister number, DataType type, std::vector<Contact> chain);
    std::uint32_t defineSlot(IrRegister number, DataType type);
    void writeDown(Operand& operand);
    void flush();

    void emit(Handler run, std::uint32_t dest, std::uint32_t a = 0, std::uint32_t b = 0, std::uint32_t extra = 0);
    std::uint32_t emitContacts(const std::vector<Contact>& chain);
    bool isStoreOf(std::size_t at, IrRegister number, DataType type) const;
    std::uint32_t memoryOffset(const IrAddress& address) const;
    std::uint32_t guardOf(const IrInstruction& i);

    const IrRoutine& m_routine;
    const Memory& m_memory;
    const ConstantPool& m_constants;
    SlotAllocator& m_slots;
    Bytecode& m_out;

    std::vector<Operand> m_registers;
    std::vector<IrRegister> m_pending;         ///< Memory and Network operands, in the order of their definition
    std::vector<bool> m_isLabel;
    std::vector<std::uint32_t> m_stepOf;       ///< first step of each labelled instruction
    std::vector<std::uint32_t> m_jumps;        ///< steps whose dest is still an IR instruction
    std::size_t m_firstGuard = 0;              ///< of this routine; their elseStep is still an IR instruction
    std::uint32_t m_at = 0;
};

} // namespace camwright
