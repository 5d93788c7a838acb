#pragma once

#include "core/online/controllerlink.h"
#include "core/online/executor.h"

#include <functional>
#include <map>
#include <memory>
#include <vector>

namespace camwright {

/// The requests a user of the link has open. Each ends exactly once: its result goes to the executor, and the callback runs
/// there unless the request was cancelled or this object destroyed meanwhile.
class SessionCalls {
public:
    explicit SessionCalls(Executor& executor) : m_executor(executor) {}

    /// `reply` as the caller gave it. What comes back ends the request; only its first call counts.
    template <class T>
    std::pair<RequestId, std::function<void(Result<T>)>> open(ControllerLink::Reply<T> reply)
    {
        const RequestId id{++m_last};
        std::function<void(Result<T>)> finish = [this, id, reply = std::move(reply), alive = std::weak_ptr(m_alive)](Result<T> result) {
            const auto found = m_calls.find(id);
            if (found == m_calls.end() || found->second.finished)
                return;
            found->second.finished = true;
            m_executor.post([this, id, reply, alive, result = std::move(result)]() mutable {
                if (!alive.expired() && m_calls.erase(id) != 0 && reply)
                    reply(std::move(result));
            });
        };
        m_calls[id].fail = [finish](const Diagnostic& why) { finish(why); };
        return {id, std::move(finish)};
    }

    bool isOpen(RequestId id) const
    {
        const auto found = m_calls.find(id);
        return found != m_calls.end() && !found->second.finished;
    }
    void cancel(RequestId id) { m_calls.erase(id); }
    void failAll(const Diagnostic& why)
    {
        std::vector<std::function<void(const Diagnostic&)>> fails;
        for (const auto& [id, call] : m_calls)
            fails.push_back(call.fail);
        for (const auto& fail : fails)
            fail(why);
    }

private:
    struct Call {
        std::function<void(const Diagnostic&)> fail;
        bool finished = false;
    };

    Executor& m_executor;
    std::map<RequestId, Call> m_calls;
    std::uint64_t m_last = 0;
    std::shared_ptr<bool> m_alive = std::make_shared<bool>(true);
};

} // namespace camwright
