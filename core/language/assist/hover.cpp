#include "core/language/assist/hover.h"

#include "core/language/assist/spot.h"
#include "core/language/check/operandtypes.h"
#include "core/language/check/resolvedprogram.h"
#include "core/language/source/koyodialect.h"

namespace camwright {

namespace {

void describeInstruction(Hover& out, const LanguageContext& context, TextLanguage language)
{
    const Instruction& instruction = *out.instruction;
    out.signature = signature(*context.dialect, instruction);
    out.help = instruction.help.in(language);
    out.group = context.family->catalogue().groupName(instruction.group).in(language);
    if (!instruction.simulated)
        out.whyNotSimulated = instruction.whyNotSimulated.in(language);
}

void describePin(Hover& out, const LanguageContext& context, TextLanguage language)
{
    out.help = out.pin->help.in(language);
    out.types = typeNames(out.pin->types);
    out.areas = areaNames(*out.pin, *context.family);
}

void describeMemory(Hover& out, const Address& address, const LanguageContext& context, TextLanguage language)
{
    out.address = address;
    if (!out.variable)
        out.variable = context.variableAt(address);
    if (address.area != VariablesArea)
        out.areaMeaning = context.family->area(address.area).meaning.in(language);
}

std::optional<Literal> literalOf(std::string_view word, const LanguageContext& context)
{
    if (context.dialect->id == DialectId::KoyoIl)
        if (const auto constant = koyoConstant(word))
            return Literal::read(*constant);
    return Literal::read(word);
}

void describeWord(Hover& out, const Spot& spot, const LanguageContext& context, TextLanguage language)
{
    out.variable = context.findVariable(spot.word);
    if (out.variable) {
        if (out.variable->address)
            describeMemory(out, *out.variable->address, context, language);
    } else if (const auto address = context.family->parseAddress(spot.word, *context.model)) {
        describeMemory(out, *address, context, language);
    } else if (const auto literal = literalOf(spot.word, context)) {
        const TypeSet types = out.pin ? intersection(literal->types(), out.pin->types) : literal->types();
        if (const auto value = literal->as(preferredType(types.isEmpty() ? literal->types() : types)))
            out.constant = *value;
    }
}

} // namespace

std::optional<Hover> hoverAt(const LanguageContext& context, std::string_view text, std::size_t offset, TextLanguage language)
{
    const Spot spot = spotAt(context, text, offset);
    if (spot.isComment || spot.word.empty())
        return std::nullopt;
    Hover out;
    out.begin = spot.begin;
    out.end = spot.end;
    out.instruction = spot.instruction;
    if (spot.isMnemonic) {
        if (!out.instruction)
            return std::nullopt;
        describeInstruction(out, context, language);
        return out;
    }
    out.pin = spot.pin;
    if (out.pin)
        describePin(out, context, language);
    describeWord(out, spot, context, language);
    const bool known = out.pin || out.variable || out.address || out.constant;
    return known ? std::optional(std::move(out)) : std::nullopt;
}

} // namespace camwright
