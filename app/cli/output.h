#pragma once

#include "core/base/diagnostic.h"

#include <nlohmann/json.hpp>

#include <QString>

namespace camwright::cli {

using Json = nlohmann::ordered_json;

/// Where a verb writes. Plain: lines on standard output. With --json: nothing but one document at the end. Progress and
/// complaints go to standard error in both.
class Output {
public:
    explicit Output(bool json) : m_asJson(json) {}

    bool asJson() const { return m_asJson; }
    /// A line for people; dropped with --json.
    void line(const QString& text);
    void line(const char* text) { line(QString::fromUtf8(text)); }
    void progress(const QString& text);
    /// "file:line:column: error CW3001: sentence" on standard output, or an entry of "diagnostics".
    void diagnostic(const Diagnostic& diagnostic);
    /// The document of --json; verbs fill it as they go.
    Json& json() { return m_json; }
    /// Prints the document if there is one to print.
    void finish();

private:
    bool m_asJson;
    Json m_json = Json::object();
};

Json toJson(const Diagnostic& diagnostic);
/// "file:line:column: error CW3001: sentence", as compilers write it; parts that are not known are left out.
QString lineOf(const Diagnostic& diagnostic);

} // namespace camwright::cli
