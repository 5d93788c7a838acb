#include "core/language/check/resolvedprogram.h"

#include "core/language/source/koyodialect.h"
#include "core/language/source/letters.h"
#include "core/language/source/operandtext.h"

#include <algorithm>
#include <charconv>
#include <memory>

namespace camwright {

namespace {

struct Misprint {
    std::string_view family, printed, meant;
};

/// Words of the manuals that are not instructions, and what they stand for (KS-IL-10 and kinco-ks.md section 10).
constexpr Misprint Misprints[] = {
    {"kinco", "BN", "GE"}, {"kinco", "MC_RESTRAT", "MC_RESTART"}, {"kinco", "MIOT_MC", "MC_MIOT"}, {"kinco", "CALL", "CAL"},
    {"kinco", "LDI", "LDN"}, {"kinco", "ANI", "ANDN"}, {"kinco", "ORI", "ORN"}, {"kinco", "OUT", "ST"}, {"kinco", "MOV", "MOVE"},
    {"kinco", "SET", "S"}, {"kinco", "RST", "R"}, {"kinco", "EU", "R_TRIG"}, {"kinco", "ED", "F_TRIG"},
    {"invt", "LDN", "LDI"}, {"invt", "ANDN", "ANI"}, {"invt", "ORN", "ORI"}, {"invt", "ST", "OUT"}, {"invt", "MOVE", "MOV"},
    {"koyo", "LDN", "STRN"}, {"koyo", "STRNOT", "STRN"}, {"koyo", "ANDNOT", "ANDN"}, {"koyo", "ORNOT", "ORN"}, {"koyo", "ANB", "ANDSTR"},
    {"koyo", "ORB", "ORSTR"}, {"koyo", "RES", "RST"}, {"koyo", "CALL", "GTS"}, {"koyo", "CAL", "GTS"}, {"koyo", "ST", "OUT"},
    {"koyo", "TON", "TMR"}, {"koyo", "CTU", "CNT"}, {"koyo", "CTUD", "UDC"}, {"koyo", "MOV", "LD"}, {"koyo", "RET", "RT"},
    {"invt", "CAL", "CALL"}, {"invt", "S", "SET"}, {"invt", "R", "RST"},
};

class Resolver {
public:
    Resolver(const LanguageContext& context, const ObjectKey& key, ProgramRole role, Diagnostics& diagnostics)
        : m_context(context), m_family(*context.family), m_sink(diagnostics, key), m_role(role)
    {
    }

    /// The variable table, and what starts the routine.
    void declarations(const Declarations& declarations, ResolvedProgram& out)
    {
        ParameterTable table = layOut(declarations, m_family, *m_context.model);
        if (table.tooMany)
            report(Code::TooManyParameters, table.tooMany->range, {"16", shortened(table.tooMany->name)});
        m_locals = std::make_shared<const std::vector<KnownParameter>>(std::move(table.parameters));
        out.parameters = m_locals;
        if (!declarations.event)
            return;
        const auto event = this->event(*declarations.event);
        out.event = event.value_or(InterruptEvent{}); // one that is wrong is still one: nobody misses another
        if (m_role != ProgramRole::Interrupt)
            report(Code::NotAnInterrupt, declarations.event->range, {shortened(m_sink.object().name)});
        else if (!event)
            report(Code::BadInterruptEvent, declarations.event->range, {shortened(declarations.event->text), "X0 RISING, 10 ms"});
    }

    ResolvedRung rung(const Rung& rung)
    {
        ResolvedRung out{{}, rung.drawable, rung.tree, rung.range};
        for (const Statement& statement : rung.statements) {
            out.statements.push_back(this->statement(statement));
            m_complete = m_complete && out.statements.back().isComplete;
        }
        return out;
    }

    bool isComplete() const { return m_complete; }

private:
    void report(Code code, const TextRange& range, std::vector<std::string> arguments)
    {
        m_sink.add(code, range, std::move(arguments));
        m_complete = false;
    }

