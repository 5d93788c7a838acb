#include "editors/axis/axiseditor.h"

#include "core/checks/checkproject.h"
#include "core/model/fieldlist.h"
#include "editors/axis/transmissionview.h"
#include "editors/document/editcommands.h"
#include "editors/shell/axisform.h"
#include "editors/shell/context.h"
#include "editors/shell/quantityfield.h"
#include "editors/shell/theme.h"
#include "editors/shell/widgets.h"
#include "editors/words/words.h"

#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QScrollArea>
#include <QVBoxLayout>

namespace camwright {

namespace {

constexpr double DefaultMotorSpeed = 3000; // turns per minute, what the results are shown for at first

QString number(double value)
{
    return QString::number(value, 'f', 3);
}

} // namespace

AxisEditor::AxisEditor(Context& context, ObjectKey key, QWidget* parent)
    : Editor(context, std::move(key), parent), m_title(new QLabel(this)), m_subtitle(new QLabel(this)), m_drawing(new TransmissionView(this)), m_form(new AxisForm(this))
{
    m_title->setFont(theme().titleFont());
    m_title->setObjectName(QStringLiteral("axisTitle"));
    m_subtitle->setObjectName(QStringLiteral("axisSubtitle"));
    auto* head = new QHBoxLayout;
    head->addWidget(m_title);
    head->addWidget(m_subtitle);
    head->addStretch();

    auto* columns = new QHBoxLayout;
    columns->setSpacing(40);
    columns->addWidget(m_form, 0, Qt::AlignTop);
    columns->addWidget(buildResults(), 1, Qt::AlignTop);

    auto* page = new QWidget;
    auto* layout = new QVBoxLayout(page);
    layout->setContentsMargins(24, 16, 24, 24);
    layout->setSpacing(16);
    layout->addLayout(head);
    layout->addWidget(m_drawing);
    layout->addLayout(columns);
    layout->addWidget(buildSimulation());
    layout->addStretch();
    auto* scroll = new QScrollArea(this);
    scroll->setWidgetResizable(true);
    scroll->setFrameShape(QFrame::NoFrame);
    scroll->setWidget(page);
    auto* outer = new QVBoxLayout(this);
    outer->setContentsMargins(0, 0, 0, 0);
    outer->addWidget(scroll);

    connect(m_form, &AxisForm::edited, this, &AxisEditor::changeField);
    connect(m_form, &AxisForm::nameEdited, this, &AxisEditor::rename);
    connect(&context.document(), &ProjectDocument::changed, this, &AxisEditor::documentChanged);
    connect(&context.document(), &ProjectDocument::diagnosticsChanged, this, &AxisEditor::refreshProblems);
    refresh();
    refreshProblems();
}

QString AxisEditor::iconName() const
{
    const Axis* axis = context().document().content<Axis>(key());
    return axis && axis->type.valueOr(AxisType::Linear) == AxisType::Rotary ? QStringLiteral("axis-rotary") : QStringLiteral("axis-linear");
}

void AxisEditor::setKey(const ObjectKey& key)
{
    Editor::setKey(key);
    refresh();
    refreshProblems();
}

QWidget* AxisEditor::buildResults()
{
    auto* panel = new QFrame(this);
    panel->setObjectName(QStringLiteral("results"));
    auto* layout = new QVBoxLayout(panel);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(new SectionHeader(tr("Results"), tr("What these values mean at the machine"), panel));
    auto* rows = new QFormLayout;
    rows->setHorizontalSpacing(24);
    rows->setVerticalSpacing(6);
    QuantitySpec speed;
    speed.name = tr("Motor speed");
    speed.unit = tr("rpm");
    speed.minimum = 0;
    speed.maximum = 100000;
    speed.help = tr("Motor speed the results below are shown for.");
    m_speed = new QuantityField(speed, panel);
    m_speed->setObjectName(QStringLiteral("resultSpeed"));
    m_speed->setFieldWidth(110);
    m_speed->setValue(DefaultMotorSpeed);
    connect(m_speed, &QuantityField::edited, this, &AxisEditor::refresh);
    rows->addRow(tr("At motor speed"), m_speed);
    for (const QString& label : {tr("Resolution"), tr("Speed of the load"), tr("The same a minute"), tr("Speed for the drive"), tr("32-bit position range")}) {
        auto* value = new QLabel(panel);
        value->setFont(theme().monoFont());
        value->setTextInteractionFlags(Qt::TextSelectableByMouse);
        rows->addRow(label, value);
        m_results.push_back(value);
    }
    layout->addLayout(rows);
    return panel;
}

QWidget* AxisEditor::buildSimulation()
{
    auto* panel = new QWidget(this);
    auto* layout = new QVBoxLayout(panel);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(new SectionHeader(tr("Simulated Machine"), tr("Used by the virtual controller only; nothing of it reaches a real machine"), panel));
    auto* rows = new QFormLayout;
    rows->setHorizontalSpacing(20);
    rows->setVerticalSpacing(Theme::RowGap);
    rows->setFieldGrowthPolicy(QFormLayout::FieldsStayAtSizeHint);
    const struct { const char* field; QString label, help; } Fields[] = {
        {"simulation.start_position", tr("Start position"), tr("Where the load stands when the controller is switched on.")},
        {"simulation.home_switch", tr("Home switch"), tr("Position at which the home switch acts.")},
        {"simulation.lower_limit_switch", tr("Lower limit switch"), tr("Position of the limit switch on the negative side.")},
        {"simulation.upper_limit_switch", tr("Upper limit switch"), tr("Position of the limit switch on the positive side.")},
        {"simulation.inertia_ratio", tr("Inertia ratio"), tr("Inertia of the load over that of the motor; a larger one lags more.")}};
    const AxisSimulation standard;
    const double defaults[] = {standard.startPosition.value(), standard.homeSwitch.value(), standard.lowerLimitSwitch.value(), standard.upperLimitSwitch.value(), standard.inertiaRatio.value()};
    for (std::size_t i = 0; i < std::size(Fields); ++i) {
        QuantitySpec spec;
        spec.name = Fields[i].label;
        spec.help = Fields[i].help;
        spec.defaultValue = defaults[i];
        if (const auto range = fieldRange(ObjectKind::Axis, Fields[i].field)) {
            spec.minimum = range->low;
            spec.maximum = range->high;
        }
        auto* edit = new QuantityField(spec, panel);
        edit->setObjectName(QString::fromLatin1(Fields[i].field));
        edit->setFieldWidth(150);
        rows->addRow(Fields[i].label, edit);
        m_simulation[Fields[i].field] = edit;
        connect(edit, &QuantityField::edited, this, [this, edit, field = std::string(Fields[i].field)] {
            const Axis* axis = context().document().content<Axis>(key());
            if (!axis)
                return;
            Axis changed = *axis;
            visitFields(changed, [&](std::string_view name, auto& member) {
                if constexpr (std::is_same_v<std::remove_cvref_t<decltype(member)>, Field<double>>) {
                    if (name == field)
                        member = edit->realField();
                }
            });
            changeField(field, changed);
        });
    }
    layout->addLayout(rows);
    return panel;
}

void AxisEditor::changeField(const std::string& field, const Axis& axis)
{
    editObject<Axis>(context().document(), key(), tr("Change axis %1").arg(QString::fromStdString(key().name)), field, [&](Axis& target) { target = axis; });
}

void AxisEditor::rename(const QString& name)
{
    if (const auto renamed = renameObject(context().document(), key(), name.trimmed().toStdString()); !renamed) {
        context().notify(renamed.error());
        refresh();
    }
}

void AxisEditor::documentChanged(const ProjectChange& change)
{
    if (change.touches(key()))
        refresh();
}

void AxisEditor::refresh()
{
    const Axis* axis = context().document().content<Axis>(key());
    if (!axis)
        return;
    const bool rotary = axis->type.valueOr(AxisType::Linear) == AxisType::Rotary;
    m_title->setText(QString::fromStdString(key().name));
    m_subtitle->setText(rotary ? tr("Rotary axis, CANopen address %1").arg(axis->number.valueOr(0)) : tr("Linear axis, CANopen address %1").arg(axis->number.valueOr(0)));
    m_form->setAxis(key().name, *axis);
    m_drawing->setAxis(*axis);
    visitFields(*axis, [&](std::string_view name, const auto& member) {
        if constexpr (std::is_same_v<std::remove_cvref_t<decltype(member)>, Field<double>>) {
            if (const auto found = m_simulation.find(std::string(name)); found != m_simulation.end())
                found->second->setField(member);
        }
    });
    for (auto& [field, edit] : m_simulation) {
        if (field == "simulation.inertia_ratio")
            continue;
        QuantitySpec spec = edit->spec();
        spec.unit = rotary ? tr("°") : tr("mm");
        spec.perTurn = axis->mechanicalEquivalent.valueOr(0);
        if (spec.unit != edit->spec().unit || spec.perTurn != edit->spec().perTurn)
            edit->setSpec(spec);
    }
    refreshResults(*axis);
    emit titleChanged();
}

void AxisEditor::refreshResults(const Axis& axis)
{
    const bool legal = axis.encoderResolution.isValid() && axis.encoderResolution.value() > 0 && axis.mechanicalEquivalent.isValid() && axis.mechanicalEquivalent.value() > 0;
    if (!legal) {
        for (QLabel* label : m_results)
            label->setText(QStringLiteral("–"));
        return;
    }
    const QString unit = axis.type.valueOr(AxisType::Linear) == AxisType::Rotary ? tr("°") : tr("mm");
    const double pulses = static_cast<double>(axis.encoderResolution.value()), travel = axis.mechanicalEquivalent.value();
    const double turnsPerSecond = m_speed->valueOr(DefaultMotorSpeed) / 60;
    m_results[0]->setText(tr("%1 %2 per pulse").arg(QString::number(travel / pulses, 'g', 6), unit));
    m_results[1]->setText(tr("%1 %2/s").arg(number(turnsPerSecond * travel), unit));
    m_results[2]->setText(tr("%1 %2/min").arg(number(turnsPerSecond * travel * 60), unit));
    m_results[3]->setText(tr("%1 pulses/s").arg(number(turnsPerSecond * pulses)));
    m_results[4]->setText(tr("±%1 %2").arg(number(2147483648.0 / pulses * travel), unit));
}

void AxisEditor::refreshProblems()
{
    const Diagnostics problems = context().document().diagnosticsOf(key());
    m_form->setProblems(key(), problems);
    for (auto& [field, edit] : m_simulation) {
        const auto found = std::ranges::find(problems, field, [](const Diagnostic& d) { return d.place.field; });
        edit->setProblem(found != problems.end() ? words::sentence(*found) : QString());
    }
}

void AxisEditor::reveal(const Place& place)
{
    if (const auto found = m_simulation.find(place.field); found != m_simulation.end()) {
        found->second->lineEdit()->setFocus(Qt::OtherFocusReason);
        return;
    }
    m_form->focusField(place.field);
}

} // namespace camwright
