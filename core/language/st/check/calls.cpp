#include "core/language/st/check/checker.h"

#include <algorithm>

namespace camwright::st {

// The part of Checker for calls of functions, function blocks and methods of the texts.

void Checker::checkCall(Expr& call)
{
    Expr& callee = *call.left;
    if (callee.kind == ExprKind::Name) {
        Symbol* symbol = lookUp(callee.name);
        const PouInfo* self = selfOf();
        if (!symbol && !(self && findMethod(*self, callee.name))) {
            checkArgumentsBlindly(call);
            return unknownName(callee);
        }
        callee.symbol = symbol;
        if (symbol && symbol->kind == SymbolKind::Standard) {
            call.intrinsic = symbol->standard;
            return checkStandardCall(call);
        }
        if (symbol && symbol->kind == SymbolKind::Subroutine)
            return checkSubroutineCall(call);
    }
    PouInfo* pou = calleeOf(callee);
    if (!pou)
        return checkArgumentsBlindly(call);
    if (m_pou && std::ranges::find(m_pou->callees, pou) == m_pou->callees.end())
        m_pou->callees.push_back(pou);
    checkPouCall(call, *pou);
}

/// The function block whose body or method is being checked.
const PouInfo* Checker::selfOf() const
{
    const PouInfo* pou = m_pou && m_pou->owner ? m_pou->owner : m_pou;
    return pou && pou->tree->kind == PouKind::FunctionBlock ? pou : nullptr;
}

/// What is called: a function, the body of an instance, or a method. Null, and reported, if it cannot be.
PouInfo* Checker::calleeOf(Expr& callee)
{
    if (callee.kind == ExprKind::Name && callee.symbol) {
        if (callee.symbol->kind == SymbolKind::Pou && callee.symbol->pou->tree->kind == PouKind::Function)
            return callee.symbol->pou;
    }
    const PouInfo* self = selfOf();
    if (callee.kind == ExprKind::Name && self && (!callee.symbol || callee.symbol->kind != SymbolKind::Variable)) {
        if (PouInfo* method = findMethod(*self, callee.name))
            return method;
    }
    if (callee.kind == ExprKind::Member) {
        const Type& object = checkExpr(*callee.left);
        if (object.kind == TypeKind::Interface) {
            report(Code::StNotBuilt, callee, {textOf(callee)});
            return nullptr;
        }
        PouInfo* method = object.kind == TypeKind::Block ? findMethod(*object.pou, callee.name) : nullptr;
        if (method) {
            callee.type = &m_void;
            return method;
        }
    }
    const Type& type = checkExpr(callee);
    if (type.kind == TypeKind::Block && type.pou->tree->kind == PouKind::FunctionBlock && callee.kind != ExprKind::This) {
        if (isVariable(callee) || callee.kind == ExprKind::Super)
            return type.pou;
    }
    if (type.kind != TypeKind::Bad)
        report(Code::StNotCallable, callee, {textOf(callee)});
    return nullptr;
}

void Checker::checkArgumentsBlindly(Expr& call)
{
    for (Argument& argument : call.arguments) {
        if (argument.value)
            checkExpr(*argument.value);
    }
}

void Checker::checkSubroutineCall(Expr& call)
{
    call.type = &m_void;
    if (call.arguments.first)
        report(Code::StArgumentCount, call, {textOf(*call.left), "0", "1"});
}

void Checker::checkPouCall(Expr& call, PouInfo& pou)
{
    call.symbol = pou.symbol;
    call.type = pou.result ? pou.result->type : &m_void;
    std::vector<const Symbol*> given;
    std::size_t position = 0;
    for (Argument& argument : call.arguments) {
        Symbol* parameter = nullptr;
        if (argument.name != 0) {
            const auto found = std::ranges::find(pou.parameters, argument.name, &Symbol::name);
            parameter = found == pou.parameters.end() ? nullptr : *found;
        } else if (position < pou.parameters.size()) {
            parameter = pou.parameters[position++];
        }
        if (!parameter) {
            if (argument.name != 0)
                report(Code::StNoParameter, argument.offset, argument.end, {text(pou.tree->name), text(argument.name)});
            else
                report(Code::StArgumentCount, argument.offset, argument.end, {text(pou.tree->name), std::to_string(pou.parameters.size()), std::to_string(position + 1)});
            if (argument.value)
                checkExpr(*argument.value);
            if (argument.name == 0)
                return;
            continue;
        }
        if (std::ranges::find(given, parameter) != given.end()) {
            report(Code::StGivenTwice, argument.offset, argument.end, {text(parameter->name)});
            continue;
        }
        given.push_back(parameter);
        checkArgument(pou, argument, *parameter);
    }
    const bool remembers = pou.tree->kind == PouKind::FunctionBlock;
    for (const Symbol* parameter : pou.parameters) {
        if (parameter->section == Section::InOut && !remembers && std::ranges::find(given, parameter) == given.end())
            report(Code::StParameterMissing, call, {text(parameter->name), text(pou.tree->name)});
    }
}

void Checker::checkArgument(const PouInfo& pou, Argument& argument, Symbol& parameter)
{
    argument.symbol = &parameter;
    parameter.isRead = true;
    if (!argument.value)
        return;
    checkExpr(*argument.value);
    const bool isOutput = parameter.section == Section::Output;
    if (argument.isOutput && !isOutput)
        return report(Code::StNoParameter, argument.offset, argument.end, {text(pou.tree->name), text(parameter.name) + " =>"});
    if (argument.name != 0 && isOutput && !argument.isOutput)
        return report(Code::StNotAssignable, argument.offset, argument.end, {text(parameter.name), CW_TEXT("Arguments", "an output")});
    if (!isOutput && parameter.section != Section::InOut) {
        coerce(argument.value, *parameter.type);
        return;
    }
    if (argument.value->type->kind == TypeKind::Bad)
        return;
    if (!isVariable(*argument.value))
        return report(Code::StVariableNeeded, *argument.value);
    checkWritable(*argument.value);
    if (isOutput) { // the value goes the other way
        Expr from;
        from.offset = argument.value->offset;
        from.end = argument.value->end;
        from.type = parameter.type;
        Expr* slot = &from;
        coerce(slot, *argument.value->type);
        return;
    }
    const Expr* root = argument.value;
    while (root->kind == ExprKind::Member || root->kind == ExprKind::Index)
        root = root->left;
    if (root->symbol && root->symbol->storage == Storage::Located)
        return report(Code::StNotA, *argument.value, {textOf(*argument.value), CW_TEXT("Arguments", "a variable without an address")});
    const bool isSameData = isSame(*argument.value->type, *parameter.type)
        || (argument.value->type->kind == TypeKind::Subrange && isSame(*argument.value->type->element, *parameter.type));
    if (!isSameData)
        mismatch(*argument.value, *parameter.type);
}

} // namespace camwright::st
