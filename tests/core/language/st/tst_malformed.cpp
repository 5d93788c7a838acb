#include "core/language/st/check/checker.h"

#include <gtest/gtest.h>

#include <chrono>
#include <fstream>
#include <sstream>

using namespace camwright;

namespace {

Diagnostics errorsOf(const std::string& text)
{
    const st::Environment environment;
    const auto compilation = st::check({{{ObjectKind::Program, "Main"}, text, true}}, environment);
    Diagnostics out;
    for (const Diagnostic& d : compilation->diagnostics[0]) {
        if (d.severity() == Severity::Error)
            out.push_back(d);
    }
    EXPECT_TRUE(compilation->diagnostics[1].empty()) << "the standard library: " << englishLine(compilation->diagnostics[1].front());
    return out;
}

std::string said(const Diagnostics& errors)
{
    std::string out;
    for (const Diagnostic& d : errors)
        out += "  " + std::to_string(d.place.range.line) + ":" + std::to_string(d.place.range.column) + " " + englishText(d) + "\n";
    return out;
}

/// One mistake, one message, with this code and at this place.
void expectOne(const std::string& text, const std::string& code, std::uint32_t line, std::uint32_t column)
{
    const Diagnostics errors = errorsOf(text);
    ASSERT_EQ(errors.size(), 1u) << text << "\n" << said(errors);
    EXPECT_EQ(codeInfo(errors[0].code).id, code) << text << "\n" << said(errors);
    EXPECT_EQ(errors[0].place.range.line, line) << text << "\n" << said(errors);
    EXPECT_EQ(errors[0].place.range.column, column) << text << "\n" << said(errors);
}

constexpr const char* Declarations = "PROGRAM Main\nVAR a, b, c : INT; q, p : BOOL; r : REAL; d : DINT; arr : ARRAY [0..9] OF INT; t : TON; tm : TIME; w : WORD; lr : LREAL; END_VAR\n";

/// Statements in a program; they begin in line 3.
struct StatementRow {
    const char* statements;
    const char* code;
    std::uint32_t line;
    std::uint32_t column;
};

constexpr StatementRow StatementRows[] = {
    {"a := 1\nb := 2;", "CW8102", 3, 7},
    {"a := 1;\nb := 2\nc := 3;", "CW8102", 4, 7},
    {"a := b +;\nc := 1;", "CW8101", 3, 9},
    {"a := ;\nc := 1;", "CW8101", 3, 6},
    {"a := (b + 1;\nc := 1;", "CW8101", 3, 12},
    {"a := b + 1);\nc := 1;", "CW8101", 3, 11},
    {"a := arr[1;\nc := 1;", "CW8101", 3, 11},
    {"a := arr 1];\nc := 1;", "CW8101", 3, 10},
    {"a = 5;\nc := 1;", "CW8117", 3, 3},
    {"a;\nc := 1;", "CW8102", 3, 2},
    {"5 := a;\nc := 1;", "CW8101", 3, 1},
    {"IF q THEN a := 1;\nb := 1;", "CW8103", 3, 1},
    {"IF q a := 1; END_IF;", "CW8102", 3, 5},
    {"IF q THEN a := 1 END_IF;", "CW8102", 3, 17},
    {"IF q THEN a := 1; END_IF\nb := 2;", "CW8102", 3, 25},
    {"IF THEN a := 1; END_IF;", "CW8101", 3, 4},
    {"IF q THEN a := 1; END_WHILE;\nb := 1;", "CW8101", 3, 19},
    {"IF q THEN a := 1; ELSE b := 2;\nc := 3;", "CW8103", 3, 1},
    {"IF q THEN a := 1; ELSIF THEN b := 2; END_IF;", "CW8101", 3, 25},
    {"END_IF;\na := 1;", "CW8104", 3, 1},
    {"ELSE\na := 1;", "CW8104", 3, 1},
    {"a := 1;\nEND_FOR;\nb := 1;", "CW8104", 4, 1},
    {"WHILE q DO a := 1;\nb := 1;", "CW8103", 3, 1},
    {"WHILE q a := 1; END_WHILE;", "CW8102", 3, 8},
    {"WHILE q DO IF p THEN a := 1; END_WHILE;", "CW8103", 3, 12},
    {"FOR a := 1 TO 5 b := 1; END_FOR;", "CW8102", 3, 16},
    {"FOR a := 1 5 DO b := 1; END_FOR;", "CW8101", 3, 12},
    {"FOR a := 1 TO DO b := 1; END_FOR;", "CW8101", 3, 15},
    {"REPEAT a := 1; UNTIL END_REPEAT;", "CW8101", 3, 22},
    {"REPEAT a := 1; END_REPEAT;", "CW8101", 3, 16},
    {"CASE a OF\n1: b := 1;\n2 b := 2;\nEND_CASE;", "CW8101", 5, 3},
    {"CASE a 1: b := 1; END_CASE;", "CW8101", 3, 8},
    {"CASE a OF\n1: b := 1;", "CW8103", 3, 1},
    {"a := 16#3G;", "CW8109", 3, 6},
    {"a := 2#102;", "CW8109", 3, 6},
    {"a := 8#9;", "CW8109", 3, 6},
    {"a := 16#;", "CW8109", 3, 6},
    {"a := 12abc;", "CW8109", 3, 6},
    {"r := 1.5x;", "CW8109", 3, 6},
    {"d := 99999999999999999999;", "CW8110", 3, 6},
    {"d := 16#10000000000000000;", "CW8110", 3, 6},
    {"lr := 1.0E999;", "CW8110", 3, 7},
    {"tm := T#5x;", "CW8111", 3, 7},
    {"tm := T#5m3h;", "CW8111", 3, 7},
    {"tm := T#1.5h3m;", "CW8111", 3, 7},
    {"tm := T#;", "CW8111", 3, 7},
    {"tm := TIME#5;", "CW8111", 3, 7},
    {"tm := T#99999999999d;", "CW8111", 3, 7},
    {"d := D#2026-02-30;", "CW8112", 3, 6},
    {"d := D#2026-13-01;", "CW8112", 3, 6},
    {"d := DATE#1969-01-01;", "CW8112", 3, 6},
    {"d := TOD#24:00:00;", "CW8112", 3, 6},
    {"d := TOD#10:60;", "CW8112", 3, 6},
    {"d := DT#2026-01-01-10;", "CW8112", 3, 6},
    {"d := LDT#2026-01-01;", "CW8112", 3, 6},
    {"tm := T#30d;", "CW8312", 3, 7},
    {"a := 'text;\nb := 1;", "CW8113", 3, 6},
    {"a := \"text;\nb := 1;", "CW8113", 3, 6},
    {"a := 1; (* open\nb := 1;", "CW3019", 3, 9},
    {"a := 1; /* open\nb := 1;", "CW3019", 3, 9},
    {"a := 1; (* one (* two *)\nb := 1;", "CW3019", 3, 9},
    {"a := 1; { pragma\nb := 1;", "CW8114", 3, 9},
    {"a := %;\nb := 1;", "CW8115", 3, 6},
    {"a := b ? c;\nb := 1;", "CW8116", 3, 8},
    {"a := b @ c;\nb := 1;", "CW8116", 3, 8},
    {"a := b $ c;", "CW8116", 3, 8},
    {"a := b ! c;", "CW8116", 3, 8},
    {"a := b ~ c;", "CW8116", 3, 8},
    {"a := b \\ c;", "CW8116", 3, 8},
    {"\xD0\x90 := 1;", "CW3005", 3, 1},
    {"a := 1;\xE2\x80\x8B", "CW3008", 3, 8},
    {"(* \xE2\x80\xAE *) a := 1;", "CW3008", 3, 4},
    {"a := 1; // \xFF", "CW3009", 3, 12},
    {"\xC3\xA9t\xC3\xA9 := 1;", "CW8108", 3, 1},
    {"speed := 1;", "CW8201", 3, 1},
    {"a := arrr[1];", "CW8202", 3, 6},
    {"a := nothing;", "CW8201", 3, 6},
    {"a := Missing(1);", "CW8201", 3, 6},
    {"a := t.DONE;", "CW8205", 3, 6},
    {"a := t.RUNNING;", "CW8205", 3, 6},
    {"a.x := 1;", "CW8205", 3, 1},
    {"IF a THEN b := 1; END_IF;", "CW8302", 3, 4},
    {"IF 5 THEN b := 1; END_IF;", "CW8301", 3, 4},
    {"WHILE r DO b := 1; END_WHILE;", "CW8302", 3, 7},
    {"a := d;", "CW8302", 3, 6},
    {"a := r;", "CW8302", 3, 6},
    {"a := 1.5;", "CW8301", 3, 6},
    {"a := TRUE;", "CW8302", 3, 6},
    {"q := a;", "CW8302", 3, 6},
    {"q := 2;", "CW8301", 3, 6},
    {"tm := 5;", "CW8301", 3, 7},
    {"a := T#5s;", "CW8302", 3, 6},
    {"a := 'x';", "CW8301", 3, 6},
    {"a := NULL;", "CW8301", 3, 6},
    {"a := 32768;", "CW8312", 3, 6},
    {"a := -32769;", "CW8312", 3, 6},
    {"a := INT#40000;", "CW8312", 3, 10},
    {"a := INT#x;", "CW8201", 3, 10},
    {"w := 65536;", "CW8312", 3, 6},
    {"w := -1;", "CW8312", 3, 6},
    {"r := 1.0E39;", "CW8312", 3, 6},
    {"a := b + w;", "CW8303", 3, 6},
    {"q := q + p;", "CW8303", 3, 6},
    {"r := r MOD 2.0;", "CW8303", 3, 6},
    {"q := a AND b;", "CW8303", 3, 6},
    {"q := q < p;", "CW8303", 3, 6},
    {"q := a = q;", "CW8303", 3, 6},
    {"tm := tm * tm;", "CW8303", 3, 7},
    {"tm := tm + 5;", "CW8303", 3, 7},
    {"q := NOT a;", "CW8304", 3, 6},
    {"a := -w;", "CW8304", 3, 6},
    {"q := -q;", "CW8304", 3, 6},
    {"r := q ** 2.0;", "CW8303", 3, 6},
    {"r := SIN(w);", "CW8304", 3, 6},
    {"r := ATAN2(r, q);", "CW8303", 3, 6},
    {"a ?= b;", "CW8323", 3, 1},
    {"a := b / 0;", "CW8315", 3, 10},
    {"a := b MOD 0;", "CW8315", 3, 12},
    {"a(1);", "CW8306", 3, 1},
    {"arr(1);", "CW8306", 3, 1},
    {"a := ABS();", "CW8307", 3, 6},
    {"a := ABS(1, 2);", "CW8307", 3, 6},
    {"a := LIMIT(1, 2);", "CW8307", 3, 6},
    {"a := SEL(q, 1);", "CW8307", 3, 6},
    {"t(INPUT := q);", "CW8308", 3, 3},
    {"t(IN := q, IN := p);", "CW8309", 3, 12},
    {"t(IN := a);", "CW8302", 3, 9},
    {"t(IN := q, Q => 5);", "CW8311", 3, 17},
    {"t(IN := q, Q := p);", "CW8305", 3, 12},
    {"t(IN => q);", "CW8308", 3, 3},
    {"t.Q(1);", "CW8306", 3, 1},
    {"a := t;", "CW8301", 3, 6},
    {"a[1] := 2;", "CW8204", 3, 1},
    {"arr[1, 2] := 2;", "CW8313", 3, 8},
    {"arr[10] := 2;", "CW8314", 3, 5},
    {"arr[-1] := 2;", "CW8314", 3, 5},
    {"arr[r] := 2;", "CW8302", 3, 5},
    {"arr := 5;", "CW8301", 3, 8},
    {"arr[q] := 2;", "CW8302", 3, 5},
    {"a^ := 5;", "CW8204", 3, 1},
    {"CASE a OF 1..5: b := 1; 3: b := 2; END_CASE;", "CW8316", 3, 25},
    {"CASE a OF 1, 1: b := 1; END_CASE;", "CW8316", 3, 14},
    {"CASE a OF 5..1: b := 1; END_CASE;", "CW8207", 3, 11},
    {"CASE r OF 1: b := 1; END_CASE;", "CW8301", 3, 6},
    {"CASE a OF b: b := 1; END_CASE;", "CW8208", 3, 11},
    {"CASE a OF 40000: b := 1; END_CASE;", "CW8312", 3, 11},
    {"FOR r := 1 TO 5 DO b := 1; END_FOR;", "CW8317", 3, 5},
    {"FOR q := FALSE TO TRUE DO b := 1; END_FOR;", "CW8317", 3, 5},
    {"FOR a := 1 TO 5 BY 0 DO b := 1; END_FOR;", "CW8322", 3, 20},
    {"FOR a := 1 TO 5 DO a := 1; END_FOR;", "CW8305", 3, 20},
    {"FOR a := 1 TO r DO b := 1; END_FOR;", "CW8302", 3, 15},
    {"EXIT;", "CW8319", 3, 1},
    {"CONTINUE;", "CW8319", 3, 1},
    {"IF q THEN EXIT; END_IF;", "CW8319", 3, 11},
    {"THIS.x := 1;", "CW8212", 3, 1},
    {"a := [1, 2];", "CW8212", 3, 6},
    {"a := REF(5);", "CW8311", 3, 10},
    {"a := SHL(r, 2);", "CW8304", 3, 6},
    {"a := SQRT(w);", "CW8304", 3, 6},
    {"w := w.16;", "CW8312", 3, 6},
    {"q := r.0;", "CW8205", 3, 6},
    {"Main();", "CW8311", 3, 1},
    {"INT := 5;", "CW8311", 3, 1},
    {"a := INT;", "CW8311", 3, 6},
};

class StMalformedStatementTest : public testing::TestWithParam<StatementRow> {};

TEST_P(StMalformedStatementTest, oneMistakeGivesOneMessageAtItsPlace)
{
    const StatementRow& row = GetParam();
    expectOne(std::string(Declarations) + row.statements + "\nEND_PROGRAM\n", row.code, row.line, row.column);
}

INSTANTIATE_TEST_SUITE_P(Rows, StMalformedStatementTest, testing::ValuesIn(StatementRows));

/// Whole texts.
constexpr StatementRow TextRows[] = {
    {"", "CW8324", 1, 1},
    {"x := 5;\nPROGRAM Main END_PROGRAM", "CW8118", 1, 1},
    {"PROGRAM Main\nVAR x : INT; END_VAR\nx := 1;\n", "CW8103", 1, 9},
    {"PROGRAM\nEND_PROGRAM", "CW8101", 2, 1},
    {"PROGRAM 5\nEND_PROGRAM", "CW8101", 1, 9},
    {"PROGRAM Main VAR x INT; END_VAR END_PROGRAM", "CW8101", 1, 20},
    {"PROGRAM Main VAR x : ; END_VAR END_PROGRAM", "CW8101", 1, 22},
    {"PROGRAM Main VAR x : INT\ny : INT; END_VAR END_PROGRAM", "CW8102", 1, 25},
    {"PROGRAM Main VAR x : INT := ; END_VAR END_PROGRAM", "CW8101", 1, 29},
    {"PROGRAM Main\nVAR x : INT;\nx := 1; END_PROGRAM", "CW8102", 2, 13},
    {"PROGRAM Main VAR x, : INT; END_VAR END_PROGRAM", "CW8101", 1, 21},
    {"PROGRAM Main VAR x : NOTYPE; END_VAR END_PROGRAM", "CW8201", 1, 22},
    {"PROGRAM Main VAR x : Main; END_VAR END_PROGRAM", "CW8204", 1, 22},
    {"PROGRAM Main VAR x : INT; X : BOOL; END_VAR END_PROGRAM", "CW8203", 1, 27},
    {"PROGRAM Main VAR x : ARRAY [9..0] OF INT; END_VAR END_PROGRAM", "CW8207", 1, 29},
    {"PROGRAM Main VAR x : ARRAY [0..] OF INT; END_VAR END_PROGRAM", "CW8101", 1, 32},
    {"PROGRAM Main VAR x : ARRAY OF INT; END_VAR END_PROGRAM", "CW8101", 1, 28},
    {"PROGRAM Main VAR x : ARRAY [0..9] INT; END_VAR END_PROGRAM", "CW8102", 1, 34},
    {"PROGRAM Main VAR n : INT; x : ARRAY [0..n] OF INT; END_VAR END_PROGRAM", "CW8208", 1, 41},
    {"PROGRAM Main VAR x : ARRAY [0..99999999] OF LREAL; END_VAR END_PROGRAM", "CW8207", 1, 29},
    {"PROGRAM Main VAR x : ARRAY [1..9, 1..'a'] OF INT; END_VAR END_PROGRAM", "CW8301", 1, 38},
    {"PROGRAM Main VAR x : STRING[0]; END_VAR END_PROGRAM", "CW8207", 1, 29},
    {"PROGRAM Main VAR x : STRING[40000]; END_VAR END_PROGRAM", "CW8207", 1, 29},
    {"PROGRAM Main VAR x : STRING := 'a$Zb'; END_VAR END_PROGRAM", "CW8320", 1, 34},
    {"PROGRAM Main VAR x : SINT := 200; END_VAR END_PROGRAM", "CW8312", 1, 30},
    {"PROGRAM Main VAR x : ARRAY [0..1] OF INT := [1, 2, 3]; END_VAR END_PROGRAM", "CW8321", 1, 45},
    {"PROGRAM Main VAR x : ARRAY [0..1] OF INT := [5(0)]; END_VAR END_PROGRAM", "CW8321", 1, 45},
    {"PROGRAM Main VAR x : INT := [1]; END_VAR END_PROGRAM", "CW8301", 1, 29},
    {"PROGRAM Main VAR x : INT (0..9) := 10; END_VAR END_PROGRAM", "CW8312", 1, 36},
    {"PROGRAM Main VAR x : REAL (0..9); END_VAR END_PROGRAM", "CW8204", 1, 22},
    {"PROGRAM Main VAR y : INT; x : INT := y; END_VAR END_PROGRAM", "CW8208", 1, 38},
    {"PROGRAM Main VAR CONSTANT n : INT := 5; END_VAR n := 6; END_PROGRAM", "CW8305", 1, 49},
    {"PROGRAM Main VAR x AT y : INT; END_VAR END_PROGRAM", "CW8101", 1, 23},
    {"PROGRAM Main VAR x__y : INT; END_VAR END_PROGRAM", "CW8108", 1, 18},
    {"PROGRAM Main VAR x_ : INT; END_VAR END_PROGRAM", "CW8108", 1, 18},
    {"PROGRAM Main VAR_EXTERNAL g : INT; END_VAR END_PROGRAM", "CW8204", 1, 27},
    {"VAR_GLOBAL g : BOOL; END_VAR PROGRAM Main VAR_EXTERNAL g : INT; END_VAR END_PROGRAM", "CW8301", 1, 56},
    {"TYPE T1 : STRUCT a : T1; END_STRUCT; END_TYPE PROGRAM Main END_PROGRAM", "CW8206", 1, 11},
    {"TYPE T1 : ARRAY [0..1] OF T2; T2 : STRUCT a : T1; END_STRUCT; END_TYPE PROGRAM Main END_PROGRAM", "CW8206", 1, 11},
    {"TYPE T1 : T1; END_TYPE PROGRAM Main END_PROGRAM", "CW8206", 1, 11},
    {"TYPE T1 : INT; T1 : BOOL; END_TYPE PROGRAM Main END_PROGRAM", "CW8203", 1, 16},
    {"TYPE T1 : INT END_TYPE PROGRAM Main END_PROGRAM", "CW8102", 1, 14},
    {"TYPE T1 INT; END_TYPE PROGRAM Main END_PROGRAM", "CW8101", 1, 9},
    {"TYPE T1 : (A, B, A); END_TYPE PROGRAM Main END_PROGRAM", "CW8203", 1, 18},
    {"TYPE T1 : (A, ); END_TYPE PROGRAM Main END_PROGRAM", "CW8101", 1, 15},
    {"TYPE T1 : STRUCT a : INT; a : INT; END_STRUCT; END_TYPE PROGRAM Main END_PROGRAM", "CW8203", 1, 27},
    {"TYPE T1 : STRUCT a : INT; END_TYPE PROGRAM Main END_PROGRAM", "CW8103", 1, 11},
    {"TYPE T1 : INT;\nPROGRAM Main END_PROGRAM", "CW8103", 1, 1},
    {"TYPE T1 : INT (5..1); END_TYPE PROGRAM Main END_PROGRAM", "CW8207", 1, 16},
    {"TYPE T1 : REAL (A, B); END_TYPE PROGRAM Main END_PROGRAM", "CW8204", 1, 11},
    {"TYPE E : (A, B); F : (C, D); END_TYPE PROGRAM Main VAR e1 : E; END_VAR e1 := C; END_PROGRAM", "CW8301", 1, 78},
    {"TYPE E : (A, B); END_TYPE PROGRAM Main VAR e1 : E; END_VAR e1 := E#C; END_PROGRAM", "CW8205", 1, 66},
    {"TYPE E : (A, B); END_TYPE PROGRAM Main VAR e1 : E; END_VAR e1 := 1; END_PROGRAM", "CW8301", 1, 66},
    {"FUNCTION f : INT f := f(); END_FUNCTION PROGRAM Main END_PROGRAM", "CW8318", 1, 10},
    {"FUNCTION f : INT f := g(); END_FUNCTION FUNCTION g : INT g := f(); END_FUNCTION PROGRAM Main END_PROGRAM", "CW8318", 1, 10},
    {"FUNCTION f : INT VAR_INPUT x : INT; END_VAR f := x; END_FUNCTION PROGRAM Main VAR a : INT; END_VAR a := f(1, 2); END_PROGRAM", "CW8307", 1, 110},
    {"FUNCTION f : INT VAR_IN_OUT x : INT; END_VAR f := x; END_FUNCTION PROGRAM Main VAR a : INT; END_VAR a := f(); END_PROGRAM", "CW8310", 1, 106},
    {"FUNCTION f : INT VAR_IN_OUT x : INT; END_VAR f := x; END_FUNCTION PROGRAM Main VAR a : INT; END_VAR a := f(5); END_PROGRAM", "CW8311", 1, 108},
    {"FUNCTION f : INT VAR_IN_OUT x : INT; END_VAR f := x; END_FUNCTION PROGRAM Main VAR a : INT; b : DINT; END_VAR a := f(b); END_PROGRAM", "CW8302", 1, 118},
    {"FUNCTION f VAR_INPUT x : INT; END_VAR END_FUNCTION PROGRAM Main VAR a : INT; END_VAR a := f(1); END_PROGRAM", "CW8301", 1, 91},
    {"FUNCTION f : INT\nf := 1;\nPROGRAM Main END_PROGRAM", "CW8103", 1, 10},
    {"FUNCTION f : INT f := 1; END_PROGRAM PROGRAM Main END_PROGRAM", "CW8101", 1, 26},
    {"FUNCTION_BLOCK B VAR b : B; END_VAR END_FUNCTION_BLOCK PROGRAM Main END_PROGRAM", "CW8206", 1, 26},
    {"FUNCTION_BLOCK B EXTENDS B END_FUNCTION_BLOCK PROGRAM Main END_PROGRAM", "CW8206", 1, 26},
    {"FUNCTION_BLOCK B EXTENDS Main END_FUNCTION_BLOCK PROGRAM Main END_PROGRAM", "CW8204", 1, 26},
    {"FUNCTION_BLOCK B IMPLEMENTS Main END_FUNCTION_BLOCK PROGRAM Main END_PROGRAM", "CW8204", 1, 29},
    {"INTERFACE I METHOD M : INT END_METHOD END_INTERFACE FUNCTION_BLOCK B IMPLEMENTS I END_FUNCTION_BLOCK PROGRAM Main END_PROGRAM", "CW8211", 1, 68},
    {"INTERFACE I METHOD M : INT END_METHOD END_INTERFACE FUNCTION_BLOCK B IMPLEMENTS I METHOD M : BOOL M := TRUE; END_METHOD END_FUNCTION_BLOCK PROGRAM Main END_PROGRAM", "CW8211", 1, 68},
    {"FUNCTION f : INT METHOD M END_METHOD f := 1; END_FUNCTION PROGRAM Main END_PROGRAM", "CW8212", 1, 25},
    {"FUNCTION_BLOCK B METHOD M END_METHOD METHOD M END_METHOD END_FUNCTION_BLOCK PROGRAM Main END_PROGRAM", "CW8203", 1, 45},
    {"FUNCTION_BLOCK B VAR_INPUT x : INT; END_VAR x := 1; END_FUNCTION_BLOCK PROGRAM Main END_PROGRAM", "CW8305", 1, 45},
    {"FUNCTION_BLOCK B METHOD M a := 1; END_METHOD END_FUNCTION_BLOCK PROGRAM Main END_PROGRAM", "CW8201", 1, 27},
    {"FUNCTION_BLOCK B VAR x AT %IX0.0 : BOOL; END_VAR END_FUNCTION_BLOCK PROGRAM Main END_PROGRAM", "CW8212", 1, 27},
    {"PROGRAM Main END_PROGRAM PROGRAM Main END_PROGRAM", "CW8203", 1, 34},
    {"PROGRAM Main END_PROGRAM CONFIGURATION C PROGRAM I : Other; END_CONFIGURATION", "CW8204", 1, 54},
    {"PROGRAM Main END_PROGRAM CONFIGURATION C PROGRAM I WITH T : Main; END_CONFIGURATION", "CW8201", 1, 57},
    {"PROGRAM Main END_PROGRAM CONFIGURATION C PROGRAM I : Main; PROGRAM J : Main; END_CONFIGURATION", "CW8309", 1, 72},
    {"PROGRAM Main END_PROGRAM CONFIGURATION C PROGRAM I : Main;", "CW8103", 1, 26},
    {"PROGRAM Main END_PROGRAM CONFIGURATION C nonsense END_CONFIGURATION", "CW8101", 1, 42},
    {"PROGRAM Main VAR r : REF_TO INT; d : DINT; END_VAR r := REF(d); END_PROGRAM", "CW8301", 1, 57},
    {"PROGRAM Main VAR r : REF_TO INT; END_VAR r := 5; END_PROGRAM", "CW8301", 1, 47},
};

class StMalformedTextTest : public testing::TestWithParam<StatementRow> {};

TEST_P(StMalformedTextTest, oneMistakeGivesOneMessageAtItsPlace)
{
    const StatementRow& row = GetParam();
    expectOne(row.statements, row.code, row.line, row.column);
}

INSTANTIATE_TEST_SUITE_P(Rows, StMalformedTextTest, testing::ValuesIn(TextRows));

/// Every pair of elementary types of which one does not become the other by itself: the conversion is named.
TEST(StMalformedFamilyTest, whatDoesNotWidenNamesItsConversion)
{
    unsigned count = 0;
    for (unsigned from = 1; from <= static_cast<unsigned>(st::Elementary::Ldt); ++from) {
        for (unsigned to = 1; to <= static_cast<unsigned>(st::Elementary::Ldt); ++to) {
            const auto source = static_cast<st::Elementary>(from);
            const auto target = static_cast<st::Elementary>(to);
            if (st::widens(source, target))
                continue;
            ++count;
            const std::string text = "PROGRAM Main\nVAR a : " + std::string(st::elementaryName(source)) + "; b : " + std::string(st::elementaryName(target)) + "; END_VAR\nb := a;\nEND_PROGRAM";
            expectOne(text, "CW8302", 3, 6);
        }
    }
    EXPECT_GT(count, 300u);
}

TEST(StMalformedFamilyTest, wordsOfTheLanguageAreNoNames)
{
    for (unsigned w = 1; w < static_cast<unsigned>(st::Word::Count); ++w) {
        const std::string word(st::wordText(static_cast<st::Word>(w)));
        const bool isBoundary = word.starts_with("END_") || word == "PROGRAM" || word == "FUNCTION" || word == "FUNCTION_BLOCK" || word == "INTERFACE" || word == "TYPE" || word == "CONFIGURATION" || word == "VAR_GLOBAL";
        if (!isBoundary)
            expectOne("PROGRAM Main\nVAR\n" + word + " : INT;\nEND_VAR\nEND_PROGRAM", "CW8107", 3, 1);
    }
}

TEST(StMalformedFamilyTest, constantsOutsideTheirTypeAreRefused)
{
    for (unsigned e = static_cast<unsigned>(st::Elementary::Byte); e <= static_cast<unsigned>(st::Elementary::Ulint); ++e) {
        const auto type = static_cast<st::Elementary>(e);
        const std::string head = "PROGRAM Main\nVAR x : " + std::string(st::elementaryName(type)) + "; END_VAR\nx := ";
        if (type != st::Elementary::Ulint && type != st::Elementary::Lword)
            expectOne(head + st::wideText(st::largestOf(type) + 1) + ";\nEND_PROGRAM", "CW8312", 3, 6);
        expectOne(head + st::wideText(st::smallestOf(type) - 1) + ";\nEND_PROGRAM", "CW8312", 3, 6);
        EXPECT_TRUE(errorsOf(head + st::wideText(st::largestOf(type)) + ";\nx := " + st::wideText(st::smallestOf(type)) + ";\nEND_PROGRAM").empty());
    }
}

// Bounds of time and memory.

std::string repeated(const std::string& text, std::size_t times)
{
    std::string out;
    for (std::size_t i = 0; i < times; ++i)
        out += text;
    return out;
}

std::string inProgram(const std::string& statements)
{
    return std::string(Declarations) + statements + "\nEND_PROGRAM\n";
}

TEST(StBoundsTest, deepNestingIsRefusedAndNotFollowed)
{
    constexpr std::size_t Depth = 100'000;
    for (const std::string& text : {"a := " + repeated("(", Depth) + "1" + repeated(")", Depth) + ";", "q := " + repeated("NOT ", Depth) + "q;", "a := " + repeated("-", Depth) + "1;",
                                    repeated("IF q THEN\n", Depth), repeated("CASE a OF 1:\n", Depth), repeated("REPEAT ", Depth), "a := " + repeated("ABS(", Depth) + "1;",
                                    "a := " + repeated("arr[", Depth) + "1;", repeated("(* ", Depth)}) {
        const Diagnostics errors = errorsOf(inProgram(text));
        EXPECT_FALSE(errors.empty());
        EXPECT_LE(errors.size(), 301u);
    }
    EXPECT_FALSE(errorsOf("PROGRAM Main VAR x : " + repeated("ARRAY [0..0] OF ", Depth) + "INT; END_VAR END_PROGRAM").empty());
    EXPECT_FALSE(errorsOf("PROGRAM Main VAR x : " + repeated("REF_TO ", Depth) + "INT; END_VAR END_PROGRAM").empty());
    EXPECT_FALSE(errorsOf("PROGRAM Main VAR x : " + repeated("STRUCT a : ", Depth) + "INT; END_VAR END_PROGRAM").empty());
}

TEST(StBoundsTest, longChainsAreRefusedWithOneMessage)
{
    EXPECT_TRUE(errorsOf(inProgram("d := 1" + repeated(" + d", 900) + ";")).empty());
    const Diagnostics errors = errorsOf(inProgram("d := 1" + repeated(" + d", 1500) + ";"));
    ASSERT_EQ(errors.size(), 1u) << said(errors);
    EXPECT_EQ(codeInfo(errors[0].code).id, "CW8106");
}

TEST(StBoundsTest, aHundredThousandErrorsEndWithOneThatSaysSo)
{
    const Diagnostics errors = errorsOf(inProgram(repeated("x = 5;\n", 100'000)));
    ASSERT_EQ(errors.size(), 301u);
    EXPECT_EQ(codeInfo(errors.back().code).id, "CW3018");
}

TEST(StBoundsTest, longNamesAndNumbersAreRefused)
{
    expectOne(inProgram(std::string(10'000, 'x') + " := 1;").substr(0, 0) + "PROGRAM " + std::string(10'000, 'x') + "\nEND_PROGRAM", "CW8108", 1, 9);
    expectOne(inProgram("d := " + std::string(10'000, '9') + ";"), "CW8110", 3, 6);
}

TEST(StBoundsTest, typesThatNeedEachOtherInALongRowAreRefused)
{
    std::string text = "TYPE\n";
    for (int i = 0; i < 5000; ++i)
        text += "T" + std::to_string(i) + " : STRUCT a : T" + std::to_string(i + 1) + "; END_STRUCT;\n";
    EXPECT_FALSE(errorsOf(text + "T5000 : INT; END_TYPE PROGRAM Main END_PROGRAM").empty());
}

TEST(StBoundsTest, aTextCutAnywhereIsAnsweredWithErrors)
{
    std::ifstream file(CAMWRIGHT_SOURCE_DIR "/tests/data/language/st/generated.st", std::ios::binary);
    std::stringstream stream;
    stream << file.rdbuf();
    const std::string text = stream.str();
    for (std::size_t length = 0; length + 200 < text.size(); length += 211)
        EXPECT_FALSE(errorsOf(text.substr(0, length)).empty()) << length;
}

} // namespace