    /// "X0 RISING", "X7 FALLING", "10 ms" (TS-INT-02, TS-INT-03).
    std::optional<InterruptEvent> event(const EventText& written) const
    {
        const std::string text = upperCase(written.text);
        const std::size_t blank = text.find_first_of(" \t");
        if (blank == std::string::npos)
            return std::nullopt;
        const std::string first = text.substr(0, blank);
        const std::string_view second = trimmed(std::string_view(text).substr(blank));
        if (second == "MS") {
            const auto number = Literal::read(first);
            const auto value = number && number->types().contains(DataType::Int) ? std::optional(number->as(DataType::Int)) : std::nullopt;
            if (!value || !value->ok() || (**value).asInteger() < 1 || (**value).asInteger() > 1000)
                return std::nullopt;
            return InterruptEvent{InterruptEvent::Kind::Timed, {}, static_cast<std::uint32_t>((**value).asInteger())};
        }
        const auto input = m_family.parseAddress(first, *m_context.model);
        if (!input || !m_family.area(input->area).isInput || (second != "RISING" && second != "FALLING"))
            return std::nullopt;
        return InterruptEvent{second == "RISING" ? InterruptEvent::Kind::Rising : InterruptEvent::Kind::Falling, *input, 0};
    }

    ResolvedStatement statement(const Statement& statement)
    {
        ResolvedStatement out;
        out.role = statement.role;
        out.form = statement.form;
        out.range = statement.range;
        if (statement.role == StatementRole::Invalid) {
            out.isComplete = false;
            return out;
        }
        out.instruction = m_family.catalogue().find(m_context.dialect->id == DialectId::KoyoIl
            ? koyoCatalogueName(statement.mnemonic, statement.role, statement.form) : statement.mnemonic);
        if (!out.instruction) {
            unknownInstruction(statement);
            out.isComplete = false;
            return out;
        }
        needs(out, statement);
        if (m_context.strictKinco && (out.role == StatementRole::OpenAnd || out.role == StatementRole::OpenOr))
            m_sink.add(Code::GroupNotInFamily, mnemonicRange(statement), {out.instruction->mnemonic});
        place(statement, out);
        return out;
    }

    static TextRange mnemonicRange(const Statement& statement)
    {
        TextRange out = statement.range;
        out.endLine = out.line;
        out.endColumn = out.column + static_cast<std::uint32_t>(statement.mnemonic.size());
        return out;
    }

    void unknownInstruction(const Statement& statement)
    {
        const std::string& word = statement.mnemonic;
        const std::string shown = shortened(word);
        const TextRange range = mnemonicRange(statement);
        if (const std::string latin = withLatinLetters(word); latin != word && m_family.catalogue().find(latin)) {
            m_sink.add(Code::LookalikeLetters, range, {shown, firstLookalike(word), latin});
            return;
        }
        const std::string upper = upperCase(word);
        for (const Misprint& misprint : Misprints)
            if (misprint.family == m_family.id() && misprint.printed == upper) {
                m_sink.add(Code::UnknownInstructionNear, range, {shown, m_family.displayName(), std::string(misprint.meant)});
                return;
            }
        std::vector<std::string_view> names;
        for (const Instruction& instruction : m_family.catalogue().instructions())
            names.push_back(instruction.mnemonic);
        if (const std::string near = nearestName(word, names); !near.empty())
            m_sink.add(Code::UnknownInstructionNear, range, {shown, m_family.displayName(), near});
        else
            m_sink.add(Code::UnknownInstruction, range, {shown, m_family.displayName()});
    }

    /// What the model must have for the instruction.
    void needs(ResolvedStatement& out, const Statement& statement)
    {
        const Capability needed = out.instruction->needs;
        if (m_context.model->has(needed))
            return;
        const Code code = needed == Capability::PulseOutputs ? Code::NeedsPulseOutputs : Code::NeedsMotionAxes;
        m_sink.add(code, mnemonicRange(statement), {out.instruction->mnemonic, m_context.model->name});
        out.isComplete = false;
    }

