#include "app/window/newprojectdialog.h"

#include "core/family/family.h"
#include "editors/shell/icons.h"
#include "editors/shell/widgets.h"

#include <QComboBox>
#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QToolButton>
#include <QVBoxLayout>

namespace camwright {

Project emptyProject(const std::string& family, const std::string& model, const std::string& name)
{
    Project out = Project().withName(name);
    ControllerSettings controller;
    controller.family = family;
    controller.model = model;
    out = out.withContent(controllerKey(), controller);
    out = out.withContent({ObjectKind::Program, "Main"}, Program{});
    out = out.withContent({ObjectKind::VariableTable, "Globals"}, VariableTable{});
    out = out.withContent({ObjectKind::WatchTable, "Watch"}, WatchTable{});
    const Family* data = findFamily(family);
    const ControllerModel* found = data ? data->findModel(model) : nullptr;
    if (family == "kinco" && found && found->axesMax > 0)
        out = out.withContent({ObjectKind::Network, "CANopen"}, Network{});
    return out;
}

NewProjectDialog::NewProjectDialog(const QString& familyId, const QString& parentFolder, QWidget* parent) : QDialog(parent)
{
    setObjectName(QStringLiteral("newProjectDialog"));
    setWindowTitle(tr("New Project"));
    setMinimumWidth(520);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(20, 18, 20, 16);
    column->setSpacing(14);
    auto* form = new QFormLayout;
    form->setLabelAlignment(Qt::AlignLeft);
    form->setHorizontalSpacing(16);
    form->setVerticalSpacing(8);
    m_family = new QComboBox(this);
    describe(m_family, "newFamily", tr("Controller family"));
    for (const Family* family : families())
        m_family->addItem(QString::fromStdString(family->displayName()), QString::fromStdString(family->id()));
    m_family->setCurrentIndex(std::max(0, m_family->findData(familyId)));
    m_model = new QComboBox(this);
    describe(m_model, "newModel", tr("Model"));
    m_facts = new QLabel(this);
    m_facts->setProperty("tone", "caption");
    m_facts->setWordWrap(true);
    m_name = new QLineEdit(tr("machine"), this);
    describe(m_name, "newName", tr("Project name"), tr("Also the name of its folder."));
    m_folder = new QLineEdit(QDir::toNativeSeparators(parentFolder), this);
    describe(m_folder, "newFolder", tr("Folder"), tr("The project's own folder is made inside it."));
    auto* choose = new QToolButton(this);
    choose->setIcon(icon(QStringLiteral("open")));
    describe(choose, "newChooseFolder", tr("Choose a folder"));
    auto* folderRow = new QHBoxLayout;
    folderRow->addWidget(m_folder);
    folderRow->addWidget(choose);
    form->addRow(tr("Family"), m_family);
    form->addRow(tr("Model"), m_model);
    form->addRow(QString(), m_facts);
    form->addRow(tr("Name"), m_name);
    form->addRow(tr("In folder"), folderRow);
    for (QWidget* field : {static_cast<QWidget*>(m_family), static_cast<QWidget*>(m_model), static_cast<QWidget*>(m_name)})
        form->labelForField(field)->setMinimumHeight(Theme::FieldHeight);
    form->labelForField(folderRow)->setMinimumHeight(Theme::FieldHeight);
    column->addLayout(form);
    m_problem = new QLabel(this);
    m_problem->setProperty("tone", "error");
    m_problem->setWordWrap(true);
    column->addWidget(m_problem);
    column->addStretch();
    auto* buttons = new QHBoxLayout;
    buttons->addStretch();
    auto* cancel = new QPushButton(tr("Cancel"), this);
    describe(cancel, "newCancel", tr("Cancel"));
    m_create = new QPushButton(tr("Create Project"), this);
    describe(m_create, "newCreate", tr("Create project"));
    makePrimary(m_create);
    m_create->setDefault(true);
    buttons->addWidget(cancel);
    buttons->addWidget(m_create);
    column->addLayout(buttons);
    connect(m_family, &QComboBox::currentIndexChanged, this, &NewProjectDialog::fillModels);
    connect(m_model, &QComboBox::currentIndexChanged, this, &NewProjectDialog::refresh);
    connect(m_name, &QLineEdit::textChanged, this, &NewProjectDialog::refresh);
    connect(m_folder, &QLineEdit::textChanged, this, &NewProjectDialog::refresh);
    connect(choose, &QToolButton::clicked, this, [this] {
        const QString folder = QFileDialog::getExistingDirectory(this, tr("Folder for the New Project"), m_folder->text());
        if (!folder.isEmpty())
            m_folder->setText(QDir::toNativeSeparators(folder));
    });
    connect(cancel, &QPushButton::clicked, this, &QDialog::reject);
    connect(m_create, &QPushButton::clicked, this, &QDialog::accept);
    fillModels();
    m_name->setFocus();
    m_name->selectAll();
}

void NewProjectDialog::fillModels()
{
    m_model->clear();
    const Family* family = findFamily(m_family->currentData().toString().toStdString());
    if (!family)
        return;
    for (const ControllerModel& model : family->models()) {
        if (model.selectable)
            m_model->addItem(QString::fromStdString(model.name));
    }
    m_model->setCurrentText(QString::fromStdString(family->defaultModel().name));
    refresh();
}

void NewProjectDialog::refresh()
{
    const Family* family = findFamily(m_family->currentData().toString().toStdString());
    const ControllerModel* model = family ? family->findModel(m_model->currentText().toStdString()) : nullptr;
    if (model) {
        QStringList facts{tr("%1 inputs, %2 outputs").arg(model->digitalInputs).arg(model->digitalOutputs)};
        if (model->axesMax > 0)
            facts << tr("up to %n axes", nullptr, int(model->axesMax));
        if (model->canPorts > 0)
            facts << tr("%n CAN ports", nullptr, int(model->canPorts));
        if (model->ethernetPorts > 0)
            facts << tr("%n Ethernet ports", nullptr, int(model->ethernetPorts));
        m_facts->setText(facts.join(QStringLiteral(", ")));
    }
    QString problem;
    if (m_name->text().trimmed().isEmpty())
        problem = tr("The project needs a name.");
    else if (m_name->text().contains(QLatin1Char('/')) || m_name->text().startsWith(QLatin1Char('.')))
        problem = tr("The name becomes a folder's: it cannot hold \"/\" or begin with a dot.");
    else if (QFileInfo::exists(path()) && !QDir(path()).isEmpty())
        problem = tr("\"%1\" is already there. Choose another name or folder.").arg(path());
    m_problem->setText(problem);
    m_create->setEnabled(problem.isEmpty());
}

Project NewProjectDialog::project() const
{
    return emptyProject(m_family->currentData().toString().toStdString(), m_model->currentText().toStdString(), m_name->text().trimmed().toStdString());
}

QString NewProjectDialog::path() const
{
    return QDir(m_folder->text()).filePath(m_name->text().trimmed());
}

QString NewProjectDialog::parentFolder() const
{
    return m_folder->text();
}

} // namespace camwright
