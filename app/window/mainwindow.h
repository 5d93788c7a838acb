#pragma once

#include "app/window/editorarea.h"
#include "app/window/workspace.h"

#include <QMainWindow>

class QSplitter;
class QStackedWidget;
class QTabBar;

namespace camwright {

class ConnectionStrip;
class EditorWindow;
class NoticeBar;
class PanelStack;
class StartPage;
class StatusLine;
class ToolRow;

enum class Layout { Configure, Program, Commission, Analyse };

/// The window: menu, tools, strip, docks around the editors, status line. It knows actions, editors and panels only by
/// their catalogues. Its parts are in mainwindow.cpp (making), windowmenus.cpp, windowlayouts.cpp, windowfiles.cpp,
/// windowonline.cpp.
class MainWindow : public QMainWindow {
    Q_OBJECT
public:
    explicit MainWindow(Workspace& workspace);
    ~MainWindow() override;

    EditorArea& editors() const { return *m_editors; }
    void setLayoutPreset(Layout layout);
    void showPanel(const QString& id);

    /// Opens a folder; asks about unsaved edits first, offers recovery, tells what is wrong. True when it is open.
    bool openProject(const QString& path);
    /// Copies the demo machine into the user's folder once, opens it, and goes online with its virtual controller.
    void openDemo();
    /// Opens a project, goes online with its virtual controller, downloads and runs: what `--demo` asks for.
    void runDemo(const QString& path);
    void download(bool thenRun = false, bool askFirst = true);
    /// Without it layouts are neither remembered nor overwritten: for taking pictures.
    void setKeepsLayouts(bool keeps) { m_keepsLayouts = keeps; }

signals:
    void languageRequested(const QString& language);

protected:
    void closeEvent(QCloseEvent* event) override;
    bool event(QEvent* event) override;

private:
    void build();
    void buildMenus();
    void buildDocks();
    void connectActions();
    void connectFileActions();
    void connectOnlineActions();
    void refreshActions();
    void refreshTitle();
    void showProject(bool open);
    void editAction(const QString& id);
    bool canEdit(const QString& id) const;
    QWidget* focusedPart() const;          ///< the editor or panel that has the focus, else the current editor
    void saveLayout();
    void restoreLayout(Layout layout);
    void restoreDocks(Layout layout);
    bool restoreEditors(EditorArea::Missing missing);      ///< false: nothing was remembered
    void showPresetView(Layout layout);
    void setDefaultLayout(Layout layout);
    void equipWindow(EditorWindow* window);
    void listenTo(ConnectionStrip& strip);
    QWidget* frontWindow();
    void armedChanged(bool armed);
    void setDark(bool dark);

    bool mayCloseProject();
    bool saveProject();
    void saveProjectAs();
    void newProject(const QString& familyId);
    void chooseProject();
    void closeProject();
    void offerRecovery();
    void outsideChanged(const QStringList& files);
    void tell(const QString& sentence, const Diagnostics& reasons);
    void showDocs(const QString& path);
    void about();
    void goOnline(const QString& address);

    Workspace& m_workspace;
    QStackedWidget* m_pages = nullptr;
    StartPage* m_start = nullptr;
    QSplitter* m_across = nullptr;
    QSplitter* m_down = nullptr;
    QSplitter* m_left = nullptr;
    PanelStack* m_right = nullptr;
    PanelStack* m_bottom = nullptr;
    EditorArea* m_editors = nullptr;
    ToolRow* m_tools = nullptr;
    StatusLine* m_status = nullptr;
    NoticeBar* m_notice = nullptr;
    QTabBar* m_presets = nullptr;
    Layout m_layout = Layout::Program;
    bool m_askingOutside = false;
    bool m_keepsLayouts = true;
};

} // namespace camwright
