#include "core/language/source/ilwriter.h"

#include "core/language/source/letters.h"

namespace camwright {

namespace {

/// Operands begin in one column where the mnemonic leaves room, as the manuals print it.
constexpr std::size_t OperandColumn = 8;

std::string writeOperand(const Operand& operand)
{
    return operand.pin.empty() ? operand.text : operand.pin + ":=" + operand.text;
}

std::string writeStatement(const Dialect& dialect, const Statement& statement)
{
    std::string out = statement.mnemonic;
    const char* separator = dialect.commaSeparated ? ", " : " ";
    for (std::size_t i = 0; i < statement.operands.size(); ++i) {
        if (i == 0)
            out.append(out.size() < OperandColumn ? OperandColumn - out.size() : 1, ' ');
        else
            out += separator;
        out += writeOperand(statement.operands[i]);
    }
    if (!statement.trailingComment.empty())
        out += "  " + statement.trailingComment;
    return out;
}

std::string withCrlf(const std::string& text)
{
    std::string out;
    for (const char c : text) {
        if (c == '\n' && !out.ends_with('\r'))
            out += '\r';
        out += c;
    }
    return out;
}

void append(std::string& out, const std::string& piece, bool startsLine)
{
    if (startsLine && !out.empty() && !out.ends_with('\n') && !piece.empty())
        out += '\n';
    out += piece;
}

} // namespace

std::string writeRung(const Dialect& dialect, const Rung& rung)
{
    std::string out;
    for (const Statement& statement : rung.statements) {
        for (const std::string& comment : statement.leadingComments)
            out += comment + '\n';
        out += writeStatement(dialect, statement) + '\n';
    }
    for (const std::string& comment : rung.closingComments)
        out += comment + '\n';
    return out;
}

std::string writeIl(const ParsedProgram& program)
{
    std::string out = program.prologue;
    for (const ParsedNetwork& network : program.networks) {
        out += network.header;
        for (const ParsedRung& rung : network.rungs) {
            if (!rung.edited) {
                out += rung.source;
                continue;
            }
            const std::string text = writeRung(dialect(program.dialect), rung.rung);
            append(out, program.crlf ? withCrlf(text) : text, true);
        }
        out += network.tail;
    }
    return out + program.epilogue;
}

} // namespace camwright
