#pragma once

#include <functional>

namespace camwright {

/// Where a link's callbacks run: the interface's event loop, the command line's, or a test's own queue.
class Executor {
public:
    virtual ~Executor() = default;
    virtual void post(std::function<void()> task) = 0; ///< from any thread; runs later, in order
};

} // namespace camwright
