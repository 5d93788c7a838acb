#pragma once

#include "core/runtime/executor/bytecode.h"
#include "core/runtime/native/registerallocator.h"
#include "core/runtime/native/routineoutline.h"

#include <deque>
#include <vector>

namespace camwright::native {

/// What the routines of a program share while they are translated.
struct ProgramTranslation {
    x86::Assembler& assembler;
    const Memory& memory;
    const Bytecode& tables;
    SlotAllocator& slots;
    const ConstantPool& constants;     ///< of REAL and LREAL
    std::deque<Step>& steps;           ///< arguments of handlers that machine code calls; they must not move
    std::vector<asmjit::Label> entries; ///< by routine
    asmjit::Label fault;               ///< counts a fault; the instruction was pushed on the stack
    asmjit::Label outOfOperations;     ///< ends the scan; the instruction is in eax
    std::uint32_t argumentA = 0, argumentB = 0, result = 0; ///< offsets of 8 bytes each, for handlers
    bool hasAndn = false;
};

/// Translates one routine in one pass. Each operation is one function here, found by a table. What is not worth code of its
/// own, such as conversions of ULINT to REAL, calls the interpreter's handler.
class RoutineTranslator {
public:
    /// Whether every instruction has code here; only routines of which that is so may be run().
    static bool canTranslate(const IrRoutine& routine);

    RoutineTranslator(ProgramTranslation& program, const IrRoutine& routine, std::uint32_t index);
    void run();

private:
    using Emit = void (RoutineTranslator::*)(const IrInstruction&);
    struct Row;
    static const Row Rows[];
    static Emit emitterOf(IrOp op);

    /// Code for what seldom happens, written behind the routine.
    struct Cold {
        void (RoutineTranslator::*write)(const Cold&);
        asmjit::Label entry;
        asmjit::Label back;          ///< where it goes on
        std::uint32_t at = 0;        ///< IR instruction
        std::uint32_t extra = 0;     ///< see the function
    };

    struct FlowLabel {
        asmjit::Label label;
        bool isReached = false;      ///< a jump to it has been translated
        Snapshot snapshot;           ///< what all jumps so far agree on
    };

    // Operations.
    void nop(const IrInstruction&) {}
    void constant(const IrInstruction& i);
    void load(const IrInstruction& i);
    void store(const IrInstruction& i);
    void bitLogic(const IrInstruction& i);
    void invert(const IrInstruction& i);
    void edge(const IrInstruction& i);
    void arithmetic(const IrInstruction& i);
    void multiply(const IrInstruction& i);
    void divide(const IrInstruction& i);
    void negate(const IrInstruction& i);
    void absolute(const IrInstruction& i);
    void extreme(const IrInstruction& i);
    void shift(const IrInstruction& i);
    void compare(const IrInstruction& i);
    void squareRoot(const IrInstruction& i);
    void convert(const IrInstruction& i);
    void jump(const IrInstruction& i);
    void jumpIf(const IrInstruction& i);
    void callRoutine(const IrInstruction& i);
    void returnFromRoutine(const IrInstruction& i);
    void element(const IrInstruction& i);
    void interpreted(const IrInstruction& i);
    void callOn(const IrInstruction& i);
    void callAt(const IrInstruction& i);
    void select(const IrInstruction& i);
    void place(const IrInstruction& i);
    void guard(const IrInstruction& i);
    void locateElement(const IrInstruction& i);
    void loadAt(const IrInstruction& i);
    void storeAt(const IrInstruction& i);
    void loadElement(const IrInstruction& i);
    void storeElement(const IrInstruction& i);
    void move(const IrInstruction& i);
    void now(const IrInstruction& i);

