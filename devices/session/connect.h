#pragma once

#include "core/online/executor.h"
#include "devices/session/onlinesession.h"

#include <memory>
#include <string>

namespace camwright {

struct ConnectOptions {
    std::string client = "camwright"; ///< how this program names itself to other people: "camwright (anna@desk)"
    bool reconnect = true;            ///< tries again by itself after the link was lost
    std::string runtimeProgram;       ///< for `local`; empty: camwright-runtime beside this executable
};

/// A link to the controller at an address: `local` (the virtual controller of the project, started if it does not run) or
/// `tcp://HOST[:PORT]` (default port 17402). Returns at once with a link that is Connecting; it becomes Online, or Offline
/// with the reason. Only an address that is none, or a kind of link this version lacks, is an error here.
/// The calling thread must run a Qt event loop; callbacks come through the executor.
Result<std::unique_ptr<OnlineSession>> connectTo(const std::string& address, const std::string& projectPath, Executor& executor,
                                                 const ConnectOptions& options = {});

} // namespace camwright
