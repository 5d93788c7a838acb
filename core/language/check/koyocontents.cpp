#include "core/language/check/koyocontents.h"

namespace camwright {

namespace {

std::optional<std::uint32_t> constantOf(const ResolvedStatement& statement)
{
    const auto* literal = statement.operands.empty() ? nullptr : std::get_if<Literal>(&statement.operands.front().value);
    if (!literal)
        return std::nullopt;
    const auto value = literal->as(DataType::Dword);
    return value ? std::optional(static_cast<std::uint32_t>(value->bits)) : std::nullopt;
}

} // namespace

KoyoContents::KoyoContents(std::span<const ResolvedProgram> programs)
{
    for (std::size_t i = 0; i < programs.size(); ++i) {
        m_accumulator.reset();
        for (const ResolvedNetwork& network : programs[i].networks)
            for (const ResolvedRung& rung : network.rungs) {
                m_accumulator.reset(); // another rung may have run instead
                for (const ResolvedStatement& statement : rung.statements)
                    if (statement.isComplete)
                        follow(i, statement);
            }
    }
}

const KnownContent* KoyoContents::find(const Address& word) const
{
    const auto found = m_contents.find({word.area, word.byte});
    return found == m_contents.end() || !found->second ? nullptr : &*found->second;
}

void KoyoContents::follow(std::size_t program, const ResolvedStatement& statement)
{
    switch (statement.instruction->id) {
    case InstructionId::KoyoLd:
    case InstructionId::KoyoLdd:
    case InstructionId::KoyoLds:
    case InstructionId::KoyoLda: m_accumulator = constantOf(statement); return;
    case InstructionId::KoyoOutw: return store(program, statement.operands.front(), m_accumulator);
    case InstructionId::KoyoOutd: return store(program, statement.operands.front(), std::nullopt);
    default: break;
    }
    if (statement.role == StatementRole::Block)
        m_accumulator.reset();
    for (const ResolvedOperand& operand : statement.operands)
        if (operand.pin->direction != PinDirection::In)
            store(program, operand, std::nullopt);
}

void KoyoContents::store(std::size_t program, const ResolvedOperand& operand, std::optional<std::uint32_t> value)
{
    const auto* memory = std::get_if<ResolvedMemory>(&operand.value);
    if (!memory)
        return;
    const Address& address = memory->address;
    const auto content = value ? std::optional(KnownContent{*value & 0xFFFF, program, operand.range}) : std::nullopt;
    const std::uint32_t words = operand.pin->types.contains(DataType::Word) || address.isBit ? 1 : 2;
    for (std::uint32_t i = 0; i < words; ++i) {
        const auto [entry, isNew] = m_contents.try_emplace({address.area, (address.byte & ~1u) + 2 * i}, content);
        if (!isNew && (!entry->second || !content || entry->second->value != content->value))
            entry->second.reset();
    }
}

} // namespace camwright
