#pragma once

#include "core/language/st/syntax/arena.h"
#include "core/language/st/syntax/token.h"

#include <cstdint>
#include <string_view>

namespace camwright::st {

// The syntax tree. Nodes lie in the arena of their Unit; offsets are bytes of its text, ends exclusive. What checking finds
// out is written into the nodes (members under "checked"), so that no stage looks anything up twice.

struct Type;
struct Symbol;
struct Constant;

enum class ExprKind : std::uint8_t {
    Bad, Literal, Name, Address, Member, Index, Dereference, Unary, Binary, Call, Typed, This, Super, Aggregate,
    Convert, ///< made by checking: the value of `left` as `type`
};

enum class Operator : std::uint8_t {
    None, Or, Xor, And, Equal, NotEqual, Less, Greater, LessEqual, GreaterEqual, Add, Subtract, Multiply, Divide, Modulo, Power, Negate, Plus, Not,
};

struct Expr {
    ExprKind kind = ExprKind::Bad;
    Operator op = Operator::None;      ///< Unary, Binary
    TokenKind literal = TokenKind::End;///< Literal: Integer, Real, …; Word for TRUE, FALSE and NULL
    bool isBased = false;              ///< Literal: 16#…; Aggregate: in brackets, of an array; Member: number of a bit
    std::uint16_t depth = 0;           ///< of the tree below
    NameId name = 0;                   ///< Name, Member, Typed (the type in front of #); Literal: the word
    std::uint32_t offset = 0;
    std::uint32_t end = 0;
    std::uint64_t value = 0;           ///< Literal: as in Token
    Expr* left = nullptr;              ///< operand, object, array, callee, what is typed
    Expr* right = nullptr;
    Expr* next = nullptr;              ///< in lists of subscripts
    List<struct Argument> arguments;   ///< Call, Index (values only), Aggregate
    // checked:
    const Type* type = nullptr;
    const Symbol* symbol = nullptr;    ///< Name, Member: the variable, enumeration value, routine
    const Constant* constant = nullptr;///< what it is before the program runs
    std::uint32_t intrinsic = 0;       ///< Call: a standard function; see standard.h
};

/// One argument of a call, one subscript, or one entry of an aggregate: `3(0)` has a repetition, `a := 1` a name.
struct Argument {
    NameId name = 0;
    bool isOutput = false;             ///< name => variable
    bool isNegated = false;            ///< NOT name => variable
    std::uint32_t offset = 0;
    std::uint32_t end = 0;
    Expr* value = nullptr;             ///< null: left empty
    Expr* repetition = nullptr;
    Argument* next = nullptr;
    // checked:
    const Symbol* symbol = nullptr;    ///< parameter or member
};

enum class StatementKind : std::uint8_t { Empty, Assign, Attempt, Call, If, Case, For, While, Repeat, Exit, Continue, Return };

struct Statement;

/// One IF or ELSIF with what follows; one case of a CASE with its labels; ELSE has neither.
struct Branch {
    Expr* condition = nullptr;
    List<struct CaseLabel> labels;
    List<Statement> body;
    std::uint32_t offset = 0;
    std::uint32_t end = 0;
    Branch* next = nullptr;
};

struct CaseLabel {
    Expr* low = nullptr;
    Expr* high = nullptr;              ///< of a range
    CaseLabel* next = nullptr;
    // checked:
    std::int64_t first = 0;
    std::int64_t last = 0;
};

struct Statement {
    StatementKind kind = StatementKind::Empty;
    std::uint32_t offset = 0;
    std::uint32_t end = 0;             ///< of the whole; of compound ones see `headEnd`
    std::uint32_t headEnd = 0;         ///< end of what is run first: the condition, the head of the loop
    Expr* target = nullptr;            ///< Assign; For: the variable; Case: the selector; Call: the call
    Expr* value = nullptr;             ///< Assign; For: the start; While, Repeat: the condition
    Expr* limit = nullptr;             ///< For
    Expr* step = nullptr;              ///< For, may be null
    List<Branch> branches;             ///< If, Case
    Branch* otherwise = nullptr;       ///< If, Case: ELSE
    List<Statement> body;              ///< loops
    Statement* next = nullptr;
};

enum class SpecKind : std::uint8_t { Bad, Named, Subrange, Text, Array, Struct, Enum, Reference };

/// What stands for a type in a declaration.
struct TypeSpec {
    SpecKind kind = SpecKind::Bad;
    bool isWide = false;               ///< Text: WSTRING
    NameId name = 0;                   ///< Named, Subrange, Enum: the (base) type
    std::uint32_t offset = 0;
    std::uint32_t end = 0;
    Expr* size = nullptr;              ///< Text: its length, may be null
    List<struct Bounds> bounds;        ///< Array; Subrange
    TypeSpec* element = nullptr;       ///< Array, Reference
    List<struct Variable> members;     ///< Struct
    List<struct EnumValue> values;     ///< Enum
};

struct Bounds {
    Expr* low = nullptr;
    Expr* high = nullptr;
    Bounds* next = nullptr;
};

struct EnumValue {
    NameId name = 0;
    std::uint32_t offset = 0;
    std::uint32_t end = 0;
    Expr* value = nullptr;
    EnumValue* next = nullptr;
};

enum class Section : std::uint8_t { Local, Input, Output, InOut, External, Global, Temp, Member };

/// One declared variable, or member of a structure. `a, b : INT := 3` gives two that share type and value.
struct Variable {
    NameId name = 0;
    Section section = Section::Local;
    bool isConstant = false, isRetain = false, isRisingEdge = false, isFallingEdge = false;
    std::uint32_t offset = 0;
    std::uint32_t end = 0;
    TypeSpec* spec = nullptr;
    Expr* initial = nullptr;
    Expr* location = nullptr;          ///< AT
    Variable* next = nullptr;
};

enum class PouKind : std::uint8_t { Program, Function, FunctionBlock, Interface, Method };

struct NameUse {
    NameId name = 0;
    std::uint32_t offset = 0;
    std::uint32_t end = 0;
    NameUse* next = nullptr;
};

struct Pou {
    PouKind kind = PouKind::Program;
    bool isAbstract = false, isFinal = false, isOverride = false, isPrivate = false;
    NameId name = 0;
    std::uint32_t offset = 0;          ///< of the name
    std::uint32_t end = 0;
    std::uint32_t bodyEnd = 0;         ///< where END_… stands
    TypeSpec* result = nullptr;        ///< functions and methods, may be null
    NameUse* extends = nullptr;
    List<NameUse> implements;          ///< of interfaces: what they extend
    List<Variable> variables;
    List<Statement> body;
    List<Pou> methods;
    Pou* next = nullptr;
};

struct TypeDeclaration {
    NameId name = 0;
    std::uint32_t offset = 0;
    std::uint32_t end = 0;
    TypeSpec* spec = nullptr;
    Expr* initial = nullptr;
    TypeDeclaration* next = nullptr;
};

struct TaskDeclaration {
    NameId name = 0;
    std::uint32_t offset = 0, end = 0;
    Expr* interval = nullptr;
    Expr* single = nullptr;
    Expr* priority = nullptr;
    TaskDeclaration* next = nullptr;
};

/// PROGRAM instance WITH task : type;
struct ProgramInstance {
    NameId name = 0;
    NameUse* task = nullptr;
    NameUse* type = nullptr;
    std::uint32_t offset = 0, end = 0;
    ProgramInstance* next = nullptr;
};

/// A CONFIGURATION with its resources, whose tasks and programs are taken together: there is one processor.
struct Configuration {
    NameId name = 0;
    std::uint32_t offset = 0, end = 0;
    List<TaskDeclaration> tasks;
    List<ProgramInstance> programs;
    Configuration* next = nullptr;
};

/// One source text as a tree.
struct Unit {
    List<TypeDeclaration> types;
    List<Pou> pous;
    List<Variable> globals;            ///< VAR_GLOBAL, of configurations too
    List<Configuration> configurations;
};

} // namespace camwright::st
