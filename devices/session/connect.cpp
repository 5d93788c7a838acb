#include "devices/session/connect.h"

#include "core/online/messages.h"
#include "devices/session/connectors.h"

#include <QCoreApplication>

#include <charconv>
#include <optional>

namespace camwright {

namespace {

struct HostPort {
    std::string host;
    std::uint16_t port = message::DefaultPort;
};

std::optional<HostPort> parseHostPort(std::string_view text)
{
    HostPort out;
    std::string_view port;
    if (text.starts_with('[')) { // an IPv6 address
        const auto close = text.find(']');
        if (close == std::string_view::npos)
            return std::nullopt;
        out.host = text.substr(1, close - 1);
        port = text.substr(close + 1);
    } else {
        const auto colon = text.find(':');
        out.host = text.substr(0, colon);
        port = colon == std::string_view::npos ? std::string_view() : text.substr(colon);
    }
    if (out.host.empty() || out.host.find_first_of("/ \t@") != std::string::npos)
        return std::nullopt;
    if (port.empty())
        return out;
    const char* end = port.data() + port.size();
    const auto [stop, error] = std::from_chars(port.data() + 1, end, out.port);
    if (port.front() != ':' || port.size() < 2 || error != std::errc() || stop != end || out.port == 0)
        return std::nullopt;
    return out;
}

Diagnostic addressError(const std::string& address)
{
    for (const char* kind : {"tls", "serial", "modbus-tcp", "modbus-rtu", "can", "ethercat"})
        if (address.starts_with(kind + std::string(":")))
            return diagnostic(Code::AddressKindNotYet, {kind});
    return diagnostic(Code::AddressNotUnderstood, {address});
}

} // namespace

Result<std::unique_ptr<OnlineSession>> connectTo(const std::string& address, const std::string& projectPath, Executor& executor,
                                                 const ConnectOptions& options)
{
    SessionOptions session;
    session.client = options.client;
    session.reconnect = options.reconnect;
    std::unique_ptr<Connector> connector;
    constexpr std::string_view Tcp = "tcp://";
    if (address == "local") {
        auto paths = LocalConnector::pathsFor(projectPath);
        if (!paths)
            return paths.error();
        const QString program = options.runtimeProgram.empty() ? QCoreApplication::applicationDirPath() + "/camwright-runtime"
                                                               : QString::fromStdString(options.runtimeProgram);
        connector = std::make_unique<LocalConnector>(std::move(*paths), program);
    } else if (address.starts_with(Tcp)) {
        const auto target = parseHostPort(std::string_view(address).substr(Tcp.size()));
        if (!target)
            return diagnostic(Code::AddressNotUnderstood, {address});
        connector = std::make_unique<TcpConnector>(address, QString::fromStdString(target->host), target->port);
    } else {
        return addressError(address);
    }
    return std::make_unique<OnlineSession>(std::move(connector), executor, session);
}

} // namespace camwright
