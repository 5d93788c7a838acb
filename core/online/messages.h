#pragma once

#include "core/online/controllerlink.h"
#include "core/online/manifest.h"

#include <array>
#include <variant>

namespace camwright {

/// What somebody may do with a controller. Each role may do what the ones before it may.
enum class Role : std::uint8_t { Nobody, Observe, Operate, Engineer };

} // namespace camwright

/// The messages of the Camwright Online Protocol as plain values; docs/protocol.md says what each means, devices/protocol
/// puts them on the wire. Numbers are permanent.
namespace camwright::message {

inline constexpr std::uint32_t ProtocolMajor = 1; ///< another major: refused in the handshake
inline constexpr std::uint32_t ProtocolMinor = 0; ///< additions that an older peer may ignore
inline constexpr std::uint16_t DefaultPort = 17402;
inline constexpr std::size_t MaximumFrame = 64 * 1024;      ///< bytes of one frame's body
inline constexpr std::size_t MaximumHandshakeFrame = 1024;  ///< the same until the client is authenticated
inline constexpr std::size_t MaximumNames = 256;            ///< of one read, description or subscription
inline constexpr std::size_t MaximumImage = 32 * 1024 * 1024;
inline constexpr std::size_t MinimumPiece = 64, MaximumPiece = 16 * 1024, PiecesInFlight = 2;
inline constexpr std::size_t PartsAtOnce = 400;             ///< of a manifest in one message
inline constexpr std::size_t MaximumParts = 65'536;         ///< of a manifest in all
inline constexpr std::size_t PlanLines = 200;               ///< of a plan; more are cut
inline constexpr std::size_t LogPage = 64;                  ///< entries of one log reply

enum class Type : std::uint16_t {
    Hello = 1, Welcome = 2, Authenticate = 3, Authenticated = 4, Done = 5, Failed = 6, Ping = 7, Pong = 8, Status = 9,
    TakeControl = 16, RenewControl = 17, ReleaseControl = 18,
    PlanDownload = 24, Plan = 25, BeginDownload = 26, DownloadBegun = 27, Piece = 28, PieceTaken = 29, CommitDownload = 30,
    AbortDownload = 31,
    Run = 40, Stop = 41, Exit = 42,
    Read = 48, Values = 49, Write = 50, Force = 51, Release = 52, Describe = 53, Types = 54,
    ReadForces = 55, Subscribe = 56, Subscribed = 57, Unsubscribe = 58, Update = 59, Forces = 60,
    ReadTerminals = 61, Terminals = 62,
    StartTrace = 64, StopTrace = 65, TraceBlock = 66, TraceBlockTaken = 67,
    Axis = 72, Heartbeat = 73, Beat = 74, StopAll = 75,
    ReadLog = 80, LogEntries = 81, Logged = 82,
};

// --- handshake and general ---

struct Hello {
    static constexpr Type type = Type::Hello;
    std::uint32_t major = ProtocolMajor, minor = ProtocolMinor;
    std::string client; ///< how it names itself to people: "camwright (anna@desk)"
    bool operator==(const Hello&) const = default;
};

struct Welcome {
    static constexpr Type type = Type::Welcome;
    std::uint32_t major = ProtocolMajor, minor = ProtocolMinor;
    std::string controller;             ///< program and version
    Bytes session;                      ///< 16 random bytes
    std::vector<std::string> methods;   ///< of authentication: "none"
    std::int64_t cycleNs = 1'000'000;   ///< length of a motion cycle
    bool operator==(const Welcome&) const = default;
};

struct Authenticate {
    static constexpr Type type = Type::Authenticate;
    std::string method = "none";
    bool operator==(const Authenticate&) const = default;
};

struct Authenticated {
    static constexpr Type type = Type::Authenticated;
    Role role = Role::Observe;
    LinkCapabilities capabilities;
    bool operator==(const Authenticated&) const = default;
};

struct Done { static constexpr Type type = Type::Done; bool operator==(const Done&) const = default; };

struct Failed {
    static constexpr Type type = Type::Failed;
    Diagnostic reason;
    bool operator==(const Failed&) const = default;
};

struct Ping { static constexpr Type type = Type::Ping; bool operator==(const Ping&) const = default; };

struct Pong {
    static constexpr Type type = Type::Pong;
    std::uint64_t cycle = 0;
    Time time{};
    bool operator==(const Pong&) const = default;
};

struct Status {
    static constexpr Type type = Type::Status;
    ControllerStatus status;
    bool operator==(const Status&) const = default;
};

// --- control ---

struct TakeControl { static constexpr Type type = Type::TakeControl; bool operator==(const TakeControl&) const = default; };
struct RenewControl { static constexpr Type type = Type::RenewControl; bool operator==(const RenewControl&) const = default; };
struct ReleaseControl { static constexpr Type type = Type::ReleaseControl; bool operator==(const ReleaseControl&) const = default; };

// --- download ---

/// A long manifest comes in several; the parts of all count together, and the last is answered.
struct PlanDownload {
    static constexpr Type type = Type::PlanDownload;
    Manifest manifest;
    bool more = false;
    bool operator==(const PlanDownload&) const = default;
};

struct Plan {
    static constexpr Type type = Type::Plan;
    DownloadPlan plan;
    bool operator==(const Plan&) const = default;
};

struct BeginDownload {
    static constexpr Type type = Type::BeginDownload;
    std::uint64_t size = 0; ///< bytes of the image
    Hash image;             ///< of those bytes
    Hash program;           ///< what will be running afterwards
    bool operator==(const BeginDownload&) const = default;
};

struct DownloadBegun {
    static constexpr Type type = Type::DownloadBegun;
    std::uint32_t transfer = 0;
    bool operator==(const DownloadBegun&) const = default;
};

struct Piece {
    static constexpr Type type = Type::Piece;
    std::uint32_t transfer = 0;
    std::uint64_t offset = 0;
    Bytes bytes;
    bool operator==(const Piece&) const = default;
};

struct PieceTaken {
    static constexpr Type type = Type::PieceTaken;
    std::uint32_t transfer = 0;
    std::uint64_t received = 0; ///< bytes without a hole from the start
    bool operator==(const PieceTaken&) const = default;
};

struct CommitDownload {
    static constexpr Type type = Type::CommitDownload;
    std::uint32_t transfer = 0;
    bool operator==(const CommitDownload&) const = default;
};

struct AbortDownload {
    static constexpr Type type = Type::AbortDownload;
    std::uint32_t transfer = 0;
    bool operator==(const AbortDownload&) const = default;
};

// --- run, stop ---

struct Run { static constexpr Type type = Type::Run; bool operator==(const Run&) const = default; };
struct Stop { static constexpr Type type = Type::Stop; bool operator==(const Stop&) const = default; };
/// Ends the controller process: only a local, virtual one agrees (CONTRACTS 14).
struct Exit { static constexpr Type type = Type::Exit; bool operator==(const Exit&) const = default; };

// --- values; `program` is the hash the names were resolved against ---

struct Read {
    static constexpr Type type = Type::Read;
    Hash program;
    std::vector<std::string> names;
    bool operator==(const Read&) const = default;
};

/// Value `index` of the names asked for.
struct IndexedValue {
    std::uint32_t index = 0;
    Value value;
    bool forced = false;
    bool operator==(const IndexedValue&) const = default;
};

struct Values {
    static constexpr Type type = Type::Values;
    std::uint64_t cycle = 0;
    std::vector<IndexedValue> values;
    bool operator==(const Values&) const = default;
};

struct Write {
    static constexpr Type type = Type::Write;
    Hash program;
    std::string name;
    Value value;
    bool operator==(const Write&) const = default;
};

struct Force {
    static constexpr Type type = Type::Force;
    Hash program;
    std::string name;
    Value value;
    bool operator==(const Force&) const = default;
};

struct Release {
    static constexpr Type type = Type::Release;
    Hash program;
    std::string name; ///< empty: every force
    bool operator==(const Release&) const = default;
};

struct Describe {
    static constexpr Type type = Type::Describe;
    Hash program;
    std::vector<std::string> names;
    bool operator==(const Describe&) const = default;
};

struct Types {
    static constexpr Type type = Type::Types;
    std::vector<DataType> types;
    bool operator==(const Types&) const = default;
};

struct ReadForces { static constexpr Type type = Type::ReadForces; bool operator==(const ReadForces&) const = default; };

struct Forces {
    static constexpr Type type = Type::Forces;
    std::vector<MonitoredValue> values; ///< by address
    bool operator==(const Forces&) const = default;
};

struct ReadTerminals {
    static constexpr Type type = Type::ReadTerminals;
    bool operator==(const ReadTerminals&) const = default;
};

struct Terminals {
    static constexpr Type type = Type::Terminals;
    std::vector<TerminalInfo> terminals;
    bool operator==(const Terminals&) const = default;
};

struct Subscribe {
    static constexpr Type type = Type::Subscribe;
    Hash program;
    std::uint32_t subscription = 0; ///< the client's choice, its own
    std::vector<std::string> names;
    Time period{};
    bool operator==(const Subscribe&) const = default;
};

struct Subscribed {
    static constexpr Type type = Type::Subscribed;
    std::uint32_t subscription = 0;
    std::vector<std::uint32_t> unknown; ///< indices of names the program does not have; the others are sent
    bool operator==(const Subscribed&) const = default;
};

struct Unsubscribe {
    static constexpr Type type = Type::Unsubscribe;
    std::uint32_t subscription = 0;
    bool operator==(const Unsubscribe&) const = default;
};

struct Update {
    static constexpr Type type = Type::Update;
    Hash program;
    std::uint32_t subscription = 0;
    std::uint64_t cycle = 0;
    std::vector<IndexedValue> values;
    bool operator==(const Update&) const = default;
};

// --- trace ---

struct StartTrace {
    static constexpr Type type = Type::StartTrace;
    Hash program;
    TraceSetup setup;
    bool operator==(const StartTrace&) const = default;
};

struct StopTrace { static constexpr Type type = Type::StopTrace; bool operator==(const StopTrace&) const = default; };

struct TraceBlock {
    static constexpr Type type = Type::TraceBlock;
    SampleBlock block;
    bool operator==(const TraceBlock&) const = default;
};

struct TraceBlockTaken {
    static constexpr Type type = Type::TraceBlockTaken;
    std::uint32_t channelSet = 0;
    std::uint64_t sequence = 0;
    bool operator==(const TraceBlockTaken&) const = default;
};

// --- motion ---

struct Axis {
    static constexpr Type type = Type::Axis;
    AxisCommand command;
    bool operator==(const Axis&) const = default;
};

/// The dead-man's beat: the newest cycle its sender has seen.
struct Heartbeat {
    static constexpr Type type = Type::Heartbeat;
    std::uint64_t cycle = 0;
    bool operator==(const Heartbeat&) const = default;
};

/// The answer to a heartbeat, so that its sender always knows a fresh cycle.
struct Beat {
    static constexpr Type type = Type::Beat;
    std::uint64_t cycle = 0;
    bool operator==(const Beat&) const = default;
};

struct StopAll { static constexpr Type type = Type::StopAll; bool operator==(const StopAll&) const = default; };

// --- log ---

struct ReadLog {
    static constexpr Type type = Type::ReadLog;
    std::uint64_t from = 0; ///< first sequence number wanted
    bool operator==(const ReadLog&) const = default;
};

struct LogEntries {
    static constexpr Type type = Type::LogEntries;
    std::vector<LogEntry> entries;
    bool more = false; ///< ask again from the last sequence number + 1
    bool operator==(const LogEntries&) const = default;
};

struct Logged {
    static constexpr Type type = Type::Logged;
    LogEntry entry;
    bool operator==(const Logged&) const = default;
};

} // namespace camwright::message

