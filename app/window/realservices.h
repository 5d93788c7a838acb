#pragma once

#include "app/window/services.h"
#include "devices/session/qtexecutor.h"

namespace camwright {

/// The services of the real program: the checks, the compiler, the online session. Must outlive every link.
class RealServices {
public:
    Services services();

private:
    QtExecutor m_executor;
};

} // namespace camwright
