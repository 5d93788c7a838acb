#include "core/language/assist/liveoperands.h"

#include "core/language/assist/spot.h"
#include "core/language/check/operandtypes.h"

#include <algorithm>

namespace camwright {

namespace {

/// Names by which the controller knows a place taken as a type; empty if it has none.
std::vector<std::string> namesOf(const LanguageContext& context, const std::string& word, const ResolvedMemory& memory, const Address& used)
{
    if (memory.variable)
        return {memory.variable->name};
    const MemoryArea& area = context.family->area(used.area);
    if (area.local)
        return {};
    std::vector<std::string> out{word};
    if (area.kind == AreaKind::Words && !used.isBit)
        for (std::uint32_t byte = area.elementBytes; byte < byteWidth(used.type); byte += area.elementBytes)
            out.push_back(context.family->formatAddress(valueAddress(used.area, used.byte + byte, memory.address.type)));
    return out;
}

std::optional<LiveOperand> liveOperand(const LanguageContext& context, std::string_view line, std::size_t column)
{
    const Spot spot = spotAt(context, line, column);
    if (spot.isMnemonic || spot.isComment || !spot.pin || spot.word.empty() || spot.kind == TokenKind::Pin)
        return std::nullopt;
    const PinKind kind = spot.pin->kind;
    if (kind == PinKind::Block || kind == PinKind::Program || kind == PinKind::Arguments)
        return std::nullopt;
    ResolvedMemory memory;
    if (const KnownVariable* variable = context.findVariable(spot.word); variable && variable->address)
        memory = {*variable->address, variable};
    else if (const auto address = context.family->parseAddress(spot.word, *context.model))
        memory = {*address, nullptr};
    else
        return std::nullopt;
    const Address used = kind == PinKind::Value || kind == PinKind::Axis ? addressAtPin(memory, *spot.pin, context) : memory.address;
    LiveOperand out{0, static_cast<std::uint32_t>(spot.begin), static_cast<std::uint32_t>(spot.end - spot.begin),
        namesOf(context, spot.word, memory, used), used.type, spot.pin->name};
    return out.names.empty() ? std::nullopt : std::optional(std::move(out));
}

} // namespace

std::vector<LiveOperand> liveOperands(const LanguageContext& context, std::string_view lines, LineState before, std::uint32_t firstLine)
{
    std::vector<LiveOperand> out;
    std::vector<Token> tokens;
    LineState state = before;
    std::uint32_t number = firstLine;
    for (std::size_t begin = 0; begin <= lines.size(); ++number) {
        const std::size_t end = std::min(lines.find('\n', begin), lines.size());
        std::string_view line = lines.substr(begin, end - begin);
        if (line.ends_with('\r'))
            line.remove_suffix(1);
        begin = end + 1;
        tokens.clear();
        const bool isCode = state == LineState::Code;
        state = tokenizeLine(*context.dialect, line, state, tokens);
        for (const Token& token : tokens) {
            if (!isCode || (token.kind != TokenKind::Address && token.kind != TokenKind::Symbol))
                continue;
            if (auto operand = liveOperand(context, line, token.column)) {
                operand->line = number;
                if (out.empty() || out.back().line != number || out.back().column != operand->column)
                    out.push_back(std::move(*operand));
            }
        }
    }
    return out;
}

Value liveValue(const LiveOperand& operand, std::span<const Value> values)
{
    if (values.size() == 1)
        return values.front();
    Value out{operand.type, 0};
    unsigned shift = 0;
    for (const Value& value : values) {
        const unsigned width = byteWidth(value.type) * 8;
        const std::uint64_t mask = width >= 64 ? ~std::uint64_t{0} : (std::uint64_t{1} << width) - 1;
        if (shift < 64)
            out.bits |= (value.bits & mask) << shift;
        shift += width;
    }
    return out;
}

} // namespace camwright
