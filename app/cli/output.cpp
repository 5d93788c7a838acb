#include "app/cli/output.h"

#include "editors/words/words.h"

#include <cstdio>

namespace camwright::cli {

void Output::line(const QString& text)
{
    if (m_asJson)
        return;
    std::puts(text.toUtf8().constData());
    std::fflush(stdout);
}

void Output::progress(const QString& text)
{
    std::fprintf(stderr, "%s\n", text.toUtf8().constData());
}

void Output::diagnostic(const Diagnostic& diagnostic)
{
    if (m_asJson)
        m_json["diagnostics"].push_back(toJson(diagnostic));
    else
        line(lineOf(diagnostic));
}

QString lineOf(const Diagnostic& d)
{
    QString where = QString::fromStdString(d.place.file.empty() ? d.place.object.name : d.place.file);
    if (d.place.range.isValid())
        where += QStringLiteral(":%1:%2").arg(d.place.range.line).arg(d.place.range.column);
    else if (!d.place.field.empty())
        where += QLatin1Char(':') + QString::fromStdString(d.place.field);
    if (!where.isEmpty())
        where += QStringLiteral(": ");
    return where + words::severityWord(d.severity()) + QLatin1Char(' ') + words::codeId(d.code) + QStringLiteral(": ") + words::sentence(d);
}

void Output::finish()
{
    if (m_asJson)
        std::puts(m_json.dump(2, ' ', false, Json::error_handler_t::replace).c_str());
}

static const char* severityWord(Severity severity)
{
    switch (severity) {
    case Severity::Information: return "information";
    case Severity::Warning: return "warning";
    case Severity::Error: return "error";
    }
    return "";
}

Json toJson(const Diagnostic& d)
{
    Json out;
    out["code"] = codeInfo(d.code).id;
    out["severity"] = severityWord(d.severity());
    out["text"] = words::sentence(d).toStdString();
    if (!d.place.file.empty())
        out["file"] = d.place.file;
    if (!d.place.object.name.empty())
        out["object"] = {{"kind", kindName(d.place.object.kind)}, {"name", d.place.object.name}};
    if (!d.place.field.empty())
        out["field"] = d.place.field;
    if (d.place.range.isValid()) {
        out["line"] = d.place.range.line;
        out["column"] = d.place.range.column;
    }
    return out;
}

} // namespace camwright::cli