    /// Puts the operands to their pins: by place, or by name.
    void place(const Statement& statement, ResolvedStatement& out)
    {
        const Instruction& instruction = *out.instruction;
        std::vector<const Operand*> atPin(instruction.pins.size(), nullptr);
        const bool hasArguments = !instruction.pins.empty() && instruction.pins.back().kind == PinKind::Arguments;
        std::vector<const Operand*> arguments;
        std::size_t next = 0, extra = 0;
        for (const Operand& operand : statement.operands) {
            std::size_t pin = next;
            if (!operand.pin.empty()) {
                pin = pinIndex(instruction, operand, out);
                if (pin == instruction.pins.size())
                    continue;
            } else {
                ++next;
            }
            if (hasArguments && operand.pin.empty() && pin + 1 >= instruction.pins.size()) {
                arguments.push_back(&operand);
                continue;
            }
            if (pin >= instruction.pins.size() || instruction.pins[pin].kind == PinKind::Arguments) {
                ++extra;
                continue;
            }
            if (atPin[pin]) {
                m_sink.add(Code::PinGivenTwice, operand.range, {instruction.pins[pin].name, instruction.mnemonic});
                out.isComplete = false;
            }
            atPin[pin] = &operand;
        }
        if (extra > 0)
            tooMany(statement, out, extra);
        for (std::size_t i = 0; i < instruction.pins.size(); ++i)
            if (instruction.pins[i].kind != PinKind::Arguments)
                out.operands.push_back(operand(statement, instruction.pins[i], atPin[i], out));
        if (hasArguments && out.isComplete)
            placeArguments(statement, arguments, out);
    }

    /// TS-SBR-04: as many as the subroutine's table has, in its order, temporary variables left out.
    void placeArguments(const Statement& statement, const std::vector<const Operand*>& written, ResolvedStatement& out)
    {
        const auto* name = std::get_if<ResolvedProgramName>(&out.operands.front().value);
        const KnownProgram* program = name ? m_context.findProgram(name->name) : nullptr;
        if (!program)
            return;
        std::vector<const Pin*> pins;
        std::string names;
        for (const KnownParameter& parameter : program->parameters)
            if (parameter.kind != ParameterKind::Temp) {
                pins.push_back(&parameter.pin);
                names += (names.empty() ? "" : " ") + parameter.variable.name;
            }
        if (pins.size() == written.size()) {
            for (std::size_t i = 0; i < pins.size(); ++i)
                out.operands.push_back(operand(statement, *pins[i], written[i], out));
            return;
        }
        const TextRange& range = written.size() > pins.size() ? written[pins.size()]->range : statement.range;
        if (pins.empty())
            m_sink.add(Code::NoParameters, range, {program->name});
        else
            m_sink.add(Code::CallArguments, range, {program->name, std::to_string(pins.size()), std::to_string(written.size()), shortened(names, 120)});
        out.isComplete = false;
    }

    std::size_t pinIndex(const Instruction& instruction, const Operand& operand, ResolvedStatement& out)
    {
        const std::string wanted = upperCase(operand.pin);
        std::string all;
        for (std::size_t i = 0; i < instruction.pins.size(); ++i) {
            if (upperCase(instruction.pins[i].name) == wanted)
                return i;
            all += (i ? ", " : "") + instruction.pins[i].name;
        }
        m_sink.add(Code::UnknownPin, operand.range, {instruction.mnemonic, shortened(operand.pin), all});
        out.isComplete = false;
        return instruction.pins.size();
    }

    void tooMany(const Statement& statement, ResolvedStatement& out, std::size_t extra)
    {
        const Instruction& instruction = *out.instruction;
        const TextRange& range = statement.operands[statement.operands.size() - extra].range;
        m_sink.add(Code::TooManyOperands, range, {instruction.mnemonic, std::to_string(instruction.pins.size()),
            std::to_string(statement.operands.size()), signature(*m_context.dialect, instruction)});
        out.isComplete = false;
    }

