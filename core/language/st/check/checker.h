#pragma once

#include "core/language/source/diagnosticsink.h"
#include "core/language/st/check/compilation.h"
#include "core/language/st/check/standard.h"

#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

namespace camwright::st {

/// Parses and checks texts together: names, types, constants, memory. What it finds out stands in the tree afterwards.
std::unique_ptr<Compilation> check(std::vector<Source> sources, const Environment& environment);

/// The checks, one object a compilation. Parts: declarations (declarations.cpp, typespecs.cpp, pous.cpp, startvalues.cpp),
/// statements.cpp, expressions.cpp, operators.cpp, calls.cpp, standardcalls.cpp, constants.cpp.
class Checker {
public:
    Checker(Compilation& out, const Environment& environment);
    void run();

private:
    // Names
    void declareGlobal(Symbol& symbol);
    void declareLocal(Symbol& symbol);
    Symbol* lookUp(NameId name);
    Symbol* lookUpType(NameId name);
    Symbol* standardSymbol(NameId name);
    Symbol* findMember(const Type& type, NameId name) const;
    PouInfo* findMethod(const PouInfo& pou, NameId name) const;
    void unknownName(const Expr& expr);
    void clearLocals();

    // Declarations
    void collect();
    void collectOuter();
    void collectPou(Pou& tree, std::uint32_t file, bool isPrelude);
    void collectEnumValues(Type& type, const TypeSpec& spec);
    void resolveTypes();
    const Type* resolveSpec(const TypeSpec* spec);
    const Type* resolveNamed(const TypeSpec& spec);
    const Type* resolveType(Type& type);
    const Type* resolveText(const TypeSpec& spec);
    const Type* resolveArray(const TypeSpec& spec);
    const Type* resolveStruct(const TypeSpec& spec, Type& out);
    const Type* resolveEnum(const TypeSpec& spec, Type& out);
    const Type* resolveSubrange(const TypeSpec& spec, Type& out);
    void resolvePou(PouInfo& pou);
    void resolveHeritage(PouInfo& pou);
    void resolveVariables(PouInfo& pou);
    void resolveResult(PouInfo& pou);
    void resolveMethods(PouInfo& pou);
    void checkImplements(PouInfo& pou);
    void checkInterface(PouInfo& pou, const PouInfo& interface);
    Symbol* makeVariable(const Variable& tree, const Type* type);
    void placeVariable(PouInfo& pou, Symbol& symbol);
    void placeExternal(Symbol& symbol);
    void placeStatic(Symbol& symbol);
    bool placeLocated(Symbol& symbol, const Expr& location);
    void resolveGlobals(std::uint32_t file);
    void resolveConfigurations(std::uint32_t file);
    void addRun(const Configuration& configuration, const ProgramInstance& instance);
    void setStartValues(const Symbol& symbol, std::uint32_t offset);
    void setStartValue(const Type& type, const Expr* initial, std::uint32_t offset);
    void setMembers(const Type& type, std::uint32_t offset);
    void setAggregate(const Type& type, const Expr& aggregate, std::uint32_t offset);
    std::uint32_t setElements(const Type& array, const Argument& argument, std::uint32_t index, std::uint32_t offset);
    void checkInitial(Expr*& initial, const Type& type);
    void checkAggregate(Expr& aggregate, const Type& type);
    const Type& flattened(const Type& type, const Expr& aggregate);
    std::uint32_t allocate(std::uint32_t bytes, std::uint32_t alignment);

    // Bodies
    void checkBody(PouInfo& pou);
    void declareScope(PouInfo& pou);
    void checkUnused(const PouInfo& pou);
    void checkRecursion();
    bool checkStatements(const List<Statement>& list);
    bool checkStatement(Statement& statement);
    void checkAssignment(Statement& statement);
    bool checkIf(Statement& statement);
    bool checkCase(Statement& statement);
    void checkLabel(CaseLabel& label, const Type& type, std::vector<struct UsedLabel>& used);
    void checkOverlaps(std::vector<struct UsedLabel>& used);
    bool checkFor(Statement& statement);
    void checkCondition(Expr*& condition);
    void checkWritable(const Expr& target);

