#include "editors/commissioning/motioncolumn.h"

#include "editors/commissioning/armbar.h"
#include "editors/commissioning/jogpad.h"
#include "editors/commissioning/movepad.h"
#include "editors/commissioning/panelcontrol.h"
#include "editors/commissioning/stopbutton.h"
#include "editors/shell/widgets.h"

#include <QVBoxLayout>

namespace camwright {

MotionColumn::MotionColumn(PanelControl& control, QWidget* parent)
    : QWidget(parent), m_control(control), m_arm(new ArmBar(control, this)), m_message(new QLabel(this)), m_jog(new JogPad(this)), m_move(new MovePad(this)), m_stop(new StopButton(this))
{
    m_message->setObjectName(QStringLiteral("panelMessage"));
    m_message->setProperty("tone", "error");
    m_message->setWordWrap(true);
    m_message->hide();
    describe(m_stop, "stopAllAxes", tr("Stop all axes"), tr("Stops every axis at once. Esc and Space do the same while this panel is armed or moves the axis."));
    auto* line = new QFrame(this);
    line->setProperty("surface", "fine");
    line->setFixedHeight(1);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(16, 12, 16, 12);
    column->setSpacing(0);
    column->addWidget(m_arm);
    column->addWidget(m_message);
    column->addSpacing(10);
    column->addWidget(m_jog);
    column->addSpacing(8);
    column->addWidget(line);
    column->addSpacing(8);
    column->addWidget(m_move);
    column->addStretch();
    column->addSpacing(12);
    column->addWidget(m_stop);
    m_move->setCap(m_jog->cap());
    wire();
}

void MotionColumn::wire()
{
    connect(m_stop, &QAbstractButton::pressed, this, [this] {
        letGoAll();
        m_control.stopAll();
    });
    connect(m_jog, &JogPad::jogWanted, this, [this](double velocity) {
        if (m_control.jog(velocity))
            m_target.reset();
    });
    connect(m_jog, &JogPad::jogEnded, &m_control, &PanelControl::endMotion);
    connect(m_jog, &JogPad::stepWanted, this, &MotionColumn::step);
    connect(m_jog, &JogPad::capChanged, this, [this] { m_move->setCap(m_jog->cap()); });
    connect(m_move, &MovePad::moveWanted, this, &MotionColumn::move);
    connect(&m_control, &PanelControl::failed, this, &MotionColumn::say);
    connect(&m_control, &PanelControl::moveStarted, this, [this] {
        say({});
        m_moveDuration = 0;
        emit moveBegan();
    });
}

void MotionColumn::setLimits(const AxisLimits& limits)
{
    m_jog->setLimits(limits);
    m_move->setLimits(limits);
}

double MotionColumn::deceleration() const
{
    return m_move->acceleration();
}

void MotionColumn::move()
{
    const AxisStatus* axis = m_control.axis();
    if (!axis)
        return;
    const double end = m_move->isRelative() ? axis->setPosition + m_move->target() : m_move->target();
    const double duration = m_move->estimate().duration;
    const bool sent = m_move->isRelative() ? m_control.moveBy(m_move->target(), m_move->velocity(), m_move->commandAcceleration())
                                           : m_control.moveTo(m_move->target(), m_move->velocity(), m_move->commandAcceleration());
    if (!sent)
        return;
    m_target = end;
    m_moveStart = m_now;
    m_moveDuration = duration;
}

void MotionColumn::step(double distance, double velocity)
{
    const AxisStatus* axis = m_control.axis();
    if (axis && m_control.moveBy(distance, velocity, m_move->commandAcceleration()))
        m_target = axis->setPosition + distance;
}

void MotionColumn::present(const ControllerStatus& status)
{
    m_now = status.time;
    m_arm->setHolder(status.control == ControlHolder::Somebody ? QString::fromStdString(status.controlOwner) : QString());
    if (const AxisStatus* axis = m_control.axis(); axis && !m_control.isDriving())
        m_move->setPosition(axis->position);
    showProgress(status);
}

void MotionColumn::showProgress(const ControllerStatus& status)
{
    if (!m_control.isDriving())
        m_moveDuration = 0;
    m_move->setProgress(m_moveDuration > 0 ? seconds(status.time - m_moveStart) / m_moveDuration : -1);
}

void MotionColumn::refresh()
{
    m_arm->refresh();
    m_jog->setMovable(m_control.mayMove(), m_control.whyNotMove());
    const bool busy = m_control.isDriving();
    m_move->setMovable(m_control.mayMove() && !busy, busy ? tr("The axis is still moving.") : m_control.whyNotMove());
    m_stop->setEnabled(m_control.isOnline());
    if (m_control.arming() == PanelControl::Arming::Asking)
        say({});
}

void MotionColumn::say(const QString& sentence)
{
    m_message->setText(sentence);
    m_message->setVisible(!sentence.isEmpty());
}

void MotionColumn::hold(int index) { m_jog->hold(index); }
void MotionColumn::letGo(int index) { m_jog->letGo(index); }
void MotionColumn::letGoAll() { m_jog->letGoAll(); }

} // namespace camwright
