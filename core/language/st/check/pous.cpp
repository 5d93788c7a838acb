#include "core/language/st/check/checker.h"

#include <algorithm>

namespace camwright::st {

// The part of Checker for the heads of POUs: their variables, where these live, and their methods.

namespace {

constexpr std::uint32_t InstanceAlignment = 8;

std::string_view sectionText(Section section)
{
    switch (section) {
    case Section::InOut: return "VAR_IN_OUT";
    case Section::Global: return "VAR_GLOBAL";
    case Section::External: return "VAR_EXTERNAL";
    default: return "VAR";
    }
}

} // namespace

/// Reads the head of a POU once; the names of the one that needs it are put aside meanwhile.
void Checker::resolvePou(PouInfo& pou)
{
    if (pou.isResolved || pou.isResolving)
        return;
    pou.isResolving = true;
    ++m_resolving;
    std::vector<Symbol*> aside;
    for (const NameId name : m_localNames)
        aside.push_back(m_local[name]);
    clearLocals();
    const std::uint32_t file = std::exchange(m_file, pou.file);
    PouInfo* const around = std::exchange(m_pou, &pou);
    resolveHeritage(pou);
    resolveVariables(pou);
    resolveResult(pou);
    resolveMethods(pou);
    pou.isResolving = false;
    pou.isResolved = true;
    checkImplements(pou);
    m_pou = around;
    m_file = file;
    clearLocals();
    for (Symbol* symbol : aside) {
        m_local[symbol->name] = symbol;
        m_localNames.push_back(symbol->name);
    }
    --m_resolving;
}

void Checker::resolveHeritage(PouInfo& pou)
{
    if (const NameUse* use = pou.tree->extends) {
        Symbol* symbol = lookUp(use->name);
        const bool isBlock = symbol && symbol->kind == SymbolKind::Pou && symbol->pou->tree->kind == PouKind::FunctionBlock;
        if (!isBlock || pou.tree->kind != PouKind::FunctionBlock || symbol->pou->tree->isFinal)
            report(Code::StNotA, use->offset, use->end, {text(use->name), CW_TEXT("Arguments", "a function block that can be extended")});
        else if (symbol->pou->isResolving)
            report(Code::StContainsItself, use->offset, use->end, {text(use->name)});
        else {
            resolvePou(*symbol->pou);
            pou.base = symbol->pou;
        }
    }
    for (const NameUse& use : pou.tree->implements) {
        Symbol* symbol = lookUp(use.name);
        if (!symbol || symbol->kind != SymbolKind::Pou || symbol->pou->tree->kind != PouKind::Interface)
            report(Code::StNotA, use.offset, use.end, {text(use.name), CW_TEXT("Arguments", "an interface")});
        else if (symbol->pou->isResolving)
            report(Code::StContainsItself, use.offset, use.end, {text(use.name)});
        else {
            resolvePou(*symbol->pou);
            pou.interfaces.push_back(symbol->pou);
        }
    }
}

void Checker::resolveVariables(PouInfo& pou)
{
    std::vector<Symbol*>* members = nullptr;
    if (pou.type && pou.tree->kind == PouKind::FunctionBlock) {
        members = &m_out.memberLists.emplace_back();
        pou.type->alignment = InstanceAlignment;
        if (pou.base) {
            pou.type->size = pou.base->type->size;
            *members = *pou.base->type->members;
            pou.parameters = pou.base->parameters;
        }
        for (Symbol* symbol : *members)
            declareLocal(*symbol);
    }
    for (const Variable& tree : pou.tree->variables) {
        Symbol* symbol = makeVariable(tree, resolveSpec(tree.spec));
        const bool isNew = symbol->name >= m_local.size() || !m_local[symbol->name];
        if (tree.section == Section::External) {
            placeExternal(*symbol);
            continue;
        }
        declareLocal(*symbol);
        if (!isNew || symbol->type->kind == TypeKind::Bad)
            continue;
        if (tree.initial) {
            Expr* initial = tree.initial;
            checkInitial(initial, *symbol->type);
            symbol->initial = initial;
        }
        placeVariable(pou, *symbol);
        pou.variables.push_back(symbol);
        if (tree.section == Section::Input || tree.section == Section::Output || tree.section == Section::InOut)
            pou.parameters.push_back(symbol);
        if (members && tree.section != Section::Temp && symbol->storage == Storage::Instance)
            members->push_back(symbol);
    }
    if (!members)
        return;
    std::ranges::sort(*members, {}, &Symbol::name);
    pou.type->members = members;
    pou.type->size = std::max((pou.type->size + InstanceAlignment - 1) / InstanceAlignment * InstanceAlignment, InstanceAlignment);
}

/// VAR_EXTERNAL is the global variable of that name.
void Checker::placeExternal(Symbol& symbol)
{
    Symbol* global = m_global[symbol.name];
    if (!global || global->kind != SymbolKind::Variable)
        return report(Code::StNotA, symbol.place, symbol.placeEnd, {text(symbol.name), CW_TEXT("Arguments", "a global variable")});
    if (symbol.type->kind != TypeKind::Bad && !isSame(*symbol.type, *global->type))
        return report(Code::StTypeNeeded, symbol.place, symbol.placeEnd, {typeName(*global->type), typeName(*symbol.type)}, global);
}

void Checker::placeVariable(PouInfo& pou, Symbol& symbol)
{
    const bool isBlock = pou.tree->kind == PouKind::FunctionBlock;
    if (const Expr* location = symbol.declaration->location) {
        const bool allowed = pou.tree->kind == PouKind::Program && (symbol.section == Section::Local || symbol.section == Section::Input || symbol.section == Section::Output);
        if (!allowed)
            return report(Code::StNotHere, *location, {"AT"});
        if (placeLocated(symbol, *location))
            return;
    }
    if (symbol.section == Section::Global || (symbol.section == Section::InOut && pou.tree->kind == PouKind::Program))
        report(Code::StNotHere, symbol.place, symbol.placeEnd, {std::string(sectionText(symbol.section))});
    if (symbol.declaration->isRisingEdge || symbol.declaration->isFallingEdge)
        report(Code::StNotBuilt, symbol.place, symbol.placeEnd, {symbol.declaration->isRisingEdge ? "R_EDGE" : "F_EDGE"});
    symbol.isPointer = symbol.section == Section::InOut;
    const bool isConstant = symbol.isConstant && symbol.initial && symbol.initial->constant && symbol.type->isScalar();
    if (isBlock && symbol.section != Section::Temp && !isConstant) {
        const std::uint32_t alignment = symbol.isPointer ? 4 : std::max(symbol.type->alignment, 1u);
        const std::uint32_t bytes = symbol.isPointer ? 4 : symbol.type->size;
        symbol.storage = Storage::Instance;
        symbol.offset = (pou.type->size + alignment - 1) / alignment * alignment;
        pou.type->size = symbol.offset + bytes;
        if (pou.type->size > MostVariableBytes) {
            report(Code::StMemoryFull, symbol.place, symbol.placeEnd, {std::to_string(MostVariableBytes)});
            pou.type->size = 0;
        }
        return;
    }
    if (symbol.isPointer) {
        symbol.offset = allocate(4, 4);
        return;
    }
    placeStatic(symbol);
    const bool isFresh = pou.tree->kind == PouKind::Function || pou.tree->kind == PouKind::Method || symbol.section == Section::Temp;
    if (isFresh && symbol.storage == Storage::Static && !symbol.type->isScalar() && symbol.section != Section::Input) {
        symbol.fresh = allocate(symbol.type->size, std::max(symbol.type->alignment, 1u));
        setStartValues(symbol, symbol.fresh);
    }
}

/// Functions and methods have a variable of their own name for what they give back.
void Checker::resolveResult(PouInfo& pou)
{
    if (!pou.tree->result)
        return;
    const Type* type = resolveSpec(pou.tree->result);
    if (type->kind == TypeKind::Bad)
        return;
    Symbol& symbol = m_out.symbols.emplace_back();
    symbol.name = pou.tree->name;
    symbol.type = type;
    symbol.section = Section::Output;
    symbol.file = pou.file;
    symbol.place = pou.tree->offset;
    symbol.placeEnd = pou.tree->end;
    symbol.offset = allocate(type->size, std::max(type->alignment, 1u));
    pou.result = &symbol;
    if (pou.symbol)
        pou.symbol->type = type;
}

void Checker::resolveMethods(PouInfo& pou)
{
    const bool mayHave = pou.tree->kind == PouKind::FunctionBlock || pou.tree->kind == PouKind::Interface;
    for (Pou& tree : pou.tree->methods) {
        if (!mayHave) {
            report(Code::StNotHere, tree.offset, tree.end, {"METHOD"});
            continue;
        }
        if (std::ranges::any_of(pou.methods, [&](const PouInfo* m) { return m->tree->name == tree.name; })) {
            report(Code::StDeclaredTwice, tree.offset, tree.end, {text(tree.name)});
            continue;
        }
        PouInfo& method = m_out.pous.emplace_back();
        method.tree = &tree;
        method.file = pou.file;
        method.owner = &pou;
        Symbol& symbol = m_out.symbols.emplace_back();
        symbol.kind = SymbolKind::Method;
        symbol.name = tree.name;
        symbol.type = &m_void;
        symbol.pou = &method;
        method.symbol = &symbol;
        pou.methods.push_back(&method);
    }
    for (PouInfo* method : pou.methods)
        resolvePou(*method);
}

void Checker::checkImplements(PouInfo& pou)
{
    if (pou.tree->kind != PouKind::FunctionBlock || pou.tree->isAbstract)
        return;
    for (const PouInfo* at = &pou; at; at = at->base) {
        for (const PouInfo* interface : at->interfaces)
            checkInterface(pou, *interface);
    }
}

void Checker::checkInterface(PouInfo& pou, const PouInfo& interface)
{
    const auto hasSameHead = [](const PouInfo& a, const PouInfo& b) {
        const bool results = !a.result == !b.result && (!a.result || isSame(*a.result->type, *b.result->type));
        return results && std::ranges::equal(a.parameters, b.parameters, [](const Symbol* x, const Symbol* y) {
            return x->name == y->name && x->section == y->section && isSame(*x->type, *y->type);
        });
    };
    for (const PouInfo* wanted : interface.methods) {
        const PouInfo* method = findMethod(pou, wanted->tree->name);
        if (!method || !hasSameHead(*method, *wanted))
            report(Code::StMethodMissing, pou.tree->offset, pou.tree->end, {text(pou.tree->name), text(interface.tree->name), text(wanted->tree->name)});
    }
    for (const PouInfo* inner : interface.interfaces)
        checkInterface(pou, *inner);
}

} // namespace camwright::st
