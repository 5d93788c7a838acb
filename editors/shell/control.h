#pragma once

#include <QObject>

#include <functional>

namespace camwright {

class Context;

/// Takes control of the controller if it is not held yet, then calls `then`; a refusal is told to the user. Nothing is called
/// when `owner` is gone or the link is another one by then.
void withControl(Context& context, QObject* owner, std::function<void()> then);

} // namespace camwright
