#include "devices/server/clientconnection.h"

#include "devices/server/server.h"

#include <QDeadlineTimer>
#include <QPointer>
#include <QRandomGenerator>

namespace camwright {

namespace {
constexpr std::size_t Congested = 64 * 1024;      // bytes waiting: pushes wait or are replaced by newer ones
constexpr std::size_t Overfull = 512 * 1024;      // bytes waiting: nothing more is read until they are gone
constexpr std::size_t LongestName = 64;           // of a client, as shown to people

/// A name as people may see it: no control characters, not endless.
std::string presentable(const std::string& text)
{
    std::string out;
    for (const char c : text.substr(0, LongestName))
        out += static_cast<unsigned char>(c) < 0x20 || c == 0x7F ? '?' : c;
    return out.empty() ? CW_TEXT("Arguments", "a client") : out;
}

Time monotonic()
{
    return Time(QDeadlineTimer::current().deadlineNSecs());
}
} // namespace

ClientConnection::ClientConnection(Server& server, ClientId id, std::unique_ptr<ByteStream> stream)
    : m_server(server), m_id(id), m_budget(server.options().messagesPerSecond)
{
    m_channel = std::make_unique<MessageChannel>(std::move(stream), MessageChannel::Listener{
        [this](const Envelope& envelope) { receive(envelope); },
        [this](const std::string& reason, bool broken) { ended(reason, broken); },
        [this] { flush(); }}, message::MaximumHandshakeFrame);
}

ClientConnection::~ClientConnection() = default;

std::string ClientConnection::who() const
{
    return m_name.empty() ? m_channel->peer() : m_name + " (" + m_channel->peer() + ")";
}

void ClientConnection::send(std::uint32_t request, Message message)
{
    if (!m_channel->send({request, std::move(message)}) && request != 0)
        m_channel->send({request, message::Failed{diagnostic(Code::TooMuchAsked, {"answer", CW_TEXT("Arguments", "more than a message"),
                                                                                  std::to_string(message::MaximumFrame)})}});
}

void ClientConnection::refuse(const Diagnostic& why)
{
    m_stage = Stage::Closed;
    send(0, message::Failed{why});
    m_channel->close();
    m_server.drop(m_id);
}

void ClientConnection::violate(const std::string& why)
{
    m_server.noteDropped(who(), why);
    refuse(diagnostic(Code::ProtocolBroken, {who(), why}));
}

void ClientConnection::ended(const std::string& reason, bool broken)
{
    if (m_stage == Stage::Closed)
        return;
    if (broken)
        m_server.noteDropped(who(), reason);
    else if (m_stage == Stage::Ready)
        m_server.host().note(diagnostic(Code::ClientLeft, {m_name}));
    if (m_transfer && !m_transfer->bytes.empty())
        m_server.host().note(diagnostic(Code::AbandonedDownload, {m_name}));
    m_stage = Stage::Closed;
    m_server.drop(m_id);
}

void ClientConnection::watch(Time passed)
{
    const std::size_t perSecond = m_server.options().messagesPerSecond;
    const auto share = static_cast<std::size_t>(static_cast<double>(perSecond) * seconds(passed));
    m_budget = std::min(m_budget + share, perSecond);
    if (m_budget > 0 && m_channel->waiting() < Overfull)
        m_channel->setPaused(false);
    m_silent += passed;
    if (m_channel->messagesReceived() != m_heard) {
        m_heard = m_channel->messagesReceived();
        if (m_stage == Stage::Ready)
            m_silent = {};
    }
    const Time limit = m_stage == Stage::Ready ? m_server.options().silence : m_server.options().handshakeTime;
    if (m_silent > limit)
        violate(fillTemplate(CW_TEXT("Arguments", "nothing came for %1 s"), {std::to_string(limit / 1s)}));
}

bool ClientConnection::mayAsk(const Envelope& envelope)
{
    const MessageRule& rule = ruleOf(envelope.message);
    if (m_role < rule.role) {
        send(envelope.request, message::Failed{diagnostic(Code::RoleTooLow, {rule.name})});
        return false;
    }
    const auto* axis = std::get_if<message::Axis>(&envelope.message);
    const bool isStop = axis != nullptr && axis->command.kind == AxisCommandKind::Stop;
    if (!rule.needsControl || isStop || m_server.holder() == m_id)
        return true;
    const Diagnostic why = m_server.holder() == 0 ? diagnostic(Code::ControlNeeded, {rule.name})
                                                  : diagnostic(Code::ControlHeld, {m_server.holderName()});
    if (envelope.request != 0)
        send(envelope.request, message::Failed{why});
    return false;
}

void ClientConnection::receive(const Envelope& envelope)
{
    if (m_stage == Stage::Closed)
        return;
    const bool handshake = std::holds_alternative<message::Hello>(envelope.message)
        || std::holds_alternative<message::Authenticate>(envelope.message)
        || std::holds_alternative<message::StopAll>(envelope.message);
    if (m_stage != Stage::Ready && !handshake)
        return violate(CW_TEXT("Arguments", "a message before the handshake was done"));
    if (m_budget > 0)
        --m_budget;
    if (m_budget == 0 || m_channel->waiting() > Overfull)
        m_channel->setPaused(true); // watch() resumes
    if (mayAsk(envelope))
        std::visit([&](const auto& message) { on(envelope.request, message); }, envelope.message);
}

void ClientConnection::answer(std::uint32_t request, const Result<void>& result)
{
    if (request == 0 || m_stage == Stage::Closed)
        return;
    if (result)
        send(request, message::Done{});
    else
        send(request, message::Failed{result.error()});
}

ControllerHost::Done ClientConnection::doneFor(std::uint32_t request)
{
    return [server = &m_server, id = m_id, request](Result<void> result) {
        if (ClientConnection* self = server->client(id))
            self->answer(request, result);
    };
}

template <class T, class Make>
ControllerHost::Reply<T> ClientConnection::replyFor(std::uint32_t request, Make make)
{
    return [server = &m_server, id = m_id, request, make](Result<T> result) {
        ClientConnection* self = server->client(id);
        if (self == nullptr)
            return;
        if (result)
            self->send(request, make(std::move(*result)));
        else
            self->send(request, message::Failed{result.error()});
    };
}

bool ClientConnection::tooMany(std::uint32_t request, const char* what, std::size_t count, std::size_t limit)
{
    if (count <= limit)
        return false;
    send(request, message::Failed{diagnostic(Code::TooMuchAsked, {what, std::to_string(count), std::to_string(limit)})});
    return true;
}

// --- handshake ---

void ClientConnection::on(std::uint32_t request, const message::Hello& hello)
{
    if (m_stage != Stage::Hello)
        return violate(CW_TEXT("Arguments", "a second hello"));
    m_name = presentable(hello.client);
    if (hello.major != message::ProtocolMajor)
        return refuse(diagnostic(Code::ProtocolVersion, {std::to_string(message::ProtocolMajor), std::to_string(hello.major)}));
    message::Welcome welcome;
    welcome.controller = m_server.options().name;
    welcome.session.resize(16);
    for (std::uint8_t& byte : welcome.session)
        byte = static_cast<std::uint8_t>(QRandomGenerator::system()->generate());
    welcome.methods = {"none"};
    welcome.cycleNs = kMotionCycle.count();
    m_stage = Stage::Authenticate;
    send(request, welcome);
}

void ClientConnection::on(std::uint32_t request, const message::Authenticate& authenticate)
{
    if (m_stage != Stage::Authenticate)
        return violate("authenticate without hello, or twice");
    if (authenticate.method != "none")
        return refuse(diagnostic(Code::RoleTooLow, {"authenticate"}));
    m_stage = Stage::Ready;
    m_silent = {};
    m_role = Role::Engineer; // only this machine can connect, and only until there are users
    m_channel->setFrameLimit(message::MaximumFrame);
    message::Authenticated reply;
    reply.role = m_role;
    LinkCapabilities& can = reply.capabilities;
    can.download = can.runStop = can.write = can.force = can.trace = can.motion = can.terminals = can.simulated = true;
    send(request, reply);
    sendStatus(m_server.lastStatus(), m_server.holder());
    m_server.host().note(diagnostic(Code::ClientCame, {m_name}));
}

void ClientConnection::on(std::uint32_t request, const message::Ping&)
{
    send(request, message::Pong{m_status.cycle, m_status.time});
}

// --- control ---

void ClientConnection::on(std::uint32_t request, const message::TakeControl&)
{
    m_server.host().takeControl(m_id, m_name, [server = &m_server, id = m_id, request](Result<void> result) {
        ClientConnection* self = server->client(id);
        if (self == nullptr)
            return;
        if (result)
            server->setHolder(id, self->m_name);
        self->answer(request, result);
    });
}

void ClientConnection::on(std::uint32_t, const message::RenewControl&) { m_server.host().renewControl(m_id); }
void ClientConnection::on(std::uint32_t request, const message::ReleaseControl&)
{
    m_server.host().releaseControl(m_id, doneFor(request));
}

// --- download ---

void ClientConnection::on(std::uint32_t request, const message::PlanDownload& plan)
{
    if (m_parts.size() + plan.manifest.parts.size() > message::MaximumParts) {
        m_parts.clear();
        return answer(request, diagnostic(Code::TooMuchAsked, {"planDownload", CW_TEXT("Arguments", "more parts"), std::to_string(message::MaximumParts)}));
    }
    m_parts.insert(m_parts.end(), plan.manifest.parts.begin(), plan.manifest.parts.end());
    if (plan.more)
        return;
    Manifest whole = plan.manifest;
    whole.parts = std::move(m_parts);
    m_parts.clear();
    DownloadPlan found = m_server.host().plan(whole);
    found.lines.resize(std::min(found.lines.size(), message::PlanLines));
    send(request, message::Plan{std::move(found)});
}

void ClientConnection::on(std::uint32_t request, const message::BeginDownload& begin)
{
    m_transfer.reset();
    if (begin.size == 0 || begin.size > message::MaximumImage)
        return answer(request, diagnostic(Code::ImageTooLarge, {std::to_string(begin.size), std::to_string(message::MaximumImage)}));
    m_transfer = std::make_unique<Transfer>(); // room is taken as pieces arrive, not as announced
    m_transfer->number = ++m_transfers;
    m_transfer->size = begin.size;
    m_transfer->image = begin.image;
    m_transfer->program = begin.program;
    send(request, message::DownloadBegun{m_transfer->number});
}

void ClientConnection::on(std::uint32_t request, const message::Piece& piece)
{
    if (!m_transfer || m_transfer->number != piece.transfer)
        return answer(request, diagnostic(Code::TransferUnknown, {std::to_string(piece.transfer)}));
    Bytes& bytes = m_transfer->bytes;
    if (piece.offset != bytes.size() || piece.bytes.size() > m_transfer->size - bytes.size() || piece.bytes.empty()) {
        const Diagnostic why = diagnostic(Code::PieceMisplaced, {std::to_string(piece.offset), std::to_string(bytes.size())});
        m_transfer.reset();
        return answer(request, why);
    }
    bytes.insert(bytes.end(), piece.bytes.begin(), piece.bytes.end());
    send(request, message::PieceTaken{piece.transfer, bytes.size()});
}

void ClientConnection::on(std::uint32_t request, const message::CommitDownload& commit)
{
    if (!m_transfer || m_transfer->number != commit.transfer)
        return answer(request, diagnostic(Code::TransferUnknown, {std::to_string(commit.transfer)}));
    const std::unique_ptr<Transfer> transfer = std::move(m_transfer);
    if (transfer->bytes.size() != transfer->size)
        return answer(request, diagnostic(Code::PieceMisplaced, {std::to_string(transfer->size), std::to_string(transfer->bytes.size())}));
    const Hash found = hashOf(transfer->bytes);
    if (found != transfer->image)
        return answer(request, diagnostic(Code::ImageDamaged, {shortHex(found), shortHex(transfer->image)}));
    m_server.host().commit(m_id, m_name, std::move(transfer->bytes), transfer->program, doneFor(request));
}

void ClientConnection::on(std::uint32_t request, const message::AbortDownload& abort)
{
    if (m_transfer && m_transfer->number == abort.transfer) {
        m_transfer.reset();
        m_server.host().note(diagnostic(Code::AbandonedDownload, {m_name}));
    }
    answer(request, {});
}

// --- run, stop, values ---

void ClientConnection::on(std::uint32_t request, const message::Run&) { m_server.host().run(m_id, doneFor(request)); }
void ClientConnection::on(std::uint32_t request, const message::Stop&) { m_server.host().stop(m_id, doneFor(request)); }

void ClientConnection::on(std::uint32_t request, const message::Exit&)
{
    if (!m_server.options().mayExit)
        return answer(request, diagnostic(Code::ExitRefused));
    answer(request, {});
    m_server.requestExit();
}

void ClientConnection::on(std::uint32_t request, const message::Read& read)
{
    if (tooMany(request, "read", read.names.size(), message::MaximumNames))
        return;
    m_server.host().read(read.program, read.names, replyFor<ControllerHost::Values>(request, [](ControllerHost::Values&& found) {
        message::Values out;
        out.cycle = found.cycle;
        for (std::uint32_t i = 0; i < found.values.size(); ++i)
            out.values.push_back({i, found.values[i].value, found.values[i].forced});
        return out;
    }));
}

void ClientConnection::on(std::uint32_t request, const message::Write& write)
{
    m_server.host().write(m_id, write.program, write.name, write.value, doneFor(request));
}

void ClientConnection::on(std::uint32_t request, const message::Force& force)
{
    m_server.host().force(m_id, force.program, force.name, force.value, doneFor(request));
}

void ClientConnection::on(std::uint32_t request, const message::Release& release)
{
    m_server.host().release(m_id, release.program, release.name, doneFor(request));
}

void ClientConnection::on(std::uint32_t request, const message::Describe& describe)
{
    if (tooMany(request, "describe", describe.names.size(), message::MaximumNames))
        return;
    m_server.host().describe(describe.program, describe.names,
        replyFor<std::vector<DataType>>(request, [](std::vector<DataType>&& types) { return message::Types{std::move(types)}; }));
}

void ClientConnection::on(std::uint32_t request, const message::Subscribe& subscribe)
{
    if (tooMany(request, "subscribe", subscribe.names.size(), message::MaximumNames))
        return;
    m_server.host().subscribe(m_id, subscribe, replyFor<std::vector<std::uint32_t>>(request,
        [number = subscribe.subscription](std::vector<std::uint32_t>&& unknown) {
            return message::Subscribed{number, std::move(unknown)};
        }));
}

void ClientConnection::on(std::uint32_t request, const message::Unsubscribe& unsubscribe)
{
    m_heldUpdates.erase(unsubscribe.subscription);
    m_server.host().unsubscribe(m_id, unsubscribe.subscription);
    answer(request, {});
}

void ClientConnection::on(std::uint32_t request, const message::ReadForces&)
{
    m_server.host().forced(replyFor<std::vector<MonitoredValue>>(request, [](std::vector<MonitoredValue>&& values) {
        values.resize(std::min(values.size(), message::MaximumNames));
        return message::Forces{std::move(values)};
    }));
}

void ClientConnection::on(std::uint32_t request, const message::ReadTerminals&)
{
    m_server.host().terminals(replyFor<std::vector<TerminalInfo>>(request,
        [](std::vector<TerminalInfo>&& terminals) { return message::Terminals{std::move(terminals)}; }));
}

// --- trace ---

void ClientConnection::on(std::uint32_t request, const message::StartTrace& start)
{
    constexpr std::size_t MaximumChannels = 32;
    if (tooMany(request, "startTrace", start.setup.channels.size(), MaximumChannels))
        return;
    m_server.host().startTrace(m_id, m_name, start.program, start.setup, doneFor(request));
}

void ClientConnection::on(std::uint32_t request, const message::StopTrace&)
{
    m_server.host().stopTrace(m_id, doneFor(request));
}

void ClientConnection::on(std::uint32_t, const message::TraceBlockTaken& taken)
{
    m_samples.taken(taken.channelSet, taken.sequence, monotonic());
    pumpSamples();
}

// --- motion, log ---

void ClientConnection::on(std::uint32_t request, const message::Axis& axis)
{
    m_server.host().axis(m_id, axis.command, doneFor(request));
}

void ClientConnection::on(std::uint32_t, const message::Heartbeat& heartbeat)
{
    m_server.host().heartbeat(m_id, heartbeat.cycle);
}

void ClientConnection::on(std::uint32_t request, const message::StopAll&) { m_server.host().stopAll(doneFor(request)); }

void ClientConnection::on(std::uint32_t request, const message::ReadLog& read)
{
    send(request, m_server.host().log(read.from));
}

// --- pushes ---

void ClientConnection::sendStatus(const ControllerStatus& status, ClientId holder)
{
    if (m_stage != Stage::Ready)
        return;
    m_status = status;
    m_status.control = holder == 0 ? ControlHolder::Nobody : holder == m_id ? ControlHolder::You : ControlHolder::Somebody;
    if (m_channel->waiting() < Congested) // else a newer one will do
        send(0, message::Status{m_status});
}

void ClientConnection::sendUpdate(const message::Update& update)
{
    if (m_channel->waiting() < Congested)
        send(0, update);
    else
        m_heldUpdates[update.subscription] = update; // only the newest waits
}

void ClientConnection::sendSamples(SampleBlock block)
{
    m_samples.add(std::move(block));
    pumpSamples();
}

void ClientConnection::sendBeat(std::uint64_t cycle) { send(0, message::Beat{cycle}); }

void ClientConnection::sendLog(const LogEntry& entry)
{
    if (m_stage == Stage::Ready && m_channel->waiting() < Overfull) // its number shows if one is missing
        send(0, message::Logged{entry});
}

void ClientConnection::flush()
{
    while (!m_heldUpdates.empty() && m_channel->waiting() < Congested) {
        const auto first = m_heldUpdates.begin();
        send(0, first->second);
        m_heldUpdates.erase(first);
    }
}

void ClientConnection::pumpSamples()
{
    while (auto block = m_samples.next())
        send(0, message::TraceBlock{std::move(*block)});
}

} // namespace camwright