    // BOOLs.
    void logicOfConstant(const IrInstruction& i, IrRegister constant, IrRegister other);
    bool joinBits(IrOp op, x86::Gp into, bool intoInverted, x86::Gp other, bool otherInverted);
    void andNot(x86::Gp into, x86::Gp inverted, x86::Gp straight);
    void shiftBits(Unit unit, unsigned from, unsigned to);
    void storeBit(const IrInstruction& i);
    void storeWholeByte(const IrInstruction& i);
    /// 0 or 1 in a register of its own; one use.
    x86::Gp ownZeroOrOne(IrRegister number);
    /// Sets the flags by a BOOL and tells under which condition it is true; one use.
    x86::CondCode testBool(IrRegister number, bool settles);

    // Numbers.
    void storeFloat(const IrInstruction& i);
    void floatArithmetic(const IrInstruction& i);
    void floatDivide(const IrInstruction& i);
    void floatExtreme(const IrInstruction& i);
    void compareFloats(const IrInstruction& i);
    void compareIntegers(const IrInstruction& i);
    void divideBy(const IrInstruction& i, x86::Gp divisor, bool mayBeZero, bool mayBeMinusOne);
    void rotateOrShift(const IrInstruction& i, x86::Gp value, unsigned count);
    void shiftByRegister(const IrInstruction& i);
    void integerToInteger(const IrInstruction& i);
    void integerToFloat(const IrInstruction& i);
    void floatToFloat(const IrInstruction& i);
    void floatToInteger(const IrInstruction& i);
    void setCondition(const IrInstruction& i, x86::CondCode condition, x86::Gp result);

    // Computed places.
    x86::Mem elementPlace(const IrInstruction& i);
    x86::Mem pointedPlace(const IrInstruction& i, IrRegister pointer);
    void loadFrom(const IrInstruction& i, const x86::Mem& source);
    void storeTo(const IrInstruction& i, const x86::Mem& place);
    void callInstance(const IrInstruction& i, const x86::Mem& instance);
    std::uint32_t variablesOffset() const { return m_program.memory.offsetOf(VariablesArea, 0); }

    // Control flow.
    bool isJumpOn(IrRegister number) const;
    void jumpWhen(x86::CondCode condition, std::uint32_t at, std::uint32_t target);
    void countJump(std::uint32_t at, std::uint32_t target);
    void land(std::uint32_t at);
    void arrive(FlowLabel& label, const Snapshot& snapshot);
    void leave(std::uint32_t at);
    Cold& cold(void (RoutineTranslator::*write)(const Cold&), std::uint32_t extra = 0);
    void coldJump(const Cold& c);
    void coldLoop(const Cold& c);
    void coldBudget(const Cold& c);
    void coldOutOfOperations(const Cold& c);
    void coldZeroDivisor(const Cold& c);
    void coldMinusOneDivisor(const Cold& c);
    void coldZeroFloatDivisor(const Cold& c);
    void coldFault(const Cold& c);
    void coldRealNaN(const Cold& c);
    void coldLrealNaN(const Cold& c);
    void coldExtremeNaN(const Cold& c);
    void coldOverflow(const Cold& c);
    void coldGuard(const Cold& c);
    void coldNaNToStore(const Cold& c);
    void callFault(std::uint32_t at);

    // Handlers.
    void putArgument(IrRegister number, DataType type, std::uint32_t offset);
    Step& callHandler(Handler handler, std::uint32_t extra);
    void takeResult(const IrInstruction& i);

    std::uint32_t offsetOf(const IrAddress& address) const
    {
        return address.area == InstanceArea ? InstanceOffset + address.byte : m_program.memory.offsetOf(address.area, address.byte);
    }
    x86::Mem frameField(std::size_t offset, unsigned bytes) const
    {
        return x86::ptr(FramePointer, static_cast<std::int32_t>(offset), bytes);
    }
    void beforeFault();

    ProgramTranslation& m_program;
    x86::Assembler& m_asm;
    const IrRoutine& m_routine;
    std::uint32_t m_index;
    RoutineOutline m_outline;
    RegisterAllocator m_registers;
    std::vector<FlowLabel> m_labels;
    std::vector<Cold> m_cold;
    std::uint32_t m_at = 0;
    bool m_isReachable = true;
};

} // namespace camwright::native
