#include "core/language/st/check/standard.h"

namespace camwright::st {

namespace {

struct Row {
    std::string_view name;
    Standard standard;
};

constexpr Row Rows[] = {
    {"ABS", Standard::Abs}, {"SQRT", Standard::Sqrt}, {"ADD", Standard::Add}, {"SUB", Standard::Sub}, {"MUL", Standard::Mul},
    {"DIV", Standard::Div}, {"MOD", Standard::Mod}, {"MOVE", Standard::Move}, {"SHL", Standard::Shl},
    {"SHR", Standard::Shr}, {"ROL", Standard::Rol}, {"ROR", Standard::Ror}, {"AND", Standard::And}, {"OR", Standard::Or},
    {"XOR", Standard::Xor}, {"NOT", Standard::Not}, {"SEL", Standard::Sel}, {"MAX", Standard::Max}, {"MIN", Standard::Min},
    {"LIMIT", Standard::Limit}, {"MUX", Standard::Mux}, {"GT", Standard::Gt}, {"GE", Standard::Ge}, {"EQ", Standard::Eq},
    {"LE", Standard::Le}, {"LT", Standard::Lt}, {"NE", Standard::Ne}, {"TRUNC", Standard::Trunc}, {"REF", Standard::Ref},
    {"ADD_TIME", Standard::Add}, {"SUB_TIME", Standard::Sub}, {"ADD_LTIME", Standard::Add}, {"SUB_LTIME", Standard::Sub},
    {"MUL_TIME", Standard::Mul}, {"DIV_TIME", Standard::Div}, {"MUL_LTIME", Standard::Mul}, {"DIV_LTIME", Standard::Div},
    {"ADD_TOD_TIME", Standard::Add}, {"ADD_DT_TIME", Standard::Add}, {"SUB_DATE_DATE", Standard::Sub}, {"SUB_TOD_TIME", Standard::Sub},
    {"SUB_TOD_TOD", Standard::Sub}, {"SUB_DT_TIME", Standard::Sub}, {"SUB_DT_DT", Standard::Sub}, {"CAMWRIGHT_NOW", Standard::Now},
    {"SIN", Standard::Sin}, {"COS", Standard::Cos}, {"TAN", Standard::Tan}, {"ASIN", Standard::Asin}, {"ACOS", Standard::Acos},
    {"ATAN", Standard::Atan}, {"ATAN2", Standard::Atan2}, {"EXP", Standard::Exp}, {"LN", Standard::Ln}, {"LOG", Standard::Log},
    {"EXPT", Standard::Expt},
};

struct LongName {
    std::string_view name;
    Elementary elementary;
};

constexpr LongName LongNames[] = {
    {"TIME_OF_DAY", Elementary::Tod}, {"DATE_AND_TIME", Elementary::Dt}, {"LTIME_OF_DAY", Elementary::Ltod}, {"LDATE_AND_TIME", Elementary::Ldt},
};

std::uint32_t findConversion(std::string_view name, std::string_view separator, bool truncates)
{
    for (std::size_t at = 0; at + separator.size() < name.size(); ++at) {
        if (!isSameName(name.substr(at, separator.size()), separator))
            continue;
        const Elementary from = findElementary(name.substr(0, at));
        const Elementary to = findElementary(name.substr(at + separator.size()));
        if (from != Elementary::None && to != Elementary::None)
            return conversionNumber(from, to, truncates);
    }
    return 0;
}

constexpr std::string_view Blocks = R"(
FUNCTION_BLOCK TON VAR_INPUT IN : BOOL; PT : TIME; END_VAR VAR_OUTPUT Q : BOOL; ET : TIME; END_VAR VAR RUNNING : BOOL; START : LINT; END_VAR
  IF NOT IN THEN
    Q := FALSE; RUNNING := FALSE; ET := T#0s;
  ELSIF RUNNING THEN
    ET := CAMWRIGHT_ELAPSED(START);
    IF ET >= PT THEN ET := PT; Q := TRUE; RUNNING := FALSE; END_IF;
  ELSIF NOT Q THEN
    RUNNING := TRUE; START := CAMWRIGHT_NOW(); ET := T#0s;
    IF PT <= T#0s THEN ET := PT; Q := TRUE; RUNNING := FALSE; END_IF;
  END_IF;
END_FUNCTION_BLOCK
FUNCTION_BLOCK TOF VAR_INPUT IN : BOOL; PT : TIME; END_VAR VAR_OUTPUT Q : BOOL; ET : TIME; END_VAR VAR RUNNING : BOOL; START : LINT; END_VAR
  IF IN THEN
    Q := TRUE; RUNNING := FALSE; ET := T#0s;
  ELSIF RUNNING THEN
    ET := CAMWRIGHT_ELAPSED(START);
    IF ET >= PT THEN ET := PT; Q := FALSE; RUNNING := FALSE; END_IF;
  ELSIF Q THEN
    RUNNING := TRUE; START := CAMWRIGHT_NOW(); ET := T#0s;
    IF PT <= T#0s THEN ET := PT; Q := FALSE; RUNNING := FALSE; END_IF;
  END_IF;
END_FUNCTION_BLOCK
FUNCTION_BLOCK TP VAR_INPUT IN : BOOL; PT : TIME; END_VAR VAR_OUTPUT Q : BOOL; ET : TIME; END_VAR VAR BEFORE : BOOL; START : LINT; END_VAR
  IF Q THEN
    ET := CAMWRIGHT_ELAPSED(START);
    IF ET >= PT THEN ET := PT; Q := FALSE; END_IF;
  ELSIF IN AND NOT BEFORE THEN
    START := CAMWRIGHT_NOW(); ET := T#0s; Q := PT > T#0s;
  END_IF;
  IF NOT Q AND NOT IN THEN ET := T#0s; END_IF;
  BEFORE := IN;
END_FUNCTION_BLOCK
FUNCTION CAMWRIGHT_ELAPSED : TIME VAR_INPUT START : LINT; END_VAR VAR SPAN : LINT; END_VAR
  SPAN := (CAMWRIGHT_NOW() - START) / 1000000;
  IF SPAN > 2147483647 THEN SPAN := 2147483647; ELSIF SPAN < 0 THEN SPAN := 0; END_IF;
  CAMWRIGHT_ELAPSED := DINT_TO_TIME(LINT_TO_DINT(SPAN));
END_FUNCTION
FUNCTION_BLOCK R_TRIG VAR_INPUT CLK : BOOL; END_VAR VAR_OUTPUT Q : BOOL; END_VAR VAR M : BOOL; END_VAR
  Q := CLK AND NOT M; M := CLK;
END_FUNCTION_BLOCK
FUNCTION_BLOCK F_TRIG VAR_INPUT CLK : BOOL; END_VAR VAR_OUTPUT Q : BOOL; END_VAR VAR M : BOOL; END_VAR
  Q := NOT CLK AND M; M := CLK;
END_FUNCTION_BLOCK
FUNCTION_BLOCK SR VAR_INPUT S1 : BOOL; R : BOOL; END_VAR VAR_OUTPUT Q1 : BOOL; END_VAR
  Q1 := S1 OR (NOT R AND Q1);
END_FUNCTION_BLOCK
FUNCTION_BLOCK RS VAR_INPUT S : BOOL; R1 : BOOL; END_VAR VAR_OUTPUT Q1 : BOOL; END_VAR
  Q1 := NOT R1 AND (S OR Q1);
END_FUNCTION_BLOCK
)";

constexpr std::string_view CounterPattern = R"(
FUNCTION_BLOCK CTU@ VAR_INPUT CU : BOOL; R : BOOL; PV : #; END_VAR VAR_OUTPUT Q : BOOL; CV : #; END_VAR VAR M : BOOL; END_VAR
  IF R THEN CV := 0; ELSIF CU AND NOT M AND CV < PV THEN CV := CV + 1; END_IF;
  M := CU; Q := CV >= PV;
END_FUNCTION_BLOCK
FUNCTION_BLOCK CTD@ VAR_INPUT CD : BOOL; LD : BOOL; PV : #; END_VAR VAR_OUTPUT Q : BOOL; CV : #; END_VAR VAR M : BOOL; END_VAR
  IF LD THEN CV := PV; ELSIF CD AND NOT M AND CV > 0 THEN CV := CV - 1; END_IF;
  M := CD; Q := CV <= 0;
END_FUNCTION_BLOCK
FUNCTION_BLOCK CTUD@ VAR_INPUT CU : BOOL; CD : BOOL; R : BOOL; LD : BOOL; PV : #; END_VAR VAR_OUTPUT QU : BOOL; QD : BOOL; CV : #; END_VAR VAR MU : BOOL; MD : BOOL; END_VAR
  IF R THEN CV := 0;
  ELSIF LD THEN CV := PV;
  ELSIF CU AND NOT MU AND CD AND NOT MD THEN ;
  ELSIF CU AND NOT MU AND CV < PV THEN CV := CV + 1;
  ELSIF CD AND NOT MD AND CV > 0 THEN CV := CV - 1;
  END_IF;
  MU := CU; MD := CD; QU := CV >= PV; QD := CV <= 0;
END_FUNCTION_BLOCK
)";

