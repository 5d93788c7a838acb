#pragma once

#include "core/language/source/ilparser.h"
#include "core/language/source/ilwriter.h"

#include <fstream>
#include <sstream>
#include <string>

namespace camwright::test {

/// A tree as text: "(LD %M0.0 [OR a | b] {x / y})": series in parentheses, parallel in brackets, forks in braces.
inline std::string show(const Rung& rung, const RungNode& node)
{
    const auto join = [&](const char* open, const char* between, const char* close) {
        std::string out = open;
        for (std::size_t i = 0; i < node.children.size(); ++i)
            out += (i ? between : "") + show(rung, node.children[i]);
        return out + close;
    };
    switch (node.kind) {
    case NodeKind::Series: return join("(", " ", ")");
    case NodeKind::Parallel: return join("[", " | ", "]");
    case NodeKind::Fork: return join("{", " / ", "}");
    case NodeKind::Element: break;
    }
    const Statement& statement = rung.statements[node.statement];
    std::string out = statement.form == ContactForm::NormallyClosed ? "/" : "";
    const bool isContact = statement.form == ContactForm::NormallyOpen || statement.form == ContactForm::NormallyClosed;
    if (!isContact)
        out += statement.mnemonic + (statement.operands.empty() ? "" : ":");
    for (std::size_t i = 0; i < statement.operands.size(); ++i)
        out += (i ? "," : "") + statement.operands[i].text;
    return out;
}

inline std::string show(const Rung& rung)
{
    return rung.drawable ? show(rung, rung.tree) : "text";
}

inline std::string readFile(const std::string& path)
{
    std::ifstream in(path, std::ios::binary);
    std::stringstream out;
    out << in.rdbuf();
    return out.str();
}

inline std::string codesOf(const Diagnostics& diagnostics)
{
    std::string out;
    for (const Diagnostic& d : diagnostics)
        out += (out.empty() ? "" : " ") + std::string(codeInfo(d.code).id) + "@" + std::to_string(d.place.range.line) + ":" + std::to_string(d.place.range.column);
    return out;
}

} // namespace camwright::test
