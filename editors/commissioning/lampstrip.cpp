#include "editors/commissioning/lampstrip.h"

#include "editors/commissioning/causetext.h"
#include "editors/commissioning/lamp.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPainter>

namespace camwright {

LampStrip::LampStrip(QWidget* parent)
    : QWidget(parent), m_lower(new Lamp(tr("Limit −"), "lampLower", this)), m_upper(new Lamp(tr("Limit +"), "lampUpper", this)), m_home(new Lamp(tr("Home switch"), "lampHome", this)), m_drive(new Lamp(tr("Drive"), "lampDrive", this)), m_error(new Lamp(tr("Error"), "lampError", this)), m_name(new QLabel(this))
{
    setObjectName(QStringLiteral("lampStrip"));
    setAttribute(Qt::WA_StyledBackground);
    const auto tint = [this] {
        setStyleSheet(QStringLiteral("QWidget#lampStrip { background: %1; border-top: 1px solid %2; border-bottom: 1px solid %2; }").arg(theme().name(Role::Raised), theme().name(Role::Line)));
    };
    tint();
    connect(&theme(), &Theme::changed, this, tint);
    m_name->setFont(theme().monoFont());
    m_name->setProperty("tone", "dim");
    m_name->setObjectName(QStringLiteral("axisIdentity"));
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(2, 0, 14, 0);
    row->setSpacing(0);
    for (Lamp* lamp : {m_lower, m_upper, m_home, m_drive, m_error})
        row->addWidget(lamp);
    row->addStretch();
    row->addWidget(m_name);
    setFixedHeight(30);
}

void LampStrip::present(const AxisStatus& axis, const std::string& family, const std::string& model)
{
    m_lower->setState(axis.lowerLimit, axis.lowerLimit ? tr("reached") : tr("free"), Role::Error);
    m_upper->setState(axis.upperLimit, axis.upperLimit ? tr("reached") : tr("free"), Role::Error);
    m_home->setState(axis.homeSwitch, axis.homeSwitch ? tr("on") : tr("off"), Role::Accent);
    m_drive->setState(axis.online, axis.online ? tr("operational") : tr("not on the bus"), Role::Ok);
    m_error->setState(axis.error != 0, axis.error == 0 ? tr("none") : tr("%1, %2").arg(errorCodeText(axis.error), axisErrorText(family, axis.error)), Role::Error);
    m_name->setText(QStringLiteral("%1 %2 · %3").arg(tr("axis"), QString::number(axis.number), QString::fromStdString(model)));
}

} // namespace camwright
