#pragma once

#include "core/language/check/checkedprogram.h"
#include "core/language/lowering/elementtables.h"
#include "core/language/lowering/irwriter.h"

#include <cstdint>
#include <functional>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace camwright {

/// What the lowering of one routine must know of the whole.
struct RoutineContext {
    const Family& family;
    const ControllerModel& model;
    ElementTables& elements;
    std::uint32_t routine = 0;   ///< its index; local memory of routine n lies n area sizes further on
    std::function<std::uint32_t(std::string_view)> routineByName;
    std::span<const CheckedProgram> programs; ///< by the index of their routine
    /// Gives a statement of a network its number in the debug map.
    std::function<std::uint32_t(std::uint32_t network, const TextRange&)> source;
    bool usesStack = false;      ///< Koyo: a program reads the stack of the accumulator
};

/// Lowers the statements of one program, in their order, with the flow (CR of Kinco, power flow of TS600) in a register.
/// Nothing flows from rung to rung. What runs only with flow is skipped by a jump; neighbours with the same flow share it.
class RoutineLowering {
public:
    RoutineLowering(const RoutineContext& context, IrRoutine& routine) : m_context(context), m_ir(routine) {}

    void lower(const CheckedProgram& program);

private:
    struct Group {
        StatementRole kind = StatementRole::OpenAnd;
        IrRegister outer = NoRegister;
    };

    /// A FOR whose NEXT is still to come.
    struct Loop {
        IrAddress counter;
        std::uint32_t begin = 0; ///< instruction that looks whether it is over
        std::size_t exit = 0;    ///< jump behind NEXT, still open
    };

    /// An open FOR: where it looks whether there is another pass, and the jump out of it.
    struct ForLoop {
        std::size_t head = 0;
        std::size_t exit = 0;
        std::size_t skip = 0;
        const CheckedStatement* statement = nullptr;
    };

    void lower(const CheckedStatement& statement);
    // Flow (flowlowering.cpp)
    void combine(StatementRole role, IrRegister contact);
    void lowerStructure(const CheckedStatement& statement);
    void lowerFlow(const CheckedStatement& statement);
    IrRegister contact(const CheckedStatement& statement);
    IrRegister comparison(const CheckedStatement& statement);
    IrRegister flow();
    // Outputs and program control (outputlowering.cpp)
    void lowerOutput(const CheckedStatement& statement);
    void lowerReset(const CheckedStatement& statement);
    void lowerBlock(const CheckedStatement& statement);
    void lowerEngineBlock(const CheckedStatement& statement);
    // Calls, jumps, loops (controllowering.cpp)
    bool lowerControl(const CheckedStatement& statement);
    void lowerReturn(const CheckedStatement& statement);
    void lowerCall(const CheckedStatement& statement);
    void lowerJump(const CheckedStatement& statement);
    void lowerLabel(const CheckedStatement& statement);
    void lowerFor(const CheckedStatement& statement);
    void lowerCountedFor(const CheckedStatement& statement);
    void lowerNext();
    void landJumps();
    void beginFlowAnew();
    // Timers and counters (elementlowering.cpp)
    bool lowerElement(const CheckedStatement& statement);
    void lowerTimer(const CheckedStatement& statement, TimerKind kind);
    void lowerCounter(const CheckedStatement& statement, CounterKind kind);
    void lowerCyclicCounter(const CheckedStatement& statement);
    IrRegister lowerCounterExtras(const CheckedStatement& statement, std::uint32_t counter, IrRegister load, IrRegister preset);
    // Moves, arithmetic, conversions (computelowering.cpp)
    bool lowerComputing(const CheckedStatement& statement);
    void lowerMove(const CheckedStatement& statement);
    void lowerUnary(const CheckedStatement& statement, IrOp op);
    void lowerBinary(const CheckedStatement& statement, IrOp op);
    void lowerConversion(const CheckedStatement& statement, IrOp op);
    void lowerStep(const CheckedStatement& statement, IrOp op);
    void lowerShift(const CheckedStatement& statement, IrOp op);
    void lowerDivision(const CheckedStatement& statement, IrOp op);
    void lowerSwap(const CheckedStatement& statement);
    void lowerExchange(const CheckedStatement& statement);

    // Koyo (koyolowering.cpp)
    bool lowerKoyo(const CheckedStatement& statement);
    void lowerKoyoData(const CheckedStatement& statement);
    void lowerKoyoInPlace(const CheckedStatement& statement);
    void lowerKoyoElement(const CheckedStatement& statement);
    void lowerKoyoControl(const CheckedStatement& statement);
    IrRegister koyoOperand(const CheckedStatement& statement);
    IrRegister koyoBits(const CheckedStatement& statement);
    void storeKoyoBits(const CheckedStatement& statement);
    unsigned koyoBitCount(const CheckedStatement& statement) const;
    IrAddress koyoBitAt(const CheckedStatement& statement, unsigned index) const;
    IrRegister takeKoyoFlow();
    void openLoop(const CheckedStatement& statement);
    void closeLoop();

    // Operands
    IrAddress place(const Address& address) const { return place(address, m_context.routine); }
    IrAddress place(const Address& address, std::uint32_t routine) const; ///< as that routine sees it
    /// An array with a variable subscript, the number known to be inside.
    struct Element {
        IrRegister isInside = NoRegister;
        IrRegister number = NoRegister;
    };
    Element elementOf(const AddressOperand& array);
    IrRegister readElement(const AddressOperand& array, DataType type);
    void writeElement(const AddressOperand& array, DataType type, IrRegister value);
    void passArguments(const CheckedStatement& statement, std::uint32_t callee, bool before);
    IrRegister read(const CheckedOperand& operand, DataType type);
    void write(const CheckedOperand& operand, DataType type, IrRegister value);
    DataType commonType(const CheckedStatement& statement) const;
    static DataType typeOf(const CheckedOperand& operand);
    static const Address* addressOf(const CheckedOperand& operand);
    static const CheckedOperand* operandAt(const CheckedStatement& statement, std::string_view pin);
    IrPin pinOf(const CheckedOperand& operand) const;

    /// What follows runs only with flow.
    void openGuard();
    void closeGuard();

    const RoutineContext& m_context;
    std::uint32_t m_network = 0;
    IrWriter m_ir;
    IrRegister m_flow = NoRegister;     ///< NoRegister: no flow begun, or a group that begins with flow on
    bool m_isRungOpen = false;
    std::vector<IrRegister> m_loads;    ///< flows put aside by a second Load, for ANB and ORB
    std::vector<IrRegister> m_pushed;   ///< MPS
    std::vector<Group> m_groups;
    std::vector<Loop> m_loops;
    IrRegister m_guard = NoRegister;    ///< flow of the open guard
    std::size_t m_guardJump = 0;
    std::vector<std::size_t> m_ends;    ///< jumps to the end of the routine that are never taken
    std::vector<ForLoop> m_forLoops;
    std::map<std::string, std::size_t, std::less<>> m_labels; ///< the instruction each stands before
    std::vector<std::pair<std::size_t, std::string>> m_jumps; ///< whose label may still come
};

} // namespace camwright
