#pragma once

#include <QCoreApplication>
#include <QDeadlineTimer>
#include <QEventLoop>
#include <QTimer>

namespace camwright::test {

/// Runs the event loop until the condition holds, without the sleeps between looks that QTest::qWaitFor takes. False if
/// it does not come true within a minute.
template <class Condition>
bool waitUntil(Condition condition)
{
    const QDeadlineTimer deadline(60'000);
    QTimer look; // wakes the loop where nothing else does
    look.start(5);
    while (!condition()) {
        if (deadline.hasExpired())
            return false;
        QCoreApplication::processEvents(QEventLoop::AllEvents | QEventLoop::WaitForMoreEvents);
        QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
    }
    return true;
}

} // namespace camwright::test
