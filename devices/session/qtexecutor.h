#pragma once

#include "core/online/executor.h"

#include <QObject>

namespace camwright {

/// Runs tasks, in order, in the Qt event loop of the thread that made it. Tasks still waiting when it is destroyed are
/// dropped.
class QtExecutor : public Executor {
public:
    void post(std::function<void()> task) override;

private:
    QObject m_context;
};

} // namespace camwright
