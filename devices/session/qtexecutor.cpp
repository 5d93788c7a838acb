#include "devices/session/qtexecutor.h"

namespace camwright {

void QtExecutor::post(std::function<void()> task)
{
    QMetaObject::invokeMethod(&m_context, [task = std::move(task)] { task(); }, Qt::QueuedConnection);
}

} // namespace camwright