    ResolvedOperand operand(const Statement& statement, const Pin& pin, const Operand* written, ResolvedStatement& out)
    {
        const Instruction& instruction = *out.instruction;
        ResolvedOperand result{&pin, std::monostate{}, {}, {}};
        if (!written) {
            if (!pin.optional) {
                if (out.isComplete) // one message a statement
                    m_sink.add(Code::TooFewOperands, statement.range, {instruction.mnemonic, pin.name, signature(*m_context.dialect, instruction)});
                out.isComplete = false;
            }
            return result;
        }
        result.text = written->text;
        result.range = written->range;
        switch (written->kind) {
        case OperandKind::Missing:
            m_sink.add(Code::OperandToFillIn, written->range, {pin.name, instruction.mnemonic});
            out.isComplete = false;
            break;
        case OperandKind::Empty:
            if (pin.optional)
                break;
            m_sink.add(Code::OperandNotOptional, written->range, {pin.name, instruction.mnemonic});
            out.isComplete = false;
            break;
        case OperandKind::Damaged:
            out.isComplete = false;
            break;
        case OperandKind::Text:
            if (auto value = this->value(pin, *written))
                result.value = std::move(*value);
            else
                out.isComplete = false;
            break;
        }
        return result;
    }

    std::optional<ResolvedValue> value(const Pin& pin, const Operand& operand)
    {
        if (pin.kind == PinKind::Program)
            return programName(operand);
        if (pin.kind == PinKind::Interrupt)
            return interruptName(operand);
        if (pin.kind == PinKind::Label)
            return label(operand);
        if (pin.kind == PinKind::Axis)
            return axis(operand);
        const TokenKind form = operandForm(*m_context.dialect, operand.text);
        if (form == TokenKind::Address)
            return address(operand);
        if (m_context.dialect->id == DialectId::KoyoIl && (form == TokenKind::Number || form == TokenKind::TypedConstant))
            return koyoNumber(pin, operand);
        if (auto literal = Literal::read(operand.text))
            return ResolvedValue(std::move(*literal));
        if (form == TokenKind::Symbol)
            return symbol(operand);
        const std::string type(pin.types.isEmpty() ? name(DataType::Int) : name(pin.types.list().front()));
        m_sink.add(Code::BadConstant, operand.range, {shortened(operand.text), type, pin.types.contains(DataType::Real) ? "1.5" : "16#FF"});
        return std::nullopt;
    }

    /// K100, O17. A bare number could mean either, so it is asked what was meant; a pin that counts in BCD takes decimal
    /// digits only.
    std::optional<ResolvedValue> koyoNumber(const Pin& pin, const Operand& operand)
    {
        const auto constant = koyoConstant(operand.text);
        const std::string shown = shortened(operand.text);
        if (!constant) {
            const bool isDecimal = std::all_of(operand.text.begin(), operand.text.end(), isDigit);
            if (isDecimal)
                m_sink.add(Code::NumberWithoutPrefix, operand.range, {shown});
            else
                m_sink.add(Code::BadConstant, operand.range, {shown, std::string(name(pin.mainType)), "K100"});
            return std::nullopt;
        }
        const bool hasDecimalDigits = upperCase(operand.text).find_first_of("ABCDEFO") == std::string::npos;
        if (pin.bcd && !hasDecimalDigits) {
            m_sink.add(Code::NumberNotBcd, operand.range, {shown, pin.name});
            return std::nullopt;
        }
        if (auto literal = Literal::read(*constant))
            return ResolvedValue(std::move(*literal));
        return std::nullopt;
    }

    std::optional<ResolvedValue> address(const Operand& operand)
    {
        auto address = m_family.parseAddress(operand.text, *m_context.model);
        if (address)
            return ResolvedMemory{*address, nullptr, nullptr, {}};
        addMoved(std::move(address).error(), operand);
        return std::nullopt;
    }

    /// A diagnostic about a word alone, put where the word stands.
    void addMoved(Diagnostic diagnostic, const Operand& operand)
    {
        TextRange& range = diagnostic.place.range;
        if (range.isValid()) {
            range.line = range.endLine = operand.range.line;
            range.column += operand.range.column - 1;
            range.endColumn += operand.range.column - 1;
        } else {
            range = operand.range;
        }
        diagnostic.place.object = m_sink.object();
        m_sink.add(std::move(diagnostic));
    }

    /// An array and what stands in its brackets; nothing if the text is not of that form.
    struct Subscripted {
        const KnownVariable* array = nullptr;
        std::string_view subscript;
    };
    std::optional<Subscripted> subscripted(std::string_view text) const
    {
        const std::size_t bracket = text.find('[');
        if (bracket == std::string_view::npos || !text.ends_with(']'))
            return std::nullopt;
        const KnownVariable* array = m_context.findVariable(text.substr(0, bracket));
        if (!array || array->elements == 0 || !array->address)
            return std::nullopt;
        return Subscripted{array, text.substr(bracket + 1, text.size() - bracket - 2)};
    }

