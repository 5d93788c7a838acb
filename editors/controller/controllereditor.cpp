#include "editors/controller/controllereditor.h"

#include "core/checks/checkproject.h"
#include "core/family/family.h"
#include "editors/document/editcommands.h"
#include "editors/shell/context.h"
#include "editors/shell/quantityfield.h"
#include "editors/shell/theme.h"
#include "editors/shell/widgets.h"
#include "editors/words/words.h"

#include <QComboBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QTableWidget>
#include <QVBoxLayout>

namespace camwright {

namespace {

const Family* familyOf(const Project& project)
{
    return findFamily(project.controller().family);
}

void setRange(QuantitySpec& spec, const char* field)
{
    if (const auto range = fieldRange(ObjectKind::Controller, field)) {
        spec.minimum = range->low;
        spec.maximum = range->high;
    }
}

} // namespace

ControllerEditor::ControllerEditor(Context& context, ObjectKey key, QWidget* parent)
    : Editor(context, std::move(key), parent)
{
    auto* columns = new QHBoxLayout(this);
    columns->setContentsMargins(24, 16, 24, 16);
    columns->setSpacing(48);
    columns->addWidget(buildForm(), 0, Qt::AlignTop);
    columns->addWidget(buildLimits(), 1);
    connect(&context.document(), &ProjectDocument::changed, this, &ControllerEditor::documentChanged);
    connect(&context.document(), &ProjectDocument::diagnosticsChanged, this, &ControllerEditor::refreshProblems);
    refresh();
    refreshProblems();
}

QString ControllerEditor::title() const
{
    return tr("Controller");
}

QWidget* ControllerEditor::buildForm()
{
    auto* page = new QWidget(this);
    m_family = new QLabel(page);
    m_family->setObjectName(QStringLiteral("controllerFamily"));
    m_model = new QComboBox(page);
    describe(m_model, "controllerModel", tr("Model"), tr("The controller this project is for; its limits apply at once"));
    m_model->setFixedWidth(200);
    m_modelProblem = new QLabel(page);
    m_modelProblem->setStyleSheet(QStringLiteral("color: %1").arg(theme().name(Role::Error)));
    m_modelProblem->setWordWrap(true);
    m_modelProblem->hide();
    connect(m_model, &QComboBox::activated, this, [this](int index) {
        editObject<ControllerSettings>(context().document(), key(), tr("Change the controller's model"), "model",
            [&](ControllerSettings& settings) { settings.model = m_model->itemText(index).toStdString(); });
    });

    QuantitySpec scan;
    scan.name = tr("Scan period");
    scan.unit = tr("µs");
    scan.integer = true;
    scan.defaultValue = 0;
    scan.help = tr("0: the program runs as fast as it can. Else every scan begins this long after the one before.");
    setRange(scan, "scan_period_us");
    m_scanPeriod = new QuantityField(scan, page);
    m_scanPeriod->setObjectName(QStringLiteral("scan_period_us"));
    m_scanPeriod->setFieldWidth(150);
    connect(m_scanPeriod, &QuantityField::edited, this, [this] {
        editObject<ControllerSettings>(context().document(), key(), tr("Change the scan period"), "scan_period_us",
            [&](ControllerSettings& settings) { settings.scanPeriodUs = m_scanPeriod->integerField(); });
    });
    QuantitySpec watchdog;
    watchdog.name = tr("Watchdog");
    watchdog.unit = tr("ms");
    watchdog.integer = true;
    watchdog.defaultValue = 500;
    watchdog.help = tr("A scan that takes longer stops the axes and the program.");
    setRange(watchdog, "watchdog_ms");
    m_watchdog = new QuantityField(watchdog, page);
    m_watchdog->setObjectName(QStringLiteral("watchdog_ms"));
    m_watchdog->setFieldWidth(150);
    connect(m_watchdog, &QuantityField::edited, this, [this] {
        editObject<ControllerSettings>(context().document(), key(), tr("Change the watchdog"), "watchdog_ms",
            [&](ControllerSettings& settings) { settings.watchdogMs = m_watchdog->integerField(); });
    });

    auto* model = new QVBoxLayout;
    model->setContentsMargins(12, 0, 0, 0);
    model->addWidget(m_model);
    model->addWidget(m_modelProblem);
    auto* family = new QHBoxLayout;
    family->setContentsMargins(12, 0, 0, 0);
    family->addWidget(m_family);
    auto* rows = new QFormLayout;
    rows->setHorizontalSpacing(20);
    rows->setVerticalSpacing(Theme::RowGap);
    rows->setFieldGrowthPolicy(QFormLayout::FieldsStayAtSizeHint);
    rows->addRow(tr("Family"), family);
    rows->addRow(tr("Model"), model);
    rows->addRow(tr("Scan period"), m_scanPeriod);
    rows->addRow(tr("Watchdog"), m_watchdog);
    auto* layout = new QVBoxLayout(page);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(Theme::RowGap);
    layout->addWidget(new SectionHeader(tr("Controller"), {}, page));
    layout->addLayout(rows);
    layout->addWidget(buildStrictRow(page));
    return page;
}

/// A row of its own: it is absent for families that have no such rule.
QWidget* ControllerEditor::buildStrictRow(QWidget* page)
{
    m_strictRow = new QWidget(page);
    m_strict = new Switch(tr("Strict Kinco"), m_strictRow);
    describe(m_strict, "strict_kinco", tr("Strict Kinco"),
        tr("Programs may hold only what KincoBuilder is known to take: nested branches, AND( and OR(, are refused, and a quick fix writes them to marker bits."));
    connect(m_strict, &QAbstractButton::clicked, this, [this](bool on) {
        editObject<ControllerSettings>(context().document(), key(), on ? tr("Make programs strict Kinco") : tr("Allow nested branches"), "strict_kinco",
            [&](ControllerSettings& settings) { settings.strictKinco = on; });
    });
    auto* words = new QLabel(tr("Strict Kinco: no nested branches, AND( and OR("), m_strictRow);
    words->setBuddy(m_strict);
    m_strictProblem = new QLabel(m_strictRow);
    m_strictProblem->setStyleSheet(QStringLiteral("color: %1").arg(theme().name(Role::Error)));
    m_strictProblem->setWordWrap(true);
    m_strictProblem->hide();
    auto* line = new QHBoxLayout;
    line->setSpacing(Theme::RowGap);
    line->addWidget(m_strict);
    line->addWidget(words, 1);
    auto* column = new QVBoxLayout(m_strictRow);
    column->setContentsMargins(0, Theme::RowGap, 0, 0);
    column->addLayout(line);
    column->addWidget(m_strictProblem);
    return m_strictRow;
}

QWidget* ControllerEditor::buildLimits()
{
    auto* page = new QWidget(this);
    m_limits = new QTableWidget(0, 2, page);
    describe(m_limits, "controllerLimits", tr("What the model offers"), tr("Limits that checks and builds apply"));
    m_limits->horizontalHeader()->hide();
    m_limits->verticalHeader()->hide();
    m_limits->verticalHeader()->setDefaultSectionSize(Theme::TableRow);
    m_limits->horizontalHeader()->setStretchLastSection(true);
    m_limits->setColumnWidth(0, 260);
    m_limits->setShowGrid(false);
    m_limits->setEditTriggers(QAbstractItemView::NoEditTriggers);
    m_limits->setSelectionMode(QAbstractItemView::NoSelection);
    auto* layout = new QVBoxLayout(page);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(new SectionHeader(tr("What the Model Offers"), {}, page));
    layout->addWidget(m_limits, 1);
    return page;
}

void ControllerEditor::documentChanged(const ProjectChange& change)
{
    if (change.touches(key()))
        refresh();
}

void ControllerEditor::refresh()
{
    const auto* settings = context().document().content<ControllerSettings>(key());
    if (!settings)
        return;
    const Family* family = familyOf(context().document().project());
    m_family->setText(family ? QString::fromStdString(family->displayName()) : QString::fromStdString(settings->family));
    m_model->clear();
    if (family) {
        for (const ControllerModel& model : family->models()) {
            if (model.selectable)
                m_model->addItem(QString::fromStdString(model.name));
        }
    }
    const int index = m_model->findText(QString::fromStdString(settings->model));
    if (index < 0)
        m_model->addItem(QString::fromStdString(settings->model));
    m_model->setCurrentIndex(index < 0 ? m_model->count() - 1 : index);
    m_scanPeriod->setField(settings->scanPeriodUs);
    m_watchdog->setField(settings->watchdogMs);
    m_strictRow->setVisible(settings->family == "kinco");
    m_strict->setChecked(settings->strictKinco.valueOr(false));
    refreshLimits(*settings);
}

void ControllerEditor::refreshLimits(const ControllerSettings& settings)
{
    const Family* family = familyOf(context().document().project());
    const ControllerModel* model = family ? family->findModel(settings.model) : nullptr;
    m_limits->setRowCount(0);
    if (!model)
        return;
    const std::pair<QString, unsigned> rows[] = {{tr("Digital inputs on the unit"), model->digitalInputs}, {tr("Digital outputs on the unit"), model->digitalOutputs},
        {tr("Axes on the motion network"), model->axesMax}, {tr("Motion instructions"), model->motionInstructionsMax},
        {tr("Program size, instructions"), model->programInstructionsMax}, {tr("Ethernet ports"), model->ethernetPorts}, {tr("CAN ports"), model->canPorts},
        {tr("Pulse outputs (not simulated yet)"), model->pulseOutputs}, {tr("Expansion modules"), model->expansionModulesMax}};
    for (const auto& [label, value] : rows) {
        const int row = m_limits->rowCount();
        m_limits->insertRow(row);
        m_limits->setItem(row, 0, new QTableWidgetItem(label));
        auto* number = new QTableWidgetItem(value == 0 ? tr("none") : QString::number(value));
        number->setFont(theme().monoFont());
        m_limits->setItem(row, 1, number);
    }
    for (const MemoryArea& area : family->areas()) {
        const AreaLayout& layout = model->area(area.id);
        if (layout.bytes == 0)
            continue;
        const int row = m_limits->rowCount();
        m_limits->insertRow(row);
        m_limits->setItem(row, 0, new QTableWidgetItem(tr("Memory %1").arg(QString::fromStdString(area.name))));
        const unsigned elements = area.isPacked() ? layout.bytes * 8 : layout.bytes / area.elementBytes;
        auto* size = new QTableWidgetItem(area.elementBytes > 1 || area.kind == AreaKind::Bits || area.isPacked()
            ? tr("%1 elements").arg(elements) : tr("%1 bytes").arg(layout.bytes));
        size->setFont(theme().monoFont());
        m_limits->setItem(row, 1, size);
    }
}

void ControllerEditor::refreshProblems()
{
    QString model, scan, watchdog, strict;
    for (const Diagnostic& d : context().document().diagnosticsOf(key())) {
        const QString sentence = words::sentence(d);
        if (d.place.field == "scan_period_us")
            scan = sentence;
        else if (d.place.field == "watchdog_ms")
            watchdog = sentence;
        else if (d.place.field == "strict_kinco")
            strict = sentence;
        else if (model.isEmpty()) // the first says it; the others stand in the list of problems
            model = sentence;
    }
    m_modelProblem->setText(model);
    m_modelProblem->setVisible(!model.isEmpty());
    m_scanPeriod->setProblem(scan);
    m_watchdog->setProblem(watchdog);
    m_strictProblem->setText(strict);
    m_strictProblem->setVisible(!strict.isEmpty());
}

void ControllerEditor::reveal(const Place& place)
{
    if (place.field == "scan_period_us")
        m_scanPeriod->lineEdit()->setFocus(Qt::OtherFocusReason);
    else if (place.field == "watchdog_ms")
        m_watchdog->lineEdit()->setFocus(Qt::OtherFocusReason);
    else if (place.field == "strict_kinco")
        m_strict->setFocus(Qt::OtherFocusReason);
    else
        m_model->setFocus(Qt::OtherFocusReason);
}

} // namespace camwright