std::string makeBlocks()
{
    std::string out(Blocks);
    for (const std::string_view type : {"INT", "DINT", "LINT", "UDINT", "ULINT", ""}) {
        for (const char c : CounterPattern) {
            if (c == '@')
                out += type.empty() ? std::string() : "_" + std::string(type);
            else if (c == '#')
                out += type.empty() ? "INT" : type;
            else
                out += c;
        }
    }
    return out;
}

} // namespace

Elementary findElementary(std::string_view name)
{
    for (unsigned e = 1; e <= static_cast<unsigned>(Elementary::Ldt); ++e) {
        if (isSameName(elementaryName(static_cast<Elementary>(e)), name))
            return static_cast<Elementary>(e);
    }
    for (const LongName& row : LongNames) {
        if (isSameName(row.name, name))
            return row.elementary;
    }
    return Elementary::None;
}

std::uint32_t findStandard(std::string_view name)
{
    for (const Row& row : Rows) {
        if (isSameName(row.name, name))
            return static_cast<std::uint32_t>(row.standard);
    }
    const auto generic = [&](std::string_view prefix, bool truncates) -> std::uint32_t {
        if (name.size() <= prefix.size() || !isSameName(name.substr(0, prefix.size()), prefix))
            return 0;
        const Elementary to = findElementary(name.substr(prefix.size()));
        return to == Elementary::None ? 0 : conversionNumber(Elementary::None, to, truncates);
    };
    if (const std::uint32_t found = generic("TO_", false))
        return found;
    if (const std::uint32_t found = generic("TRUNC_", true))
        return found;
    if (const std::uint32_t found = findConversion(name, "_TO_", false))
        return found;
    return findConversion(name, "_TRUNC_", true);
}

std::string_view standardBlocks()
{
    static const std::string blocks = makeBlocks();
    return blocks;
}

} // namespace camwright::st
