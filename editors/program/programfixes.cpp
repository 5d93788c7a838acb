#include "editors/program/programfixes.h"

#include "core/language/assist/quickfix.h"
#include "editors/document/projectdocument.h"

#include <QCoreApplication>

#include <algorithm>
#include <iterator>

namespace camwright {

namespace {

ProjectEdit editOf(const Project& project, const Diagnostic& problem, const QuickFix& fix)
{
    ProjectEdit edit{sentenceOf(fix), {}, {"source"}, problem.place, {}};
    const ObjectKey& key = problem.place.object;
    // From the end on: an edit moves what stands behind it.
    if (const auto* program = project.content<Program>(key))
        std::ranges::transform(fix.edits.rbegin(), fix.edits.rend(), std::back_inserter(edit.deltas), [&](const TextEdit& change) {
            return TextDelta{key, change.offset, program->source.substr(change.offset, change.length), change.text};
        });
    for (const Object& object : fix.objects)
        edit.deltas.push_back(ObjectDelta{object.key, project.find(object.key), std::make_shared<const Object>(object)});
    return edit;
}

/// Made anew when it is done: the text may have changed while the menu was open.
void apply(ProjectDocument& document, const Diagnostic& problem, std::size_t index)
{
    const std::vector<QuickFix> fixes = quickFixes(document.project(), problem);
    if (index >= fixes.size())
        return;
    document.closeMerge();
    document.push(editOf(document.project(), problem, fixes[index]));
    document.closeMerge();
}

std::vector<Fix> fixes(ProjectDocument& document, const Diagnostic& problem)
{
    std::vector<Fix> out;
    const std::vector<QuickFix> found = quickFixes(document.project(), problem);
    for (std::size_t i = 0; i < found.size(); ++i)
        out.push_back({sentenceOf(found[i]), [&document, problem, i] { apply(document, problem, i); }});
    return out;
}

} // namespace

QString sentenceOf(const QuickFix& fix)
{
    const QString translated = QCoreApplication::translate("QuickFix", fix.sentence);
    return QString::fromStdString(fillTemplate(translated.toStdString(), fix.arguments));
}

FixProvider programFixProvider()
{
    return {hasQuickFixes, fixes};
}

} // namespace camwright
