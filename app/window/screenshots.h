#pragma once

#include <QObject>
#include <QTimer>

namespace camwright {

class MainWindow;
class Workspace;

/// Takes pictures of the window and ends the program: the start page, then every view of the open project, light and dark.
/// Waits for a controller that is connecting, so that live values are seen.
class Screenshots : public QObject {
    Q_OBJECT
public:
    Screenshots(Workspace& workspace, MainWindow& window, const QString& directory);
    void start();
    /// The start page, light and dark, before a project is opened.
    static void saveStartPage(MainWindow& window, const QString& directory);

signals:
    void done(bool saved);

private:
    void take();
    void grab(const QString& name);

    Workspace& m_workspace;
    MainWindow& m_window;
    QString m_directory;
    QTimer m_wait;
    int m_waited = 0;
    bool m_saved = true;
};

} // namespace camwright