namespace camwright {

using Message = std::variant<
    message::Hello, message::Welcome, message::Authenticate, message::Authenticated, message::Done, message::Failed, message::Ping,
    message::Pong, message::Status, message::TakeControl, message::RenewControl, message::ReleaseControl, message::PlanDownload,
    message::Plan, message::BeginDownload, message::DownloadBegun, message::Piece, message::PieceTaken, message::CommitDownload,
    message::AbortDownload, message::Run, message::Stop, message::Exit, message::Read, message::Values, message::Write,
    message::Force, message::Release, message::Describe, message::Types, message::Subscribe, message::Subscribed,
    message::Unsubscribe, message::Update, message::ReadForces, message::Forces, message::ReadTerminals, message::Terminals,
    message::StartTrace, message::StopTrace, message::TraceBlock, message::TraceBlockTaken, message::Axis, message::Heartbeat, message::Beat, message::StopAll, message::ReadLog, message::LogEntries, message::Logged>;

/// What travels: a message and the request it asks or answers. Requests count from 1; 0 is a push or needs no answer.
struct Envelope {
    std::uint32_t request = 0;
    Message message;
    bool operator==(const Envelope&) const = default;
};

enum class Sender : std::uint8_t { Client, Controller };

/// What the controller asks of whoever sends a message, and how it travels.
struct MessageRule {
    message::Type type;
    const char* name;    ///< "takeControl"
    Sender sender;
    Role role;           ///< the least role that may send it
    bool needsControl;   ///< only from the holder of the lease
    bool urgent;         ///< overtakes everything that waits to be sent
};

/// One row a message, in the order of `Message`.
const std::array<MessageRule, std::variant_size_v<Message>>& messageRules();
inline const MessageRule& ruleOf(const Message& message) { return messageRules()[message.index()]; }

} // namespace camwright
