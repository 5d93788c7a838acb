#pragma once

#include "core/base/time.h"
#include "core/fieldbus/nmt.h"
#include "core/fieldbus/objectdictionary.h"
#include "core/fieldbus/sdo.h"

#include <array>
#include <cstdint>
#include <vector>

namespace camwright {

/// What the device behind a CANopen slave is asked and told. Calls come from inside CanopenSlave::receive and ::step.
class SlaveApplication {
public:
    virtual ~SlaveApplication() = default;
    /// A value about to be stored that passed access, length and range. Anything but None refuses it.
    virtual SdoAbort checkWrite(ObjectId id, std::int64_t value) = 0;
    /// Stored, by SDO or by PDO.
    virtual void written(ObjectId id, std::int64_t value) = 0;
    virtual void nmtChanged(NmtState state) = 0;
    /// ResetNode: the application starts anew. The communication objects are reset by the slave itself.
    virtual void resetNode() = 0;
    /// Life guarding: true when the master fell silent for guard time times life factor, false when it is heard again.
    virtual void lifeGuardChanged(bool lost) = 0;
};

/// The communication part of a CANopen device (CiA 301): NMT slave, boot-up, SDO server (expedited and segmented), PDOs with
/// configurable mapping, node guarding answer and life guarding, heartbeat and emergency producer. Frames in by receive(),
/// out by the CanPort, time passed in; one thread.
///
/// It adds the communication objects 0x1000 to 0x1A07 to the dictionary; the device adds its own before calling start().
/// As CiA 301 has it, a life guarding error takes an operational node to pre-operational.
class CanopenSlave {
public:
    static constexpr unsigned kMaximumPdos = 8;    ///< in each direction (KS-COM-01)
    static constexpr unsigned kMaximumMapped = 8;  ///< objects in one PDO; only whole bytes are mapped

    CanopenSlave(std::uint8_t node, ObjectDictionary& dictionary, SlaveApplication& application, CanPort& port, unsigned pdos = 4);

    /// All objects are in: looks up slots, sends the boot-up message at `now`, goes to pre-operational.
    void start(Time now);
    /// No voltage: nothing is received or sent until the next start().
    void stop() { m_running = false; }
    void receive(const CanFrame& frame, Time now);
    /// Sends what is due: events, timers, heartbeat; watches life guarding. Call each millisecond, after the device has
    /// brought its objects up to date.
    void step(Time now);

    void sendEmergency(std::uint16_t errorCode, std::uint8_t errorRegister, std::array<std::uint8_t, 5> vendor, Time now);

    std::uint8_t node() const { return m_node; }
    NmtState state() const { return m_state; }
    bool isRunning() const { return m_running; }
    bool lifeLost() const { return m_lifeLost; }
    std::uint64_t unsentFrames() const { return m_unsent; } ///< the port was full

    /// Without the dictionary, which its owner saves, and restores before this.
    void save(ByteWriter& writer) const;
    void restore(ByteReader& reader);

private:
    struct Pdo {
        // From the dictionary whenever that is written; not saved.
        std::uint32_t cobId = 0x80000000;
        std::uint8_t type = 255;
        std::uint8_t length = 0;
        std::uint8_t count = 0;
        std::array<ObjectDictionary::Slot, kMaximumMapped> slots{};
        Time inhibit{0};
        Time eventTimer{0};
        // Running state.
        CanFrame last{};           ///< last sent or, received and waiting for SYNC, the data
        bool everSent = false;
        bool waiting = false;
        std::uint8_t syncCount = 0;
        Time lastSent{0};
        bool valid() const { return (cobId & 0x80000000U) == 0; }
    };
    struct Server {
        Bytes data;
        std::uint32_t position = 0;
        std::uint32_t expected = 0;
        ObjectId id;
        bool active = false;
        bool writing = false;
        bool toggle = false;
    };

    void addCommunicationObjects();
    void findSlots();
    void loadPdo(bool transmit, unsigned number);
    void loadAllPdos();
    SdoAbort checkPdoWrite(ObjectId id, std::int64_t value) const;
    SdoAbort checkPdoCobId(const Pdo& pdo, std::int64_t value) const;
    SdoAbort checkMappingCount(ObjectId id, std::int64_t count) const;
    SdoAbort checkMappingEntry(ObjectId id, std::int64_t value) const;
    SdoAbort store(ObjectId id, ByteSpan data);
    void communicationWritten(ObjectId id);
    void resetCommunication(Time now);

    void receiveNmt(const CanFrame& frame, Time now);
    void receiveGuard(Time now);
    void receiveSync(Time now);
    void receivePdo(Pdo& pdo, const CanFrame& frame, Time now);
    void applyPdo(const Pdo& pdo, const CanFrame& frame);
    void receiveSdo(const CanFrame& frame);
    void serveUpload(const CanFrame& frame, CanFrame& reply);
    void serveUploadSegment(const CanFrame& frame, CanFrame& reply);
    void serveDownload(const CanFrame& frame, CanFrame& reply);
    void serveDownloadSegment(const CanFrame& frame, CanFrame& reply);
    void abortTransfer(SdoAbort abort, CanFrame& reply);

    void enter(NmtState state, Time now);
    CanFrame packPdo(const Pdo& pdo) const;
    void sendPdo(Pdo& pdo, const CanFrame& frame, Time now);
    void stepPdo(Pdo& pdo, Time now);
    void stepLifeGuard(Time now);
    bool send(const CanFrame& frame);

    ObjectDictionary& m_dictionary;
    SlaveApplication& m_application;
    CanPort& m_port;
    std::uint8_t m_node;
    unsigned m_pdoCount;
    std::array<Pdo, kMaximumPdos> m_transmit{};
    std::array<Pdo, kMaximumPdos> m_receive{};
    Server m_server;
    NmtState m_state = NmtState::BootUp;
    bool m_running = false;
    bool m_guardToggle = false;
    bool m_guarded = false;     ///< the master has asked at least once
    bool m_lifeLost = false;
    Time m_lastGuard{0};
    Time m_lastHeartbeat{0};
    std::uint64_t m_unsent = 0;
    ObjectDictionary::Slot m_guardTimeSlot = 0;
    ObjectDictionary::Slot m_lifeFactorSlot = 0;
    ObjectDictionary::Slot m_heartbeatSlot = 0;
};

} // namespace camwright
