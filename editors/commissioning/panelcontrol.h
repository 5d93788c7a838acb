#pragma once

#include "core/online/controllerlink.h"

#include <QObject>
#include <QString>

#include <cstdint>

namespace camwright {

class Context;

/// The panel's hold on one axis, without any widget: control, arming, one motion at a time, and how each of them ends
/// (CONTRACTS 19, 20). Every way out stops the axis; nothing begins again by itself. The heart beats through Context::arm,
/// on the interface's thread, so that a frozen window stops beating. All of it on the interface's thread.
class PanelControl : public QObject {
    Q_OBJECT
public:
    enum class Arming : std::uint8_t { Off, TakingControl, Asking, On };

    PanelControl(Context& context, std::string axis, QObject* parent = nullptr);
    /// Stops and disarms what is still armed.
    ~PanelControl() override;

    void setAxisName(std::string name);
    /// The newest status of the axis; null while offline or where the running program has no such axis.
    const AxisStatus* axis() const;

    Arming arming() const { return m_arming; }
    bool isArmed() const { return m_arming == Arming::On; }
    /// The panel moves the axis, or has moved it and it does not stand yet.
    bool isDriving() const { return m_wanted || m_moved; }
    bool isOnline() const;
    bool mayArm() const;                     ///< online, and the link can move axes under a dead-man
    bool mayMove() const;                    ///< armed, enabled, on the bus, no error
    QString whyNotMove() const;              ///< one sentence; empty where mayMove()

    /// Takes control if need be, then arms. The answer comes as changed() or failed().
    void arm();
    /// Stops what the panel moves and lets the program have the axis again.
    void disarm();

    void enable();
    void disable();                          ///< stops first
    void reset();
    void home();
    /// Signed user units per second. False, and nothing is sent, while an earlier motion or stop is unanswered: jogs are
    /// never queued.
    bool jog(double velocity);
    bool moveTo(double position, double velocity, double acceleration);
    bool moveBy(double distance, double velocity, double acceleration);
    /// Stops this axis if the panel moves it.
    void endMotion();
    /// Stops every axis: always accepted, also without control.
    void stopAll();

signals:
    void changed();
    void failed(const QString& sentence);
    void moveStarted();

private:
    using Answer = void (PanelControl::*)(std::uint64_t, const Result<void>&);

    ControllerLink* online() const;
    AxisCommand command(AxisCommandKind kind) const;
    void send(AxisCommand command, std::uint64_t number, Answer answer);
    void askToArm(std::uint64_t epoch);
    void armAnswered(std::uint64_t epoch, const Result<void>& result);
    void refuseArming(const Diagnostic& why);
    bool startMotion(AxisCommand command);
    void motionAnswered(std::uint64_t motion, const Result<void>& result);
    void sendStop();
    void stopAnswered(std::uint64_t number, const Result<void>& result);
    void orderAnswered(std::uint64_t number, const Result<void>& result);
    void simpleOrder(AxisCommandKind kind);
    void follow(const ControllerStatus& status);
    void followArming(const ControllerStatus& status, const AxisStatus* axis);
    void followMotion(const AxisStatus* axis);
    void lose();                             ///< the link is gone: nothing can be sent, nothing resumes
    void letGo();

    Context& m_context;
    std::string m_axis;
    Arming m_arming = Arming::Off;
    std::uint64_t m_epoch = 0;               ///< counts armings, so that a late answer to an old one is told apart
    int m_statusesSinceArm = 0;
    bool m_seenArmed = false;                ///< a status has confirmed the arming
    bool m_seenControl = false;
    bool m_wanted = false;                   ///< a motion is asked for and not ended
    bool m_endless = false;                  ///< it is a jog, which only its release ends
    bool m_moved = false;                    ///< until the axis is seen at rest
    int m_restSeen = 0;
    std::uint64_t m_motion = 0;              ///< counts motions
    bool m_motionUnanswered = false;
    int m_stopsUnanswered = 0;
};

} // namespace camwright
