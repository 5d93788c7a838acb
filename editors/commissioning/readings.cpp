#include "editors/commissioning/readings.h"

#include "editors/commissioning/bigdigits.h"
#include "editors/commissioning/moveestimate.h"
#include "editors/commissioning/numbers.h"
#include "editors/commissioning/travelbar.h"
#include "editors/shell/icons.h"
#include "editors/shell/widgets.h"
#include "editors/words/words.h"

#include <QGridLayout>

#include <algorithm>
#include <cmath>

namespace camwright {

namespace {

constexpr int Decimals = 3; // room kept behind the point in every row

QLabel* groupLabel(const QString& text, QWidget* parent)
{
    auto* label = new QLabel(text, parent);
    label->setProperty("tone", "group");
    return label;
}

QFrame* fineLine(QWidget* parent)
{
    auto* line = new QFrame(parent);
    line->setProperty("surface", "fine");
    line->setFixedHeight(1);
    return line;
}

} // namespace

Readings::Readings(QWidget* parent)
    : QWidget(parent), m_homedIcon(new QLabel(this)), m_homed(new QLabel(this)), m_digits(new BigDigits(this)), m_state(new Pill(this)), m_travel(new TravelBar(this)), m_stopsWithin(new QLabel(this))
{
    describe(m_digits, "actualPosition", tr("Actual position"), tr("Position of the load as the drive measures it"));
    describe(m_travel, "travelBar", tr("Travel"), tr("Position, stopping distance and target between the limits"));
    m_homed->setObjectName(QStringLiteral("homedMark"));
    m_state->setObjectName(QStringLiteral("motionPill"));
    m_stopsWithin->setObjectName(QStringLiteral("stopsWithin"));
    m_stopsWithin->setProperty("tone", "caption");
    m_stopsWithin->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    m_stopsWithin->ensurePolished();
    // Room for it from the beginning: it must not be cut, and the columns must not move, when the axis does.
    m_stopsWithin->setMinimumWidth(m_stopsWithin->fontMetrics().horizontalAdvance(tr("stops within %1 %2").arg(QStringLiteral("00000.0"), words::unitWord("mm"))));
    auto* title = new QHBoxLayout;
    title->setSpacing(4);
    title->addWidget(groupLabel(tr("Actual Position"), this));
    title->addStretch();
    title->addWidget(m_homedIcon);
    title->addWidget(m_homed);
    auto* digits = new QHBoxLayout;
    digits->addWidget(m_digits, 1);
    digits->addWidget(m_state, 0, Qt::AlignVCenter);
    auto* table = new QGridLayout;
    buildTable(table);
    auto* travel = new QHBoxLayout;
    travel->addWidget(groupLabel(tr("Travel"), this));
    travel->addStretch();
    travel->addWidget(m_stopsWithin);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(16, 12, 16, 8);
    column->setSpacing(0);
    column->addLayout(title);
    column->addLayout(digits);
    column->addLayout(table);
    column->addSpacing(14);
    column->addLayout(travel);
    column->addWidget(m_travel);
    column->addStretch();
    connect(&theme(), &Theme::changed, this, [this] { showState(m_last); });
}

void Readings::buildTable(QGridLayout* table)
{
    table->setSpacing(0);
    table->setColumnStretch(0, 1);
    table->setColumnMinimumWidth(1, 70);
    table->setColumnMinimumWidth(3, 56);
    auto* now = new QLabel(tr("now"), this);
    now->setProperty("tone", "caption");
    auto* peak = new LinkLabel(tr("peak"), this);
    describe(peak, "resetPeaks", tr("Reset the peaks"), tr("Largest values since the last reset. Click to begin again."));
    peak->setProperty("tone", "caption");
    connect(peak, &LinkLabel::activated, this, &Readings::resetPeaks);
    table->addWidget(now, 0, 1, Qt::AlignRight);
    table->addWidget(peak, 0, 3, Qt::AlignRight);
    const QString names[RowCount] = {tr("Set position"), tr("To target"), tr("Velocity"), tr("Following error"), tr("Torque")};
    for (int row = 0; row < RowCount; ++row) {
        const auto at = static_cast<std::size_t>(row);
        auto* name = new QLabel(names[row], this);
        name->setProperty("tone", "dim");
        m_now[at] = new QLabel(this);
        m_now[at]->setFont(theme().monoFont());
        m_now[at]->setAccessibleName(names[row]);
        m_now[at]->setObjectName(QStringLiteral("reading%1").arg(row));
        m_units[at] = new QLabel(this);
        m_units[at]->setProperty("tone", "dim");
        m_units[at]->setContentsMargins(6, 0, 6, 0);
        m_peakLabels[at] = new QLabel(this);
        m_peakLabels[at]->setFont(theme().monoFont());
        m_peakLabels[at]->setProperty("tone", "dim");
        m_peakLabels[at]->setObjectName(QStringLiteral("peak%1").arg(row));
        table->addWidget(fineLine(this), 2 * row + 1, 0, 1, 4);
        table->addWidget(name, 2 * row + 2, 0);
        table->addWidget(m_now[at], 2 * row + 2, 1, Qt::AlignRight);
        table->addWidget(m_units[at], 2 * row + 2, 2);
        table->addWidget(m_peakLabels[at], 2 * row + 2, 3, Qt::AlignRight);
        table->setRowMinimumHeight(2 * row + 2, 25);
    }
}

void Readings::showState(const AxisStatus& axis)
{
    const Role ink = axis.homed ? Role::Ok : Role::Dim;
    const QString sheet = QStringLiteral("color: %1; font-weight: 600;").arg(theme().name(ink));
    m_homed->setText(axis.homed ? tr("homed") : tr("not homed"));
    if (sheet != m_homed->styleSheet()) {
        m_homed->setStyleSheet(sheet);
        m_homedIcon->setPixmap(iconPixmap(axis.homed ? QStringLiteral("check") : QStringLiteral("ring"), 14, ink, devicePixelRatioF()));
    }
    if (axis.error != 0)
        m_state->setContent(tr("error"), Role::Error, Role::ErrorSoft, QStringLiteral("error"));
    else if (axis.moving)
        m_state->setContent(axis.velocity < 0 ? tr("moving −") : tr("moving +"), Role::Accent, Role::AccentSoft, QStringLiteral("triangle-right"));
    else if (axis.enabled)
        m_state->setContent(tr("standing"), Role::Dim, Role::FineLine, QStringLiteral("square"));
    else
        m_state->setContent(tr("disabled"), Role::Dim, Role::FineLine, QStringLiteral("ring"));
}

void Readings::showRow(Row row, std::optional<double> value, const QString& unit, int decimals, bool hasPeak)
{
    const auto at = static_cast<std::size_t>(row);
    m_now[at]->setText(value ? shownNumber(*value, decimals, Decimals) : QStringLiteral("–") + QString(4, QChar(0x00a0)));
    m_units[at]->setText(unit);
    if (!hasPeak)
        return;
    m_peaks[at] = std::max(m_peaks[at], std::abs(value.value_or(0)));
    m_peakLabels[at]->setText(shownNumber(m_peaks[at], decimals, Decimals));
}

void Readings::present(const AxisStatus& axis, const ReadingsInput& input)
{
    m_last = axis;
    const QString unit = words::unitWord(axis.unit);
    m_digits->setValue(shownNumber(axis.position, 3), unit);
    showState(axis);
    showRow(SetPosition, axis.setPosition, unit, 3, false);
    showRow(ToTarget, input.target ? std::optional(*input.target - axis.position) : std::nullopt, unit, 3, false);
    showRow(Velocity, axis.velocity, tr("%1/s").arg(unit), 1, true);
    showRow(FollowingError, axis.followingError, unit, 3, true);
    showRow(Torque, axis.torque, QStringLiteral("%"), 1, true);
    const double way = axis.moving ? stoppingDistance(axis.velocity, input.deceleration) : 0;
    m_stopsWithin->setText(axis.moving ? tr("stops within %1 %2").arg(shownNumber(std::abs(way), 1), unit) : QString());
    m_travel->setTravel({axis.position, axis.position + way, input.target, input.lower, input.upper, unit});
}

void Readings::resetPeaks()
{
    m_peaks = {};
    for (QLabel* label : m_peakLabels)
        label->clear();
}

} // namespace camwright
