#include "core/language/assist/completion.h"

#include "core/language/assist/spot.h"
#include "core/language/check/operandtypes.h"
#include "core/language/check/resolvedprogram.h"
#include "core/language/source/letters.h"

#include <algorithm>

namespace camwright {

namespace {

class Completer {
public:
    Completer(const LanguageContext& context, TextLanguage language, std::string_view typed)
        : m_context(context), m_language(language), m_typed(upperCase(typed))
    {
    }

    void instructions()
    {
        for (const Instruction& instruction : m_context.family->catalogue().instructions())
            add({CompletionKind::Instruction, instruction.mnemonic, signature(*m_context.dialect, instruction), instruction.help.in(m_language)});
        sort();
    }

    void operands(const Instruction& instruction, const Pin* pin)
    {
        if (pin) {
            switch (pin->kind) {
            case PinKind::Program: programs(ProgramRole::Subroutine); break;
            case PinKind::Interrupt: programs(ProgramRole::Interrupt); break;
            case PinKind::Axis: axes(true); break;
            case PinKind::Value: case PinKind::Block: values(*pin); break;
            case PinKind::Timer: case PinKind::Counter: case PinKind::Arguments: case PinKind::Label: break;
            }
        }
        sort();
        if (m_typed.empty())
            return;
        for (const Pin& other : instruction.pins)
            if (other.kind != PinKind::Arguments)
                add({CompletionKind::Pin, other.name + ":=", typeNames(other.types), other.help.in(m_language)});
    }

    std::vector<CompletionItem> take(const Pin* pin)
    {
        if (m_items.size() > MaximumCompletions)
            m_items.resize(MaximumCompletions);
        if (m_typed.empty() && pin) {
            m_items.push_back({CompletionKind::Placeholder, "???", {}, {}});
            if (pin->optional)
                m_items.push_back({CompletionKind::Placeholder, "_", {}, {}});
        }
        return std::move(m_items);
    }

private:
    void add(CompletionItem item)
    {
        if (upperCase(std::string_view(item.text).substr(0, m_typed.size())) == m_typed)
            m_items.push_back(std::move(item));
    }

    void sort()
    {
        std::sort(m_items.begin(), m_items.end(), [](const CompletionItem& a, const CompletionItem& b) {
            return std::pair(a.kind, upperCase(a.text)) < std::pair(b.kind, upperCase(b.text));
        });
    }

    void programs(ProgramRole role)
    {
        for (const KnownProgram& program : m_context.programs)
            if (program.role == role)
                add({CompletionKind::Program, program.name, {}, {}});
    }

    void axes(bool byName)
    {
        for (const KnownAxis& axis : m_context.axes)
            add({CompletionKind::Axis, byName ? axis.name : std::to_string(axis.number), byName ? std::to_string(axis.number) : axis.name, {}});
    }

    void values(const Pin& pin)
    {
        const Family& family = *m_context.family;
        if (pin.name == "AXIS" && pin.constantAllowed)
            axes(false);
        for (const KnownVariable& variable : m_context.variables)
            if (variable.address && pin.types.contains(variable.type) && areaAllowed(pin, *variable.address, family))
                add({CompletionKind::Variable, variable.name, std::string(name(variable.type))
                    + (variable.isBound ? " " + family.formatAddress(*variable.address) : ""), {}});
        areas(pin);
    }

    /// "%VB", "%VW" … of the areas and widths the pin takes; on TS600 "D", "X".
    void areas(const Pin& pin)
    {
        const Family& family = *m_context.family;
        for (const AreaId id : pin.areas) {
            const MemoryArea& area = family.area(id);
            if (area.kind != AreaKind::Bytes || area.isPacked()) {
                if (area.kind != AreaKind::TimerValues && area.kind != AreaKind::CounterValues && fits(pin, area.name + "0"))
                    add({CompletionKind::Area, area.name, {}, area.meaning.in(m_language)});
                continue;
            }
            for (const char letter : area.sizeLetters) {
                const std::string start = "%" + area.name + (letter == 'X' ? "" : std::string(1, letter));
                if (fits(pin, start + (letter == 'X' ? "0.0" : "0")))
                    add({CompletionKind::Area, start, {}, area.meaning.in(m_language)});
            }
        }
    }

    bool fits(const Pin& pin, const std::string& example) const
    {
        const auto address = m_context.family->parseAddress(example, *m_context.model);
        if (!address)
            return false;
        const std::vector<DataType> types = pin.types.list();
        return std::any_of(types.begin(), types.end(), [&](DataType type) { return m_context.family->withType(*address, type, *m_context.model).ok(); });
    }

    const LanguageContext& m_context;
    TextLanguage m_language;
    std::string m_typed;
    std::vector<CompletionItem> m_items;
};

} // namespace

Completion completeAt(const LanguageContext& context, std::string_view text, std::size_t offset, TextLanguage language)
{
    offset = std::min(offset, text.size());
    const Spot spot = spotAt(context, text, offset);
    Completion out{spot.begin, spot.end, {}};
    if (spot.isComment)
        return out;
    Completer completer(context, language, std::string_view(spot.word).substr(0, offset - spot.begin));
    if (spot.isMnemonic)
        completer.instructions();
    else if (spot.instruction)
        completer.operands(*spot.instruction, spot.pin);
    out.items = completer.take(spot.isMnemonic ? nullptr : spot.pin);
    return out;
}

} // namespace camwright
