#include "editors/shell/control.h"

#include "editors/shell/context.h"

#include <QPointer>

namespace camwright {

void withControl(Context& context, QObject* owner, std::function<void()> then)
{
    ControllerLink* link = context.link();
    if (!link)
        return;
    // Asked for even if the newest status says that it is held: that may be older than a lapse of the lease.
    QPointer<QObject> guard(owner);
    QPointer<Context> surroundings(&context);
    link->takeControl([guard, surroundings, link, then = std::move(then)](const Result<void>& taken) {
        if (!guard || !surroundings || surroundings->link() != link)
            return;
        if (taken)
            then();
        else
            surroundings->notify(taken.error());
    });
}

} // namespace camwright
