#include "app/window/statusline.h"

#include "editors/shell/theme.h"
#include "editors/shell/widgets.h"

#include <QCoreApplication>
#include <QHBoxLayout>
#include <QLabel>

namespace camwright {

StatusLine::StatusLine(Context& context, Connection& connection, Workbench& workbench, QWidget* parent)
    : QFrame(parent), m_context(context), m_connection(connection), m_workbench(workbench)
{
    setObjectName(QStringLiteral("statusLine"));
    setFixedHeight(25);
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(12, 1, 12, 0);
    row->setSpacing(18);
    m_state = new Pill(this);
    row->addWidget(m_state);
    const auto label = [&](QLabel*& out) {
        out = new QLabel(this);
        out->setProperty("tone", "caption");
        row->addWidget(out);
    };
    label(m_problems);
    label(m_scan);
    label(m_program);
    label(m_control);
    label(m_bus);
    label(m_forces);
    row->addStretch();
    label(m_position);
    label(m_project);
    connect(&context, &Context::statusChanged, this, &StatusLine::refresh);
    connect(&context, &Context::linkChanged, this, &StatusLine::refresh);
    connect(&context, &Context::programMatchesChanged, this, &StatusLine::refresh);
    connect(&connection, &Connection::stateChanged, this, &StatusLine::refresh);
    connect(&workbench, &Workbench::builtChanged, this, &StatusLine::refresh);
    connect(&workbench, &Workbench::busyChanged, this, &StatusLine::refresh);
    connect(&context.document(), &ProjectDocument::diagnosticsChanged, this, &StatusLine::refresh);
    connect(&context.document(), &ProjectDocument::pathChanged, this, &StatusLine::refresh);
    connect(&context.document(), &ProjectDocument::modifiedChanged, this, &StatusLine::refresh);
    connect(&theme(), &Theme::changed, this, &StatusLine::refresh);
    refresh();
}

void StatusLine::setPosition(const QString& text)
{
    m_position->setText(text);
}

void StatusLine::refresh()
{
    setStyleSheet(QStringLiteral("#statusLine { background: %1; border: none; border-top: 1px solid %2; }")
                      .arg(theme().name(Role::Surface), theme().name(Role::Line)));
    const ProjectDocument& document = m_context.document();
    const bool online = m_context.isOnline();
    m_state->setVisible(document.isOpen());
    for (QLabel* label : {m_problems, m_scan, m_program, m_control, m_bus, m_forces})
        label->hide();
    m_position->setVisible(document.isOpen());
    if (!document.isOpen()) {
        m_project->setText(tr("Camwright %1").arg(QCoreApplication::applicationVersion()));
        m_problems->setText(tr("No project open"));
        m_problems->setStyleSheet({});
        m_problems->show();
        return;
    }
    QString name = document.displayName();
    if (document.isReadOnly())
        name = tr("%1 (read only)").arg(name);
    else if (document.isModified())
        name = tr("%1, not saved").arg(name);
    m_project->setText(name);
    const int errors = document.errorCount();
    const int warnings = document.warningCount();
    if (errors + warnings > 0) {
        m_problems->setText(errors > 0 ? tr("%n errors", nullptr, errors) : tr("%n warnings", nullptr, warnings));
        m_problems->setStyleSheet(QStringLiteral("color: %1; font-weight: 600;").arg(theme().name(errors > 0 ? Role::Error : Role::Warn)));
        m_problems->show();
    }
    if (online)
        refreshOnline();
    else
        refreshOffline();
}

void StatusLine::refreshOnline()
{
    const ControllerStatus& status = m_context.status();
    if (status.state == RunState::Run)
        m_state->setContent(QStringLiteral("RUN"), Role::Ok, Role::OkSoft, QStringLiteral("triangle-right"));
    else if (status.state == RunState::Stop)
        m_state->setContent(QStringLiteral("STOP"), Role::Dim, Role::FineLine, QStringLiteral("square"));
    else
        m_state->setContent(tr("ERROR"), Role::Error, Role::ErrorSoft, QStringLiteral("error"));
    m_scan->setText(tr("scan %1 ms").arg(status.scanMs, 0, 'f', 2));
    m_scan->setToolTip(tr("Longest scan %1 ms").arg(status.scanMaxMs, 0, 'f', 2));
    m_program->setText(m_context.programMatches() ? tr("program same ✓") : tr("program differs ≠"));
    m_control->setText(status.control == ControlHolder::You ? tr("control: you")
            : status.control == ControlHolder::Somebody     ? tr("control: %1").arg(QString::fromStdString(status.controlOwner))
                                                            : tr("control: nobody"));
    m_bus->setText(tr("bus %1 %").arg(status.busLoadPercent, 0, 'f', 0));
    m_forces->setText(tr("forces %1").arg(status.forces));
    m_forces->setStyleSheet(status.forces > 0 ? QStringLiteral("color: %1; font-weight: 600;").arg(theme().name(Role::Forced)) : QString());
    for (QLabel* label : {m_scan, m_program, m_control, m_bus, m_forces})
        label->show();
}

void StatusLine::refreshOffline()
{
    const LinkState state = m_connection.state();
    if (state == LinkState::Connecting)
        m_state->setContent(tr("CONNECTING"), Role::Accent, Role::AccentSoft, QStringLiteral("plug"));
    else if (state == LinkState::Lost)
        m_state->setContent(tr("LOST"), Role::Error, Role::ErrorSoft, QStringLiteral("unplug"));
    else
        m_state->setContent(tr("OFFLINE"), Role::Dim, Role::FineLine, QStringLiteral("ring"));
    m_program->setText(m_workbench.isBusy() ? tr("building") : m_workbench.isBuilt() ? tr("built") : tr("not built since the last edit"));
    m_program->show();
}

} // namespace camwright
