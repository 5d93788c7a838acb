#pragma once

#include "core/online/messages.h"

#include <tuple>

/// Which field of a message has which key on the wire. Keys are permanent, below 64 and unique within their message.
namespace camwright::wire {

template <class Owner, class Member>
struct FieldEntry {
    unsigned key;
    Member Owner::*member;
    bool required;
};

template <class Owner, class Member>
constexpr FieldEntry<Owner, Member> must(unsigned key, Member Owner::*member) { return {key, member, true}; }
template <class Owner, class Member>
constexpr FieldEntry<Owner, Member> may(unsigned key, Member Owner::*member) { return {key, member, false}; }

template <class T>
struct Fields; ///< `list`: a tuple of FieldEntry

#define CAMWRIGHT_FIELDS(Struct, ...)                                                                                               \
    template <>                                                                                                                     \
    struct Fields<Struct> {                                                                                                         \
        using S = Struct;                                                                                                           \
        static constexpr auto list = std::make_tuple(__VA_ARGS__);                                                                  \
    };

// --- parts of messages ---

CAMWRIGHT_FIELDS(TextRange, must(1, &S::line), must(2, &S::column), must(3, &S::endLine), must(4, &S::endColumn))
CAMWRIGHT_FIELDS(ObjectKey, must(1, &S::kind), must(2, &S::name))
CAMWRIGHT_FIELDS(Place, must(1, &S::object), must(2, &S::field), may(3, &S::range), may(4, &S::file))
CAMWRIGHT_FIELDS(LinkCapabilities, must(1, &S::download), must(2, &S::runStop), must(3, &S::write), must(4, &S::force),
                 must(5, &S::trace), must(6, &S::motion), must(7, &S::terminals), must(8, &S::simulated), must(9, &S::whyNoMotion))
CAMWRIGHT_FIELDS(AxisStatus, must(1, &S::name), must(2, &S::number), must(3, &S::state), must(4, &S::stateName), must(5, &S::error),
                 must(6, &S::enabled), must(7, &S::homed), must(8, &S::moving), must(9, &S::online), must(10, &S::panelArmed),
                 must(11, &S::lowerLimit), must(12, &S::upperLimit), must(13, &S::homeSwitch), must(14, &S::position),
                 must(15, &S::setPosition), must(16, &S::velocity), must(17, &S::followingError), must(18, &S::torque),
                 must(19, &S::unit), must(20, &S::lastCause), must(21, &S::lastChange))
CAMWRIGHT_FIELDS(ControllerStatus, must(1, &S::cycle), must(2, &S::time), must(3, &S::state), must(4, &S::family), must(5, &S::model),
                 must(6, &S::projectName), must(7, &S::program), must(8, &S::scanMs), must(9, &S::scanMaxMs),
                 must(10, &S::busLoadPercent), must(11, &S::forces), must(12, &S::lateCycles), must(13, &S::control),
                 must(14, &S::controlOwner), must(15, &S::axes))
CAMWRIGHT_FIELDS(LogEntry, must(1, &S::sequence), must(2, &S::cycle), must(3, &S::time), must(4, &S::message))
CAMWRIGHT_FIELDS(PlanLine, must(1, &S::what), must(2, &S::effect), must(3, &S::message))
CAMWRIGHT_FIELDS(DownloadPlan, must(1, &S::sameProgram), must(2, &S::mustStop), must(3, &S::lines))
CAMWRIGHT_FIELDS(ManifestPart, must(1, &S::kind), must(2, &S::name), must(3, &S::hash))
CAMWRIGHT_FIELDS(Manifest, must(1, &S::program), must(2, &S::family), must(3, &S::model), must(4, &S::parts))
CAMWRIGHT_FIELDS(AxisCommand, must(1, &S::axis), must(2, &S::kind), may(3, &S::position), may(4, &S::velocity), may(5, &S::acceleration))
CAMWRIGHT_FIELDS(TraceSetup, must(1, &S::channels), must(2, &S::stride), may(3, &S::trigger), may(4, &S::triggerChannel),
                 may(5, &S::triggerLevel), may(6, &S::preTrigger), may(7, &S::samples))
CAMWRIGHT_FIELDS(MonitoredValue, must(1, &S::name), must(2, &S::value), must(3, &S::forced))
CAMWRIGHT_FIELDS(TerminalInfo, must(1, &S::name), must(2, &S::isInput))
CAMWRIGHT_FIELDS(ChannelInfo, must(1, &S::name), must(2, &S::type), must(3, &S::unit))
CAMWRIGHT_FIELDS(SampleBlock, must(1, &S::channelSet), must(2, &S::sequence), must(3, &S::firstCycle), must(4, &S::stride),
                 must(5, &S::cycleNs), must(6, &S::lostRows), must(7, &S::triggerCycle), must(8, &S::last), may(9, &S::channels),
                 must(10, &S::columns))

// --- messages ---

CAMWRIGHT_FIELDS(message::Hello, must(1, &S::major), must(2, &S::minor), must(3, &S::client))
CAMWRIGHT_FIELDS(message::Welcome, must(1, &S::major), must(2, &S::minor), must(3, &S::controller), must(4, &S::session),
                 must(5, &S::methods), must(6, &S::cycleNs))
CAMWRIGHT_FIELDS(message::Authenticate, must(1, &S::method))
CAMWRIGHT_FIELDS(message::Authenticated, must(1, &S::role), must(2, &S::capabilities))
CAMWRIGHT_FIELDS(message::Done)
CAMWRIGHT_FIELDS(message::Failed, must(1, &S::reason))
CAMWRIGHT_FIELDS(message::Ping)
CAMWRIGHT_FIELDS(message::Pong, must(1, &S::cycle), must(2, &S::time))
CAMWRIGHT_FIELDS(message::Status, must(1, &S::status))
CAMWRIGHT_FIELDS(message::TakeControl)
CAMWRIGHT_FIELDS(message::RenewControl)
CAMWRIGHT_FIELDS(message::ReleaseControl)
CAMWRIGHT_FIELDS(message::PlanDownload, must(1, &S::manifest), must(2, &S::more))
CAMWRIGHT_FIELDS(message::Plan, must(1, &S::plan))
CAMWRIGHT_FIELDS(message::BeginDownload, must(1, &S::size), must(2, &S::image), must(3, &S::program))
CAMWRIGHT_FIELDS(message::DownloadBegun, must(1, &S::transfer))
CAMWRIGHT_FIELDS(message::Piece, must(1, &S::transfer), must(2, &S::offset), must(3, &S::bytes))
CAMWRIGHT_FIELDS(message::PieceTaken, must(1, &S::transfer), must(2, &S::received))
CAMWRIGHT_FIELDS(message::CommitDownload, must(1, &S::transfer))
CAMWRIGHT_FIELDS(message::AbortDownload, must(1, &S::transfer))
CAMWRIGHT_FIELDS(message::Run)
CAMWRIGHT_FIELDS(message::Stop)
CAMWRIGHT_FIELDS(message::Exit)
CAMWRIGHT_FIELDS(message::Read, must(1, &S::program), must(2, &S::names))
CAMWRIGHT_FIELDS(message::Values, must(1, &S::cycle), must(2, &S::values))
CAMWRIGHT_FIELDS(message::Write, must(1, &S::program), must(2, &S::name), must(3, &S::value))
CAMWRIGHT_FIELDS(message::Force, must(1, &S::program), must(2, &S::name), must(3, &S::value))
CAMWRIGHT_FIELDS(message::Release, must(1, &S::program), must(2, &S::name))
CAMWRIGHT_FIELDS(message::Describe, must(1, &S::program), must(2, &S::names))
CAMWRIGHT_FIELDS(message::Types, must(1, &S::types))
CAMWRIGHT_FIELDS(message::Subscribe, must(1, &S::program), must(2, &S::subscription), must(3, &S::names), must(4, &S::period))
CAMWRIGHT_FIELDS(message::Subscribed, must(1, &S::subscription), must(2, &S::unknown))
CAMWRIGHT_FIELDS(message::Unsubscribe, must(1, &S::subscription))
CAMWRIGHT_FIELDS(message::Update, must(1, &S::program), must(2, &S::subscription), must(3, &S::cycle), must(4, &S::values))
CAMWRIGHT_FIELDS(message::ReadForces)
CAMWRIGHT_FIELDS(message::Forces, must(1, &S::values))
CAMWRIGHT_FIELDS(message::ReadTerminals)
CAMWRIGHT_FIELDS(message::Terminals, must(1, &S::terminals))
CAMWRIGHT_FIELDS(message::StartTrace, must(1, &S::program), must(2, &S::setup))
CAMWRIGHT_FIELDS(message::StopTrace)
CAMWRIGHT_FIELDS(message::TraceBlock, must(1, &S::block))
CAMWRIGHT_FIELDS(message::TraceBlockTaken, must(1, &S::channelSet), must(2, &S::sequence))
CAMWRIGHT_FIELDS(message::Axis, must(1, &S::command))
CAMWRIGHT_FIELDS(message::Heartbeat, must(1, &S::cycle))
CAMWRIGHT_FIELDS(message::Beat, must(1, &S::cycle))
CAMWRIGHT_FIELDS(message::StopAll)
CAMWRIGHT_FIELDS(message::ReadLog, must(1, &S::from))
CAMWRIGHT_FIELDS(message::LogEntries, must(1, &S::entries), must(2, &S::more))
CAMWRIGHT_FIELDS(message::Logged, must(1, &S::entry))

#undef CAMWRIGHT_FIELDS

// --- the last legal number of each enumeration that travels ---

template <class E>
inline constexpr E LastOf = E{};
template <> inline constexpr ObjectKind LastOf<ObjectKind> = ObjectKind::WatchTable;
template <> inline constexpr RunState LastOf<RunState> = RunState::Error;
template <> inline constexpr ControlHolder LastOf<ControlHolder> = ControlHolder::Somebody;
template <> inline constexpr PartKind LastOf<PartKind> = PartKind::Retained;
template <> inline constexpr AxisCommandKind LastOf<AxisCommandKind> = AxisCommandKind::Stop;
template <> inline constexpr TriggerKind LastOf<TriggerKind> = TriggerKind::Below;
template <> inline constexpr Role LastOf<Role> = Role::Engineer;
template <> inline constexpr DataType LastOf<DataType> = DataType::Lword;

template <class E>
inline constexpr E FirstOf = E{};
template <> inline constexpr DataType FirstOf<DataType> = DataType::Bool;

} // namespace camwright::wire
