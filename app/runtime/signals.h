#pragma once

#include <functional>

namespace camwright {

/// Calls `quit` in the event loop when the process is asked to end (SIGTERM, SIGINT, SIGHUP). Once per process.
void onTermination(std::function<void()> quit);

} // namespace camwright
