#include "editors/shell/fixes.h"

#include "editors/shell/context.h"
#include "editors/shell/icons.h"
#include "editors/shell/registry.h"

#include <QCoreApplication>
#include <QMenu>

#include <algorithm>

namespace camwright {

bool mayFix(const Context& context, Code code)
{
    return std::ranges::any_of(context.registry().fixProviders(), [code](const FixProvider& provider) { return provider.knows(code); });
}

std::vector<Fix> fixesOf(Context& context, const Diagnostic& problem)
{
    std::vector<Fix> out;
    for (const FixProvider& provider : context.registry().fixProviders()) {
        if (!provider.knows(problem.code))
            continue;
        for (Fix& fix : provider.fixes(context.document(), problem))
            out.push_back(std::move(fix));
    }
    return out;
}

QMenu* showFixes(Context& context, const std::vector<Diagnostic>& problems, QWidget* parent, const QPoint& globalPoint)
{
    auto* menu = new QMenu(parent);
    menu->setObjectName(QStringLiteral("quickFixes"));
    menu->setAccessibleName(QCoreApplication::translate("Fixes", "Quick fixes"));
    menu->setAttribute(Qt::WA_DeleteOnClose);
    for (const Diagnostic& problem : problems) {
        for (const Fix& fix : fixesOf(context, problem)) {
            // A name may hold an ampersand, which would be a menu's access key.
            QString text = fix.sentence;
            menu->addAction(icon(QStringLiteral("quick-fix")), text.replace(QLatin1Char('&'), QLatin1String("&&")), menu, fix.apply);
        }
    }
    if (menu->isEmpty()) {
        delete menu;
        context.notify(Severity::Information, problems.empty() ? QCoreApplication::translate("Fixes", "There is no problem here.")
                                                               : QCoreApplication::translate("Fixes", "There is no quick fix for this problem."));
        return nullptr;
    }
    menu->setActiveAction(menu->actions().constFirst());
    menu->popup(globalPoint);
    return menu;
}

} // namespace camwright
