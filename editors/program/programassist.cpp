#include "editors/program/programassist.h"

#include "core/language/assist/completion.h"
#include "core/language/assist/hover.h"
#include "editors/shell/theme.h"
#include "editors/words/words.h"

#include <QCoreApplication>

#include <algorithm>

namespace camwright::assist {

namespace {

constexpr int EntryColumn = 18; // hints begin here, if the text is not longer
constexpr qsizetype LongestHint = 60;

TextLanguage textLanguage()
{
    const QString language = words::currentLanguage();
    return language == QLatin1String("zh") ? TextLanguage::Chinese : language == QLatin1String("ru") ? TextLanguage::Russian : TextLanguage::English;
}

QString escaped(const std::string& text)
{
    return QString::fromStdString(text).toHtmlEscaped();
}

QString paragraph(const QString& html)
{
    return html.isEmpty() ? QString() : QStringLiteral("<p style='margin:2px 0'>%1</p>").arg(html);
}

QString dim(const QString& text)
{
    return QStringLiteral("<span style='color:%1'>%2</span>").arg(theme().name(Role::Dim), text);
}

/// The operands of an instruction as a small table: name, types, meaning.
QString pinTable(const Instruction& instruction)
{
    QString rows;
    for (const Pin& pin : instruction.pins) {
        QStringList types;
        for (const DataType type : pin.types.list())
            types << QString::fromUtf8(name(type).data(), static_cast<qsizetype>(name(type).size()));
        rows += QStringLiteral("<tr><td><b>%1</b>&nbsp;</td><td>%2&nbsp;</td><td>%3</td></tr>")
            .arg(escaped(pin.name), dim(types.join(QLatin1Char(' '))), words::pick(pin.help.en, pin.help.zh, pin.help.ru).toHtmlEscaped());
    }
    return rows.isEmpty() ? QString() : QStringLiteral("<table>%1</table>").arg(rows);
}

QString instructionHtml(const Hover& hover)
{
    QString html = paragraph(QStringLiteral("<b>%1</b>").arg(escaped(hover.signature)));
    html += paragraph(escaped(hover.help));
    html += pinTable(*hover.instruction);
    if (!hover.whyNotSimulated.empty())
        html += paragraph(dim(escaped(hover.whyNotSimulated)));
    if (!hover.instruction->sources.empty())
        html += paragraph(dim(escaped(hover.instruction->sources)));
    return html;
}

QString operandHtml(const LanguageContext& context, const Hover& hover)
{
    QString html;
    if (hover.variable) {
        html += paragraph(QStringLiteral("<b>%1</b> %2 %3").arg(escaped(hover.variable->name),
            QString::fromUtf8(name(hover.variable->type).data(), static_cast<qsizetype>(name(hover.variable->type).size())),
            hover.variable->address ? escaped(context.family->formatAddress(*hover.variable->address)) : QString()));
    } else if (hover.address) {
        html += paragraph(QStringLiteral("<b>%1</b> %2 %3").arg(escaped(context.family->formatAddress(*hover.address)),
            QString::fromUtf8(name(hover.address->type).data(), static_cast<qsizetype>(name(hover.address->type).size())), dim(escaped(hover.areaMeaning))));
    } else if (hover.constant) {
        html += paragraph(QStringLiteral("<b>%1</b> %2").arg(escaped(formatValue(*hover.constant)), escaped(formatValue(*hover.constant, NumberBase::Hexadecimal))));
    }
    if (hover.pin)
        html += paragraph(QStringLiteral("%1: %2 %3").arg(escaped(hover.pin->name), escaped(hover.help), dim(escaped(hover.types))));
    return html;
}

std::string_view view(const QByteArray& text)
{
    return {text.constData(), static_cast<std::size_t>(text.size())};
}

} // namespace

QString hover(const Project& project, const QByteArray& text, int position)
{
    const auto context = contextOf(project);
    if (!context)
        return {};
    const auto found = hoverAt(*context, view(text), static_cast<std::size_t>(position), textLanguage());
    if (!found)
        return {};
    return !found->signature.empty() && found->instruction ? instructionHtml(*found) : operandHtml(*context, *found);
}

Completions complete(const Project& project, const QByteArray& text, int position, bool asked)
{
    const auto context = contextOf(project);
    if (!context)
        return {};
    const Completion found = completeAt(*context, view(text), static_cast<std::size_t>(position), textLanguage());
    const bool enough = found.end - found.begin >= 2;
    const std::string typed(view(text).substr(found.begin, found.end - found.begin));
    if (!asked && (!enough || (found.items.size() == 1 && found.items.front().text == typed)))
        return {};
    Completions out;
    out.begin = static_cast<qsizetype>(found.begin);
    out.end = static_cast<qsizetype>(found.end);
    for (const CompletionItem& item : found.items) {
        QString hint = QString::fromStdString(item.kind == CompletionKind::Instruction && !item.help.empty() ? item.help : item.detail);
        hint = hint.section(QLatin1Char('\n'), 0, 0).left(LongestHint);
        out.entries << QString::fromStdString(item.text).leftJustified(EntryColumn) + QStringLiteral("  ") + hint;
    }
    return out;
}

QByteArray insertionOf(const QByteArray& entry)
{
    const qsizetype blank = entry.indexOf(' ');
    return blank < 0 ? entry : entry.left(blank);
}

TextChange toggleComment(const QByteArray& text, std::uint32_t firstLine, std::uint32_t lastLine)
{
    QList<QByteArray> lines = text.split('\n');
    const auto last = std::min<qsizetype>(lastLine, lines.size());
    const auto first = std::max<qsizetype>(1, firstLine);
    bool all = true;
    for (qsizetype line = first; line <= last; ++line) {
        const QByteArray trimmed = lines[line - 1].trimmed();
        all = all && (trimmed.isEmpty() || (trimmed.startsWith("(*") && trimmed.endsWith("*)")));
    }
    QList<QByteArray> changed;
    std::size_t offset = 0, removed = 0;
    for (qsizetype line = 1; line <= last; ++line) {
        const QByteArray& old = lines[line - 1];
        if (line < first) {
            offset += static_cast<std::size_t>(old.size()) + 1;
            continue;
        }
        removed += static_cast<std::size_t>(old.size()) + (line > first ? 1 : 0);
        QByteArray trimmed = old.trimmed();
        if (trimmed.isEmpty())
            changed << old;
        else if (all)
            changed << trimmed.mid(2, trimmed.size() - 4).trimmed();
        else
            changed << (trimmed.startsWith("(*") ? old : "(* " + old + " *)");
    }
    return {offset, removed, changed.join('\n')};
}

std::optional<Place> definitionOf(const Project& project, const QByteArray& word)
{
    const auto context = contextOf(project);
    if (!context || word.isEmpty())
        return std::nullopt;
    if (const KnownVariable* variable = context->findVariable(view(word)))
        return variable->place;
    if (const KnownProgram* program = context->findProgram(view(word)))
        return Place{{ObjectKind::Program, program->name}, {}, {1, 1, 1, 1}, {}};
    if (const KnownAxis* axis = context->findAxis(view(word)))
        return Place{{ObjectKind::Axis, axis->name}, {}, {}, {}};
    if (const auto address = context->family->parseAddress(view(word), *context->model, AddressMode::Typed)) {
        if (const KnownVariable* variable = context->variableAt(*address))
            return variable->place;
    }
    return std::nullopt;
}

} // namespace camwright::assist
