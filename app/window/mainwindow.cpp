#include "app/window/mainwindow.h"

#include "app/window/badgetabbar.h"
#include "app/window/connectionstrip.h"
#include "app/window/editorwindow.h"
#include "app/window/noticebar.h"
#include "app/window/palette.h"
#include "app/window/panelstack.h"
#include "app/window/startpage.h"
#include "app/window/statusline.h"
#include "app/window/toolrow.h"
#include "editors/shell/icons.h"

#include <QApplication>
#include <QCloseEvent>
#include <QLabel>
#include <QMenuBar>
#include <QSplitter>
#include <QStackedWidget>
#include <QUndoStack>
#include <QVBoxLayout>

namespace camwright {

namespace {

std::vector<PanelFactory> panelsIn(const Registry& registry, PanelArea area)
{
    std::vector<PanelFactory> out;
    for (const PanelFactory& factory : registry.panels()) {
        if (factory.area == area)
            out.push_back(factory);
    }
    std::sort(out.begin(), out.end(), [](const PanelFactory& a, const PanelFactory& b) { return a.order < b.order; });
    return out;
}

} // namespace

MainWindow::MainWindow(Workspace& workspace) : m_workspace(workspace)
{
    setObjectName(QStringLiteral("mainWindow"));
    setWindowTitle(QStringLiteral("Camwright"));
    setWindowIcon(icon(QStringLiteral("cam"), Role::Accent));
    setMinimumSize(900, 560);
    resize(1440, 900);
    restoreGeometry(workspace.settings.layout(QStringLiteral("window")));
    for (const ActionRow& row : workspace.actions.rows())
        addAction(workspace.actions.action(QString::fromLatin1(row.id)));
    build();
    buildMenus();
    connectActions();
    connectFileActions();
    connectOnlineActions();
    restoreLayout(Layout::Program);
    showProject(workspace.document.isOpen());
    refreshTitle();
    refreshActions();
}

MainWindow::~MainWindow()
{
    saveLayout();
    // The focus still changes and documents still close while the parts go: nobody may call back into half a window.
    const std::initializer_list<const QObject*> heard{qApp, &m_workspace.document, &m_workspace.document.undoStack(), &m_workspace.context,
        &m_workspace.connection, &m_workspace.workbench, m_bottom, m_right};
    for (const QObject* sender : heard)
        sender->disconnect(this);
    // Editors and panels go before anything they listen to.
    delete takeCentralWidget();
}

void MainWindow::build()
{
    Context& context = m_workspace.context;
    auto* central = new QWidget;
    auto* column = new QVBoxLayout(central);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    m_tools = new ToolRow(context, m_workspace.connection, m_workspace.settings);
    column->addWidget(m_tools);
    auto* strip = new ConnectionStrip(context, m_workspace.connection);
    column->addWidget(strip);
    m_pages = new QStackedWidget;
    m_start = new StartPage(m_workspace.settings);
    m_pages->addWidget(m_start);
    buildDocks();
    column->addWidget(m_pages, 1);
    m_notice = new NoticeBar;
    column->addWidget(m_notice);
    m_status = new StatusLine(context, m_workspace.connection, m_workspace.workbench);
    column->addWidget(m_status);
    setCentralWidget(central);
    listenTo(*strip);
    connect(&context, &Context::notified, m_notice, &NoticeBar::tell);
    connect(&context, &Context::panelRequested, this, &MainWindow::showPanel);
    connect(&context, &Context::openRequested, m_editors, &EditorArea::open);
    connect(&context, &Context::revealRequested, m_editors, &EditorArea::reveal);
    connect(&context, &Context::armedChanged, this, &MainWindow::armedChanged);
    connect(m_start, &StartPage::demoRequested, this, &MainWindow::openDemo);
    connect(m_start, &StartPage::newRequested, this, &MainWindow::newProject);
    connect(m_start, &StartPage::pageRequested, this, &MainWindow::showDocs);
    connect(m_start, &StartPage::openRequested, this, [this](const QString& path) {
        if (path.isEmpty())
            chooseProject();
        else
            openProject(path);
    });
}

void MainWindow::buildDocks()
{
    Context& context = m_workspace.context;
    const Registry& registry = m_workspace.registry;
    m_across = new QSplitter(Qt::Horizontal);
    m_across->setHandleWidth(1);
    m_across->setChildrenCollapsible(false);
    m_left = new QSplitter(Qt::Vertical);
    m_left->setHandleWidth(1);
    for (const PanelArea area : {PanelArea::Left, PanelArea::LeftBottom}) {
        for (const PanelFactory& factory : panelsIn(registry, area)) {
            Panel* panel = factory.create(context);
            panel->setProperty("panelId", factory.id);
            m_left->addWidget(panel);
            m_left->setStretchFactor(m_left->count() - 1, area == PanelArea::Left ? 3 : 1);
        }
    }
    m_down = new QSplitter(Qt::Vertical);
    m_down->setHandleWidth(1);
    m_down->setChildrenCollapsible(false);
    m_editors = new EditorArea(context);
    m_bottom = new PanelStack(context, panelsIn(registry, PanelArea::Bottom), tr("Bottom dock"));
    m_bottom->setObjectName(QStringLiteral("bottomDock"));
    m_down->addWidget(m_editors);
    m_down->addWidget(m_bottom);
    m_down->setStretchFactor(0, 1);
    m_right = new PanelStack(context, panelsIn(registry, PanelArea::Right), tr("Side dock"));
    m_right->setObjectName(QStringLiteral("sideDock"));
    m_across->addWidget(m_left);
    m_across->addWidget(m_down);
    m_across->addWidget(m_right);
    m_across->setStretchFactor(1, 1);
    m_pages->addWidget(m_across);
    // Problems count from the start, whether they are shown or not.
    m_bottom->panel(QStringLiteral("problems"));
    m_bottom->panel(QStringLiteral("output"));
    for (QWidget* dock : {static_cast<QWidget*>(m_left), static_cast<QWidget*>(m_right), static_cast<QWidget*>(m_bottom)})
        dock->setMinimumWidth(180);
    connect(m_editors, &EditorArea::windowMade, this, &MainWindow::equipWindow);
    for (const PanelStack* stack : {m_bottom, m_right})
        connect(stack, &PanelStack::abilitiesChanged, this, &MainWindow::refreshActions);
    connect(m_editors, &EditorArea::currentChanged, this, [this] {
        const Editor* editor = m_editors->current();
        m_right->setExtraPage(editor ? const_cast<Editor*>(editor)->propertiesWidget() : nullptr, tr("Properties"));
        m_status->setPosition(editor ? editor->positionText() : QString());
        refreshActions();
        refreshTitle();
    });
    connect(m_editors, &EditorArea::positionChanged, this, [this] {
        const Editor* editor = m_editors->current();
        m_status->setPosition(editor ? editor->positionText() : QString());
        refreshActions();
    });
}

/// A window beside this one: the same keys, and the strip that tells which machine is meant.
void MainWindow::equipWindow(EditorWindow* window)
{
    for (const ActionRow& row : m_workspace.actions.rows())
        window->addAction(m_workspace.actions.action(QString::fromLatin1(row.id)));
    auto* strip = new ConnectionStrip(m_workspace.context, m_workspace.connection);
    window->setHead(strip);
    listenTo(*strip);
}

void MainWindow::listenTo(ConnectionStrip& strip)
{
    connect(&strip, &ConnectionStrip::showDifferencesRequested, this, [this] { download(); });
    connect(&strip, &ConnectionStrip::releaseForcesRequested, &m_workspace.connection, &Connection::releaseForces);
}

/// Where a question or a palette belongs: over the window the user works in.
QWidget* MainWindow::frontWindow()
{
    auto* active = qobject_cast<EditorWindow*>(QApplication::activeWindow());
    return active ? static_cast<QWidget*>(active) : this;
}

void MainWindow::showProject(bool open)
{
    m_pages->setCurrentIndex(open ? 1 : 0);
    m_presets->setVisible(open);
    if (open)
        return;
    m_start->refresh();
    m_start->setFocus();
}

void MainWindow::showPanel(const QString& id)
{
    if (m_bottom->has(id)) {
        m_bottom->setVisible(true);
        m_bottom->showPanel(id);
    } else if (m_right->has(id)) {
        m_right->setVisible(true);
        m_right->showPanel(id);
    } else if (const PanelFactory* factory = m_workspace.registry.panel(id); factory && factory->area == PanelArea::Center) {
        m_editors->openPanel(*factory);
    } else if (factory) {
        m_left->setVisible(true);
    }
    refreshActions();
}

void MainWindow::refreshTitle()
{
    const ProjectDocument& document = m_workspace.document;
    setWindowModified(document.isModified());
    setWindowTitle(document.isOpen() ? QStringLiteral("%1[*] - Camwright").arg(document.displayName()) : QStringLiteral("Camwright"));
}

QWidget* MainWindow::focusedPart() const
{
    for (QWidget* widget = QApplication::focusWidget(); widget; widget = widget->parentWidget()) {
        if (qobject_cast<Panel*>(widget) || qobject_cast<Editor*>(widget))
            return widget;
    }
    return m_editors->current() ? static_cast<QWidget*>(m_editors->current()) : m_editors->currentPanel();
}

bool MainWindow::canEdit(const QString& id) const
{
    QWidget* part = focusedPart();
    if (const auto* editor = qobject_cast<Editor*>(part))
        return editor->can(id);
    if (const auto* panel = qobject_cast<Panel*>(part))
        return panel->can(id);
    return false;
}

void MainWindow::editAction(const QString& id)
{
    QWidget* part = focusedPart();
    if (auto* editor = qobject_cast<Editor*>(part))
        editor->perform(id);
    else if (auto* panel = qobject_cast<Panel*>(part))
        panel->perform(id);
}

void MainWindow::refreshActions()
{
    using enum Availability;
    Availability holding = Always;
    const auto also = [&holding](bool condition, Availability what) {
        if (condition)
            holding = holding | what;
    };
    const Context& context = m_workspace.context;
    ProjectDocument& document = m_workspace.document;
    also(document.isOpen(), ProjectOpen);
    also(document.isModified(), Modified);
    also(document.undoStack().canUndo(), CanUndo);
    also(document.undoStack().canRedo(), CanRedo);
    also(!document.diagnostics().empty(), Problems);
    also(context.isOnline(), Online);
    also(m_workspace.connection.state() == LinkState::Offline, Offline);
    also(context.isOnline() && context.status().state == RunState::Run, Running);
    also(context.isOnline() && context.status().state != RunState::Run, Stopped);
    also(!m_workspace.workbench.isBusy(), Idle);
    also(m_editors->activeGroup().count() > 0, TabOpen);
    also(m_editors->canMove(), TabMovable);
    also(m_editors->groups().size() > 1, SeveralGroups);
    m_workspace.actions.setState(holding, [this](const QString& id) { return canEdit(id); });
    const auto label = [this](const char* id, const QString& withName, const QString& plain, const QString& name) {
        m_workspace.actions.action(QString::fromLatin1(id))->setText(name.isEmpty() ? plain : withName.arg(name));
    };
    label("edit.undo", tr("&Undo %1"), tr("&Undo"), document.undoStack().undoText());
    label("edit.redo", tr("&Redo %1"), tr("&Redo"), document.undoStack().redoText());
    const auto check = [this](const char* id, bool on) { m_workspace.actions.action(QString::fromLatin1(id))->setChecked(on); };
    check("view.left", m_left->isVisibleTo(m_across));
    check("view.right", m_right->isVisibleTo(m_across));
    check("view.bottom", m_bottom->isVisibleTo(m_down));
    check("view.dark", theme().isDark());
    check("view.ownWindow", m_editors->isInOwnWindow());
}

void MainWindow::armedChanged(bool armed)
{
    // While a panel is armed, F1 to F4, Esc and Space are the panel's, wherever the focus is (CONTRACTS 23).
    static const QList<QKeySequence> panelKeys{QKeySequence(Qt::Key_F1), QKeySequence(Qt::Key_F2), QKeySequence(Qt::Key_F3),
        QKeySequence(Qt::Key_F4), QKeySequence(Qt::Key_Escape), QKeySequence(Qt::Key_Space)};
    m_workspace.actions.withhold(armed ? panelKeys : QList<QKeySequence>());
}

void MainWindow::setDark(bool dark)
{
    m_workspace.settings.setThemeChoice(dark ? Settings::ThemeChoice::Dark : Settings::ThemeChoice::Light);
    theme().setKind(dark ? Theme::Kind::Dark : Theme::Kind::Light);
    refreshActions();
}

void MainWindow::closeEvent(QCloseEvent* event)
{
    if (!mayCloseProject()) {
        event->ignore();
        return;
    }
    saveLayout();
    m_workspace.settings.setLayout(QStringLiteral("window"), saveGeometry());
    m_editors->closeWindows(); // the main window ends the program, and nothing is lost: the edits are the project's
    m_workspace.rememberProject();
    m_workspace.connection.disconnectNow();
    m_workspace.document.close();
    event->accept();
}

bool MainWindow::event(QEvent* event)
{
    if (event->type() == QEvent::WindowActivate)
        refreshActions();
    return QMainWindow::event(event);
}

} // namespace camwright
