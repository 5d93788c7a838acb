// Opening, saving and closing projects, and the questions that come with it.
#include "app/window/mainwindow.h"

#include "app/window/newprojectdialog.h"
#include "app/window/startpage.h"
#include "editors/words/shipped.h"
#include "editors/words/words.h"

#include <QApplication>
#include <QDir>
#include <QDirIterator>
#include <QFileDialog>
#include <QMessageBox>
#include <QPushButton>
#include <QStandardPaths>

namespace camwright {

namespace {

/// A question whose buttons are verbs. Gives the index of the chosen one; the last is what Escape means.
int ask(QWidget* parent, const QString& title, const QString& question, const QString& detail, const QStringList& answers)
{
    QMessageBox box(parent);
    box.setObjectName(QStringLiteral("question"));
    box.setWindowTitle(title);
    box.setIcon(QMessageBox::NoIcon);
    box.setText(QStringLiteral("<b>%1</b>").arg(question.toHtmlEscaped()));
    box.setInformativeText(detail);
    QList<QPushButton*> buttons;
    for (const QString& answer : answers)
        buttons << box.addButton(answer, answer == answers.last() ? QMessageBox::RejectRole : QMessageBox::AcceptRole);
    buttons.first()->setProperty("primary", true);
    box.setDefaultButton(buttons.first());
    box.setEscapeButton(buttons.last());
    box.exec();
    return int(buttons.indexOf(qobject_cast<QPushButton*>(box.clickedButton())));
}

bool copyFolder(const QString& from, const QString& to)
{
    if (!QDir().mkpath(to))
        return false;
    QDirIterator it(from, QDir::AllEntries | QDir::NoDotAndDotDot, QDirIterator::Subdirectories);
    while (it.hasNext()) {
        const QFileInfo entry(it.next());
        const QString target = QDir(to).filePath(QDir(from).relativeFilePath(entry.filePath()));
        if (entry.isDir() ? !QDir().mkpath(target) : !QFile::copy(entry.filePath(), target))
            return false;
        if (entry.isFile())
            QFile::setPermissions(target, QFile::permissions(target) | QFile::WriteOwner);
    }
    return true;
}

} // namespace

void MainWindow::connectFileActions()
{
    ActionCatalogue& actions = m_workspace.actions;
    const auto on = [&](const char* id, auto function) { actions.on(QString::fromLatin1(id), this, function); };
    on("file.new", [this] { newProject({}); });
    on("file.open", [this] { chooseProject(); });
    on("file.demo", [this] { openDemo(); });
    on("file.save", [this] { saveProject(); });
    on("file.saveAs", [this] { saveProjectAs(); });
    on("file.close", [this] { closeProject(); });
    on("file.quit", [this] { close(); });
    on("file.reload", [this] {
        if (const auto done = m_workspace.document.reload(); !done)
            tell(tr("The project was not reloaded."), done.error());
    });
    ProjectDocument& document = m_workspace.document;
    connect(&document, &ProjectDocument::changedOutside, this, &MainWindow::outsideChanged, Qt::QueuedConnection);
    connect(&document, &ProjectDocument::journalFailed, this, [this](const Diagnostic& why) {
        m_workspace.context.notify(Severity::Warning, tr("Edits are kept in memory only until you save. %1").arg(words::sentence(why)));
    });
}

void MainWindow::tell(const QString& sentence, const Diagnostics& reasons)
{
    QStringList lines;
    for (const Diagnostic& reason : reasons) {
        const QString where = reason.place.file.empty() ? words::placeText(reason.place)
            : reason.place.range.isValid()              ? QStringLiteral("%1:%2").arg(QString::fromStdString(reason.place.file)).arg(reason.place.range.line)
                                                        : QString::fromStdString(reason.place.file);
        lines << (where.isEmpty() ? QString() : where + QStringLiteral(": ")) + words::sentence(reason) + QStringLiteral(" (%1)").arg(words::codeId(reason.code));
    }
    for (const QString& line : lines)
        m_workspace.context.output(line);
    QMessageBox box(this);
    box.setWindowTitle(QStringLiteral("Camwright"));
    box.setText(QStringLiteral("<b>%1</b>").arg(sentence.toHtmlEscaped()));
    box.setInformativeText(lines.mid(0, 8).join(QStringLiteral("\n\n")));
    box.exec();
}

bool MainWindow::openProject(const QString& path)
{
    if (!mayCloseProject())
        return false;
    m_workspace.rememberProject();
    saveLayout();
    if (!m_editors->closeAll())
        return false;
    if (const auto opened = m_workspace.document.open(path); !opened) {
        tell(tr("\"%1\" was not opened.").arg(QDir::toNativeSeparators(path)), opened.error());
        return false;
    }
    m_workspace.rememberProject();
    for (const Diagnostic& note : m_workspace.document.openingNotes())
        m_workspace.context.notify(note);
    if (m_workspace.document.isReadOnly())
        m_workspace.context.notify(Severity::Warning, tr("Another Camwright works on this project. Edits here can be saved only under another name."));
    const auto programs = m_workspace.document.project().objects(ObjectKind::Program);
    if (!restoreEditors(EditorArea::Missing::Open) && !programs.empty())
        m_workspace.context.open(programs.front()->key);
    offerRecovery();
    return true;
}

void MainWindow::offerRecovery()
{
    ProjectDocument& document = m_workspace.document;
    if (!document.hasRecovery())
        return;
    const int answer = ask(this, tr("Unsaved Edits"), tr("Camwright ended without saving this project."),
        tr("The edits are kept: %n steps.", nullptr, document.recoveredSteps()) + QLatin1Char(' ')
            + tr("Restoring them is one step that can be undone; the files stay as they are until you save."),
        {tr("Restore the Edits"), tr("Discard Them")});
    if (answer == 0)
        document.acceptRecovery();
    else
        document.dropRecovery();
}

void MainWindow::outsideChanged(const QStringList& files)
{
    if (m_askingOutside)
        return;
    m_askingOutside = true;
    ProjectDocument& document = m_workspace.document;
    const QString detail = files.mid(0, 6).join(QStringLiteral(", "))
        + (document.isModified() ? QLatin1Char('\n') + tr("Reloading replaces your unsaved edits; Ctrl+Z brings them back.") : QString());
    const int answer = ask(this, tr("Changed Outside"), tr("Another program changed files of this project."), detail, {tr("Reload"), tr("Keep Mine")});
    m_askingOutside = false;
    if (answer != 0) {
        document.keepMine();
        return;
    }
    if (const auto done = document.reload(); !done)
        tell(tr("The project was not reloaded."), done.error());
}

bool MainWindow::saveProject()
{
    ProjectDocument& document = m_workspace.document;
    if (document.isReadOnly()) {
        saveProjectAs();
        return !document.isModified();
    }
    Result<void> saved = document.save();
    if (!saved && saved.error().code == Code::ChangedOutside) {
        const int answer = ask(this, tr("Changed Outside"), words::sentence(saved.error()), tr("Saving now replaces what the other program wrote."),
            {tr("Overwrite the File"), tr("Keep It")});
        if (answer != 0)
            return false;
        saved = document.save(SaveOver::Allow);
    }
    if (!saved) {
        tell(tr("The project was not saved."), {saved.error()});
        return false;
    }
    m_workspace.rememberProject();
    return true;
}

void MainWindow::saveProjectAs()
{
    ProjectDocument& document = m_workspace.document;
    const QString start = QDir(m_workspace.settings.projectsFolder()).filePath(document.displayName());
    const QString path = QFileDialog::getSaveFileName(this, tr("Save Project As"), start, tr("Project folder (*)"));
    if (path.isEmpty())
        return;
    if (const auto saved = document.saveAs(path); !saved)
        tell(tr("The project was not saved."), {saved.error()});
    else
        m_workspace.rememberProject();
}

bool MainWindow::mayCloseProject()
{
    ProjectDocument& document = m_workspace.document;
    if (!document.isModified())
        return true;
    const int answer = ask(this, tr("Unsaved Edits"), tr("\"%1\" has edits that are not saved.").arg(document.displayName()),
        tr("Discarding them cannot be undone."), {tr("Save"), tr("Discard the Edits"), tr("Go On Working")});
    if (answer == 0)
        return saveProject();
    return answer == 1;
}

void MainWindow::newProject(const QString& familyId)
{
    NewProjectDialog dialog(familyId, m_workspace.settings.projectsFolder(), this);
    if (dialog.exec() != QDialog::Accepted || !mayCloseProject())
        return;
    m_workspace.settings.setProjectsFolder(dialog.parentFolder());
    m_workspace.rememberProject();
    saveLayout();
    if (const auto made = m_workspace.document.create(dialog.project(), dialog.path()); !made) {
        tell(tr("The project was not created."), made.error());
        return;
    }
    m_workspace.rememberProject();
    m_workspace.context.open({ObjectKind::Program, "Main"});
}

void MainWindow::chooseProject()
{
    const QString path = QFileDialog::getExistingDirectory(this, tr("Open Project Folder"), m_workspace.settings.projectsFolder());
    if (!path.isEmpty())
        openProject(path);
}

void MainWindow::closeProject()
{
    if (!mayCloseProject())
        return;
    saveLayout();
    if (!m_editors->closeAll())
        return;
    m_workspace.rememberProject();
    m_workspace.document.close();
}

void MainWindow::openDemo()
{
    const QString data = QStandardPaths::writableLocation(QStandardPaths::GenericDataLocation) + QStringLiteral("/camwright/demo/kinco-feeder");
    if (!QFileInfo::exists(data + QStringLiteral("/project.toml"))) {
        const QString shipped = sharedPath(QStringLiteral("examples/kinco-feeder"));
        if (shipped.isEmpty() || !copyFolder(shipped, data)) {
            tell(tr("The demo machine could not be copied to \"%1\".").arg(QDir::toNativeSeparators(data)), {});
            return;
        }
    }
    if (openProject(data))
        goOnline(QStringLiteral("local"));
}

} // namespace camwright
