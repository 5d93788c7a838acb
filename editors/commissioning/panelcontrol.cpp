#include "editors/commissioning/panelcontrol.h"

#include "editors/shell/context.h"
#include "editors/words/words.h"

#include <QPointer>

namespace camwright {

namespace {

/// A stopped axis is believed to stand after this many statuses without motion since the last answer: the first may have
/// been on its way already.
constexpr int RestStatuses = 2;
/// An arming that no status confirms within this many was lost again.
constexpr int ArmStatuses = 5;

} // namespace

PanelControl::PanelControl(Context& context, std::string axis, QObject* parent)
    : QObject(parent), m_context(context), m_axis(std::move(axis))
{
    connect(&context, &Context::linkAboutToChange, this, [this] {
        disarm();
        lose();
    });
    connect(&context, &Context::disarmRequested, this, &PanelControl::disarm);
    connect(&context, &Context::linkChanged, this, &PanelControl::changed);
    connect(&context, &Context::linkStateChanged, this, [this](LinkState state) {
        if (state != LinkState::Online)
            lose();
        emit changed();
    });
    connect(&context, &Context::statusChanged, this, &PanelControl::follow);
}

PanelControl::~PanelControl()
{
    disarm();
}

void PanelControl::setAxisName(std::string name)
{
    if (name == m_axis)
        return;
    disarm();
    m_axis = std::move(name);
    emit changed();
}

const AxisStatus* PanelControl::axis() const
{
    if (!m_context.isOnline())
        return nullptr;
    for (const AxisStatus& axis : m_context.status().axes) {
        if (axis.name == m_axis)
            return &axis;
    }
    return nullptr;
}

ControllerLink* PanelControl::online() const
{
    return m_context.isOnline() ? m_context.link() : nullptr;
}

bool PanelControl::isOnline() const
{
    return online() != nullptr;
}

bool PanelControl::mayArm() const
{
    return online() && online()->capabilities().motion && axis();
}

bool PanelControl::mayMove() const
{
    return whyNotMove().isEmpty();
}

QString PanelControl::whyNotMove() const
{
    const AxisStatus* now = axis();
    if (!now)
        return tr("Go online to move this axis.");
    if (!isArmed())
        return tr("Arm panel control first.");
    if (!now->online)
        return tr("The drive is not on the bus.");
    if (now->error != 0)
        return tr("The axis has an error. Remove its cause, then reset it.");
    return now->enabled ? QString() : tr("Enable the axis first.");
}

AxisCommand PanelControl::command(AxisCommandKind kind) const
{
    AxisCommand out;
    out.axis = m_axis;
    out.kind = kind;
    return out;
}

void PanelControl::send(AxisCommand order, std::uint64_t number, Answer answer)
{
    QPointer<PanelControl> self(this);
    online()->command(std::move(order), [self, number, answer](const Result<void>& result) {
        if (self)
            (self->*answer)(number, result);
    });
}

// --- arming

void PanelControl::arm()
{
    if (m_arming != Arming::Off || !mayArm())
        return;
    const std::uint64_t epoch = ++m_epoch;
    if (m_context.status().control == ControlHolder::You) {
        askToArm(epoch);
        return;
    }
    m_arming = Arming::TakingControl;
    QPointer<PanelControl> self(this);
    online()->takeControl([self, epoch](const Result<void>& result) {
        if (!self || epoch != self->m_epoch || self->m_arming != Arming::TakingControl)
            return;
        result ? self->askToArm(epoch) : self->refuseArming(result.error());
    });
    emit changed();
}

void PanelControl::askToArm(std::uint64_t epoch)
{
    m_arming = Arming::Asking;
    send(command(AxisCommandKind::Arm), epoch, &PanelControl::armAnswered);
    emit changed();
}

void PanelControl::armAnswered(std::uint64_t epoch, const Result<void>& result)
{
    if (epoch != m_epoch || m_arming != Arming::Asking) {
        // The user has changed his mind meanwhile, and disarm() has been sent behind it.
        return;
    }
    if (!result) {
        refuseArming(result.error());
        return;
    }
    m_arming = Arming::On;
    m_statusesSinceArm = 0;
    m_seenArmed = m_seenControl = false;
    m_context.arm(this);
    emit changed();
}

void PanelControl::refuseArming(const Diagnostic& why)
{
    m_arming = Arming::Off;
    emit changed();
    emit failed(words::sentence(why));
}

void PanelControl::disarm()
{
    if (m_arming == Arming::Off)
        return;
    const bool told = m_arming != Arming::TakingControl;
    const bool moving = m_wanted; // otherwise a stop has been sent already
    letGo();
    if (online() && told) {
        if (moving)
            sendStop();
        send(command(AxisCommandKind::Disarm), m_epoch, &PanelControl::orderAnswered);
    }
    m_context.disarm(this);
    emit changed();
}

void PanelControl::letGo()
{
    ++m_epoch;
    m_arming = Arming::Off;
    m_wanted = false;
}

void PanelControl::lose()
{
    letGo();
    m_moved = false;
    m_motionUnanswered = false;
    m_stopsUnanswered = 0;
    ++m_motion;
    m_context.disarm(this);
    emit changed();
}

// --- orders that move nothing

void PanelControl::simpleOrder(AxisCommandKind kind)
{
    if (isArmed() && online())
        send(command(kind), m_epoch, &PanelControl::orderAnswered);
}

void PanelControl::enable() { simpleOrder(AxisCommandKind::Enable); }
void PanelControl::reset() { simpleOrder(AxisCommandKind::Reset); }

void PanelControl::disable()
{
    endMotion();
    simpleOrder(AxisCommandKind::Disable);
}

void PanelControl::orderAnswered(std::uint64_t, const Result<void>& result)
{
    if (!result)
        emit failed(words::sentence(result.error()));
}

// --- motion

bool PanelControl::startMotion(AxisCommand order)
{
    const bool endless = order.kind == AxisCommandKind::Jog;
    if (!mayMove() || m_wanted || m_motionUnanswered || m_stopsUnanswered > 0)
        return false;
    m_wanted = m_moved = m_motionUnanswered = true;
    m_endless = endless;
    m_restSeen = 0;
    send(std::move(order), ++m_motion, &PanelControl::motionAnswered);
    emit moveStarted();
    emit changed();
    return true;
}

void PanelControl::motionAnswered(std::uint64_t motion, const Result<void>& result)
{
    if (motion != m_motion)
        return;
    m_motionUnanswered = false;
    m_restSeen = 0;
    if (result && !m_wanted) {
        // Ended before it was accepted. The stop may have overtaken it on its way, so it is said again.
        sendStop();
    } else if (!result) {
        m_wanted = false;
        emit failed(words::sentence(result.error()));
    }
    emit changed();
}

void PanelControl::home()
{
    startMotion(command(AxisCommandKind::Home));
}

bool PanelControl::jog(double velocity)
{
    AxisCommand order = command(AxisCommandKind::Jog);
    order.velocity = velocity;
    return startMotion(std::move(order));
}

bool PanelControl::moveTo(double position, double velocity, double acceleration)
{
    AxisCommand order = command(AxisCommandKind::MoveAbsolute);
    order.position = position;
    order.velocity = velocity;
    order.acceleration = acceleration;
    return startMotion(std::move(order));
}

bool PanelControl::moveBy(double distance, double velocity, double acceleration)
{
    AxisCommand order = command(AxisCommandKind::MoveRelative);
    order.position = distance;
    order.velocity = velocity;
    order.acceleration = acceleration;
    return startMotion(std::move(order));
}

void PanelControl::endMotion()
{
    if (!m_wanted)
        return;
    m_wanted = false;
    if (online())
        sendStop();
    emit changed();
}

void PanelControl::sendStop()
{
    ++m_stopsUnanswered;
    m_restSeen = 0;
    send(command(AxisCommandKind::Stop), m_motion, &PanelControl::stopAnswered);
}

void PanelControl::stopAnswered(std::uint64_t, const Result<void>& result)
{
    m_stopsUnanswered = std::max(0, m_stopsUnanswered - 1);
    m_restSeen = 0;
    if (!result)
        emit failed(words::sentence(result.error()));
}

void PanelControl::stopAll()
{
    m_wanted = false;
    m_restSeen = 0;
    if (ControllerLink* link = online()) {
        QPointer<PanelControl> self(this);
        link->stopAllAxes([self](const Result<void>& result) {
            if (self && !result)
                emit self->failed(words::sentence(result.error()));
        });
    }
    emit changed();
}

// --- what the controller says

void PanelControl::follow(const ControllerStatus& status)
{
    const AxisStatus* now = axis();
    followArming(status, now);
    followMotion(now);
    emit changed();
}

void PanelControl::followArming(const ControllerStatus& status, const AxisStatus* axis)
{
    if (!isArmed())
        return;
    ++m_statusesSinceArm;
    m_seenArmed = m_seenArmed || (axis && axis->panelArmed);
    m_seenControl = m_seenControl || status.control == ControlHolder::You;
    const bool settled = m_statusesSinceArm >= ArmStatuses;
    if (status.control != ControlHolder::You && (m_seenControl || settled)) {
        disarm();
        emit failed(status.control == ControlHolder::Somebody ? tr("%1 has taken control. Panel control is off.").arg(QString::fromStdString(status.controlOwner))
                                                              : tr("Control was lost. Panel control is off."));
    } else if (!(axis && axis->panelArmed) && (m_seenArmed || settled)) {
        disarm();
        emit failed(tr("The controller has ended panel control of this axis. Arm it again to go on."));
    }
}

void PanelControl::followMotion(const AxisStatus* axis)
{
    // A jog that has not begun to turn yet must not count as ended: its release would stop nothing.
    if (!m_moved || m_motionUnanswered || m_stopsUnanswered > 0 || (m_wanted && m_endless))
        return;
    m_restSeen = axis && axis->moving ? 0 : m_restSeen + 1;
    if (m_restSeen >= RestStatuses)
        m_wanted = m_moved = false;
}

} // namespace camwright
