#include "core/language/st/check/checker.h"

namespace camwright::st {

// The part of Checker for calls of standard functions. Those that are operators become them: ADD(a, b, c) is a + b + c.

namespace {

Elementary valueType(const Type& type)
{
    return type.kind == TypeKind::Elementary || type.kind == TypeKind::Subrange ? type.elementary : Elementary::None;
}

Operator operatorOf(Standard standard)
{
    switch (standard) {
    case Standard::Add: return Operator::Add;
    case Standard::Sub: return Operator::Subtract;
    case Standard::Mul: return Operator::Multiply;
    case Standard::Div: return Operator::Divide;
    case Standard::Mod: return Operator::Modulo;
    case Standard::Expt: return Operator::Power;
    case Standard::And: return Operator::And;
    case Standard::Or: return Operator::Or;
    case Standard::Xor: return Operator::Xor;
    case Standard::Gt: return Operator::Greater;
    case Standard::Ge: return Operator::GreaterEqual;
    case Standard::Eq: return Operator::Equal;
    case Standard::Le: return Operator::LessEqual;
    case Standard::Lt: return Operator::Less;
    case Standard::Ne: return Operator::NotEqual;
    default: return Operator::None;
    }
}

std::size_t countOf(const Expr& call)
{
    std::size_t count = 0;
    for ([[maybe_unused]] const Argument& argument : call.arguments)
        ++count;
    return count;
}

constexpr std::size_t Most = 64; ///< arguments of functions that take any number; ours

} // namespace

/// Whether the number of arguments is right; reported if not. They are checked in any case.
bool Checker::takes(const Expr& call, std::size_t least, std::size_t most)
{
    const std::size_t count = countOf(call);
    if (count >= least && count <= most)
        return true;
    report(Code::StArgumentCount, call, {textOf(*call.left), std::to_string(count < least ? least : most), std::to_string(count)});
    return false;
}

void Checker::checkStandardCall(Expr& call)
{
    const Standard standard = standardOf(call.intrinsic);
    bool isGood = true;
    for (Argument& argument : call.arguments) {
        if (!argument.value || argument.isOutput) {
            report(Code::StNoParameter, argument.offset, argument.end, {textOf(*call.left), text(argument.name)});
            return;
        }
        isGood &= checkExpr(*argument.value).kind != TypeKind::Bad;
    }
    if (!isGood)
        return;
    if (standard == Standard::Convert || standard == Standard::Trunc)
        return checkConversion(call);
    if (standard == Standard::Ref)
        return checkReference(call);
    if (standard == Standard::Now) {
        if (takes(call, 0, 0))
            call.type = &elementary(Elementary::Lint);
        return;
    }
    if (standard == Standard::Atan2) {
        if (takes(call, 2, 2))
            checkReals(call, call.arguments.first->value, call.arguments.first->next->value);
        return;
    }
    if (const Operator op = operatorOf(standard); op != Operator::None)
        return asOperator(call, op);
    if (standard >= Standard::Shl && standard <= Standard::Ror)
        return checkShift(call);
    if (standard >= Standard::Sel && standard <= Standard::Mux)
        return checkSelection(call, standard);
    checkNumeric(call, standard);
}

/// ADD(a, b, c) as (a + b) + c; comparisons of more than two join their pairs by AND: of two only here.
void Checker::asOperator(Expr& call, Operator op)
{
    const bool isChain = op == Operator::Add || op == Operator::Multiply || op == Operator::And || op == Operator::Or || op == Operator::Xor;
    if (!takes(call, 2, isChain ? Most : 2))
        return;
    const Argument* argument = call.arguments.first;
    Expr* left = argument->value;
    for (argument = argument->next; argument; argument = argument->next) {
        Expr* binary = argument->next ? m_out.arena.make<Expr>() : &call;
        binary->offset = call.offset;
        binary->end = call.end;
        Expr* const right = argument->value;
        if (binary == &call)
            call.arguments = {};
        binary->kind = ExprKind::Binary;
        binary->op = op;
        binary->left = left;
        binary->right = right;
        binary->type = &m_bad;
        checkBinary(*binary);
        left = binary;
        if (binary == &call)
            return;
    }
}

void Checker::checkConversion(Expr& call)
{
    if (!takes(call, 1, 1))
        return;
    Argument& argument = *call.arguments.first;
    const bool isPlainTrunc = standardOf(call.intrinsic) == Standard::Trunc;
    const Elementary from = isPlainTrunc ? Elementary::None : convertsFrom(call.intrinsic);
    const Elementary to = isPlainTrunc ? Elementary::Dint : convertsTo(call.intrinsic);
    if (from != Elementary::None && argument.value->type->kind != TypeKind::Enum && !coerce(argument.value, elementary(from)))
        return;
    useDefaultType(*argument.value);
    const Type& type = *argument.value->type;
    const Elementary source = type.kind == TypeKind::Enum ? type.elementary : valueType(type);
    const bool truncates = isPlainTrunc || convertTruncates(call.intrinsic);
    if (type.kind == TypeKind::Bad)
        return;
    if (source == Elementary::None || (truncates && (!isAnyReal(source) || !isAnyInteger(to))))
        return report(Code::StNoUnaryOperator, call, {textOf(*call.left), typeName(type)});
    call.intrinsic = conversionNumber(source, to, truncates);
    call.type = &elementary(to);
}

void Checker::checkReference(Expr& call)
{
    if (!takes(call, 1, 1))
        return;
    const Expr& variable = *call.arguments.first->value;
    const Expr* root = &variable;
    while (root->kind == ExprKind::Member || root->kind == ExprKind::Index)
        root = root->left;
    const bool isElsewhere = root->symbol && (root->symbol->storage == Storage::Located || root->symbol->storage == Storage::Constant);
    if (!isVariable(variable) || isElsewhere)
        return report(Code::StVariableNeeded, variable);
    Type& type = makeType(TypeKind::Reference);
    type.data = DataType::Dword;
    type.size = type.alignment = 4;
    type.element = variable.type;
    call.type = &type;
}

/// All arguments from an index on as one type; null if there is none.
const Type* Checker::unifyAll(Expr& call, std::size_t from)
{
    std::size_t at = 0;
    Argument* first = nullptr;
    for (Argument& argument : call.arguments) {
        if (at++ < from)
            continue;
        if (!first)
            first = &argument;
        else if (!unify(first->value, argument.value))
            return nullptr;
    }
    if (!first)
        return nullptr;
    useDefaultType(*first->value);
    at = 0;
    for (Argument& argument : call.arguments) {
        if (at++ >= from && !coerce(argument.value, *first->value->type))
            return nullptr;
    }
    return first->value->type->kind == TypeKind::Subrange ? first->value->type->element : first->value->type;
}

void Checker::checkSelection(Expr& call, Standard standard)
{
    const bool hasSelector = standard == Standard::Sel || standard == Standard::Mux;
    const std::size_t least = standard == Standard::Sel || standard == Standard::Limit ? 3 : 2;
    if (!takes(call, least, standard == Standard::Sel || standard == Standard::Limit ? 3 : Most))
        return;
    if (hasSelector && !coerce(call.arguments.first->value, elementary(standard == Standard::Sel ? Elementary::Bool : Elementary::Dint)))
        return;
    const Argument* example = hasSelector ? call.arguments.first->next : call.arguments.first;
    const std::string found = typeName(*example->value->type);
    const std::string other = typeName(*(example->next ? example->next : example)->value->type);
    if (example->value->type->kind == TypeKind::Enum && hasSelector) {
        for (Argument* argument = call.arguments.first->next; argument; argument = argument->next) {
            if (!coerce(argument->value, *example->value->type))
                return;
        }
        call.type = example->value->type;
        return;
    }
    const Type* common = unifyAll(call, hasSelector ? 1 : 0);
    const bool isGood = common && valueType(*common) != Elementary::None && (hasSelector || valueType(*common) != Elementary::Bool);
    if (!isGood)
        return report(Code::StNoOperator, call, {textOf(*call.left), found, other});
    call.type = common;
}

void Checker::checkShift(Expr& call)
{
    if (!takes(call, 2, 2))
        return;
    Argument& value = *call.arguments.first;
    useDefaultType(*value.value);
    if (!coerce(value.next->value, elementary(Elementary::Dint)))
        return;
    const Elementary e = valueType(*value.value->type);
    if (!isBits(e) && !isAnyInteger(e))
        return report(Code::StNoUnaryOperator, call, {textOf(*call.left), typeName(*value.value->type)});
    call.type = &elementary(e);
}

/// Two reals of one type; whole numbers become reals.
void Checker::checkReals(Expr& expr, Expr*& left, Expr*& right)
{
    const std::string leftName = typeName(*left->type);
    const std::string rightName = typeName(*right->type);
    const auto isReal = [](const Type& type) { return type.kind == TypeKind::AnyInteger || type.kind == TypeKind::AnyReal || isNumber(valueType(type)); };
    const Type* common = isReal(*left->type) && isReal(*right->type) ? unify(left, right) : nullptr;
    const bool isUntyped = common && (common->kind == TypeKind::AnyInteger || common->kind == TypeKind::AnyReal);
    if (isUntyped && expr.kind == ExprKind::Binary) {
        expr.type = &m_anyReal;
        return;
    }
    if (isUntyped) {
        common = &elementary(Elementary::Lreal);
        coerce(left, *common);
        coerce(right, *common);
    }
    const Elementary e = common ? valueType(*common) : Elementary::None;
    if (!isAnyReal(e)) {
        const Type& real = elementary(Elementary::Lreal);
        const bool isWhole = common && isAnyInteger(e) && widens(e, Elementary::Lreal);
        if (!isWhole)
            return report(Code::StNoOperator, expr, {expr.kind == ExprKind::Call ? textOf(*expr.left) : "**", leftName, rightName});
        coerce(left, real);
        coerce(right, real);
        common = &real;
    }
    expr.type = common;
}

/// Functions of one number: ABS, SQRT, NOT, MOVE.
void Checker::checkNumeric(Expr& call, Standard standard)
{
    if (!takes(call, 1, 1))
        return;
    Expr*& value = call.arguments.first->value;
    const bool isReal = standard == Standard::Sqrt || standard >= Standard::Sin;
    if (isReal && value->type->kind == TypeKind::AnyInteger)
        coerce(value, elementary(Elementary::Lreal));
    useDefaultType(*value);
    const Elementary e = valueType(*value->type);
    bool isGood = e != Elementary::None;
    if (standard == Standard::Abs)
        isGood = isNumber(e);
    else if (isReal)
        isGood = isAnyReal(e);
    else if (standard == Standard::Not)
        isGood = e == Elementary::Bool || isBits(e);
    if (!isGood)
        return report(Code::StNoUnaryOperator, call, {textOf(*call.left), typeName(*value->type)});
    call.type = &elementary(e);
}

} // namespace camwright::st
