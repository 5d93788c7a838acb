#include "editors/shell/axisform.h"

#include "core/checks/checkproject.h"
#include "core/model/fieldlist.h"
#include "editors/shell/quantityfield.h"
#include "editors/shell/theme.h"
#include "editors/shell/widgets.h"
#include "editors/words/words.h"

#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QVBoxLayout>

#include <type_traits>

namespace camwright {

namespace {

QuantitySpec spec(const char* field, const QString& name, const QString& unit, bool integer, const QString& help, const QString& reference)
{
    QuantitySpec out;
    out.name = name;
    out.unit = unit;
    out.integer = integer;
    out.help = help;
    out.reference = reference;
    if (const auto range = fieldRange(ObjectKind::Axis, field)) {
        out.minimum = range->low;
        out.maximum = range->high;
    }
    const Axis standard;
    visitFields(standard, [&](std::string_view key, const auto& member) {
        using Member = std::remove_cvref_t<decltype(member)>;
        if constexpr (std::is_same_v<Member, Field<double>>) {
            if (key == field)
                out.defaultValue = member.value();
        } else if constexpr (std::is_same_v<Member, Field<std::int64_t>>) {
            if (key == field)
                out.defaultValue = static_cast<double>(member.value());
        }
    });
    return out;
}

QLabel* rowLabel(const QString& text)
{
    auto* label = new QLabel(text);
    label->setMinimumHeight(Theme::FieldHeight);
    return label;
}

} // namespace

AxisForm::AxisForm(QWidget* parent)
    : QWidget(parent), m_rows(new QFormLayout(this)), m_name(new QLineEdit(this)), m_nameProblem(new QLabel(this))
{
    m_rows->setContentsMargins(0, 0, 0, 0);
    m_rows->setHorizontalSpacing(20);
    m_rows->setVerticalSpacing(Theme::RowGap);
    m_rows->setFieldGrowthPolicy(QFormLayout::FieldsStayAtSizeHint);
    m_rows->setLabelAlignment(Qt::AlignLeft | Qt::AlignTop);
    addNumbers();
    addMechanics();
    addSupervision();
    refresh();
}

void AxisForm::addNumbers()
{
    describe(m_name, "axisName", tr("Name"), tr("Name of the axis, as programs, traces and this window call it (KS-MCN-08)"));
    m_name->setFixedWidth(220);
    m_name->setMinimumHeight(Theme::FieldHeight);
    m_nameProblem->setStyleSheet(QStringLiteral("color: %1").arg(theme().name(Role::Error)));
    m_nameProblem->setWordWrap(true);
    m_nameProblem->hide();
    auto* column = new QVBoxLayout;
    column->setContentsMargins(12, 0, 0, 0); // in line with fields that have a dot before them
    column->addWidget(m_name);
    column->addWidget(m_nameProblem);
    m_rows->addRow(rowLabel(tr("Name")), column);
    connect(m_name, &QLineEdit::editingFinished, this, [this] {
        if (m_name->isModified()) {
            m_name->setModified(false);
            emit nameEdited(m_name->text());
        }
    });
    addField(tr("Axis number"), "number", spec("number", tr("Axis number"), {}, true,
        tr("Address of the drive on the CANopen bus. Numbers go from 1 without a gap."), QStringLiteral("KS-MCN-06")));
}

void AxisForm::addMechanics()
{
    m_type = new SegmentedControl(tr("Axis type"), this);
    m_type->setObjectName(QStringLiteral("axisType"));
    m_type->addSegment(tr("Linear"), QStringLiteral("axis-linear"), tr("Positions in millimetres"));
    m_type->addSegment(tr("Rotary"), QStringLiteral("axis-rotary"), tr("Positions in degrees"));
    auto* holder = new QWidget(this);
    auto* line = new QHBoxLayout(holder);
    line->setContentsMargins(12, 0, 0, 0);
    line->addWidget(m_type);
    line->addStretch();
    m_rows->addRow(rowLabel(tr("Type")), holder);
    connect(m_type, &SegmentedControl::chosen, this, [this](int index) {
        m_axis.type = index == 0 ? AxisType::Linear : AxisType::Rotary;
        refreshUnits();
        emit edited("type", m_axis);
    });
    addField(tr("Encoder resolution"), "encoder_resolution", spec("encoder_resolution", tr("Encoder resolution"), tr("pulses"), true,
        tr("Pulses of the encoder per turn of the motor."), QStringLiteral("KS-MCN-12")));
    addField(tr("Travel per motor turn"), "mechanical_equivalent", spec("mechanical_equivalent", tr("Travel per motor turn"), tr("mm"), false,
        tr("How far the load moves while the motor makes one turn."), QStringLiteral("KS-MCN-12")));
}

QWidget* AxisForm::addGuardingChoice()
{
    m_guarding = new SegmentedControl(tr("Node guarding"), this);
    m_guarding->setObjectName(QStringLiteral("nodeGuarding"));
    m_guarding->addSegment(tr("Default"), {}, tr("Guard time 1000 ms, life factor 3"));
    m_guarding->addSegment(tr("Advanced"), {}, tr("Own guard time and life factor"));
    auto* holder = new QWidget(this);
    auto* line = new QHBoxLayout(holder);
    line->setContentsMargins(12, 0, 0, 0);
    line->addWidget(m_guarding);
    line->addStretch();
    connect(m_guarding, &SegmentedControl::chosen, this, [this](int index) {
        m_advanced = index == 1;
        showGuarding(m_advanced);
        const Axis standard;
        if (index == 0 && (m_axis.guardTimeMs != standard.guardTimeMs || m_axis.lifeFactor != standard.lifeFactor)) {
            m_axis.guardTimeMs = standard.guardTimeMs;
            m_axis.lifeFactor = standard.lifeFactor;
            refresh();
            emit edited("guard_time_ms", m_axis);
        }
    });
    return holder;
}

void AxisForm::addSupervision()
{
    m_rows->addRow(rowLabel(tr("Node guarding")), addGuardingChoice());
    addField(tr("Guard time"), "guard_time_ms", spec("guard_time_ms", tr("Guard time"), tr("ms"), true,
        tr("How often the master asks the drive whether it is alive. 0 switches guarding off."), QStringLiteral("KS-COM-12")));
    addField(tr("Life factor"), "life_factor", spec("life_factor", tr("Life factor"), {}, true,
        tr("How many answers may be missing before the axis counts as lost."), QStringLiteral("KS-COM-12")));
    addField(tr("PDO inhibit time"), "inhibit_time_ms", spec("inhibit_time_ms", tr("PDO inhibit time"), tr("ms"), true,
        tr("Shortest distance between two process data frames of the drive. Position and speed change quickly; without it they would fill the bus."), QStringLiteral("KS-MCN-09")));
    addField(tr("PDO event timer"), "event_timer_ms", spec("event_timer_ms", tr("PDO event timer"), tr("ms"), true,
        tr("Sends process data at least this often, also when nothing changed. 0: only on change."), QStringLiteral("KS-COM-14")));
}

QuantityField* AxisForm::addField(const QString& label, const char* field, QuantitySpec quantity)
{
    auto* edit = new QuantityField(quantity, this);
    edit->setObjectName(QString::fromLatin1(field));
    edit->setFieldWidth(150);
    m_rows->addRow(rowLabel(label), edit);
    m_fields[field] = edit;
    connect(edit, &QuantityField::edited, this, [this, edit, field = std::string(field)] {
        visitFields(m_axis, [&](std::string_view key, auto& member) {
            using Member = std::remove_cvref_t<decltype(member)>;
            if (key != field)
                return;
            if constexpr (std::is_same_v<Member, Field<double>>)
                member = edit->realField();
            else if constexpr (std::is_same_v<Member, Field<std::int64_t>>)
                member = edit->integerField();
        });
        emit edited(field, m_axis);
    });
    return edit;
}

void AxisForm::setAxis(const std::string& name, const Axis& axis)
{
    if (!m_name->hasFocus() || !m_name->isModified())
        m_name->setText(QString::fromStdString(name));
    const bool other = !(m_axis == axis);
    m_axis = axis;
    if (other)
        refresh();
}

QString AxisForm::axisName() const
{
    return m_name->text();
}

void AxisForm::refresh()
{
    visitFields(m_axis, [&](std::string_view key, const auto& member) {
        using Member = std::remove_cvref_t<decltype(member)>;
        const auto found = m_fields.find(std::string(key));
        if (found == m_fields.end())
            return;
        if constexpr (std::is_same_v<Member, Field<double>> || std::is_same_v<Member, Field<std::int64_t>>)
            found->second->setField(member);
    });
    m_type->setCurrentIndex(m_axis.type.valueOr(AxisType::Linear) == AxisType::Rotary ? 1 : 0);
    refreshUnits();
    const Axis standard;
    const bool own = m_axis.guardTimeMs != standard.guardTimeMs || m_axis.lifeFactor != standard.lifeFactor;
    const bool advanced = own || m_advanced; // whoever asked for the fields keeps them, also at their defaults
    m_guarding->setCurrentIndex(advanced ? 1 : 0);
    showGuarding(advanced);
}

void AxisForm::refreshUnits()
{
    QuantityField* travel = m_fields["mechanical_equivalent"];
    QuantitySpec quantity = travel->spec();
    quantity.unit = m_axis.type.valueOr(AxisType::Linear) == AxisType::Rotary ? tr("°") : tr("mm");
    if (quantity.unit != travel->spec().unit)
        travel->setSpec(quantity);
}

void AxisForm::showGuarding(bool advanced)
{
    for (const char* field : {"guard_time_ms", "life_factor"}) {
        QuantityField* edit = m_fields[field];
        m_rows->labelForField(edit)->setVisible(advanced);
        edit->setVisible(advanced);
    }
}

void AxisForm::setProblems(const ObjectKey& key, const Diagnostics& diagnostics)
{
    std::map<std::string, const Diagnostic*> byField;
    for (const Diagnostic& d : diagnostics) {
        if (d.place.object == key)
            byField.try_emplace(d.place.field, &d);
    }
    for (const auto& [field, edit] : m_fields) {
        const auto found = byField.find(field);
        const bool any = found != byField.end();
        edit->setProblem(any ? words::sentence(*found->second) : QString(), any && found->second->severity() == Severity::Warning);
        if (any && (field == "guard_time_ms" || field == "life_factor"))
            showGuarding(true);
    }
    const auto name = byField.find("name");
    m_nameProblem->setVisible(name != byField.end());
    m_nameProblem->setText(name != byField.end() ? words::sentence(*name->second) : QString());
}

void AxisForm::focusField(const std::string& field)
{
    if (field == "name")
        m_name->setFocus(Qt::OtherFocusReason);
    else if (const auto found = m_fields.find(field); found != m_fields.end()) {
        if (field == "guard_time_ms" || field == "life_factor")
            showGuarding(true);
        found->second->lineEdit()->setFocus(Qt::OtherFocusReason);
        found->second->selectAll();
    }
}

} // namespace camwright
