#include "editors/commissioning/movepad.h"

#include "editors/commissioning/numbers.h"
#include "editors/commissioning/plainfield.h"
#include "editors/commissioning/profileview.h"
#include "editors/shell/icons.h"
#include "editors/shell/quantityfield.h"
#include "editors/shell/widgets.h"

#include <QGridLayout>

#include <algorithm>

namespace camwright {

namespace {

constexpr int ColumnGap = 8, SmallestField = 92;

QLabel* caption(const QString& text, QWidget* parent)
{
    auto* label = new QLabel(text, parent);
    label->setProperty("tone", "caption");
    return label;
}

} // namespace

MovePad::MovePad(QWidget* parent)
    : QWidget(parent), m_kind(new SegmentedControl(tr("Kind of move"), this)), m_takes(caption({}, this)), m_profile(new ProfileView(this)), m_move(new QPushButton(this))
{
    auto* grid = new QGridLayout(this);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setHorizontalSpacing(ColumnGap);
    grid->setVerticalSpacing(2);
    for (int column = 0; column < 4; ++column)
        grid->setColumnStretch(column, 1);
    m_kind->setObjectName(QStringLiteral("moveKind"));
    m_kind->addSegment(tr("Absolute"), {}, tr("The target is a position."));
    m_kind->addSegment(tr("Relative"), {}, tr("The target is a distance from where the axis stands."));
    grid->addWidget(caption(tr("Move"), this), 0, 0);
    grid->addWidget(m_kind, 1, 0, 1, 2, Qt::AlignLeft | Qt::AlignTop);
    m_target = addField(grid, 0, 2, tr("Target"), "moveTarget");
    m_velocity = addField(grid, 0, 3, tr("Velocity"), "moveVelocity", &m_capNote);
    grid->setRowMinimumHeight(2, 4);
    m_acceleration = addField(grid, 3, 0, tr("Acceleration"), "moveAcceleration");
    auto* head = new QHBoxLayout;
    head->addWidget(caption(tr("Profile"), this));
    head->addStretch();
    head->addWidget(m_takes);
    m_takes->setObjectName(QStringLiteral("moveTakes"));
    grid->addLayout(head, 3, 1, 1, 2);
    grid->addWidget(m_profile, 4, 1, 1, 2, Qt::AlignTop);
    describe(m_profile, "moveProfile", tr("Velocity profile of the move"));
    describe(m_move, "move", tr("Move"));
    m_move->setText(tr("Move"));
    makePrimary(m_move);
    grid->addWidget(m_move, 4, 3, Qt::AlignTop);
    connect(m_kind, &SegmentedControl::chosen, this, &MovePad::refresh);
    connect(m_move, &QPushButton::clicked, this, &MovePad::moveWanted);
    for (QuantityField* field : {m_target, m_velocity, m_acceleration})
        connect(field, &QuantityField::edited, this, &MovePad::refresh);
    refresh();
}

QuantityField* MovePad::addField(QGridLayout* grid, int row, int column, const QString& name, const char* objectName, QLabel** note)
{
    auto* head = new QHBoxLayout;
    auto* label = caption(name, this);
    head->addWidget(label);
    head->addStretch();
    if (note) {
        *note = caption({}, this);
        head->addWidget(*note);
    }
    if (!m_targetLabel)
        m_targetLabel = label;
    QuantitySpec spec;
    spec.name = name;
    auto* field = new QuantityField(spec, this);
    field->setObjectName(QLatin1String(objectName));
    grid->addLayout(head, row, column);
    grid->addWidget(new PlainField(field, SmallestField, this), row + 1, column, Qt::AlignTop);
    return field;
}

void MovePad::setLimits(const AxisLimits& limits)
{
    if (limits == m_limits && m_started)
        return;
    const bool first = !m_started || limits.unit != m_limits.unit || limits.perTurn != m_limits.perTurn;
    m_limits = limits;
    m_started = true;
    const auto spec = [&](const QString& name, const QString& unit, double minimum, const QString& help) {
        QuantitySpec out;
        out.name = name;
        out.unit = unit;
        out.minimum = minimum;
        out.perTurn = limits.perTurn;
        out.help = help;
        return out;
    };
    m_target->setSpec(spec(tr("Target"), limits.unit, -std::numeric_limits<double>::infinity(), tr("Position to move to, or distance to move by.")));
    QuantitySpec velocity = spec(tr("Velocity"), tr("%1/s").arg(limits.unit), limits.perTurn * 1e-4, tr("The speed cap limits it."));
    velocity.maximum = limits.highestSpeed;
    m_velocity->setSpec(velocity);
    m_acceleration->setSpec(spec(tr("Acceleration"), tr("%1/s²").arg(limits.unit), limits.perTurn * 1e-4,
        limits.drivesOwnAcceleration ? tr("Only for the duration shown here: a Kinco axis moves with its drive's own acceleration, drive parameters 0 and 1.")
                                     : tr("Acceleration and deceleration of the move.")));
    if (first) {
        m_target->setValue(0);
        m_velocity->setValue(m_cap > 0 ? m_cap : limits.firstMaxSpeed);
        m_acceleration->setValue(limits.acceleration);
    }
    refresh();
}

void MovePad::setCap(double cap)
{
    m_cap = cap;
    refresh();
}

void MovePad::setMovable(bool movable, const QString& why)
{
    if (movable == m_movable && why == m_why)
        return;
    m_movable = movable;
    m_why = why;
    refresh();
}

void MovePad::setPosition(double position)
{
    if (position == m_position)
        return;
    m_position = position;
    if (!isRelative())
        refresh();
}

void MovePad::setProgress(double progress)
{
    m_profile->setProgress(progress);
}

bool MovePad::isRelative() const
{
    return m_kind->currentIndex() == 1;
}

double MovePad::target() const
{
    return m_target->valueOr(0);
}

double MovePad::velocity() const
{
    return std::min(m_velocity->valueOr(0), m_cap);
}

double MovePad::acceleration() const
{
    return m_acceleration->valueOr(0);
}

double MovePad::commandAcceleration() const
{
    return m_limits.drivesOwnAcceleration ? 0 : acceleration();
}

QString MovePad::whyNot() const
{
    if (!m_movable)
        return m_why;
    for (const QuantityField* field : {m_target, m_velocity, m_acceleration}) {
        if (!field->problem().isEmpty())
            return field->problem();
    }
    return {};
}

void MovePad::refresh()
{
    const QString why = whyNot();
    m_move->setIcon(icon(isRelative() ? QStringLiteral("move-relative") : QStringLiteral("move-absolute"), Role::OnAccent));
    m_move->setEnabled(why.isEmpty());
    m_targetLabel->setText(isRelative() ? tr("Distance") : tr("Target"));
    m_capNote->setText(m_velocity->valueOr(0) >= m_cap ? tr("at cap") : QString());
    m_estimate = estimateMove(isRelative() ? target() : target() - m_position, velocity(), acceleration());
    m_takes->setText(m_estimate.duration > 0 ? tr("takes %1 s").arg(shownNumber(m_estimate.duration, 3)) : tr("already there"));
    if (isRelative() && m_estimate.duration <= 0)
        m_takes->clear();
    m_profile->setEstimate(m_estimate);
    const QString what = isRelative() ? tr("Moves by the distance.") : tr("Moves to the target.");
    m_move->setToolTip(why.isEmpty() ? what : why);
}

} // namespace camwright
