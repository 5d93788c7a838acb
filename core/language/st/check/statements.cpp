#include "core/language/st/check/checker.h"

#include <algorithm>

namespace camwright::st {

// The part of Checker for bodies.

/// The values a label of a CASE stands for.
struct UsedLabel {
    std::int64_t first = 0;
    std::int64_t last = 0;
    const Expr* expr = nullptr;
};

void Checker::declareScope(PouInfo& pou)
{
    clearLocals();
    if (pou.owner && pou.owner->type->members) {
        for (Symbol* symbol : *pou.owner->type->members)
            declareLocal(*symbol);
    }
    if (pou.type && pou.type->members && !pou.owner) {
        for (Symbol* symbol : *pou.type->members)
            declareLocal(*symbol);
    }
    for (Symbol* symbol : pou.variables) {
        if (m_local[symbol->name] == symbol)
            continue;
        if (m_local[symbol->name]) // a method's own variable hides that of its block
            m_local[symbol->name] = symbol;
        else
            declareLocal(*symbol);
    }
}

void Checker::checkBody(PouInfo& pou)
{
    m_file = pou.file;
    m_pou = &pou;
    declareScope(pou);
    m_loops = 0;
    checkStatements(pou.tree->body);
    if (!pou.isPrelude)
        checkUnused(pou);
    if (pou.tree->kind == PouKind::Function && pou.result && !pou.result->isWritten && !pou.isPrelude)
        report(Code::StResultNotSet, pou.tree->offset, pou.tree->end, {text(pou.tree->name)});
    clearLocals();
    m_pou = nullptr;
}

void Checker::checkUnused(const PouInfo& pou)
{
    if (camwright::hasErrors(m_out.diagnostics[m_file])) // what uses it may be what could not be read
        return;
    for (const Symbol* symbol : pou.variables) {
        const bool isOwn = symbol->section == Section::Local || symbol->section == Section::Temp;
        if (isOwn && !symbol->isRead && !symbol->isWritten && symbol->storage != Storage::Located && pou.methods.empty())
            report(Code::StUnused, symbol->place, symbol->placeEnd, {text(symbol->name)});
    }
}

/// Calls that lead back to where they began. Each circle is reported once, at one of its POUs.
void Checker::checkRecursion()
{
    std::vector<unsigned char> state(m_out.pous.size(), 0); // 1: open, 2: done
    const auto indexOf = [this](const PouInfo* pou) {
        for (std::size_t i = 0; i < m_out.pous.size(); ++i) {
            if (&m_out.pous[i] == pou)
                return i;
        }
        return std::size_t{0};
    };
    std::vector<std::pair<std::size_t, std::size_t>> stack;
    for (std::size_t begin = 0; begin < m_out.pous.size(); ++begin) {
        if (state[begin] != 0 || m_out.pous[begin].callees.empty())
            continue;
        stack.push_back({begin, 0});
        state[begin] = 1;
        while (!stack.empty()) {
            auto& [at, next] = stack.back();
            const PouInfo& pou = m_out.pous[at];
            if (next == pou.callees.size()) {
                state[at] = 2;
                stack.pop_back();
                continue;
            }
            const PouInfo* callee = pou.callees[next++];
            if (callee->callees.empty())
                continue;
            const std::size_t index = indexOf(callee);
            if (state[index] == 1) {
                m_file = callee->file;
                report(Code::StRecursion, callee->tree->offset, callee->tree->end, {text(callee->tree->name)});
            } else if (state[index] == 0) {
                state[index] = 1;
                stack.push_back({index, 0});
            }
        }
    }
}

/// False if the end of the list is never reached.
bool Checker::checkStatements(const List<Statement>& list)
{
    bool isReached = true;
    bool isReported = false;
    for (Statement& statement : list) {
        if (!isReached && !std::exchange(isReported, true))
            report(Code::StUnreachable, statement.offset, statement.headEnd);
        isReached = checkStatement(statement) && isReached;
    }
    return isReached;
}

bool Checker::checkStatement(Statement& statement)
{
    switch (statement.kind) {
    case StatementKind::Empty: return true;
    case StatementKind::Assign: checkAssignment(statement); return true;
    case StatementKind::Attempt:
        report(Code::StNotBuilt, statement.offset, statement.headEnd, {"?="});
        return true;
    case StatementKind::Call: checkExpr(*statement.target); return true;
    case StatementKind::If: return checkIf(statement);
    case StatementKind::Case: return checkCase(statement);
    case StatementKind::For: return checkFor(statement);
    case StatementKind::While:
    case StatementKind::Repeat:
        if (statement.kind == StatementKind::While)
            checkCondition(statement.value);
        ++m_loops;
        checkStatements(statement.body);
        --m_loops;
        if (statement.kind == StatementKind::Repeat)
            checkCondition(statement.value);
        return true;
    case StatementKind::Exit:
    case StatementKind::Continue:
        if (m_loops == 0)
            report(Code::StNotInLoop, statement.offset, statement.headEnd, {statement.kind == StatementKind::Exit ? "EXIT" : "CONTINUE"});
        return false;
    case StatementKind::Return: return false;
    }
    return true;
}

void Checker::checkAssignment(Statement& statement)
{
    const Type& target = checkExpr(*statement.target);
    checkExpr(*statement.value);
    if (target.kind == TypeKind::Bad)
        return;
    if (!isVariable(*statement.target))
        return report(Code::StVariableNeeded, *statement.target);
    checkWritable(*statement.target);
    if (statement.value->type->kind == TypeKind::Void)
        return report(Code::StTypeNeeded, *statement.value, {typeName(target), typeName(m_void)});
    if (target.kind == TypeKind::Interface || (target.kind == TypeKind::Text && statement.value->type->kind == TypeKind::Text && !isSame(target, *statement.value->type)))
        return report(Code::StNotBuilt, *statement.value, {textOf(*statement.value)});
    coerce(statement.value, target);
}

/// Constants, inputs and counters of loops are not written.
void Checker::checkWritable(const Expr& target)
{
    const Expr* root = &target;
    while (root->kind == ExprKind::Member || root->kind == ExprKind::Index)
        root = root->left;
    const Symbol* symbol = root->symbol;
    if (!symbol || root->kind == ExprKind::Dereference)
        return;
    symbol->isWritten = true;
    if (symbol->isConstant)
        return report(Code::StNotAssignable, target, {textOf(target), CW_TEXT("Arguments", "a constant")});
    if (std::ranges::find(m_counters, symbol) != m_counters.end() && root == &target)
        return report(Code::StNotAssignable, target, {textOf(target), CW_TEXT("Arguments", "the counter of a loop around it")});
    if (symbol->section == Section::Input && m_pou && m_pou->tree->kind == PouKind::FunctionBlock && root == &target && symbol->storage == Storage::Instance)
        report(Code::StNotAssignable, target, {textOf(target), CW_TEXT("Arguments", "an input")});
}

void Checker::checkCondition(Expr*& condition)
{
    checkExpr(*condition);
    coerce(condition, boolType());
}

bool Checker::checkIf(Statement& statement)
{
    bool isReached = !statement.otherwise;
    for (Branch& branch : statement.branches) {
        checkCondition(branch.condition);
        isReached = checkStatements(branch.body) || isReached;
    }
    if (statement.otherwise)
        isReached = checkStatements(statement.otherwise->body) || isReached;
    return isReached;
}

bool Checker::checkCase(Statement& statement)
{
    checkExpr(*statement.target);
    useDefaultType(*statement.target);
    const Type& type = *statement.target->type;
    const bool isWhole = type.kind == TypeKind::Enum || type.kind == TypeKind::Subrange || isAnyInteger(type.elementary) || isBits(type.elementary);
    if (type.kind != TypeKind::Bad && !isWhole)
        report(Code::StTypeNeeded, *statement.target, {CW_TEXT("Arguments", "a whole number"), typeName(type)});
    std::vector<UsedLabel> used;
    bool isReached = !statement.otherwise;
    for (Branch& branch : statement.branches) {
        for (CaseLabel& label : branch.labels) {
            if (isWhole)
                checkLabel(label, type, used);
        }
        isReached = checkStatements(branch.body) || isReached;
    }
    checkOverlaps(used);
    if (statement.otherwise)
        isReached = checkStatements(statement.otherwise->body) || isReached;
    return isReached;
}

/// Of two labels with a value in common the one that stands later in the text is wrong.
void Checker::checkOverlaps(std::vector<UsedLabel>& used)
{
    std::ranges::sort(used, {}, [](const UsedLabel& label) { return std::pair(label.first, label.expr->offset); });
    for (std::size_t i = 1; i < used.size(); ++i) {
        UsedLabel& before = used[i - 1];
        UsedLabel& label = used[i];
        if (label.first > before.last)
            continue;
        const Expr& later = before.expr->offset > label.expr->offset ? *before.expr : *label.expr;
        report(Code::StCaseTwice, later, {std::to_string(label.first)});
        label.last = std::max(label.last, before.last);
    }
}

void Checker::checkLabel(CaseLabel& label, const Type& type, std::vector<UsedLabel>& used)
{
    const Type& wanted = type.kind == TypeKind::Subrange ? *type.element : type;
    const auto first = constantInteger(label.low, &wanted);
    const auto last = label.high ? constantInteger(label.high, &wanted) : first;
    if (!first || !last)
        return;
    if (*last < *first)
        return report(Code::StBadBounds, label.low->offset, label.high->end, {wideText(*first), wideText(*last)});
    label.first = static_cast<std::int64_t>(*first);
    label.last = static_cast<std::int64_t>(*last);
    used.push_back({label.first, label.last, label.low});
}

bool Checker::checkFor(Statement& statement)
{
    const Type& type = checkExpr(*statement.target);
    const Type& plain = type.kind == TypeKind::Subrange ? *type.element : type;
    checkExpr(*statement.value);
    checkExpr(*statement.limit);
    if (type.kind != TypeKind::Bad) {
        if (!isVariable(*statement.target) || plain.kind != TypeKind::Elementary || !isAnyInteger(plain.elementary)) {
            report(Code::StForCounter, *statement.target, {typeName(type)});
        } else {
            checkWritable(*statement.target);
            coerce(statement.value, plain);
            coerce(statement.limit, plain);
            if (statement.step) {
                checkExpr(*statement.step);
                coerce(statement.step, plain);
                if (statement.step->constant && statement.step->constant->integer == 0)
                    report(Code::StStepZero, *statement.step);
            }
        }
    }
    m_counters.push_back(statement.target->symbol);
    ++m_loops;
    checkStatements(statement.body);
    --m_loops;
    m_counters.pop_back();
    return true;
}

} // namespace camwright::st
