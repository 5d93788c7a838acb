#pragma once

#include "core/language/source/rung.h"

#include <optional>
#include <string>
#include <string_view>

namespace camwright {

/// What is special about the mnemonics of the Koyo DL205. One mnemonic means several instructions there: `OUT C0` is a
/// coil, `OUT V1400` stores the accumulator, `STR C0` is a contact, `STR V1400 K5` compares. Its operands decide.

/// Gives a statement the role and form its operands ask for. To be called once they are read.
void settleKoyoStatement(Statement& statement);

/// The catalogue's mnemonic of a statement: "OUTW" for OUT with a word, "STR>=" for STR with two operands, "ML_PRRD" for
/// IB-2001. The mnemonic itself where it stands in the catalogue under its own name.
std::string koyoCatalogueName(std::string_view mnemonic, StatementRole role, ContactForm form);
/// The same of a mnemonic alone, as completion and tool tips meet it.
std::string koyoCatalogueName(std::string_view mnemonic);

/// How many flows the instruction takes: 2 for CNT, TMRA and TMRAF, 3 for UDC, else 1.
unsigned koyoFlowsOf(std::string_view mnemonic);

/// Whether a rung of its own begins with it wherever it stands: SBR, RT, NEXT.
bool standsAlone(std::string_view mnemonic);

/// K100 (decimal or hex digits, as they lie in memory), O10000 (octal): the constant in the common notation, "16#100",
/// "8#10000". Nothing for anything else.
std::optional<std::string> koyoConstant(std::string_view text);

/// The number of a subroutine's text, as its SBR says it: "K3"; empty if it does not begin with one.
std::string subroutineNumber(std::string_view text);

} // namespace camwright
