#include "core/language/st/check/checker.h"

#include <algorithm>

namespace camwright::st {

// The part of Checker for types.

namespace {

constexpr unsigned DeepestTypes = 200;         ///< types that need each other; ours
constexpr std::uint32_t DefaultTextLength = 254; ///< of STRING without a length; ours
constexpr std::uint32_t LongestText = 32767;

std::uint32_t aligned(std::uint32_t offset, std::uint32_t alignment)
{
    return (offset + alignment - 1) / alignment * alignment;
}

} // namespace

void Checker::resolveTypes()
{
    for (m_file = 0; m_file < m_out.units.size(); ++m_file) {
        for (const TypeDeclaration& tree : m_out.units[m_file].types) {
            Symbol* symbol = m_global[tree.name];
            if (symbol && symbol->kind == SymbolKind::Type && symbol->type->spec == tree.spec) {
                Type& type = const_cast<Type&>(*symbol->type);
                resolveType(type);
                if (tree.initial) {
                    Expr* initial = tree.initial;
                    checkInitial(initial, type);
                    type.initial = initial;
                }
            }
        }
    }
}

/// Finishes a named type; null if that leads back to itself.
const Type* Checker::resolveType(Type& type)
{
    if (type.kind != TypeKind::Bad || !type.spec)
        return &type;
    if (type.alignment == 0 || m_resolving > DeepestTypes) {
        report(m_resolving > DeepestTypes ? Code::StTooDeep : Code::StContainsItself, type.spec->offset, type.spec->end,
               {m_resolving > DeepestTypes ? std::to_string(DeepestTypes) : text(type.name)});
        type.spec = nullptr;
        return &type;
    }
    const TypeSpec* spec = type.spec;
    type.alignment = 0; // being resolved
    ++m_resolving;
    if (spec->kind == SpecKind::Struct) {
        resolveStruct(*spec, type);
    } else if (spec->kind == SpecKind::Enum) {
        resolveEnum(*spec, type);
    } else if (const Type* aliased = resolveSpec(spec); aliased && type.spec) {
        const NameId name = type.name;
        const Expr* initial = type.initial ? type.initial : aliased->initial;
        type = *aliased;
        type.name = name;
        type.initial = initial;
        type.spec = spec;
    }
    --m_resolving;
    if (type.alignment == 0)
        type.alignment = 1;
    return &type;
}

const Type* Checker::resolveSpec(const TypeSpec* spec)
{
    if (!spec)
        return &m_bad;
    switch (spec->kind) {
    case SpecKind::Named: return resolveNamed(*spec);
    case SpecKind::Text: return resolveText(*spec);
    case SpecKind::Array: return resolveArray(*spec);
    case SpecKind::Struct: return resolveStruct(*spec, makeType(TypeKind::Bad));
    case SpecKind::Enum: return resolveEnum(*spec, makeType(TypeKind::Bad));
    case SpecKind::Subrange: return resolveSubrange(*spec, makeType(TypeKind::Bad));
    case SpecKind::Reference: {
        Type& type = makeType(TypeKind::Reference);
        type.data = DataType::Dword;
        type.size = type.alignment = 4;
        const bool isNamed = spec->element && spec->element->kind == SpecKind::Named;
        Symbol* target = isNamed ? lookUpType(spec->element->name) : nullptr;
        // A type may hold references to itself, so what they refer to need not be finished.
        type.element = target && target->kind == SymbolKind::Type ? target->type : resolveSpec(spec->element);
        return &type;
    }
    case SpecKind::Bad: break;
    }
    return &m_bad;
}

const Type* Checker::resolveNamed(const TypeSpec& spec)
{
    Symbol* symbol = lookUpType(spec.name);
    if (!symbol) {
        Expr name;
        name.name = spec.name;
        name.offset = spec.offset;
        name.end = spec.end;
        unknownName(name);
        return &m_bad;
    }
    if (symbol->kind == SymbolKind::Type)
        return resolveType(const_cast<Type&>(*symbol->type));
    const bool isObject = symbol->kind == SymbolKind::Pou && symbol->pou->tree->kind != PouKind::Function && symbol->pou->tree->kind != PouKind::Program;
    if (!isObject) {
        report(Code::StNotA, spec.offset, spec.end, {text(spec.name), CW_TEXT("Arguments", "a type")});
        return &m_bad;
    }
    if (symbol->pou->tree->kind == PouKind::FunctionBlock) {
        if (symbol->pou->isResolving || m_resolving > DeepestTypes) {
            report(m_resolving > DeepestTypes ? Code::StTooDeep : Code::StContainsItself, spec.offset, spec.end,
                   {m_resolving > DeepestTypes ? std::to_string(DeepestTypes) : text(spec.name)});
            return &m_bad;
        }
        resolvePou(*symbol->pou);
    }
    return symbol->pou->type;
}

const Type* Checker::resolveText(const TypeSpec& spec)
{
    std::uint32_t length = DefaultTextLength;
    if (Expr* size = spec.size) {
        const auto value = constantInteger(size);
        if (!value)
            return &m_bad;
        if (*value < 1 || *value > LongestText) {
            report(Code::StBadBounds, *size, {"1", wideText(*value)});
            return &m_bad;
        }
        length = static_cast<std::uint32_t>(*value);
    }
    Type& type = makeType(TypeKind::Text);
    type.capacity = length;
    type.isWide = spec.isWide;
    type.size = 2 + length * (spec.isWide ? 2 : 1);
    type.alignment = 2;
    return &type;
}

const Type* Checker::resolveArray(const TypeSpec& spec)
{
    const Type* element = resolveSpec(spec.element);
    if (element->kind == TypeKind::Bad)
        return &m_bad;
    std::vector<const Bounds*> bounds;
    for (const Bounds& b : spec.bounds)
        bounds.push_back(&b);
    for (auto b = bounds.rbegin(); b != bounds.rend(); ++b) {
        Expr* low = (*b)->low;
        Expr* high = (*b)->high;
        const auto first = constantInteger(low);
        const auto last = constantInteger(high);
        if (!first || !last)
            return &m_bad;
        const Wide bytes = (*last - *first + 1) * std::max<std::uint32_t>(element->size, 1);
        if (*last < *first || *first < INT32_MIN || *last > INT32_MAX || bytes > MostVariableBytes) {
            report(Code::StBadBounds, low->offset, high->end, {wideText(*first), wideText(*last)});
            return &m_bad;
        }
        Type& type = makeType(TypeKind::Array);
        type.element = element;
        type.low = static_cast<std::int64_t>(*first);
        type.high = static_cast<std::int64_t>(*last);
        type.alignment = element->alignment;
        type.size = static_cast<std::uint32_t>(*last - *first + 1) * element->size;
        element = &type;
    }
    return element;
}

const Type* Checker::resolveStruct(const TypeSpec& spec, Type& out)
{
    auto& members = m_out.memberLists.emplace_back();
    std::uint64_t size = 0;
    std::uint32_t alignment = 1;
    for (const Variable& tree : spec.members) {
        const Type* type = resolveSpec(tree.spec);
        Symbol* symbol = makeVariable(tree, type);
        symbol->section = Section::Member;
        symbol->offset = aligned(static_cast<std::uint32_t>(size), std::max(type->alignment, 1u));
        size = std::uint64_t{symbol->offset} + type->size;
        alignment = std::max(alignment, type->alignment);
        if (size > MostVariableBytes) {
            report(Code::StMemoryFull, tree.offset, tree.end, {std::to_string(MostVariableBytes)});
            return &m_bad;
        }
        if (tree.initial) {
            Expr* initial = tree.initial;
            checkInitial(initial, *type);
            symbol->initial = initial;
        }
        members.push_back(symbol);
    }
    std::ranges::sort(members, {}, [](const Symbol* s) { return std::pair(s->name, s->place); });
    for (std::size_t i = 1; i < members.size(); ++i) {
        if (members[i]->name == members[i - 1]->name)
            report(Code::StDeclaredTwice, members[i]->place, members[i]->placeEnd, {text(members[i]->name)}, members[i - 1]);
    }
    out.kind = TypeKind::Struct;
    out.members = &members;
    out.alignment = alignment;
    out.size = aligned(static_cast<std::uint32_t>(size), alignment);
    return &out;
}

const Type* Checker::resolveEnum(const TypeSpec& spec, Type& out)
{
    Elementary base = Elementary::Dint;
    if (spec.name != 0) {
        base = findElementary(m_out.names.text(spec.name));
        if (!isAnyInteger(base) && !isBits(base)) {
            report(Code::StNotA, spec.offset, spec.end, {text(spec.name), CW_TEXT("Arguments", "a whole-number type")});
            base = Elementary::Dint;
        }
    }
    out.elementary = base;
    out.data = dataTypeOf(base);
    out.size = out.alignment = byteWidth(out.data);
    out.kind = TypeKind::Enum;
    collectEnumValues(out, spec);
    return &out;
}

void Checker::collectEnumValues(Type& type, const TypeSpec& spec)
{
    auto& values = m_out.memberLists.emplace_back();
    Wide next = 0;
    for (const EnumValue& tree : spec.values) {
        if (Expr* value = tree.value)
            next = constantInteger(value, &elementary(type.elementary)).value_or(next);
        Symbol& symbol = m_out.symbols.emplace_back();
        symbol.kind = SymbolKind::EnumValue;
        symbol.name = tree.name;
        symbol.type = &type;
        symbol.storage = Storage::Constant;
        symbol.file = m_file;
        symbol.place = tree.offset;
        symbol.placeEnd = tree.end;
        symbol.constant = makeInteger(next++);
        values.push_back(&symbol);
        declareGlobal(symbol);
    }
    std::ranges::sort(values, {}, [](const Symbol* s) { return std::pair(s->name, s->place); });
    for (std::size_t i = 1; i < values.size(); ++i) {
        if (values[i]->name == values[i - 1]->name)
            report(Code::StDeclaredTwice, values[i]->place, values[i]->placeEnd, {text(values[i]->name)});
    }
    type.members = &values;
}

const Type* Checker::resolveSubrange(const TypeSpec& spec, Type& out)
{
    const Elementary base = findElementary(m_out.names.text(spec.name));
    if (!isAnyInteger(base) || !spec.bounds.first || !spec.bounds.first->high) {
        report(Code::StNotA, spec.offset, spec.end, {text(spec.name), CW_TEXT("Arguments", "a whole-number type")});
        return &m_bad;
    }
    Expr* low = spec.bounds.first->low;
    Expr* high = spec.bounds.first->high;
    const auto first = constantInteger(low, &elementary(base));
    const auto last = constantInteger(high, &elementary(base));
    if (!first || !last)
        return &m_bad;
    if (*last < *first || *last > INT64_MAX) {
        report(Code::StBadBounds, low->offset, high->end, {wideText(*first), wideText(*last)});
        return &m_bad;
    }
    out = elementary(base);
    out.kind = TypeKind::Subrange;
    out.element = &elementary(base);
    out.low = static_cast<std::int64_t>(*first);
    out.high = static_cast<std::int64_t>(*last);
    return &out;
}

} // namespace camwright::st
