#include "core/online/messages.h"

namespace camwright {

namespace {

using message::Type;
constexpr auto C = Sender::Client;
constexpr auto S = Sender::Controller;
constexpr bool control = true, urgent = true, no = false;

constexpr std::array<MessageRule, std::variant_size_v<Message>> Rules{{
    {Type::Hello, "hello", C, Role::Nobody, no, no},
    {Type::Welcome, "welcome", S, Role::Nobody, no, no},
    {Type::Authenticate, "authenticate", C, Role::Nobody, no, no},
    {Type::Authenticated, "authenticated", S, Role::Nobody, no, no},
    {Type::Done, "done", S, Role::Nobody, no, no},
    {Type::Failed, "failed", S, Role::Nobody, no, no},
    {Type::Ping, "ping", C, Role::Observe, no, no},
    {Type::Pong, "pong", S, Role::Observe, no, no},
    {Type::Status, "status", S, Role::Observe, no, no},
    {Type::TakeControl, "takeControl", C, Role::Operate, no, no},
    {Type::RenewControl, "renewControl", C, Role::Operate, no, urgent},
    {Type::ReleaseControl, "releaseControl", C, Role::Operate, no, no},
    {Type::PlanDownload, "planDownload", C, Role::Observe, no, no},
    {Type::Plan, "plan", S, Role::Observe, no, no},
    {Type::BeginDownload, "beginDownload", C, Role::Engineer, control, no},
    {Type::DownloadBegun, "downloadBegun", S, Role::Engineer, no, no},
    {Type::Piece, "piece", C, Role::Engineer, control, no},
    {Type::PieceTaken, "pieceTaken", S, Role::Engineer, no, no},
    {Type::CommitDownload, "commitDownload", C, Role::Engineer, control, no},
    {Type::AbortDownload, "abortDownload", C, Role::Engineer, no, no},
    {Type::Run, "run", C, Role::Operate, control, no},
    {Type::Stop, "stop", C, Role::Operate, control, no},
    {Type::Exit, "exit", C, Role::Operate, control, no},
    {Type::Read, "read", C, Role::Observe, no, no},
    {Type::Values, "values", S, Role::Observe, no, no},
    {Type::Write, "write", C, Role::Operate, control, no},
    {Type::Force, "force", C, Role::Operate, control, no},
    {Type::Release, "release", C, Role::Operate, control, no},
    {Type::Describe, "describe", C, Role::Observe, no, no},
    {Type::Types, "types", S, Role::Observe, no, no},
    {Type::Subscribe, "subscribe", C, Role::Observe, no, no},
    {Type::Subscribed, "subscribed", S, Role::Observe, no, no},
    {Type::Unsubscribe, "unsubscribe", C, Role::Observe, no, no},
    {Type::Update, "update", S, Role::Observe, no, no},
    {Type::ReadForces, "readForces", C, Role::Observe, no, no},
    {Type::Forces, "forces", S, Role::Observe, no, no},
    {Type::ReadTerminals, "readTerminals", C, Role::Observe, no, no},
    {Type::Terminals, "terminals", S, Role::Observe, no, no},
    {Type::StartTrace, "startTrace", C, Role::Observe, no, no},
    {Type::StopTrace, "stopTrace", C, Role::Observe, no, no},
    {Type::TraceBlock, "traceBlock", S, Role::Observe, no, no},
    {Type::TraceBlockTaken, "traceBlockTaken", C, Role::Observe, no, no},
    {Type::Axis, "axis", C, Role::Operate, control, no},
    {Type::Heartbeat, "heartbeat", C, Role::Operate, control, urgent},
    {Type::Beat, "beat", S, Role::Operate, no, urgent},
    {Type::StopAll, "stopAll", C, Role::Nobody, no, urgent},
    {Type::ReadLog, "readLog", C, Role::Observe, no, no},
    {Type::LogEntries, "logEntries", S, Role::Observe, no, no},
    {Type::Logged, "logged", S, Role::Observe, no, no},
}};

} // namespace

const std::array<MessageRule, std::variant_size_v<Message>>& messageRules()
{
    return Rules;
}

} // namespace camwright
