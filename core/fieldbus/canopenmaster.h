#pragma once

#include "core/base/result.h"
#include "core/base/time.h"
#include "core/fieldbus/nmt.h"
#include "core/fieldbus/objectdictionary.h"
#include "core/fieldbus/sdo.h"

#include <array>
#include <cstdint>
#include <vector>

namespace camwright {

/// What the master sends to a drive. Positions in drive counts, speeds in counts/s. docs/canopen.md has the mapping.
struct DriveOutputs {
    std::uint16_t controlWord = 0;    ///< 0x6040
    std::int8_t mode = 0;             ///< 0x6060
    std::int32_t targetPosition = 0;  ///< 0x607A
    std::uint32_t profileVelocity = 0;///< 0x6081
    std::int32_t targetVelocity = 0;  ///< 0x60FF
    bool operator==(const DriveOutputs&) const = default;
};

/// What the drive has sent last. Zero until the first PDOs arrive.
struct DriveInputs {
    std::uint16_t statusWord = 0;     ///< 0x6041
    std::int8_t mode = 0;             ///< 0x6061
    std::int32_t position = 0;        ///< 0x6064
    std::int32_t velocity = 0;        ///< 0x606C
    std::int32_t demandPosition = 0;  ///< 0x6062
    std::int16_t torque = 0;          ///< 0x6078, 0.1 % of rated
    std::uint32_t digitalInputs = 0;  ///< 0x60FD: bit 0 negative limit, 1 positive limit, 2 home switch, 16 … DIN1 …
    std::uint16_t errorCode = 0;      ///< 0x603F
    bool operator==(const DriveInputs&) const = default;
};

/// One axis node, from the motion network window (KS-MCN).
struct MasterNodeConfig {
    std::uint8_t node = 1;            ///< 1 … 127
    Time guardTime = 1000ms;          ///< 0: no guarding, the node is never found lost
    std::uint8_t lifeFactor = 3;
    Time inhibitTime = 10ms;          ///< of every PDO of the node, in both directions; steps of 100 µs
    Time eventTimer{0};               ///< of the node's transmit PDOs, whole ms, 0: off
};

struct MasterConfig {
    Time sdoTimeout = 100ms;
    Time syncPeriod{0};               ///< 0: no SYNC
    std::vector<MasterNodeConfig> nodes;
};

enum class NodeState : std::uint8_t {
    Idle,        ///< the master has not been started
    Booting,
    Operational, ///< online
    BootFailed,  ///< see BootReport
    Lost,        ///< was online; node guarding, or the node restarted by itself. Stays so until restart() (KS-MC-08)
};

/// The steps of KS-MC-21, in their order.
enum class BootStep : std::uint8_t { None, PreOperational, Guarding, Mapping, Communication, Start };

struct BootReport {
    bool running = false;
    BootStep step = BootStep::None;          ///< reached, or where it failed
    SdoStatus status = SdoStatus::Done;      ///< how the last transfer ended; Done after success
    SdoAbort abort = SdoAbort::None;
    ObjectId object;                         ///< the object of a failed transfer
};

struct SdoResult {
    SdoStatus status = SdoStatus::Pending;
    SdoAbort abort = SdoAbort::None;
    Bytes data;                              ///< of a read
    /// `data` as a number of this type; a wrong length gives 0 and false.
    bool number(DataType type, std::int64_t& out) const;
};

struct Emergency {
    Time at{0};
    std::uint8_t node = 0;
    std::uint16_t errorCode = 0;             ///< 0: the error is gone
    std::uint8_t errorRegister = 0;
    std::array<std::uint8_t, 5> vendor{};
};

/// The CANopen master of a motion network: boots each axis node in the order of KS-MC-21, exchanges process data by PDO,
/// serves SDO requests, guards the nodes. Frames in by receive(), out by the CanPort, time passed in; one thread.
///
/// Sending of process data: a PDO goes out when its data changed. A changed control word or mode goes at once, after the
/// speeds it refers to; targets alone wait for the inhibit time. setOutputs with `urgent` (stop, CONTRACTS 19) waits for nothing:
/// its control word goes before the speeds and before every frame that still waits in the send buffer.
class CanopenMaster {
public:
    using SdoHandle = std::uint32_t;                       ///< 0 is none
    static constexpr std::size_t kEmergencyHistory = 64;

    CanopenMaster(MasterConfig config, CanPort& port);

    /// Boots all nodes.
    void start(Time now);
    /// Everything ends; nodes go to pre-operational by one broadcast.
    void stop(Time now);
    void receive(const CanFrame& frame, Time now);
    /// Time-outs, guarding, process data. Call each motion cycle after the outputs are set.
    void step(Time now);

    bool hasNode(std::uint8_t node) const { return slotOf(node) >= 0; }
    NodeState nodeState(std::uint8_t node) const;          ///< Idle for a foreign node
    bool isOnline(std::uint8_t node) const { return nodeState(node) == NodeState::Operational; }
    BootReport bootReport(std::uint8_t node) const;
    /// MC_RESTART: configures and starts one node anew; its outputs become zero. `sdoTimeout` 0 takes the network's.
    /// False: foreign node, or its boot runs already.
    bool restart(std::uint8_t node, Time sdoTimeout, Time now);
    void cancelRestart(std::uint8_t node);