    /// The element a constant subscript names, inside the array.
    static std::optional<Address> constantElement(const Subscripted& written)
    {
        std::uint32_t number = 0;
        const char* end = written.subscript.data() + written.subscript.size();
        const auto read = std::from_chars(written.subscript.data(), end, number);
        if (read.ec != std::errc{} || read.ptr != end || number >= written.array->elements)
            return std::nullopt;
        Address out = *written.array->address;
        out.byte += number * byteWidth(written.array->type);
        return out;
    }

    /// array[3], array[index], array[index[5]] (TS-IDX-01 … 05). The index is an INT or DINT variable, no soft element.
    std::optional<ResolvedValue> element(const Operand& operand)
    {
        const auto written = subscripted(operand.text);
        if (!written) {
            m_sink.add(Code::UnknownName, operand.range, {shortened(operand.text)});
            return std::nullopt;
        }
        const bool isConstant = !written->subscript.empty() && std::all_of(written->subscript.begin(), written->subscript.end(), isDigit);
        if (isConstant) {
            if (const auto address = constantElement(*written))
                return ResolvedMemory{*address, written->array, nullptr, {}};
            m_sink.add(Code::SubscriptOutOfRange, operand.range, {std::string(written->subscript), written->array->name,
                std::to_string(written->array->elements - 1)});
            return std::nullopt;
        }
        const KnownVariable* index = m_context.findVariable(written->subscript);
        std::optional<Address> place = index && index->elements == 0 ? index->address : std::nullopt;
        if (const auto inner = subscripted(written->subscript)) {
            index = inner->array;
            place = constantElement(*inner);
        }
        if (place && (index->type == DataType::Int || index->type == DataType::Dint))
            return ResolvedMemory{*written->array->address, written->array, index, *place};
        m_sink.add(Code::BadSubscript, operand.range, {shortened(written->subscript)});
        return std::nullopt;
    }

    /// A variable of the program's own table: IN1, or as the manual writes it #IN1 (TS-IL-03).
    const KnownVariable* local(std::string_view text) const
    {
        if (text.starts_with('#'))
            text = trimmed(text.substr(1));
        for (const KnownParameter& parameter : *m_locals)
            if (parameter.variable.name == text)
                return &parameter.variable;
        return nullptr;
    }

    std::optional<ResolvedValue> symbol(const Operand& operand)
    {
        if (const KnownVariable* variable = local(operand.text))
            return ResolvedMemory{*variable->address, variable, nullptr, {}};
        if (operand.text.find('[') != std::string::npos)
            return element(operand);
        if (const KnownVariable* variable = m_context.findVariable(operand.text)) {
            if (variable->elements > 0) {
                m_sink.add(Code::ArrayNeedsSubscript, operand.range, {shortened(operand.text)});
                return std::nullopt;
            }
            if (variable->address)
                return ResolvedMemory{*variable->address, variable, nullptr, {}};
            m_sink.add(Code::VariableWithoutAddress, operand.range, {variable->name});
            m_sink.relate(variable->place);
            return std::nullopt;
        }
        if (m_context.dialect->commaSeparated && lacksPercent(operand.text))
            return address(operand);
        const std::string shown = shortened(operand.text);
        if (const std::string latin = withLatinLetters(operand.text); latin != operand.text) {
            const TokenKind form = operandForm(*m_context.dialect, latin);
            if (form != TokenKind::Symbol || lacksPercent(latin) || m_context.findVariable(latin)) {
                m_sink.add(Code::LookalikeLetters, operand.range, {shown, firstLookalike(operand.text), latin});
                return std::nullopt;
            }
        }
        std::vector<std::string_view> names;
        if (m_nearSearches++ < MaximumNearSearches)
            for (const KnownVariable& variable : m_context.variables)
                names.push_back(variable.name);
        if (const std::string near = nearestName(operand.text, names); !near.empty())
            m_sink.add(Code::UnknownNameNear, operand.range, {shown, near});
        else
            m_sink.add(Code::UnknownName, operand.range, {shown});
        return std::nullopt;
    }

