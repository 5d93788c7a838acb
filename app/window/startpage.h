#pragma once

#include "app/window/settings.h"

#include <QScrollArea>

class QVBoxLayout;

namespace camwright {

class RecentList;

/// What the window shows while no project is open: the demo machine, a new project by family, recent projects, first steps.
class StartPage : public QScrollArea {
    Q_OBJECT
public:
    explicit StartPage(Settings& settings, QWidget* parent = nullptr);
    void refresh();                       ///< recent projects

signals:
    void demoRequested();
    void newRequested(const QString& familyId);
    void openRequested(const QString& path); ///< empty: choose
    void pageRequested(const QString& path);

protected:
    void keyPressEvent(QKeyEvent* event) override;

private:
    QWidget* hero();
    QWidget* familyCards();
    QWidget* recentHeader();
    QWidget* learnColumn();

    Settings& m_settings;
    RecentList* m_recent;
    QWidget* m_recentCard;
    QWidget* m_recentEmpty;
};

} // namespace camwright
