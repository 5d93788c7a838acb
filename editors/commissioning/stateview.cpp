#include "editors/commissioning/stateview.h"

#include "core/family/family.h"
#include "editors/commissioning/causetext.h"
#include "editors/commissioning/numbers.h"
#include "editors/commissioning/statediagram.h"
#include "editors/shell/widgets.h"

#include <QGridLayout>

namespace camwright {

StateView::StateView(QWidget* parent)
    : QWidget(parent), m_number(new QLabel(this)), m_diagram(new StateDiagram(this)), m_transition(new QLabel(this)), m_time(new QLabel(this)), m_cause(new QLabel(this))
{
    describe(m_diagram, "stateDiagram", tr("Axis state"), tr("States of the axis; the lit one is the current one"));
    m_transition->setObjectName(QStringLiteral("lastTransition"));
    m_transition->setProperty("tone", "heading");
    m_cause->setObjectName(QStringLiteral("lastCause"));
    m_cause->setProperty("tone", "caption");
    m_cause->setWordWrap(true);
    m_time->setFont(theme().monoFont());
    m_number->setProperty("tone", "caption");
    auto* heading = new QLabel(tr("Axis State"), this);
    heading->setProperty("tone", "group");
    auto* title = new QHBoxLayout;
    title->addWidget(heading);
    title->addStretch();
    title->addWidget(m_number);

    auto* caption = new QFrame(this);
    caption->setObjectName(QStringLiteral("transitionCaption"));
    caption->setProperty("surface", "raised");
    auto* rows = new QGridLayout(caption);
    rows->setContentsMargins(10, 4, 10, 4);
    rows->setVerticalSpacing(1);
    rows->setColumnStretch(0, 1);
    rows->addWidget(m_transition, 0, 0);
    rows->addWidget(m_time, 0, 1);
    rows->addWidget(m_cause, 1, 0, 1, 2);
    const auto tint = [caption] { caption->setStyleSheet(QStringLiteral("QFrame#transitionCaption { border-left: 2px solid %1; }").arg(theme().name(Role::Accent))); };
    tint();
    connect(&theme(), &Theme::changed, caption, tint);

    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(16, 12, 16, 12);
    column->setSpacing(6);
    column->addLayout(title);
    column->addWidget(m_diagram, 1);
    column->addWidget(caption);
}

void StateView::setFamily(const std::string& family)
{
    if (family == m_family)
        return;
    m_family = family;
    std::vector<DiagramState> states;
    if (const Family* known = findFamily(family)) {
        for (const AxisState& state : known->axisStates())
            states.push_back({state.number, QString::fromStdString(state.id)});
    }
    m_diagram->setStates(std::move(states), family == "kinco");
}

QString StateView::stateName(int number) const
{
    const Family* family = findFamily(m_family);
    const AxisState* state = family ? family->findAxisState(number) : nullptr;
    return state ? QString::fromStdString(state->id) : QString::number(number);
}

void StateView::present(const AxisStatus& axis, Time controllerTime)
{
    const Time age = std::max(Time(0), controllerTime - axis.lastChange);
    if (axis.lastChange != m_lastChange || axis.state != m_current) {
        m_previous = axis.state == m_current ? m_previous : m_current;
        m_current = axis.state;
        m_lastChange = axis.lastChange;
        m_changedAt = QDateTime::currentDateTime().addMSecs(-std::chrono::duration_cast<std::chrono::milliseconds>(age).count());
    }
    m_diagram->setCurrent(m_current, m_previous, axis.moving);
    m_number->setText(tr("state %1").arg(axis.state));
    showTransition(axis, age);
}

void StateView::showTransition(const AxisStatus& axis, Time age)
{
    const QString now = stateName(m_current);
    m_transition->setText(m_previous < 0 ? now : QStringLiteral("%1 → %2").arg(stateName(m_previous), now));
    m_time->setText(axis.lastCause.empty() ? QString() : m_changedAt.time().toString(QStringLiteral("HH:mm:ss.zzz")));
    const double passed = seconds(age);
    const QString ago = passed < 60 ? tr("%1 s ago").arg(shownNumber(passed, passed < 10 ? 2 : 0))
                      : passed < 3600 ? tr("%1 min ago").arg(static_cast<int>(passed / 60))
                                      : tr("%1 h ago").arg(static_cast<int>(passed / 3600));
    const QString cause = causeText(axis.lastCause);
    m_cause->setText(cause.isEmpty() ? tr("no change since the controller started") : tr("%1, %2").arg(cause, ago));
}

void StateView::forget()
{
    m_current = m_previous = -1;
    m_lastChange = Time(-1);
}

} // namespace camwright
