#pragma once

#include "editors/shell/context.h"
#include "editors/shell/editor.h"
#include "editors/shell/panel.h"

#include <QWidget>

class QHBoxLayout;
class QStackedWidget;

namespace camwright {

class EditorTabBar;

/// The editors of the window in tabs: one per object and view, a preview tab that the next preview replaces, panels that
/// live in the middle, and the way back and forward.
class EditorArea : public QWidget {
    Q_OBJECT
public:
    explicit EditorArea(Context& context, QWidget* parent = nullptr);

    void open(const ObjectKey& key, const QString& viewId, bool preview);
    void reveal(const Place& place);
    void openPanel(const PanelFactory& factory);
    Editor* current() const;
    Panel* currentPanel() const;
    int count() const;
    bool closeTab(int index);              ///< false: the editor wants to stay
    bool closeCurrent();
    bool closeAll();
    void goBack();
    void goForward();
    void step(int direction);              ///< to the next tab
    /// What is open, to open it again in a window in another language.
    struct Open {
        ObjectKey key;
        QString viewId;
    };
    std::vector<Open> opened() const;

signals:
    void currentChanged();
    void positionChanged();

private:
    struct Tab {
        QWidget* page = nullptr;
        Editor* editor = nullptr;          ///< null for a panel
        QString viewId;                    ///< or the panel's id
        bool preview = false;
    };
    int find(const ObjectKey& key, const QString& viewId) const;
    int add(Tab tab, const QString& title, const QString& iconName);
    void keep(int index);                  ///< a preview becomes a tab of its own
    void becameCurrent();
    void follow(const ProjectChange& change);
    void note();                           ///< the current place into the history
    void visit(const Place& place);

    Context& m_context;
    EditorTabBar* m_bar;
    QHBoxLayout* m_row;
    QWidget* m_rowWidget = nullptr;
    QStackedWidget* m_pages;
    std::vector<Tab> m_tabs;
    std::vector<Place> m_history;
    std::size_t m_historyAt = 0;
    bool m_visiting = false;
};

} // namespace camwright
