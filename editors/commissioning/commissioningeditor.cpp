#include "editors/commissioning/commissioningeditor.h"

#include "editors/commissioning/axislimits.h"
#include "editors/commissioning/lampstrip.h"
#include "editors/commissioning/motioncolumn.h"
#include "editors/commissioning/panelcontrol.h"
#include "editors/commissioning/panelkeys.h"
#include "editors/commissioning/panelwatch.h"
#include "editors/commissioning/readings.h"
#include "editors/commissioning/stateview.h"
#include "editors/shell/context.h"
#include "editors/shell/widgets.h"

#include <QHBoxLayout>
#include <QStackedLayout>
#include <QVBoxLayout>

namespace camwright {

namespace {

// Shares of the width, after the drawing.
constexpr int ReadingsShare = 300, StateShare = 396, MotionShare = 508;
constexpr int LineWidth = 1;

QFrame* verticalLine(QWidget* parent)
{
    auto* line = new QFrame(parent);
    line->setProperty("surface", "fine");
    line->setFixedWidth(LineWidth);
    return line;
}

} // namespace

CommissioningEditor::CommissioningEditor(Context& context, ObjectKey key, QWidget* parent)
    : Editor(context, key, parent), m_control(new PanelControl(context, key.name, this)), m_keys(new PanelKeys(this)), m_watch(new PanelWatch(*this)), m_layers(new QStackedLayout(this)), m_empty(new EmptyState(QStringLiteral("axis-linear"), {}, this))
{
    setObjectName(QStringLiteral("commissioning"));
    m_layers->addWidget(m_empty);
    m_page = buildPage();
    m_layers->addWidget(m_page);
    connectSafety();
    connect(m_control, &PanelControl::changed, this, &CommissioningEditor::refresh);
    connect(&context.document(), &ProjectDocument::changed, this, [this](const ProjectChange& change) {
        if (change.touches(this->key()))
            refreshLimits();
    });
    connect(&context, &Context::linkChanged, this, [this] {
        m_state->forget();
        m_readings->resetPeaks();
        m_motion->say({});
        refresh();
    });
    refresh();
}

CommissioningEditor::~CommissioningEditor()
{
    // The control's last signals must not reach a half-gone page.
    m_control->disconnect(this);
    m_control->disarm();
}

QWidget* CommissioningEditor::buildPage()
{
    auto* page = new QFrame(this);
    page->setProperty("surface", "plain");
    m_readings = new Readings(page);
    m_state = new StateView(page);
    m_stateLine = verticalLine(page);
    auto* columns = new QHBoxLayout;
    columns->setContentsMargins(0, 0, 0, 0);
    columns->setSpacing(0);
    columns->addWidget(m_readings, ReadingsShare);
    columns->addWidget(m_stateLine);
    columns->addWidget(m_state, StateShare);
    columns->addWidget(verticalLine(page));
    columns->addWidget(buildRight(), MotionShare);
    m_lamps = new LampStrip(page);
    auto* note = new QLabel(tr("This is a convenience, not a safety function: the machine needs its own emergency stop."), page);
    note->setObjectName(QStringLiteral("safetyNote"));
    note->setProperty("tone", "caption");
    note->setContentsMargins(16, 4, 16, 5);
    auto* rows = new QVBoxLayout(page);
    rows->setContentsMargins(0, 0, 0, 0);
    rows->setSpacing(0);
    rows->addLayout(columns);
    rows->addWidget(m_lamps);
    rows->addWidget(note);
    rows->addStretch(1);
    return page;
}

QWidget* CommissioningEditor::buildRight()
{
    auto* holder = new QWidget(this);
    m_right = new QStackedLayout(holder);
    m_motion = new MotionColumn(*m_control, holder);
    m_noMotion = new EmptyState(QStringLiteral("lock"), {}, holder);
    m_noMotion->setObjectName(QStringLiteral("whyNoMotion"));
    m_right->addWidget(m_motion);
    m_right->addWidget(m_noMotion);
    connect(m_motion, &MotionColumn::moveBegan, m_readings, &Readings::resetPeaks);
    return holder;
}

void CommissioningEditor::connectSafety()
{
    connect(m_keys, &PanelKeys::stopPressed, this, [this] {
        m_motion->letGoAll();
        m_control->stopAll();
    });
    connect(m_keys, &PanelKeys::jogPressed, m_motion, &MotionColumn::hold);
    connect(m_keys, &PanelKeys::jogReleased, m_motion, &MotionColumn::letGo);
    connect(&context(), &Context::disarmRequested, m_motion, &MotionColumn::letGoAll);
    connect(m_watch, &PanelWatch::focusMoved, m_motion, &MotionColumn::letGoAll);
    connect(m_watch, &PanelWatch::left, this, [this] {
        m_motion->letGoAll();
        m_control->disarm();
    });
}

QString CommissioningEditor::title() const
{
    return tr("%1 · Commissioning").arg(QString::fromStdString(key().name));
}

QString CommissioningEditor::iconName() const
{
    const Axis* axis = context().document().content<Axis>(key());
    const bool rotary = axis && axis->type.valueOr(AxisType::Linear) == AxisType::Rotary;
    return rotary ? QStringLiteral("axis-rotary") : QStringLiteral("axis-linear");
}

void CommissioningEditor::setKey(const ObjectKey& key)
{
    Editor::setKey(key);
    m_control->setAxisName(key.name);
    emit titleChanged();
}

void CommissioningEditor::reveal(const Place&)
{
    setFocus(Qt::OtherFocusReason);
}

QString CommissioningEditor::emptySentence() const
{
    if (!context().isOnline())
        return tr("Go online to move this axis.");
    if (!m_control->axis())
        return tr("The controller's program has no axis \"%1\". Download this project to move it.").arg(QString::fromStdString(key().name));
    return {};
}

void CommissioningEditor::refreshLimits()
{
    const Axis* axis = context().document().content<Axis>(key());
    if (!axis || !context().isOnline())
        return;
    const std::string& running = context().status().family;
    const std::string& family = running.empty() ? context().document().project().controller().family : running;
    m_motion->setLimits(axisLimits(*axis, family, context().link()->capabilities().simulated));
    m_state->setFamily(family);
}

void CommissioningEditor::refresh()
{
    using Mode = PanelKeys::Mode;
    m_keys->setMode(m_control->isArmed() ? Mode::StopAndJog : m_control->isDriving() ? Mode::StopOnly : Mode::Off);
    m_watch->setActive(m_control->arming() != PanelControl::Arming::Off);
    const QString empty = emptySentence();
    m_empty->setSentence(empty);
    m_layers->setCurrentIndex(empty.isEmpty() ? 1 : 0);
    m_motion->refresh();
    if (!empty.isEmpty())
        return;

    refreshLimits();
    const ControllerStatus& status = context().status();
    const LinkCapabilities can = context().link()->capabilities();
    m_right->setCurrentIndex(can.motion ? 0 : 1);
    if (!can.motion)
        m_noMotion->setSentence(can.whyNoMotion.empty() ? tr("This link cannot move axes.") : tr("This link cannot move axes: %1").arg(QString::fromStdString(can.whyNoMotion)));
    const AxisStatus& axis = *m_control->axis();
    m_motion->present(status);
    const Axis* project = context().document().content<Axis>(key());
    const AxisLimits limits = project ? axisLimits(*project, status.family, can.simulated) : AxisLimits();
    m_readings->present(axis, {m_motion->target(), limits.lower, limits.upper, m_motion->deceleration()});
    m_state->present(axis, status.time);
    m_lamps->present(axis, status.family, status.model);
    arrange(); // texts of another length want other room
}

/// Where the three do not fit side by side, the state diagram gives its room to the controls; the state stays as a pill.
void CommissioningEditor::arrange()
{
    const int controls = m_readings->minimumSizeHint().width() + LineWidth + m_motion->minimumSizeHint().width();
    m_page->setMinimumWidth(controls);
    const bool room = width() >= controls + LineWidth + m_state->minimumSizeHint().width();
    m_state->setVisible(room);
    m_stateLine->setVisible(room);
}

void CommissioningEditor::resizeEvent(QResizeEvent* event)
{
    Editor::resizeEvent(event);
    arrange();
}

} // namespace camwright
