#include "core/language/st/check/checker.h"

#include "core/language/check/resolvedprogram.h"
#include "core/language/source/letters.h"
#include "core/language/st/syntax/parser.h"

#include <algorithm>
#include <memory>

namespace camwright::st {

bool Compilation::hasErrors() const
{
    return std::ranges::any_of(diagnostics, [](const Diagnostics& d) { return camwright::hasErrors(d); });
}

std::unique_ptr<Compilation> check(std::vector<Source> sources, const Environment& environment)
{
    auto out = std::make_unique<Compilation>();
    out->sources = std::move(sources);
    out->sources.push_back({{ObjectKind::Program, "standard"}, standardBlocks(), false});
    out->diagnostics.resize(out->sources.size());
    out->variableBytes = environment.variablesFrom;
    out->subroutines = environment.subroutines;
    for (std::size_t i = 0; i < out->sources.size(); ++i) {
        DiagnosticSink sink(out->diagnostics[i], out->sources[i].key);
        const TextLines& lines = out->lines.emplace_back(out->sources[i].text);
        out->units.push_back(Parser(lines, out->names, out->arena, sink).parse());
    }
    Checker(*out, environment).run();
    for (std::size_t i = 0; i < out->sources.size(); ++i)
        DiagnosticSink(out->diagnostics[i], out->sources[i].key).sort();
    return out;
}

Checker::Checker(Compilation& out, const Environment& environment)
    : m_out(out), m_environment(environment), m_elementary(out.elementary), m_bad(out.bad), m_void(out.nothing), m_anyInteger(out.anyInteger),
      m_anyReal(out.anyReal), m_anyText(out.anyText), m_null(out.null)
{
    for (std::size_t i = 0; i < out.sources.size(); ++i)
        m_sinks.emplace_back(out.diagnostics[i], out.sources[i].key);
    m_void.kind = TypeKind::Void;
    m_anyInteger.kind = TypeKind::AnyInteger;
    m_anyReal.kind = TypeKind::AnyReal;
    m_anyText.kind = TypeKind::AnyText;
    m_null.kind = TypeKind::Null;
    for (unsigned e = 0; e <= static_cast<unsigned>(Elementary::Ldt); ++e) {
        Type& type = m_elementary.emplace_back();
        type.kind = TypeKind::Elementary;
        type.elementary = static_cast<Elementary>(e);
        type.data = dataTypeOf(type.elementary);
        type.size = type.alignment = byteWidth(type.data);
    }
}

void Checker::run()
{
    collect();
    for (m_file = 0; m_file < m_out.units.size(); ++m_file)
        resolveGlobals(m_file);
    resolveTypes();
    for (PouInfo& pou : m_out.pous) {
        if (pou.tree->kind != PouKind::Method)
            resolvePou(pou);
    }
    for (m_file = 0; m_file < m_out.units.size(); ++m_file)
        resolveConfigurations(m_file);
    for (std::size_t i = 0; i < m_out.pous.size(); ++i)
        checkBody(m_out.pous[i]);
    checkRecursion();
}

void Checker::report(Code code, std::uint32_t offset, std::uint32_t end, std::vector<std::string> arguments, const Symbol* related)
{
    DiagnosticSink& sink = m_sinks[m_file];
    if (m_out.diagnostics[m_file].size() > MaximumDiagnostics)
        return;
    sink.add(code, m_out.lines[m_file].range(offset, end), std::move(arguments));
    if (related && related->declaration && !sink.isFull())
        sink.relate({m_out.sources[related->file].key, {}, m_out.lines[related->file].range(related->place, related->placeEnd), {}});
}

std::string Checker::textOf(const Expr& expr) const
{
    return shortened(m_out.lines[m_file].text().substr(expr.offset, expr.end - expr.offset), 40);
}

Type& Checker::makeType(TypeKind kind)
{
    Type& type = m_out.types.emplace_back();
    type.kind = kind;
    return type;
}

void Checker::declareGlobal(Symbol& symbol)
{
    if (symbol.name >= m_global.size())
        m_global.resize(std::max<std::size_t>(symbol.name + 1, m_out.names.count()));
    Symbol*& slot = m_global[symbol.name];
    if (slot && symbol.kind == SymbolKind::EnumValue)
        return; // reached by its type's name then
    if (slot && slot->kind != SymbolKind::EnumValue)
        return report(Code::StDeclaredTwice, symbol.place, symbol.placeEnd, {text(symbol.name)}, slot);
    slot = &symbol;
}

void Checker::declareLocal(Symbol& symbol)
{
    if (symbol.name >= m_local.size())
        m_local.resize(std::max<std::size_t>(symbol.name + 1, m_out.names.count()));
    if (Symbol* before = m_local[symbol.name])
        return report(Code::StDeclaredTwice, symbol.place, symbol.placeEnd, {text(symbol.name)}, before);
    m_local[symbol.name] = &symbol;
    m_localNames.push_back(symbol.name);
}

void Checker::clearLocals()
{
    for (const NameId name : m_localNames)
        m_local[name] = nullptr;
    m_localNames.clear();
}

Symbol* Checker::lookUp(NameId name)
{
    if (name < m_local.size() && m_local[name])
        return m_local[name];
    if (name < m_global.size() && m_global[name])
        return m_global[name];
    return standardSymbol(name);
}

/// A name where only a type or a POU can stand: variables of the same name do not hide it.
Symbol* Checker::lookUpType(NameId name)
{
    return name < m_global.size() && m_global[name] ? m_global[name] : standardSymbol(name);
}

/// Elementary types and standard functions become symbols when they are asked for first.
Symbol* Checker::standardSymbol(NameId name)
{
    const std::string_view written = m_out.names.text(name);
    const Elementary elementary = findElementary(written);
    const std::uint32_t standard = elementary == Elementary::None ? findStandard(written) : 0;
    if (elementary == Elementary::None && standard == 0)
        return nullptr;
    Symbol& symbol = m_out.symbols.emplace_back();
    symbol.name = name;
    symbol.kind = standard != 0 ? SymbolKind::Standard : SymbolKind::Type;
    symbol.standard = standard;
    symbol.type = &this->elementary(elementary);
    if (name >= m_global.size())
        m_global.resize(std::max<std::size_t>(name + 1, m_out.names.count()));
    m_global[name] = &symbol;
    return &symbol;
}

void Checker::unknownName(const Expr& expr)
{
    if (m_sinks[m_file].isFull())
        return report(Code::StUnknownName, expr, {shortened(m_out.names.text(expr.name))});
    std::vector<std::string_view> names;
    constexpr std::size_t MostCompared = 2000;
    for (const NameId name : m_localNames)
        names.push_back(m_out.names.text(name));
    for (std::size_t name = 0; name < m_global.size() && names.size() < MostCompared; ++name) {
        if (m_global[name] && !m_out.names.text(static_cast<NameId>(name)).starts_with("CAMWRIGHT"))
            names.push_back(m_out.names.text(static_cast<NameId>(name)));
    }
    const std::string wanted = text(expr.name);
    const std::string near = nearestName(wanted, names);
    if (near.empty())
        report(Code::StUnknownName, expr, {shortened(wanted)});
    else
        report(Code::StUnknownNameNear, expr, {shortened(wanted), near});
}

Symbol* Checker::findMember(const Type& type, NameId name) const
{
    if (!type.members)
        return nullptr;
    const auto found = std::ranges::lower_bound(*type.members, name, {}, [](const Symbol* symbol) { return symbol->name; });
    return found != type.members->end() && (*found)->name == name ? *found : nullptr;
}

PouInfo* Checker::findMethod(const PouInfo& pou, NameId name) const
{
    for (const PouInfo* at = &pou; at; at = at->base) {
        for (PouInfo* method : at->methods) {
            if (method->tree->name == name)
                return method;
        }
        for (const PouInfo* interface : at->tree->kind == PouKind::Interface ? at->interfaces : std::vector<PouInfo*>()) {
            if (PouInfo* method = findMethod(*interface, name))
                return method;
        }
    }
    return nullptr;
}

} // namespace camwright::st
