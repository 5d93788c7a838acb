#include "core/language/st/lowering/bodylowering.h"

namespace camwright::st {

// Statements.

namespace {

const Type& plainOf(const Type& type)
{
    return type.kind == TypeKind::Subrange ? *type.element : type;
}

} // namespace

void BodyLowering::lower()
{
    enter();
    statements(m_pou.tree->body);
}

/// What begins anew with each call: the locals of functions and methods, VAR_TEMP, the result.
void BodyLowering::enter()
{
    const bool isFunction = m_pou.tree->kind == PouKind::Function || m_pou.tree->kind == PouKind::Method;
    const auto begin = [this](const Symbol& symbol) {
        const ValuePlace place = placeOf(symbol);
        if (symbol.type->isScalar()) {
            static const Constant zero;
            const Expr* initial = symbol.initial ? symbol.initial : symbol.type->initial;
            store(place, *symbol.type, constantOf(*symbol.type, initial && initial->constant ? *initial->constant : zero));
        } else if (symbol.fresh != 0) {
            ValuePlace fresh;
            fresh.address = {VariablesArea, IrAddress::WholeByte, symbol.fresh};
            move(place, fresh, symbol.type->size);
        }
    };
    for (const Symbol* symbol : m_pou.variables) {
        const bool isParameter = symbol->section == Section::Input || symbol->section == Section::InOut;
        if (symbol->storage == Storage::Static && !isParameter && (isFunction || symbol->section == Section::Temp))
            begin(*symbol);
    }
    if (m_pou.result)
        begin(*m_pou.result);
}

void BodyLowering::statements(const List<Statement>& list)
{
    for (const Statement& s : list)
        statement(s);
}

void BodyLowering::markSource(std::uint32_t offset, std::uint32_t end)
{
    m_ir.setSource(m_link.source(m_pou.file, offset, end));
}

void BodyLowering::landAll(const std::vector<std::size_t>& jumps)
{
    for (const std::size_t at : jumps)
        m_ir.land(at);
}

std::size_t BodyLowering::jump()
{
    return m_ir.emit(m_ir.make(IrOp::Jump, DataType::Bool));
}

void BodyLowering::jumpBack(std::size_t target, IrOp op, IrRegister condition)
{
    m_ir.control(op, static_cast<std::uint32_t>(target), condition);
}

void BodyLowering::statement(const Statement& s)
{
    const std::size_t guards = m_guards.size();
    markSource(s.offset, s.headEnd);
    switch (s.kind) {
    case StatementKind::Assign: assign(s); break;
    case StatementKind::Call: call(*s.target); break;
    case StatementKind::If: ifStatement(s); break;
    case StatementKind::Case: caseStatement(s); break;
    case StatementKind::For: forStatement(s); break;
    case StatementKind::While: whileStatement(s); break;
    case StatementKind::Repeat: repeatStatement(s); break;
    case StatementKind::Exit: m_loops.back().exits.push_back(jump()); break;
    case StatementKind::Continue: m_loops.back().continues.push_back(jump()); break;
    case StatementKind::Return: m_ir.control(IrOp::Return); break;
    case StatementKind::Attempt:
    case StatementKind::Empty: break;
    }
    for (std::size_t at = guards; at < m_guards.size(); ++at)
        m_ir.land(m_guards[at]);
    m_guards.resize(guards);
}

void BodyLowering::assign(const Statement& s)
{
    const Type& type = *s.target->type;
    if (type.isScalar()) {
        const ValuePlace place = placeOf(*s.target);
        const IrRegister result = value(*s.value);
        return store(place, type, result);
    }
    if (type.kind == TypeKind::Text && s.value->constant) {
        const ValuePlace place = placeOf(*s.target);
        const std::string_view text = s.value->constant->text.substr(0, type.capacity);
        ValuePlace whole = place;
        if (place.kind == ValuePlace::Kind::Element) {
            whole.kind = ValuePlace::Kind::Pointer;
            whole.pointer = pointerTo(place, type.size);
            whole.reach = type.size;
        }
        Type word;
        word.data = DataType::Word;
        Type byte;
        byte.data = DataType::Byte;
        store(whole, word, integer(DataType::Word, static_cast<std::int64_t>(text.size())));
        for (std::size_t i = 0; i < text.size(); ++i)
            store(memberOf(whole, 2 + static_cast<std::uint32_t>(i)), byte, integer(DataType::Byte, static_cast<unsigned char>(text[i])));
        return;
    }
    if (s.value->kind == ExprKind::Call)
        value(*s.value);
    const ValuePlace from = s.value->kind == ExprKind::Call ? placeOf(*s.value->symbol->pou->result) : placeOf(*s.value);
    const ValuePlace to = placeOf(*s.target);
    move(to, from, type.size);
}

void BodyLowering::ifStatement(const Statement& s)
{
    std::vector<std::size_t> ends;
    for (const Branch& branch : s.branches) {
        if (&branch != s.branches.first)
            markSource(branch.offset, branch.end);
        const std::size_t skip = m_ir.jumpIf(false, value(*branch.condition));
        statements(branch.body);
        if (branch.next || s.otherwise)
            ends.push_back(jump());
        m_ir.land(skip);
    }
    if (s.otherwise)
        statements(s.otherwise->body);
    landAll(ends);
}

IrRegister BodyLowering::labelMatches(const CaseLabel& label, IrRegister selector, DataType type)
{
    const IrRegister low = integer(type, label.first);
    if (label.first == label.last)
        return m_ir.compute(IrOp::Equal, type, selector, low);
    const IrRegister above = m_ir.compute(IrOp::GreaterEqual, type, selector, low);
    const IrRegister high = integer(type, label.last);
    const IrRegister below = m_ir.compute(IrOp::LessEqual, type, selector, high);
    return m_ir.compute(IrOp::And, DataType::Bool, above, below);
}

void BodyLowering::caseStatement(const Statement& s)
{
    const DataType type = s.target->type->data;
    const IrRegister selector = value(*s.target);
    std::vector<std::size_t> ends;
    for (const Branch& branch : s.branches) {
        markSource(branch.offset, branch.end);
        IrRegister matches = NoRegister;
        for (const CaseLabel& label : branch.labels) {
            const IrRegister one = labelMatches(label, selector, type);
            matches = matches == NoRegister ? one : m_ir.compute(IrOp::Or, DataType::Bool, matches, one);
        }
        const std::size_t skip = m_ir.jumpIf(false, matches);
        statements(branch.body);
        ends.push_back(jump());
        m_ir.land(skip);
    }
    if (s.otherwise)
        statements(s.otherwise->body);
    landAll(ends);
}

/// The counter is compared before the first turn and after each step; the limit is computed once.
void BodyLowering::forStatement(const Statement& s)
{
    const Type& type = plainOf(*s.target->type);
    const bool isDown = s.step && s.step->constant && s.step->constant->integer < 0;
    const IrRegister start = value(*s.value);
    const IrRegister limit = value(*s.limit);
    const IrRegister step = s.step ? value(*s.step) : integer(type.data, 1);
    store(placeOf(*s.target), type, start);
    IrRegister runs = NoRegister;
    if (!s.step || s.step->constant) {
        runs = m_ir.compute(isDown ? IrOp::GreaterEqual : IrOp::LessEqual, type.data, start, limit);
    } else {
        const IrRegister isUp = m_ir.compute(IrOp::Greater, type.data, step, integer(type.data, 0));
        const IrRegister up = m_ir.compute(IrOp::LessEqual, type.data, start, limit);
        const IrRegister down = m_ir.compute(IrOp::GreaterEqual, type.data, start, limit);
        runs = select(DataType::Bool, isUp, up, down);
    }
    const std::size_t skip = m_ir.jumpIf(false, runs);
    const std::size_t begin = m_ir.here();
    m_loops.emplace_back();
    statements(s.body);
    markSource(s.offset, s.headEnd);
    landAll(m_loops.back().continues);
    stepAndRepeat(s, begin, limit, step);
    landAll(m_loops.back().exits);
    m_loops.pop_back();
    m_ir.land(skip);
}

/// Where the counter cannot leave its type, it is stepped and compared; else it is asked first whether a step is left.
void BodyLowering::stepAndRepeat(const Statement& s, std::size_t begin, IrRegister limit, IrRegister step)
{
    const Type& type = plainOf(*s.target->type);
    const Wide by = !s.step ? Wide{1} : s.step->constant ? s.step->constant->integer : Wide{0};
    const Constant* last = s.limit->constant;
    const bool fits = by != 0 && last && last->integer + by <= largestOf(type.elementary) && last->integer + by >= smallestOf(type.elementary);
    if (!fits)
        return repeatWhileInside(s, begin, limit, step);
    const IrRegister old = load(placeOf(*s.target), type);
    const IrRegister next = m_ir.compute(IrOp::Add, type.data, old, step);
    store(placeOf(*s.target), type, next);
    jumpBack(begin, IrOp::JumpIf, m_ir.compute(by < 0 ? IrOp::GreaterEqual : IrOp::LessEqual, type.data, next, limit));
}

void BodyLowering::repeatWhileInside(const Statement& s, std::size_t begin, IrRegister limit, IrRegister step)
{
    const Type& type = plainOf(*s.target->type);
    const IrRegister old = load(placeOf(*s.target), type);
    const IrRegister next = m_ir.compute(IrOp::Add, type.data, old, step);
    const IrRegister zero = integer(type.data, 0);
    const IrRegister isUp = m_ir.compute(IrOp::Greater, type.data, step, zero);
    const IrRegister grew = m_ir.compute(IrOp::Greater, type.data, next, old);
    const IrRegister below = m_ir.compute(IrOp::LessEqual, type.data, next, limit);
    const IrRegister shrank = m_ir.compute(IrOp::Less, type.data, next, old);
    const IrRegister above = m_ir.compute(IrOp::GreaterEqual, type.data, next, limit);
    const IrRegister up = m_ir.compute(IrOp::And, DataType::Bool, grew, below);
    const IrRegister down = m_ir.compute(IrOp::And, DataType::Bool, shrank, above);
    const IrRegister more = select(DataType::Bool, isUp, up, down);
    const std::size_t done = m_ir.jumpIf(false, more);
    store(placeOf(*s.target), type, next);
    jumpBack(begin);
    m_ir.land(done);
}

void BodyLowering::whileStatement(const Statement& s)
{
    const std::size_t begin = m_ir.here();
    const std::size_t leave = m_ir.jumpIf(false, value(*s.value));
    m_loops.emplace_back();
    statements(s.body);
    markSource(s.offset, s.headEnd);
    landAll(m_loops.back().continues);
    jumpBack(begin);
    landAll(m_loops.back().exits);
    m_loops.pop_back();
    m_ir.land(leave);
}

void BodyLowering::repeatStatement(const Statement& s)
{
    const std::size_t begin = m_ir.here();
    m_loops.emplace_back();
    statements(s.body);
    landAll(m_loops.back().continues);
    markSource(s.value->offset, s.value->end);
    jumpBack(begin, IrOp::JumpIfNot, value(*s.value));
    landAll(m_loops.back().exits);
    m_loops.pop_back();
}

} // namespace camwright::st
