#include "core/language/assist/quickfix.h"

#include "core/language/assist/fixscene.h"
#include "core/language/assist/freememory.h"
#include "core/language/check/operandtypes.h"
#include "core/language/source/letters.h"
#include "core/language/source/operandtext.h"

#include <algorithm>
#include <charconv>

namespace camwright {

namespace {

constexpr const char* WriteInPlace = CW_TEXT("QuickFix", "Write %2 in place of %1");

/// The range of the problem, or the word it begins in, if that is what the problem's first argument shows.
std::optional<TextRange> rangeOfFirstArgument(const FixScene& scene)
{
    if (shortened(scene.textAt(scene.range())) == scene.argument(1))
        return scene.range();
    const std::uint32_t line = scene.range().line;
    for (const Token& token : scene.tokensOf(line)) {
        const TextRange range{line, token.column + 1, line, token.column + token.length + 1};
        if (scene.range().column >= range.column && scene.range().column < range.endColumn && shortened(scene.textAt(range)) == scene.argument(1))
            return range;
    }
    return std::nullopt;
}

template <std::size_t N>
void writeArgument(FixScene& scene)
{
    // An argument that was cut for the sentence is no text to write.
    if (const auto range = rangeOfFirstArgument(scene); range && !scene.argument(N).empty() && !scene.argument(N).ends_with("…"))
        scene.replace(WriteInPlace, *range, scene.argument(N));
}

void unescape(FixScene& scene)
{
    const auto range = rangeOfFirstArgument(scene);
    if (!range)
        return;
    const bool isComment = scene.argument(2) == "(* ... *)"; // stands for any
    scene.replace(WriteInPlace, *range, isComment ? withoutMarkdownEscapes(scene.textAt(*range)) : scene.argument(2));
}

void writeOddByte(FixScene& scene)
{
    writeArgument<2>(scene);
    writeArgument<3>(scene);
}

void removeFence(FixScene& scene)
{
    if (trimmed(scene.lineText(scene.range().line)).starts_with("```"))
        scene.removeLine(CW_TEXT("QuickFix", "Remove the line \"%1\""), scene.range().line);
}

void commentStrayText(FixScene& scene)
{
    const std::string text(scene.textAt(scene.range()));
    const std::size_t begin = scene.offsetOf(scene.range().line, scene.range().column);
    if (text.empty() || shortened(text) != scene.argument(1))
        return;
    if (text.find("*)") == std::string::npos)
        scene.offer(CW_TEXT("QuickFix", "Make a comment of \"%1\""), {shortened(text)}, {{begin, text.size(), "(* " + text + " *)"}});
    scene.offer(CW_TEXT("QuickFix", "Remove \"%1\""), {shortened(text)}, {{begin, text.size(), {}}});
}

void removeOddCharacter(FixScene& scene)
{
    const std::string_view text = scene.textAt(scene.range());
    if (text.empty() || codePointName(characterAt(text, 0).code) != scene.argument(1))
        return;
    const std::size_t begin = scene.offsetOf(scene.range().line, scene.range().column);
    if (isOddBlank(characterAt(text, 0).code))
        scene.offer(CW_TEXT("QuickFix", "Write a plain blank in place of the character %1"), {scene.argument(1)}, {{begin, text.size(), " "}});
    else
        scene.offer(CW_TEXT("QuickFix", "Remove the character %1"), {scene.argument(1)}, {{begin, text.size(), {}}});
}

void removeComma(FixScene& scene)
{
    if (scene.textAt(scene.range()) == ",")
        scene.offer(CW_TEXT("QuickFix", "Write a blank in place of the comma"), {}, {{scene.offsetOf(scene.range().line, scene.range().column), 1, " "}});
}

void fillOperandIn(FixScene& scene)
{
    if (scene.textAt(scene.range()) != ",")
        return;
    const std::size_t comma = scene.offsetOf(scene.range().line, scene.range().column);
    // "MOVE , B" and "A, , B": the comma ends an operand that is not there; "A, B,": it stands before one.
    bool missesBefore = false;
    const Token* last = nullptr;
    const std::vector<Token> tokens = scene.tokensOf(scene.range().line);
    for (const Token& token : tokens) {
        if (token.column + 1 == scene.range().column)
            missesBefore = last && (last->kind == TokenKind::Mnemonic || last->kind == TokenKind::Separator);
        if (token.kind != TokenKind::Comment)
            last = &token;
    }
    const TextEdit edit = missesBefore ? TextEdit{comma, 0, "???"} : TextEdit{comma + 1, 0, " ???"};
    scene.offer(CW_TEXT("QuickFix", "Write ??? for the operand, to be filled in later"), {}, {edit});
}

void addOperands(FixScene& scene)
{
    const auto found = scene.statement();
    if (!found)
        return;
    const Statement& statement = scene.at(*found);
    const Instruction* instruction = scene.context.family->catalogue().find(statement.mnemonic);
    const auto named = [](const Operand& operand) { return !operand.pin.empty(); };
    if (!instruction || std::ranges::any_of(statement.operands, named) || statement.operands.size() >= instruction->requiredPins())
        return;
    const bool commas = scene.context.dialect->commaSeparated;
    std::string text, pins;
    for (std::size_t i = statement.operands.size(); i < instruction->requiredPins(); ++i) {
        text += i == 0 ? " ???" : commas ? ", ???" : " ???";
        pins += (pins.empty() ? "" : ", ") + instruction->pins[i].name;
    }
    const std::size_t end = scene.offsetOf(statement.range.endLine, statement.range.endColumn);
    scene.offer(CW_TEXT("QuickFix", "Add %1 as ???, to be filled in later"), {pins}, {{end, 0, text}});
}

void removeOperands(FixScene& scene)
{
    for (const ParsedNetwork& network : scene.parsed().networks)
        for (const ParsedRung& rung : network.rungs)
            for (const Statement& statement : rung.rung.statements)
                for (std::size_t i = 1; i < statement.operands.size(); ++i) {
                    if (statement.operands[i].range != scene.range())
                        continue;
                    const TextRange& last = statement.operands[i - 1].range;
                    const std::size_t begin = scene.offsetOf(last.endLine, last.endColumn);
                    const std::size_t end = scene.offsetOf(statement.range.endLine, statement.range.endColumn);
                    scene.offer(CW_TEXT("QuickFix", "Remove \"%1\""), {shortened(trimmed(std::string_view(scene.source).substr(begin, end - begin)))}, {{begin, end - begin, {}}});
                    return;
                }
}

void markOperand(FixScene& scene)
{
    if (scene.textAt(scene.range()) == "_")
        scene.offer(CW_TEXT("QuickFix", "Write ??? for the operand, to be filled in later"), {}, {{scene.offsetOf(scene.range().line, scene.range().column), 1, "???"}});
}

void writeNearPin(FixScene& scene)
{
    const Instruction* instruction = scene.context.family->catalogue().find(scene.argument(1));
    if (!instruction)
        return;
    std::vector<std::string_view> names;
    for (const Pin& pin : instruction->pins)
        names.push_back(pin.name);
    const std::string near = nearestName(scene.argument(2), names);
    const std::uint32_t line = scene.range().line;
    for (const Token& token : scene.tokensOf(line)) {
        const TextRange range{line, token.column + 1, line, token.column + token.length + 1};
        if (token.kind == TokenKind::Pin && !near.empty() && range.column < scene.range().column && shortened(scene.textAt(range)) == scene.argument(2))
            scene.replace(WriteInPlace, range, near);
    }
}

void rewriteConstant(FixScene& scene)
{
    const std::string_view text = scene.textAt(scene.range());
    if (shortened(text) != scene.argument(1))
        return;
    if (scene.argument(3) == std::string(text) + ".0")
        scene.replace(WriteInPlace, scene.range(), scene.argument(3));
    else if (scene.argument(3) == "TRUE" && (text == "0" || text == "1"))
        scene.replace(WriteInPlace, scene.range(), text == "1" ? "TRUE" : "FALSE");
}

/// An integer beside a REAL is meant as one.
void makeConstantReal(FixScene& scene)
{
    const auto found = scene.operand();
    if (!found.operand || (scene.argument(2) != "REAL" && scene.argument(4) != "REAL"))
        return;
    for (const ResolvedOperand& operand : found.statement->operands) {
        const bool isInteger = std::holds_alternative<Literal>(operand.value) && operand.text.find_first_not_of("-0123456789") == std::string::npos;
        if (isInteger && operand.pin->typeGroup == found.operand->pin->typeGroup && scene.textAt(operand.range) == operand.text)
            scene.replace(WriteInPlace, operand.range, operand.text + ".0");
    }
}

void limitConstant(FixScene& scene)
{
    const auto literal = Literal::read(scene.textAt(scene.range()));
    const auto value = literal ? literal->as(literal->types().contains(DataType::Dint) ? DataType::Dint : preferredType(literal->types()))
                               : Result<Value>(diagnostic(Code::InternalError));
    if (!value || shortened(scene.textAt(scene.range())) != scene.argument(1))
        return;
    for (const auto& [limit, isLow] : {std::pair{scene.argument(4), true}, {scene.argument(5), false}}) {
        double bound = 0;
        const auto [end, error] = std::from_chars(limit.data(), limit.data() + limit.size(), bound);
        if (error == std::errc{} && end == limit.data() + limit.size() && (isLow ? value->asDouble() < bound : value->asDouble() > bound))
            scene.replace(WriteInPlace, scene.range(), limit);
    }
}

void writeNearAxis(FixScene& scene)
{
    std::vector<std::string_view> names;
    for (const KnownAxis& axis : scene.context.axes)
        names.push_back(axis.name);
    if (const std::string near = nearestName(scene.argument(1), names); !near.empty() && shortened(scene.textAt(scene.range())) == scene.argument(1))
        scene.replace(WriteInPlace, scene.range(), near);
}

/// Names a table or a program takes without further questions.
bool isPlainName(std::string_view name)
{
    const auto isWord = [](char c) { return isAsciiLetter(c) || isDigit(c) || c == '_' || !isAscii(c); };
    return !name.empty() && !isDigit(name.front()) && name.front() != '_' && std::ranges::all_of(name, isWord);
}

/// The type of a name that is not known yet: what its pin wants, and what stands at the pins that share its type.
DataType wantedType(const FixScene& scene, const FixScene::FoundOperand& found)
{
    const Pin& pin = *found.operand->pin;
    TypeSet types = pin.types;
    for (const ResolvedOperand& other : found.statement->operands) {
        const auto* memory = std::get_if<ResolvedMemory>(&other.value);
        if (memory && pin.typeGroup != 0 && other.pin->typeGroup == pin.typeGroup)
            if (types.contains(memory->address.type))
                return memory->address.type;
    }
    const DataType type = types.contains(pin.mainType) && scene.context.dialect->id == DialectId::Ts600Il ? pin.mainType : preferredType(types);
    return type;
}

Object withVariable(const Project& project, const Variable& variable)
{
    const auto tables = project.objects(ObjectKind::VariableTable);
    if (tables.empty())
        return {{ObjectKind::VariableTable, "Globals"}, project.nextOrder(ObjectKind::VariableTable), VariableTable::of({variable}), {}};
    Object out = *tables.front();
    auto& table = std::get<VariableTable>(out.content);
    table = table.replaced(table.rowCount(), 0, {variable});
    return out;
}

void declareVariable(FixScene& scene)
{
    const auto found = scene.operand();
    if (!found.operand || !isPlainName(found.operand->text) || shortened(found.operand->text) != scene.argument(1) || scene.context.findVariable(found.operand->text))
        return;
    const Pin& pin = *found.operand->pin;
    if (pin.kind != PinKind::Value || pin.areas.empty() || pin.types.isEmpty())
        return;
    Variable variable;
    variable.name = found.operand->text;
    const DataType type = wantedType(scene, found);
    variable.type = type;
    if (scene.context.dialect->id != DialectId::Ts600Il) { // TS600 finds a place by itself
        const auto address = FreeMemory(scene.project, scene.context).takeFor(&pin, type);
        if (!address)
            return;
        variable.address = scene.context.family->formatAddress(*address);
    }
    Object table = withVariable(scene.project, variable);
    std::string where = table.key.name;
    if (variable.address.empty())
        scene.offer(CW_TEXT("QuickFix", "Declare %1 as %2 in the table \"%3\""), {variable.name, std::string(name(type)), std::move(where)}, {}, {std::move(table)});
    else
        scene.offer(CW_TEXT("QuickFix", "Declare %1 as %2 at %4 in the table \"%3\""),
            {variable.name, std::string(name(type)), std::move(where), variable.address}, {}, {std::move(table)});
}

void nearOrDeclare(FixScene& scene)
{
    writeArgument<2>(scene);
    declareVariable(scene);
}

void addSubroutine(FixScene& scene)
{
    const std::string name(scene.textAt(scene.range()));
    if (!isPlainName(name) || shortened(name) != scene.argument(1) || scene.context.findProgram(name))
        return;
    Program program;
    program.role = ProgramRole::Subroutine;
    if (scene.context.dialect->networkHeaders)
        program.source = "(* Network " + std::to_string(scene.context.dialect->firstNetwork) + " *)\n";
    scene.offer(CW_TEXT("QuickFix", "Add the subroutine %1"), {name}, {},
        {Object{{ObjectKind::Program, name}, scene.project.nextOrder(ObjectKind::Program), std::move(program), {}}});
}

void nearOrAddSubroutine(FixScene& scene)
{
    writeArgument<2>(scene);
    addSubroutine(scene);
}

void makeSubroutine(FixScene& scene)
{
    const ObjectPtr called = scene.project.find({ObjectKind::Program, std::string(scene.textAt(scene.range()))});
    const auto* program = called ? std::get_if<Program>(&called->content) : nullptr;
    if (!program || program->role != ProgramRole::Interrupt)
        return; // the main program stays one
    Object changed = *called;
    std::get<Program>(changed.content).role = ProgramRole::Subroutine;
    scene.offer(CW_TEXT("QuickFix", "Make %1 a subroutine"), {called->key.name}, {}, {std::move(changed)});
}

/// A row of a table that lacks its address, found by the name the problem tells.
void giveAddress(FixScene& scene)
{
    for (const ObjectPtr& object : scene.project.objects(ObjectKind::VariableTable)) {
        const auto& table = std::get<VariableTable>(object->content);
        for (std::size_t row = 0; row < table.rowCount(); ++row) {
            Variable variable = table.row(row);
            if (variable.name != scene.argument(1) || !variable.type.isValid())
                continue;
            const auto address = FreeMemory(scene.project, scene.context).takeFor(nullptr, variable.type.value());
            if (!address)
                return;
            variable.address = scene.context.family->formatAddress(*address);
            Object changed = *object;
            std::get<VariableTable>(changed.content) = table.replaced(row, 1, {variable});
            scene.offer(CW_TEXT("QuickFix", "Put %1 at %2, which nothing uses"), {variable.name, variable.address}, {}, {std::move(changed)});
            return;
        }
    }
}

struct FixRule {
    Code code;
    void (*offer)(FixScene&);
};

constexpr FixRule Rules[] = {
    {Code::UnterminatedComment, fixOpenComment},
    {Code::CommentOpenAtEnd, fixOpenComment},
    {Code::StrayText, commentStrayText},
    {Code::MarkdownEscape, unescape},
    {Code::MarkdownFence, removeFence},
    {Code::LookalikeLetters, writeArgument<3>},
    {Code::StrayLetters, writeArgument<2>},
    {Code::ConstantHasBlanks, writeArgument<2>},
    {Code::OddCharacter, removeOddCharacter},
    {Code::MissingComma, writeArgument<2>},
    {Code::UnexpectedComma, removeComma},
    {Code::OperandLeftOut, fillOperandIn},
    {Code::StatementBeforeNetwork, fixStatementBeforeNetwork},
    {Code::NetworkNumber, fixNetworkNumber},
    {Code::TextAfterEnd, fixTextAfterEnd},
    {Code::RungNeedsLoad, fixMissingLoad},
    {Code::SecondLoad, fixSecondLoad},
    {Code::NothingToJoin, fixUnusedJoin},
    {Code::BranchNotOpen, fixUnusedJoin},
    {Code::BranchNotClosed, fixOpenBranch},
    {Code::GroupNotClosed, fixOpenGroup},
    {Code::GroupNotOpen, fixUnusedJoin},
    {Code::FlowLeftOver, fixUnusedFlow},
    {Code::GroupNotInFamily, fixForeignGroup},
    {Code::UnknownInstructionNear, writeArgument<3>},
    {Code::TooFewOperands, addOperands},
    {Code::TooManyOperands, removeOperands},
    {Code::NoParameters, removeOperands},
    {Code::OperandNotOptional, markOperand},
    {Code::UnknownPin, writeNearPin},
    {Code::TypesDiffer, makeConstantReal},
    {Code::BadConstant, rewriteConstant},
    {Code::ConstantOutOfRange, limitConstant},
    {Code::UnknownName, declareVariable},
    {Code::UnknownNameNear, nearOrDeclare},
    {Code::UnknownSubroutine, addSubroutine},
    {Code::UnknownSubroutineNear, nearOrAddSubroutine},
    {Code::NotASubroutine, makeSubroutine},
    {Code::UnknownAxis, writeNearAxis},
    {Code::VariableWithoutAddress, giveAddress},
    {Code::AddressMissing, giveAddress},
    {Code::AddressMissingPercent, writeArgument<2>},
    {Code::AddressOddByte, writeOddByte},
};

const FixRule* ruleOf(Code code)
{
    const auto* rule = std::ranges::find(Rules, code, &FixRule::code);
    return rule == std::end(Rules) ? nullptr : rule;
}

} // namespace

bool hasQuickFixes(Code code)
{
    return ruleOf(code) != nullptr;
}

std::vector<QuickFix> quickFixes(const Project& project, const Diagnostic& problem)
{
    const FixRule* rule = ruleOf(problem.code);
    const auto context = rule ? contextOf(project) : std::nullopt;
    if (!context)
        return {};
    FixScene scene(project, *context, problem);
    if (problem.place.object.kind == ObjectKind::Program && (scene.source.empty() || !problem.place.range.isValid()))
        return {};
    rule->offer(scene);
    return std::move(scene.fixes);
}

std::string applied(const std::string& source, const std::vector<TextEdit>& edits)
{
    std::string out;
    std::size_t at = 0;
    for (const TextEdit& edit : edits) {
        if (edit.offset < at || edit.offset + edit.length > source.size())
            continue;
        out.append(source, at, edit.offset - at);
        out += edit.text;
        at = edit.offset + edit.length;
    }
    return out.append(source, at);
}

Project applied(const Project& project, const ObjectKey& program, const QuickFix& fix)
{
    Project out = project;
    if (const auto* content = project.content<Program>(program); content && !fix.edits.empty()) {
        Program changed = *content;
        changed.source = applied(content->source, fix.edits);
        out = out.withContent(program, std::move(changed));
    }
    for (const Object& object : fix.objects)
        out = out.with(object.key, std::make_shared<const Object>(object));
    return out;
}

} // namespace camwright
