#include "core/language/st/check/checker.h"

#include <algorithm>

namespace camwright::st {

// The part of Checker for what stands outside of bodies: the names of a text, globals, configurations.

void Checker::collect()
{
    m_global.resize(m_out.names.count());
    m_local.resize(m_out.names.count());
    const std::size_t library = m_out.units.size() - 1;
    m_file = static_cast<std::uint32_t>(library);
    for (Pou& pou : m_out.units[library].pous)
        collectPou(pou, m_file, true);
    for (m_file = 0; m_file < library; ++m_file) {
        for (const TypeDeclaration& tree : m_out.units[m_file].types) {
            Type& type = makeType(TypeKind::Bad);
            type.name = tree.name;
            type.spec = tree.spec;
            Symbol& symbol = m_out.symbols.emplace_back();
            symbol.kind = SymbolKind::Type;
            symbol.name = tree.name;
            symbol.type = &type;
            symbol.file = m_file;
            symbol.place = tree.offset;
            symbol.placeEnd = tree.end;
            declareGlobal(symbol);
        }
        for (Pou& pou : m_out.units[m_file].pous)
            collectPou(pou, m_file, false);
    }
    collectOuter();
}

/// Variables and programs of the project. A name of the texts hides them.
void Checker::collectOuter()
{
    const auto add = [this](std::string_view name) -> Symbol* {
        const NameId id = m_out.names.intern(name);
        if (id >= m_global.size())
            m_global.resize(std::max<std::size_t>(id + 1, m_out.names.count()));
        if (m_global[id])
            return nullptr;
        Symbol& symbol = m_out.symbols.emplace_back();
        symbol.name = id;
        m_global[id] = &symbol;
        return &symbol;
    };
    for (const OuterVariable& variable : m_environment.variables) {
        Symbol* symbol = add(variable.name);
        if (!symbol)
            continue;
        symbol->section = Section::Global;
        symbol->isConstant = !variable.isWritable;
        for (const Type& type : m_elementary) {
            if (type.data == variable.type && type.elementary != Elementary::None && !symbol->type)
                symbol->type = &type;
        }
        symbol->storage = variable.address.area == VariablesArea ? Storage::Static : Storage::Located;
        symbol->address = variable.address;
        symbol->offset = variable.address.byte;
    }
    for (std::size_t i = 0; i < m_environment.subroutines.size(); ++i) {
        if (Symbol* symbol = add(m_environment.subroutines[i])) {
            symbol->kind = SymbolKind::Subroutine;
            symbol->standard = static_cast<std::uint32_t>(i);
            symbol->type = &m_void;
        }
    }
}

void Checker::collectPou(Pou& tree, std::uint32_t file, bool isPrelude)
{
    PouInfo& pou = m_out.pous.emplace_back();
    pou.tree = &tree;
    pou.file = file;
    pou.isPrelude = isPrelude;
    Symbol& symbol = m_out.symbols.emplace_back();
    symbol.kind = SymbolKind::Pou;
    symbol.name = tree.name;
    symbol.pou = &pou;
    symbol.type = &m_void;
    symbol.file = file;
    symbol.place = tree.offset;
    symbol.placeEnd = tree.end;
    pou.symbol = &symbol;
    if (tree.kind != PouKind::Function) {
        pou.type = &makeType(tree.kind == PouKind::Interface ? TypeKind::Interface : TypeKind::Block);
        pou.type->name = tree.name;
        pou.type->pou = &pou;
        pou.type->data = DataType::Lword; // of an interface: which block, and where
        if (tree.kind == PouKind::Interface)
            pou.type->size = pou.type->alignment = 8;
        symbol.type = pou.type;
    }
    if (tree.name != 0)
        declareGlobal(symbol);
}

std::uint32_t Checker::allocate(std::uint32_t bytes, std::uint32_t alignment)
{
    const std::uint32_t offset = (m_out.variableBytes + alignment - 1) / alignment * alignment;
    if (bytes > MostVariableBytes || offset + bytes > MostVariableBytes) {
        report(Code::StMemoryFull, m_pou ? m_pou->tree->offset : 0, m_pou ? m_pou->tree->end : 0, {std::to_string(MostVariableBytes)});
        return 0;
    }
    m_out.variableBytes = offset + bytes;
    return offset;
}

void Checker::resolveGlobals(std::uint32_t file)
{
    for (const Variable& tree : m_out.units[file].globals) {
        Symbol* symbol = makeVariable(tree, resolveSpec(tree.spec));
        symbol->section = Section::Global;
        declareGlobal(*symbol);
        if (m_global[symbol->name] != symbol)
            continue;
        if (symbol->type->kind == TypeKind::Bad)
            continue;
        if (tree.initial) {
            Expr* initial = tree.initial;
            checkInitial(initial, *symbol->type);
            symbol->initial = initial;
        }
        if (!tree.location || !placeLocated(*symbol, *tree.location))
            placeStatic(*symbol);
        m_out.globals.push_back(symbol);
    }
}

Symbol* Checker::makeVariable(const Variable& tree, const Type* type)
{
    Symbol& symbol = m_out.symbols.emplace_back();
    symbol.name = tree.name;
    symbol.type = type;
    symbol.section = tree.section;
    symbol.isConstant = tree.isConstant;
    symbol.isRetain = tree.isRetain;
    symbol.declaration = &tree;
    symbol.file = m_file;
    symbol.place = tree.offset;
    symbol.placeEnd = tree.end;
    return &symbol;
}

/// A constant of a scalar type needs no memory.
void Checker::placeStatic(Symbol& symbol)
{
    if (symbol.isConstant && symbol.initial && symbol.initial->constant && symbol.type->isScalar()) {
        symbol.storage = Storage::Constant;
        symbol.constant = symbol.initial->constant;
        return;
    }
    symbol.storage = Storage::Static;
    symbol.offset = allocate(symbol.type->size, std::max(symbol.type->alignment, 1u));
    setStartValues(symbol, symbol.offset);
}

bool Checker::placeLocated(Symbol& symbol, const Expr& location)
{
    const std::string written = textOf(location);
    if (symbol.type->kind != TypeKind::Elementary) {
        report(Code::StNotAnAddressHere, location, {written, typeName(*symbol.type)});
        return false;
    }
    if (m_environment.isLoose || !m_environment.findAddress)
        return false; // no controller is known: the variable lives in memory
    const auto address = m_environment.findAddress(written, symbol.type->data);
    if (!address) {
        report(Code::StNotAnAddressHere, location, {written, typeName(*symbol.type)});
        return false;
    }
    symbol.storage = Storage::Located;
    symbol.address = *address;
    return true;
}

/// What runs: the programs of a configuration, or of the main text where there is none.
void Checker::resolveConfigurations(std::uint32_t file)
{
    if (!m_out.sources[file].isMain)
        return;
    const Unit& unit = m_out.units[file];
    for (const Configuration& configuration : unit.configurations) {
        for (const ProgramInstance& instance : configuration.programs)
            addRun(configuration, instance);
    }
    if (!m_out.runs.empty())
        return;
    for (const Pou& pou : unit.pous) {
        Symbol* symbol = pou.kind == PouKind::Program && pou.name != 0 ? m_global[pou.name] : nullptr;
        if (symbol && symbol->pou && symbol->pou->tree == &pou) {
            m_out.runs.push_back({symbol->pou, 0, 0, 0});
            return;
        }
    }
    if (!camwright::hasErrors(m_out.diagnostics[file]))
        report(Code::StNoProgram, 0, 0);
}

void Checker::addRun(const Configuration& configuration, const ProgramInstance& instance)
{
    if (!instance.type)
        return;
    Symbol* symbol = lookUp(instance.type->name);
    if (!symbol || symbol->kind != SymbolKind::Pou || symbol->pou->tree->kind != PouKind::Program)
        return report(Code::StNotA, instance.type->offset, instance.type->end, {text(instance.type->name), CW_TEXT("Arguments", "a program")});
    if (std::ranges::any_of(m_out.runs, [&](const ProgramRun& run) { return run.program == symbol->pou; }))
        return report(Code::StGivenTwice, instance.type->offset, instance.type->end, {text(instance.type->name)});
    ProgramRun run{symbol->pou, 0, INT32_MAX, 0};
    bool isKnown = !instance.task;
    for (const TaskDeclaration& task : configuration.tasks) {
        if (!instance.task || task.name != instance.task->name)
            continue;
        isKnown = true;
        if (task.single)
            report(Code::StNotBuilt, *task.single, {"SINGLE"});
        if (Expr* interval = task.interval) {
            checkExpr(*interval);
            coerce(interval, elementary(Elementary::Ltime));
            run.intervalNs = interval->constant ? static_cast<std::int64_t>(interval->constant->integer) : 0;
        }
        if (Expr* priority = task.priority)
            run.priority = static_cast<std::int64_t>(constantInteger(priority).value_or(0));
        if (run.intervalNs > 0)
            run.nextRun = allocate(8, 8);
    }
    if (!isKnown)
        report(Code::StUnknownName, instance.task->offset, instance.task->end, {text(instance.task->name)});
    const auto behind = std::ranges::upper_bound(m_out.runs, run.priority, {}, &ProgramRun::priority);
    m_out.runs.insert(behind, run);
}

} // namespace camwright::st
