#include "app/window/connectionstrip.h"

#include "core/family/family.h"
#include "editors/shell/actions.h"
#include "editors/shell/icons.h"
#include "editors/shell/widgets.h"

#include <QHBoxLayout>
#include <QLabel>

namespace camwright {

namespace {

QString machineName(const ControllerStatus& status)
{
    const Family* family = findFamily(status.family);
    QStringList parts;
    if (family)
        parts << QString::fromStdString(family->displayName()).section(QLatin1Char(' '), 0, 0); // the model names the series
    if (!status.model.empty())
        parts << QString::fromStdString(status.model);
    return parts.join(QLatin1Char(' '));
}

} // namespace

ConnectionStrip::ConnectionStrip(Context& context, Connection& connection, QWidget* parent)
    : QFrame(parent), m_context(context), m_connection(connection)
{
    setObjectName(QStringLiteral("connectionStrip"));
    setFixedHeight(24);
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(12, 0, 12, 0);
    row->setSpacing(12);
    m_sign = new QLabel(this);
    m_words = new QLabel(this);
    m_forces = new Pill(this);
    m_differs = new QLabel(this);
    m_showDifferences = new LinkLabel(tr("Show What Differs"), this);
    m_showDifferences->setObjectName(QStringLiteral("showDifferences"));
    m_showDifferences->setToolTip(tr("Shows what a download would change; nothing is sent before you agree."));
    m_armed = new QLabel(tr("A panel is armed"), this);
    m_release = new LinkLabel(tr("Release all"), this);
    m_release->setObjectName(QStringLiteral("releaseForces"));
    for (QWidget* widget : {static_cast<QWidget*>(m_sign), static_cast<QWidget*>(m_words), static_cast<QWidget*>(m_forces),
             static_cast<QWidget*>(m_differs), static_cast<QWidget*>(m_showDifferences)})
        row->addWidget(widget);
    row->addStretch();
    row->addWidget(m_armed);
    row->addWidget(m_release);
    connect(m_showDifferences, &LinkLabel::activated, this, &ConnectionStrip::showDifferencesRequested);
    connect(m_release, &LinkLabel::activated, this, &ConnectionStrip::releaseForcesRequested);
    connect(&context, &Context::statusChanged, this, &ConnectionStrip::refresh);
    connect(&context, &Context::linkChanged, this, &ConnectionStrip::refresh);
    connect(&context, &Context::programMatchesChanged, this, &ConnectionStrip::refresh);
    connect(&context, &Context::armedChanged, this, &ConnectionStrip::refresh);
    connect(&connection, &Connection::stateChanged, this, &ConnectionStrip::refresh);
    connect(&theme(), &Theme::changed, this, &ConnectionStrip::refresh);
    refresh();
}

void ConnectionStrip::refresh()
{
    const LinkState state = m_connection.state();
    setVisible(state != LinkState::Offline);
    if (state == LinkState::Offline)
        return;
    const ControllerStatus& status = m_context.status();
    const bool simulated = !m_context.link() || m_context.link()->capabilities().simulated || m_connection.address() == QLatin1String("local");
    const bool lost = state == LinkState::Lost;
    QString words;
    if (state == LinkState::Connecting)
        words = tr("Connecting to %1").arg(m_connection.address());
    else if (lost)
        words = tr("Connection to %1 lost, trying again").arg(m_connection.address());
    else if (simulated)
        words = tr("Virtual controller · %1").arg(machineName(status));
    else
        words = tr("REAL MACHINE · %1 · %2").arg(machineName(status), m_connection.address());
    const Role ink = lost ? Role::Error : simulated ? Role::Simulated : Role::Real;
    const Role ground = lost ? Role::ErrorSoft : simulated ? Role::AccentSoft : Role::WarnSoft;
    setStyleSheet(QStringLiteral("#connectionStrip { background: %1; border: none; } #connectionStrip QLabel { color: %2; font-weight: 600; font-size: %3px; }")
                      .arg(theme().name(ground), theme().name(ink))
                      .arg(theme().smallFont().pixelSize()));
    m_words->setText(words);
    m_sign->setVisible(lost || !simulated);
    m_sign->setPixmap(iconPixmap(QStringLiteral("warning"), 14, ink, devicePixelRatioF()));
    m_forces->setVisible(status.forces > 0);
    m_forces->setContent(tr("F %n forced", nullptr, int(status.forces)), Role::Forced, Role::ForcedSoft);
    m_release->setVisible(status.forces > 0);
    if (const QAction* release = m_context.actions().action(QStringLiteral("online.releaseForces")))
        m_release->setToolTip(release->toolTip());
    const bool differs = state == LinkState::Online && !m_context.programMatches() && m_context.document().isOpen();
    m_differs->setVisible(differs);
    m_differs->setText(status.program == Hash{} ? tr("The controller has no program yet.") : tr("The controller runs another program: live values are off."));
    m_showDifferences->setVisible(differs);
    m_armed->setVisible(m_context.isArmed());
}

} // namespace camwright