    // Expressions
    const Type& checkExpr(Expr& expr);
    void checkLiteral(Expr& expr);
    void checkText(Expr& expr);
    void checkName(Expr& expr);
    void checkAddress(Expr& expr);
    void checkMember(Expr& expr);
    void checkBit(Expr& expr);
    void checkIndex(Expr& expr);
    void checkDereference(Expr& expr);
    void checkTyped(Expr& expr);
    void checkThis(Expr& expr);
    void checkUnary(Expr& expr);
    void checkBinary(Expr& expr);
    void checkLogic(Expr& expr);
    void checkComparison(Expr& expr);
    void checkArithmetic(Expr& expr);
    bool checkTimeArithmetic(Expr& expr);
    const Type* unify(Expr*& left, Expr*& right);
    const Type* unifyAll(Expr& call, std::size_t from);
    bool coerce(Expr*& expr, const Type& target);
    bool coerceLiteral(Expr& expr, const Type& target);
    void mismatch(const Expr& expr, const Type& target);
    void useDefaultType(Expr& expr);
    Expr* converted(Expr& expr, const Type& target);
    bool isVariable(const Expr& expr) const;
    void setBad(Expr& expr) { expr.type = &m_bad; }

    // Calls
    void checkCall(Expr& call);
    void checkPouCall(Expr& call, PouInfo& pou);
    void checkArgument(const PouInfo& pou, Argument& argument, Symbol& parameter);
    void checkArgumentsBlindly(Expr& call);
    void checkSubroutineCall(Expr& call);
    void checkStandardCall(Expr& call);
    void checkConversion(Expr& call);
    void checkReference(Expr& call);
    void checkSelection(Expr& call, Standard standard);
    void checkShift(Expr& call);
    void checkNumeric(Expr& call, Standard standard);
    void checkReals(Expr& expr, Expr*& left, Expr*& right);
    bool takes(const Expr& call, std::size_t least, std::size_t most);
    void asOperator(Expr& call, Operator op);
    PouInfo* calleeOf(Expr& callee);
    const PouInfo* selfOf() const;

    // Constants
    const Constant* makeInteger(Wide value);
    const Constant* makeReal(double value);
    void foldUnary(Expr& expr);
    void foldBinary(Expr& expr);
    bool foldIntegers(Expr& expr, Wide a, Wide b);
    void foldReals(Expr& expr, double a, double b);
    void foldComparison(Expr& expr);
    void foldConversion(Expr& expr);
    void refoldReal(Expr& expr, const Type& type);
    void keepInRange(Expr& expr);
    std::optional<Wide> constantInteger(Expr*& expr, const Type* type = nullptr);

    // Messages
    void report(Code code, std::uint32_t offset, std::uint32_t end, std::vector<std::string> arguments = {}, const Symbol* related = nullptr);
    void report(Code code, const Expr& expr, std::vector<std::string> arguments = {}) { report(code, expr.offset, expr.end, std::move(arguments)); }
    std::string text(NameId name) const { return std::string(m_out.names.text(name)); }
    std::string textOf(const Expr& expr) const;
    std::string typeName(const Type& type) const { return typeText(type, m_out.names); }

    Type& makeType(TypeKind kind);
    const Type& elementary(Elementary e) const { return m_elementary[static_cast<std::size_t>(e)]; }
    const Type& boolType() const { return elementary(Elementary::Bool); }

    Compilation& m_out;
    const Environment& m_environment;
    std::vector<DiagnosticSink> m_sinks;
    std::uint32_t m_file = 0;
    std::vector<Symbol*> m_global;             ///< by NameId
    std::vector<Symbol*> m_local;              ///< by NameId
    std::vector<NameId> m_localNames;
    std::vector<Type>& m_elementary;
    Type &m_bad, &m_void, &m_anyInteger, &m_anyReal, &m_anyText, &m_null;
    PouInfo* m_pou = nullptr;                  ///< whose body is checked
    unsigned m_loops = 0;
    unsigned m_resolving = 0;                  ///< types being resolved inside each other
    std::vector<const Symbol*> m_counters;     ///< of the FOR loops around
};

} // namespace camwright::st
