#pragma once

#include "devices/session/connect.h"
#include "devices/session/qtexecutor.h"
#include "devices/transport/memorystream.h"
#include "tests/core/storage/memoryfilesystem.h"
#include "tests/support/feederimage.h"
#include "tests/support/testcontroller.h"
#include "tests/support/waituntil.h"

#include <QtTest>

#include <memory>
#include <optional>

namespace camwright::test {

/// Connects to a TestController inside the process, and can cut the line after a number of bytes.
class MemoryConnector final : public Connector {
public:
    MemoryConnector(TestController& controller, std::uint64_t cutAfter) : m_controller(controller), m_cutAfter(cutAfter) {}
    void open(Opened opened) override
    {
        m_opened = std::move(opened);
        QMetaObject::invokeMethod(&m_context, [this] {
            auto [mine, theirs] = MemoryStream::pair();
            if (m_cutAfter != 0)
                mine->cutAfter(m_cutAfter);
            m_controller.server.accept(std::move(theirs));
            m_opened(std::unique_ptr<ByteStream>(std::move(mine)));
        }, Qt::QueuedConnection);
    }
    std::string address() const override { return "memory"; }

private:
    TestController& m_controller;
    std::uint64_t m_cutAfter;
    QObject m_context;
    Opened m_opened;
};

/// Waits for one answer of a link.
template <class T, class Ask>
std::optional<Result<T>> answerOf(Ask ask)
{
    auto kept = std::make_shared<std::optional<Result<T>>>();
    ask([kept](Result<T> result) { kept->emplace(std::move(result)); });
    (void)waitUntil([&] { return kept->has_value(); });
    return *kept;
}

inline DownloadPackage packageOf(const ControllerImage& image) { return {write(image), programHash(image)}; }

/// Moves it along: true, or the failure's text on the console.
inline bool good(const std::optional<Result<void>>& result)
{
    if (!result)
        qWarning("no answer");
    else if (!*result)
        qWarning("%s", englishText(result->error()).c_str());
    return result && result->ok();
}

inline Code codeOf(const std::optional<Result<void>>& result)
{
    return result && !*result ? result->error().code : Code::InternalError;
}

} // namespace camwright::test