    std::optional<ResolvedValue> programName(const Operand& operand)
    {
        const KnownProgram* program = m_context.findProgram(operand.text);
        if (!program && m_context.dialect->id == DialectId::KoyoIl)
            program = m_context.findSubroutine(upperCase(operand.text));
        const std::string shown = shortened(operand.text);
        if (program && program->role == ProgramRole::Subroutine) {
            if (m_role != ProgramRole::Interrupt || m_family.id() != "invt")
                return ResolvedProgramName{program->name};
            m_sink.add(Code::CallInInterrupt, operand.range, {m_context.model->name, shown}); // TS-SBR-05
            return std::nullopt;
        }
        if (program) {
            m_sink.add(Code::NotASubroutine, operand.range, {shown});
            return std::nullopt;
        }
        std::vector<std::string_view> names;
        for (const KnownProgram& known : m_context.programs)
            if (known.role == ProgramRole::Subroutine)
                names.push_back(known.name);
        if (const std::string near = nearestName(operand.text, names); !near.empty())
            m_sink.add(Code::UnknownSubroutineNear, operand.range, {shown, near});
        else
            m_sink.add(Code::UnknownSubroutine, operand.range, {shown});
        return std::nullopt;
    }

    std::optional<ResolvedValue> interruptName(const Operand& operand)
    {
        const KnownProgram* program = m_context.findProgram(operand.text);
        if (program && program->role == ProgramRole::Interrupt)
            return ResolvedProgramName{program->name};
        m_sink.add(Code::NotAnInterrupt, operand.range, {shortened(operand.text)});
        return std::nullopt;
    }

    std::optional<ResolvedValue> label(const Operand& operand)
    {
        const TokenKind form = operandForm(*m_context.dialect, operand.text);
        const bool isNumber = std::all_of(operand.text.begin(), operand.text.end(), isDigit);
        if (form == TokenKind::Symbol || isNumber)
            return ResolvedLabel{upperCase(operand.text)};
        m_sink.add(Code::UnknownLabel, operand.range, {shortened(operand.text)});
        return std::nullopt;
    }

    std::optional<ResolvedValue> axis(const Operand& operand)
    {
        if (const KnownAxis* axis = m_context.findAxis(std::string_view(operand.text)))
            return ResolvedValue(*Literal::read(std::to_string(axis->number)));
        if (operandForm(*m_context.dialect, operand.text) == TokenKind::Address)
            return address(operand);
        if (auto literal = Literal::read(operand.text); literal && literal->types().contains(DataType::Int))
            return ResolvedValue(std::move(*literal));
        m_sink.add(Code::UnknownAxis, operand.range, {shortened(operand.text)});
        return std::nullopt;
    }

    /// Comparing with every variable is slow; a text of another kind has thousands of unknown names.
    static constexpr unsigned MaximumNearSearches = 20;

    const LanguageContext& m_context;
    const Family& m_family;
    DiagnosticSink m_sink;
    ProgramRole m_role;
    std::shared_ptr<const std::vector<KnownParameter>> m_locals = std::make_shared<const std::vector<KnownParameter>>();
    bool m_complete = true;
    unsigned m_nearSearches = 0;
};

} // namespace

ResolvedProgram resolve(const ParsedProgram& program, ProgramRole role, const LanguageContext& context, Diagnostics& diagnostics)
{
    ResolvedProgram out{program.object, role, program.dialect, {}, !hasErrors(program.diagnostics), {}, {}};
    Resolver resolver(context, program.object, role, diagnostics);
    resolver.declarations(program.declarations, out);
    for (const ParsedNetwork& network : program.networks) {
        ResolvedNetwork resolved{network.number, {}, network.range};
        for (const ParsedRung& rung : network.rungs)
            resolved.rungs.push_back(resolver.rung(rung.rung));
        out.networks.push_back(std::move(resolved));
    }
    out.isComplete = out.isComplete && resolver.isComplete() && !hasErrors(diagnostics);
    return out;
}

} // namespace camwright
