#include "core/language/st/check/checker.h"

#include <algorithm>

namespace camwright::st {

// The part of Checker for initial values: whether they fit, and what memory holds at power-on.

namespace {

Value valueOf(const Type& type, const Constant& constant)
{
    if (isFloat(type.data))
        return Value::ofDouble(type.data, constant.isReal ? constant.real : static_cast<double>(constant.integer));
    return Value::ofInteger(type.data, static_cast<std::int64_t>(constant.integer));
}

} // namespace

void Checker::checkInitial(Expr*& initial, const Type& type)
{
    if (initial->type) // shared by the variables of one line, checked with the first
        return;
    if (initial->kind == ExprKind::Aggregate) {
        if (type.kind != TypeKind::Array && type.kind != TypeKind::Struct && type.kind != TypeKind::Block)
            return mismatch(*initial, type);
        return checkAggregate(*initial, type);
    }
    checkExpr(*initial);
    if (!coerce(initial, type) || initial->type->kind == TypeKind::Bad)
        return;
    if (!initial->constant && type.kind != TypeKind::Reference)
        report(Code::StConstantNeeded, *initial);
}

/// The values of an array of arrays may stand in one row. Then it is taken as one long array.
const Type& Checker::flattened(const Type& type, const Expr& aggregate)
{
    if (type.kind != TypeKind::Array || type.element->kind != TypeKind::Array || !aggregate.arguments.first)
        return type;
    const Argument* first = aggregate.arguments.first;
    const Expr* value = first->repetition && first->value->arguments.first ? first->value->arguments.first->value : first->value;
    if (!value || value->kind == ExprKind::Aggregate || (value->type && value->type->kind == TypeKind::Array))
        return type;
    Type& flat = makeType(TypeKind::Array);
    flat = type;
    while (flat.element->kind == TypeKind::Array)
        flat.element = flat.element->element;
    flat.low = 0;
    flat.high = static_cast<std::int64_t>(type.size / std::max(flat.element->size, 1u)) - 1;
    return flat;
}

void Checker::checkAggregate(Expr& aggregate, const Type& given)
{
    const Type& type = flattened(given, aggregate);
    aggregate.type = &type;
    if (aggregate.isBased != (type.kind == TypeKind::Array)) {
        report(Code::StTypeNeeded, aggregate, {typeName(type), textOf(aggregate)});
        return;
    }
    Wide count = 0;
    for (Argument& argument : aggregate.arguments) {
        if (type.kind == TypeKind::Array) {
            Wide each = 1;
            if (argument.repetition) {
                each = 0;
                for ([[maybe_unused]] const Argument& inner : argument.value->arguments)
                    ++each;
                each = std::max<Wide>(each, 1) * argument.repetition->value;
            }
            count += each;
            if (argument.repetition) {
                for (Argument& inner : argument.value->arguments) {
                    if (inner.value)
                        checkInitial(inner.value, *type.element);
                }
            } else if (argument.value) {
                checkInitial(argument.value, *type.element);
            }
            continue;
        }
        Symbol* member = findMember(type, argument.name);
        if (!member) {
            report(Code::StNoMember, argument.offset, argument.end, {typeName(type), text(argument.name)});
            continue;
        }
        argument.symbol = member;
        if (argument.value)
            checkInitial(argument.value, *member->type);
    }
    if (type.kind == TypeKind::Array && count > Wide{type.high} - type.low + 1)
        report(Code::StTooManyValues, aggregate, {typeName(type)});
}

void Checker::setStartValues(const Symbol& symbol, std::uint32_t offset)
{
    setStartValue(*symbol.type, symbol.initial, offset);
}

void Checker::setStartValue(const Type& type, const Expr* initial, std::uint32_t offset)
{
    if (!initial)
        initial = type.initial;
    if (initial && initial->kind == ExprKind::Aggregate) {
        setMembers(type, offset);
        return setAggregate(type.kind == TypeKind::Array && initial->type ? *initial->type : type, *initial, offset);
    }
    if (type.isScalar()) {
        const Constant* constant = initial ? initial->constant : nullptr;
        if (type.kind == TypeKind::Reference || type.kind == TypeKind::Interface) {
            m_out.startValues.push_back({offset, {DataType::Dword, 0xFFFFFFFF}}); // NULL
            return;
        }
        Value value = constant ? valueOf(type, *constant) : Value{type.data, 0};
        if (!constant && type.kind == TypeKind::Subrange && (type.low > 0 || type.high < 0))
            value = Value::ofInteger(type.data, type.low);
        if (value.bits != 0 || initial)
            m_out.startValues.push_back({offset, value});
        return;
    }
    if (type.kind == TypeKind::Text && initial && initial->constant) {
        const std::string_view text = initial->constant->text.substr(0, type.capacity);
        m_out.startValues.push_back({offset, {DataType::Word, text.size()}});
        for (std::size_t i = 0; i < text.size(); ++i)
            m_out.startValues.push_back({offset + 2 + static_cast<std::uint32_t>(i), {DataType::Byte, static_cast<std::uint8_t>(text[i])}});
        return;
    }
    setMembers(type, offset);
}

/// What the members, elements and the base of a type begin with.
void Checker::setMembers(const Type& type, std::uint32_t offset)
{
    if (type.kind == TypeKind::Array) {
        const std::size_t before = m_out.startValues.size();
        setStartValue(*type.element, nullptr, offset);
        const std::size_t each = m_out.startValues.size() - before;
        const auto count = static_cast<std::uint32_t>(type.high - type.low + 1);
        if (each == 0)
            return;
        for (std::uint32_t i = 1; i < count; ++i) {
            for (std::size_t k = 0; k < each; ++k) {
                StartValue value = m_out.startValues[before + k];
                value.offset += i * type.element->size;
                m_out.startValues.push_back(value);
            }
        }
    } else if (type.members && type.kind != TypeKind::Enum) {
        for (const Symbol* member : *type.members) {
            if (!member->isPointer)
                setStartValue(*member->type, member->initial, offset + member->offset);
            else
                m_out.startValues.push_back({offset + member->offset, {DataType::Dword, 0xFFFFFFFF}});
        }
    }
}

void Checker::setAggregate(const Type& type, const Expr& aggregate, std::uint32_t offset)
{
    if (type.kind == TypeKind::Array) {
        std::uint32_t index = 0;
        for (const Argument& argument : aggregate.arguments)
            index = setElements(type, argument, index, offset);
        return;
    }
    for (const Argument& argument : aggregate.arguments) {
        if (argument.symbol && argument.value)
            setStartValue(*argument.symbol->type, argument.value, offset + argument.symbol->offset);
    }
}

/// One entry of an array's values from an index on; returns the index behind it.
std::uint32_t Checker::setElements(const Type& array, const Argument& argument, std::uint32_t index, std::uint32_t offset)
{
    const auto count = static_cast<std::uint64_t>(array.high - array.low + 1);
    const std::uint64_t times = argument.repetition ? std::min<std::uint64_t>(argument.repetition->value, count) : 1;
    for (std::uint64_t i = 0; i < times && index < count; ++i) {
        if (!argument.repetition) {
            if (index < count && argument.value)
                setStartValue(*array.element, argument.value, offset + index * array.element->size);
            ++index;
            continue;
        }
        for (const Argument& inner : argument.value->arguments) {
            if (index < count && inner.value)
                setStartValue(*array.element, inner.value, offset + index * array.element->size);
            ++index;
        }
        if (argument.value->arguments.empty())
            ++index;
    }
    return index;
}

} // namespace camwright::st
