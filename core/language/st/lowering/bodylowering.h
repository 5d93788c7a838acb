#pragma once

#include "core/language/lowering/irwriter.h"
#include "core/language/st/check/compilation.h"
#include "core/language/st/check/standard.h"

#include <cstdint>
#include <functional>
#include <vector>

namespace camwright::st {

/// What the body of one POU needs of the others.
struct LinkContext {
    std::function<IrAddress(const Address&)> placeOf; ///< of a variable with an address of the family
    std::function<std::uint32_t(const PouInfo&)> routineOf;
    std::function<std::uint32_t(std::uint32_t subroutine)> subroutineOf;
    std::function<std::uint32_t(std::uint32_t file, std::uint32_t offset, std::uint32_t end)> source;
};

/// Where a value lies: at a fixed address, in an array there, or behind a pointer.
struct ValuePlace {
    enum class Kind : std::uint8_t { Fixed, Element, Pointer };
    Kind kind = Kind::Fixed;
    IrAddress address;               ///< Fixed, Element: its beginning
    IrRegister index = NoRegister;   ///< Element
    std::uint32_t stride = 0;        ///< Element
    IrRegister pointer = NoRegister; ///< Pointer
    std::uint32_t offset = 0;        ///< Pointer: bytes behind it
    std::uint32_t reach = 0;         ///< Pointer: bytes it may reach; Element: bytes of the whole array
};

/// Turns the body of one POU into IR. A statement whose subscript or reference is bad is left out from there on: the jump
/// of each guard leads behind the statement it belongs to.
class BodyLowering {
public:
    BodyLowering(const LinkContext& link, const Compilation& compilation, const PouInfo& pou, IrRoutine& routine)
        : m_link(link), m_compilation(compilation), m_pou(pou), m_ir(routine)
    {
    }

    void lower();

private:
    struct Loop {
        std::vector<std::size_t> exits;
        std::vector<std::size_t> continues;
    };

    // Statements
    void enter();
    void statements(const List<Statement>& list);
    void statement(const Statement& statement);
    void assign(const Statement& statement);
    void ifStatement(const Statement& statement);
    void caseStatement(const Statement& statement);
    IrRegister labelMatches(const CaseLabel& label, IrRegister selector, DataType type);
    void forStatement(const Statement& statement);
    void stepAndRepeat(const Statement& statement, std::size_t begin, IrRegister limit, IrRegister step);
    void repeatWhileInside(const Statement& statement, std::size_t begin, IrRegister limit, IrRegister step);
    void whileStatement(const Statement& statement);
    void repeatStatement(const Statement& statement);
    void jumpBack(std::size_t target, IrOp op = IrOp::Jump, IrRegister condition = NoRegister);
    std::size_t jump();
    void landAll(const std::vector<std::size_t>& jumps);
    void markSource(std::uint32_t offset, std::uint32_t end);

    // Places
    ValuePlace placeOf(const Expr& expr);
    ValuePlace placeOf(const Symbol& symbol);
    ValuePlace memberOf(const ValuePlace& place, std::uint32_t offset);
    ValuePlace elementOf(const Expr& expr);
    ValuePlace indexed(ValuePlace place, const Type& array, const Expr& subscript);
    ValuePlace reached(IrRegister stored, std::uint32_t bytes);
    IrRegister boundedIndex(const Expr& subscript, const Type& array);
    IrRegister pointerTo(const ValuePlace& place, std::uint32_t bytes);
    IrRegister load(const ValuePlace& place, const Type& type);
    void store(const ValuePlace& place, const Type& type, IrRegister value);
    void move(const ValuePlace& to, const ValuePlace& from, std::uint32_t bytes);

    // Expressions
    IrRegister value(const Expr& expr);
    IrRegister constantOf(const Type& type, const Constant& constant);
    IrRegister integer(DataType type, std::int64_t value);
    IrRegister binary(const Expr& expr);
    IrRegister unary(const Expr& expr);
    IrRegister bit(const Expr& expr);
    IrRegister convert(Elementary from, Elementary to, IrRegister value, bool truncates);
    IrRegister scaled(IrOp op, std::int64_t factor, DataType from, DataType to, IrRegister value);
    IrRegister asData(DataType from, DataType to, IrRegister value);
    IrRegister select(DataType type, IrRegister condition, IrRegister yes, IrRegister no);

    // Calls
    IrRegister call(const Expr& call);
    IrRegister standardCall(const Expr& call);
    IrRegister mux(const Expr& call);
    void passArguments(const Expr& call, const PouInfo& pou, const ValuePlace* instance);
    void resetInputs(const Expr& call, const PouInfo& pou);
    void takeOutputs(const Expr& call, const PouInfo& pou, const ValuePlace* instance);
    ValuePlace parameterPlace(const Symbol& parameter, const ValuePlace* instance);
    void callRoutine(const PouInfo& pou, const ValuePlace* instance);
    std::optional<ValuePlace> instanceOf(const Expr& callee, const PouInfo& pou);

    const LinkContext& m_link;
    const Compilation& m_compilation;
    const PouInfo& m_pou;
    IrWriter m_ir;
    std::vector<std::size_t> m_guards;   ///< of the statements that are open; they land behind theirs
    std::vector<Loop> m_loops;
};

} // namespace camwright::st
