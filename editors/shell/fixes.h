#pragma once

#include "core/base/diagnostic.h"

#include <QString>

#include <functional>
#include <vector>

class QMenu;
class QPoint;
class QWidget;

namespace camwright {

class Context;
class ProjectDocument;

/// One way out of a problem. Doing it is one step of the project's undo.
struct Fix {
    QString sentence;             ///< what it does, as the menu shows it
    std::function<void()> apply;  ///< once, while the document is as it was when the fix was made
};

/// What a library knows about mending problems; registered with the Registry.
struct FixProvider {
    std::function<bool(Code)> knows; ///< cheap: whether there may be fixes for a code
    std::function<std::vector<Fix>(ProjectDocument&, const Diagnostic&)> fixes;
};

/// Whether any provider may mend the problem.
bool mayFix(const Context& context, Code code);
/// The fixes of all providers, the likeliest first.
std::vector<Fix> fixesOf(Context& context, const Diagnostic& problem);
/// Opens a menu with the fixes of some problems at a point of the screen; it deletes itself. Says so where there is none, and
/// returns null then.
QMenu* showFixes(Context& context, const std::vector<Diagnostic>& problems, QWidget* parent, const QPoint& globalPoint);

} // namespace camwright