    const DriveInputs& inputs(std::uint8_t node) const;    ///< the node must exist
    const DriveOutputs& outputs(std::uint8_t node) const;  ///< the node must exist
    /// Taken over by the next step(); kept but not sent while the node is not operational.
    void setOutputs(std::uint8_t node, const DriveOutputs& outputs, bool urgent = false);
    /// Outputs that differ from what was sent: waiting for the inhibit time or for room in the send buffer.
    bool outputsPending(std::uint8_t node) const;
    /// The same for control word, mode and target alone: false once a stop has been handed to the CAN controller.
    bool commandPending(std::uint8_t node) const;
    /// The last attempt to send process data to the node found the send buffer full.
    bool sendBlocked(std::uint8_t node) const;

    /// Always gives a handle; a request that cannot start has ended already. Each handle must be taken once.
    SdoHandle readSdo(std::uint8_t node, ObjectId object, Time now, Time timeout = Time{0});
    SdoHandle writeSdo(std::uint8_t node, ObjectId object, ByteSpan data, Time now, Time timeout = Time{0});
    SdoHandle writeSdo(std::uint8_t node, ObjectId object, std::int64_t value, unsigned bytes, Time now, Time timeout = Time{0});
    bool sdoBusy(std::uint8_t node) const;                 ///< a request, or the boot, is on its way
    /// Pending while on its way. Any other status ends the handle: it is unknown (Cancelled) after that.
    SdoResult takeSdo(SdoHandle handle);
    void cancelSdo(SdoHandle handle);

    void sendNmt(NmtCommand command, std::uint8_t node);
    const std::vector<Emergency>& emergencies() const { return m_emergencies; } ///< oldest first
    std::uint64_t emergencyCount() const { return m_emergencyCount; }
    std::uint64_t bufferFullCount() const { return m_bufferFull; }

    const MasterConfig& config() const { return m_config; }
    void save(ByteWriter& writer) const;
    /// Into a master made from the same configuration.
    void restore(ByteReader& reader);

private:
    static constexpr unsigned kReceivePdos = 2;  ///< seen from the node
    static constexpr unsigned kTransmitPdos = 3;

    struct BootWrite {
        BootStep step = BootStep::Guarding;
        ObjectId object;
        std::uint32_t value = 0;
        std::uint8_t bytes = 4;
    };
    struct Node {
        MasterNodeConfig config;
        std::vector<BootWrite> bootList; ///< made from the configuration, not saved
        NodeState state = NodeState::Idle;
        DriveInputs inputs;
        DriveOutputs outputs;
        std::array<CanFrame, kReceivePdos> sent{};
        std::array<Time, kReceivePdos> sentAt{};
        std::array<bool, kReceivePdos> everSent{};
        bool urgent = false;
        bool blocked = false;

        BootReport boot;
        std::uint16_t bootIndex = 0;
        Time bootTimeout{0};
        bool everOnline = false;

        SdoTransfer transfer;
        SdoHandle handle = 0;        ///< 0 while the boot owns the transfer
        bool transferActive = false;
        Time transferDeadline{0};
        Time transferTimeout{0};

        Time guardSent{0};
        Time guardHeard{0};
        bool guardToggle = false;
        bool guardFirst = true;
    };
    struct Finished {
        SdoHandle handle = 0;
        SdoResult result;
    };

    int slotOf(std::uint8_t node) const { return m_slots[node & 0x7F]; }
    static std::vector<BootWrite> bootListFor(const MasterNodeConfig& config);
    Node* find(std::uint8_t node);
    const Node* find(std::uint8_t node) const;
    bool send(const CanFrame& frame);

    void beginBoot(Node& node, Time timeout, Time now);
    void nextBootWrite(Node& node, Time now);
    void failBoot(Node& node, SdoStatus status, SdoAbort abort);
    void goOnline(Node& node, Time now);

    SdoHandle beginSdo(std::uint8_t node, ObjectId object, const ByteSpan* data, Time now, Time timeout);
    SdoHandle finishAtOnce(SdoStatus status);
    void endTransfer(Node& node, Time now);
    void dropTransfer(Node& node);
    void keepResult(SdoHandle handle, SdoResult result);
    void receiveSdo(Node& node, const CanFrame& frame, Time now);
    void receivePdo(Node& node, unsigned number, const CanFrame& frame);
    void receiveErrorControl(Node& node, const CanFrame& frame, Time now);
    void receiveEmergency(Node& node, const CanFrame& frame, Time now);
    void stepTransfer(Node& node, Time now);
    void stepGuard(Node& node, Time now);
    void stepOutputs(Node& node, Time now);
    bool sendOutput(Node& node, unsigned number, const CanFrame& frame, Time now);
    void noteSent(Node& node, unsigned number, const CanFrame& frame, Time now);
    void saveNode(ByteWriter& writer, const Node& node) const;
    void restoreNode(ByteReader& reader, Node& node);

    MasterConfig m_config;
    CanPort& m_port;
    std::array<std::int8_t, 128> m_slots{};
    std::vector<Node> m_nodes;
    std::vector<Finished> m_finished;
    SdoHandle m_lastHandle = 0;
    std::vector<Emergency> m_emergencies;
    std::uint64_t m_emergencyCount = 0;
    std::uint64_t m_bufferFull = 0;
    bool m_started = false;
    Time m_lastSync{0};
};

/// Why a node did not come up, or how a transfer ended, as a message for the log.
Diagnostic bootDiagnostic(std::uint8_t node, const BootReport& report);
Diagnostic sdoDiagnostic(std::uint8_t node, ObjectId object, SdoStatus status, SdoAbort abort);
Diagnostic emergencyDiagnostic(const Emergency& emergency);

} // namespace camwright
