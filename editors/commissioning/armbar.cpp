#include "editors/commissioning/armbar.h"

#include "editors/commissioning/panelcontrol.h"
#include "editors/shell/icons.h"
#include "editors/shell/widgets.h"

#include <QHBoxLayout>
#include <QVBoxLayout>

namespace camwright {

namespace {

constexpr char ButtonRoom[] = "padding: 0 8px;"; // three of them stand beside a sentence

} // namespace

ArmBar::ArmBar(PanelControl& control, QWidget* parent)
    : QWidget(parent), m_control(control), m_switch(new Switch(tr("Panel control"), this)), m_title(new QLabel(this)), m_explanation(new QLabel(this)), m_enable(new QPushButton(this)), m_reset(new QPushButton(this)), m_home(new QPushButton(this))
{
    m_switch->setObjectName(QStringLiteral("arm"));
    m_switch->setOnRole(Role::Real);
    m_title->setTextFormat(Qt::RichText);
    m_title->setObjectName(QStringLiteral("armTitle"));
    m_explanation->setProperty("tone", "caption");
    m_explanation->setObjectName(QStringLiteral("armExplanation"));
    m_explanation->setWordWrap(true);
    auto* words = new QVBoxLayout;
    words->setSpacing(0);
    words->addWidget(m_title);
    words->addWidget(m_explanation);
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(6);
    row->addWidget(m_switch);
    row->addSpacing(4);
    row->addLayout(words, 1);
    const struct { QPushButton* button; const char* name; QString text; const char* icon; } Buttons[] = {
        {m_enable, "enable", tr("Enable"), "power"}, {m_reset, "reset", tr("Reset"), "reset"}, {m_home, "home", tr("Home"), "home"}};
    for (const auto& [button, name, text, iconName] : Buttons) {
        describe(button, name, text);
        button->setText(text);
        button->setIcon(icon(QLatin1String(iconName)));
        button->setStyleSheet(QLatin1String(ButtonRoom));
        row->addWidget(button);
    }
    connect(m_switch, &QAbstractButton::clicked, this, &ArmBar::toggled);
    connect(m_enable, &QPushButton::clicked, this, [this] {
        const AxisStatus* axis = m_control.axis();
        axis && axis->enabled ? m_control.disable() : m_control.enable();
    });
    connect(m_reset, &QPushButton::clicked, &m_control, &PanelControl::reset);
    connect(m_home, &QPushButton::clicked, &m_control, &PanelControl::home);
    connect(&theme(), &Theme::changed, this, &ArmBar::refresh);
    refresh();
}

void ArmBar::toggled()
{
    m_control.arming() == PanelControl::Arming::Off ? m_control.arm() : m_control.disarm();
    refresh();
}

void ArmBar::setHolder(const QString& holder)
{
    if (holder == m_holder)
        return;
    m_holder = holder;
    refresh();
}

void ArmBar::refresh()
{
    const PanelControl::Arming arming = m_control.arming();
    m_switch->setChecked(arming != PanelControl::Arming::Off);
    m_switch->setEnabled(m_control.mayArm());
    m_switch->setToolTip(m_control.isArmed() ? tr("Click to let the program have the axis again. What this panel moves stops first.")
                                             : tr("Click to move this axis by hand. The program's motion of it is refused meanwhile."));
    const QString amber = theme().name(Role::Real);
    const QString word = m_control.isArmed() ? QStringLiteral(" <b style=\"color:%1\">%2</b>").arg(amber, tr("armed"))
                                             : QStringLiteral(" <span style=\"color:%1\">%2</span>").arg(theme().name(Role::Dim), tr("off"));
    m_title->setText(QStringLiteral("<b>%1</b>%2").arg(tr("Panel Control"), word));
    switch (arming) {
    case PanelControl::Arming::On: m_explanation->setText(tr("program motion is refused")); break;
    case PanelControl::Arming::TakingControl: m_explanation->setText(tr("taking control")); break;
    case PanelControl::Arming::Asking: m_explanation->setText(tr("arming")); break;
    case PanelControl::Arming::Off:
        m_explanation->setText(m_holder.isEmpty() ? tr("arm it to move the axis") : tr("%1 has control").arg(m_holder));
        break;
    }
    refreshButtons();
}

void ArmBar::refreshButtons()
{
    const AxisStatus* axis = m_control.axis();
    const bool armed = m_control.isArmed() && axis && axis->online;
    const bool enabled = axis && axis->enabled, error = axis && axis->error != 0;
    const QString unarmed = tr("Arm panel control first.");
    m_enable->setEnabled(armed && (enabled || !error));
    m_enable->setText(enabled ? tr("Enabled") : tr("Enable"));
    m_enable->setToolTip(!armed ? unarmed : enabled ? tr("The axis is enabled. Click to stop it and take the power off.") : tr("Puts the axis under power. It does not move."));
    m_enable->setIcon(icon(QStringLiteral("power"), enabled ? Role::Ok : Role::Text));
    const QString look = enabled ? QStringLiteral("background: %1; border-color: %2; color: %2;").arg(theme().name(Role::OkSoft), theme().name(Role::Ok)) : QString();
    if (const QString sheet = QLatin1String(ButtonRoom) + look; sheet != m_enable->styleSheet())
        m_enable->setStyleSheet(sheet); // polishing at every status would be felt
    m_reset->setEnabled(armed && error);
    m_reset->setToolTip(!armed ? unarmed : error ? tr("Clears the error once its cause is gone.") : tr("There is no error to reset."));
    m_home->setEnabled(m_control.mayMove() && !m_control.isDriving());
    m_home->setToolTip(m_control.mayMove() ? tr("Searches the home position with the method set in the drive. The axis moves.") : m_control.whyNotMove());
}

} // namespace camwright
