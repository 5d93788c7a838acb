// Menus of the main window, and what its actions do inside the window.
#include "app/window/badgetabbar.h"
#include "app/window/docviewer.h"
#include "app/window/mainwindow.h"
#include "app/window/palette.h"
#include "app/window/panelstack.h"
#include "app/window/settingsdialog.h"
#include "editors/shell/icons.h"
#include "editors/shell/problemsview.h"
#include "editors/words/shipped.h"
#include "editors/words/words.h"

#include <QApplication>
#include <QLabel>
#include <QMenuBar>
#include <QMessageBox>
#include <QSplitter>
#include <QUndoStack>

namespace camwright {

void MainWindow::buildMenus()
{
    ActionCatalogue& actions = m_workspace.actions;
    const auto menu = [&](const QString& title, std::initializer_list<const char*> ids) {
        QMenu* made = menuBar()->addMenu(title);
        connect(made, &QMenu::aboutToShow, this, &MainWindow::refreshActions); // the selection in a list may have changed since
        for (const char* id : ids) {
            if (!*id)
                made->addSeparator();
            else if (QAction* action = actions.action(QString::fromLatin1(id)))
                made->addAction(action);
        }
        return made;
    };
    menu(tr("&File"), {"file.new", "file.open", "file.demo", "", "file.save", "file.saveAs", "file.reload", "file.close", "", "file.settings", "", "file.quit"});
    menu(tr("&Edit"), {"edit.undo", "edit.redo", "", "edit.cut", "edit.copy", "edit.paste", "edit.delete", "edit.duplicate", "edit.selectAll", "", "edit.rename", "",
                          "edit.find", "edit.replace", "edit.quickFix"});
    QMenu* view = menu(tr("&View"), {"view.configure", "view.program", "view.commission", "view.analyse", "view.resetLayout", "", "view.left", "view.right", "view.bottom", "",
                                        "view.splitRight", "view.splitDown", "view.moveTab", "view.ownWindow", "view.unite", "", "view.tabLeft", "view.tabRight", "view.closeTab", "",
                                        "view.dark", ""});
    for (const PanelFactory& factory : m_workspace.registry.panels()) {
        if (factory.area == PanelArea::Left)
            continue;
        view->addAction(icon(factory.iconName), factory.name, this, [this, id = factory.id] {
            if (m_workspace.document.isOpen())
                showPanel(id);
        });
    }
    menu(tr("&Go"), {"go.anything", "go.action", "", "go.back", "go.forward", "", "go.nextTab", "go.previousTab", "go.nextGroup", "go.previousGroup", "", "go.definition", "go.references", "", "go.nextProblem", "go.previousProblem"});
    menu(tr("&Project"), {"project.check", "project.build"});
    menu(tr("&Controller"), {"online.connect", "online.disconnect", "", "online.download", "online.run", "online.stop", "", "online.releaseForces", "online.stopAxes"});
    menu(tr("&Help"), {"help.docs", "help.explain", "", "help.about"});

    menuBar()->setFixedHeight(27);
    auto* name = new QLabel(QStringLiteral("Camwright"));
    name->setFont(theme().boldFont());
    name->setContentsMargins(12, 0, 8, 1);
    name->setFixedHeight(26);
    menuBar()->setCornerWidget(name, Qt::TopLeftCorner);
    m_presets = new BadgeTabBar;
    m_presets->setObjectName(QStringLiteral("presets"));
    m_presets->setAccessibleName(tr("Layouts"));
    m_presets->setFixedHeight(26);
    for (const QString& preset : {tr("Configure"), tr("Program"), tr("Commission"), tr("Analyse")})
        m_presets->addTab(preset);
    const auto keyTips = [this, &actions] {
        const char* presets[] = {"view.configure", "view.program", "view.commission", "view.analyse"};
        for (int i = 0; i < m_presets->count(); ++i)
            m_presets->setTabToolTip(i, actions.action(QString::fromLatin1(presets[i]))->toolTip());
    };
    keyTips();
    connect(&actions, &ActionCatalogue::keysChanged, m_presets, keyTips);
    menuBar()->setCornerWidget(m_presets, Qt::TopRightCorner);
    connect(m_presets, &QTabBar::tabBarClicked, this, [this](int index) {
        if (index >= 0)
            setLayoutPreset(Layout(index));
    });
}

void MainWindow::connectActions()
{
    ActionCatalogue& actions = m_workspace.actions;
    ProjectDocument& document = m_workspace.document;
    const auto on = [&](const char* id, auto function) { actions.on(QString::fromLatin1(id), this, function); };
    on("edit.undo", [&document] { document.undo(); });
    on("edit.redo", [&document] { document.redo(); });
    for (const ActionRow& row : actions.rows()) {
        if (!(row.availability & Availability::Editor))
            continue;
        actions.on(QString::fromLatin1(row.id), this, [this, id = QString::fromLatin1(row.id)] { editAction(id); });
    }
    const char* presets[] = {"view.configure", "view.program", "view.commission", "view.analyse"};
    for (int i = 0; i < 4; ++i)
        on(presets[i], [this, i] { setLayoutPreset(Layout(i)); });
    on("view.resetLayout", [this] {
        m_workspace.settings.forgetLayouts();
        m_editors->unite();
        setDefaultLayout(m_layout);
        showPresetView(m_layout);
        refreshActions();
    });
    on("view.left", [this](bool show) { m_left->setVisible(show); });
    on("view.right", [this](bool show) { m_right->setVisible(show && !m_right->isEmpty()); });
    on("view.bottom", [this](bool show) { m_bottom->setVisible(show); });
    on("view.closeTab", [this] { m_editors->closeCurrent(); });
    on("view.dark", [this](bool dark) { setDark(dark); });
    on("view.splitRight", [this] { m_editors->split(Side::Right); });
    on("view.splitDown", [this] { m_editors->split(Side::Below); });
    on("view.moveTab", [this] { m_editors->moveToNextGroup(); });
    on("view.ownWindow", [this] { m_editors->toggleOwnWindow(); });
    on("view.unite", [this] { m_editors->unite(); });
    on("view.tabLeft", [this] { m_editors->moveCurrentTab(-1); });
    on("view.tabRight", [this] { m_editors->moveCurrentTab(1); });
    on("go.nextTab", [this] { m_editors->stepTab(1); });
    on("go.previousTab", [this] { m_editors->stepTab(-1); });
    on("go.nextGroup", [this] { m_editors->stepGroup(1); });
    on("go.previousGroup", [this] { m_editors->stepGroup(-1); });
    on("go.back", [this] { m_editors->goBack(); });
    on("go.forward", [this] { m_editors->goForward(); });
    on("go.anything", [this] {
        auto* palette = new Palette(tr("Find Anything"), tr("Name of an object or variable"), findableObjects(m_workspace.context), frontWindow());
        palette->show();
    });
    on("go.action", [this] {
        refreshActions();
        auto* palette = new Palette(tr("Find Action"), tr("Name of an action"), findableActions(m_workspace.context), frontWindow());
        palette->show();
    });
    const auto stepProblem = [this](int direction) {
        showPanel(QStringLiteral("problems"));
        if (auto* problems = qobject_cast<ProblemsView*>(m_bottom->panel(QStringLiteral("problems"))))
            problems->step(direction);
    };
    on("go.nextProblem", [stepProblem] { stepProblem(1); });
    on("go.previousProblem", [stepProblem] { stepProblem(-1); });
    on("help.docs", [this] { showDocs({}); });
    on("help.about", [this] { about(); });
    on("file.settings", [this] {
        SettingsDialog dialog(m_workspace.settings, m_workspace.keys, m_workspace.actions, frontWindow());
        connect(&dialog, &SettingsDialog::themeChosen, this, [this] {
            theme().setKind(m_workspace.settings.themeKind());
            refreshActions();
        });
        connect(&dialog, &SettingsDialog::languageChosen, this, [this, &dialog](const QString& language) {
            dialog.accept();
            emit languageRequested(language);
        });
        dialog.exec();
    });

    const auto refresh = [this] { refreshActions(); };
    connect(&document.undoStack(), &QUndoStack::indexChanged, this, refresh);
    connect(&document, &ProjectDocument::diagnosticsChanged, this, refresh);
    connect(&document, &ProjectDocument::modifiedChanged, this, [this] {
        refreshTitle();
        refreshActions();
    });
    connect(&document, &ProjectDocument::pathChanged, this, [this] {
        showProject(m_workspace.document.isOpen());
        refreshTitle();
        refreshActions();
    });
    connect(&document, &ProjectDocument::revealRequested, m_editors, &EditorArea::reveal);
    connect(&m_workspace.context, &Context::statusChanged, this, [this, last = RunState::Error](const ControllerStatus& status) mutable {
        if (status.state != last) {
            last = status.state;
            refreshActions();
        }
    });
    connect(&m_workspace.context, &Context::explainRequested, this,
        [this](Code code) { showDocs(words::explanationPath(words::codeId(code))); });
    connect(&m_workspace.connection, &Connection::stateChanged, this, refresh);
    connect(&m_workspace.workbench, &Workbench::busyChanged, this, refresh);
    connect(qApp, &QApplication::focusChanged, this, refresh);
}

void MainWindow::showDocs(const QString& path)
{
    auto* viewer = findChild<DocViewer*>();
    if (!viewer)
        viewer = new DocViewer(path, this);
    else if (!path.isEmpty())
        viewer->showPage(path);
    viewer->show();
    viewer->raise();
    viewer->activateWindow();
}

void MainWindow::about()
{
    QMessageBox::about(this, tr("About Camwright"),
        tr("<b>Camwright %1</b><br>Engineering tool for small motion controllers.<br><br>Free software under the GNU General Public License, "
           "version 3 or later. It comes without any warranty.")
            .arg(QApplication::applicationVersion()));
}

} // namespace camwright
