#pragma once

#include "core/online/messages.h"
#include "devices/controller/controllerhost.h"
#include "devices/server/samplequeue.h"
#include "devices/transport/messagechannel.h"

#include <QObject>

#include <map>
#include <memory>
#include <string>

namespace camwright {

class Server;

/// One client of the server, from its first byte to its last.
class ClientConnection final : public QObject {
    Q_OBJECT
public:
    ClientConnection(Server& server, ClientId id, std::unique_ptr<ByteStream> stream);
    ~ClientConnection() override;

    void refuse(const Diagnostic& why); ///< says why and closes
    void close() { m_channel->close(); }
    void watch(Time passed);            ///< called now and then: limits in time, budget of messages

    void sendStatus(const ControllerStatus& status, ClientId holder);
    void sendUpdate(const message::Update& update);
    void sendSamples(SampleBlock block);
    void sendBeat(std::uint64_t cycle);
    void sendLog(const LogEntry& entry);

private:
    enum class Stage : std::uint8_t { Hello, Authenticate, Ready, Closed };
    struct Transfer {
        std::uint32_t number = 0;
        std::uint64_t size = 0;
        Hash image, program;
        Bytes bytes;
    };

    void receive(const Envelope& envelope);
    bool mayAsk(const Envelope& envelope);
    void send(std::uint32_t request, Message message);
    void answer(std::uint32_t request, const Result<void>& result);
    void violate(const std::string& why);
    void ended(const std::string& reason, bool broken);
    void flush();
    void pumpSamples();
    std::string who() const;
    /// A callback for the host that finds this connection again, or finds it gone.
    ControllerHost::Done doneFor(std::uint32_t request);
    template <class T, class Make>
    ControllerHost::Reply<T> replyFor(std::uint32_t request, Make make);
    bool tooMany(std::uint32_t request, const char* what, std::size_t count, std::size_t limit);

    void on(std::uint32_t request, const message::Hello& hello);
    void on(std::uint32_t request, const message::Authenticate& authenticate);
    void on(std::uint32_t request, const message::Ping&);
    void on(std::uint32_t request, const message::TakeControl&);
    void on(std::uint32_t request, const message::RenewControl&);
    void on(std::uint32_t request, const message::ReleaseControl&);
    void on(std::uint32_t request, const message::PlanDownload& plan);
    void on(std::uint32_t request, const message::BeginDownload& begin);
    void on(std::uint32_t request, const message::Piece& piece);
    void on(std::uint32_t request, const message::CommitDownload& commit);
    void on(std::uint32_t request, const message::AbortDownload& abort);
    void on(std::uint32_t request, const message::Run&);
    void on(std::uint32_t request, const message::Stop&);
    void on(std::uint32_t request, const message::Exit&);
    void on(std::uint32_t request, const message::Read& read);
    void on(std::uint32_t request, const message::Write& write);
    void on(std::uint32_t request, const message::Force& force);
    void on(std::uint32_t request, const message::Release& release);
    void on(std::uint32_t request, const message::Describe& describe);
    void on(std::uint32_t request, const message::Subscribe& subscribe);
    void on(std::uint32_t request, const message::Unsubscribe& unsubscribe);
    void on(std::uint32_t request, const message::ReadForces&);
    void on(std::uint32_t request, const message::ReadTerminals&);
    void on(std::uint32_t request, const message::StartTrace& start);
    void on(std::uint32_t request, const message::StopTrace&);
    void on(std::uint32_t request, const message::TraceBlockTaken& taken);
    void on(std::uint32_t request, const message::Axis& axis);
    void on(std::uint32_t request, const message::Heartbeat& heartbeat);
    void on(std::uint32_t request, const message::StopAll&);
    void on(std::uint32_t request, const message::ReadLog& read);
    /// What only a controller sends.
    template <class M>
    void on(std::uint32_t, const M&) { violate(std::string("the message is only for controllers")); }

    Server& m_server;
    ClientId m_id;
    std::unique_ptr<MessageChannel> m_channel;
    Stage m_stage = Stage::Hello;
    Role m_role = Role::Nobody;
    std::string m_name;
    Time m_silent{};
    std::uint64_t m_heard = 0;
    std::size_t m_budget;
    std::unique_ptr<Transfer> m_transfer;
    std::uint32_t m_transfers = 0;
    std::vector<ManifestPart> m_parts; ///< of a manifest that is not complete yet
    std::map<std::uint32_t, message::Update> m_heldUpdates;
    SampleQueue m_samples;
    ControllerStatus m_status;
};

} // namespace camwright
