#pragma once

#include "app/window/arrangement.h"
#include "app/window/dropzone.h"

#include <QWidget>

#include <functional>
#include <vector>

class QHBoxLayout;
class QStackedWidget;

namespace camwright {

class Editor;
class EditorTabBar;
class EmptyState;
class Panel;

/// One strip of tabs with the pages under it. It knows how tabs look and move; what they show, and whether they may close, is
/// the editor area's.
class EditorGroup : public QWidget {
    Q_OBJECT
public:
    /// A tab: what it shows, and its page once somebody has looked at it.
    struct Tab {
        ObjectKey key;                     ///< default for a panel
        QString viewId;                    ///< or the panel's id
        QString title;
        QString iconName;
        bool preview = false;
        Editor* editor = nullptr;          ///< null for a panel, or not made yet
        QWidget* page = nullptr;
    };
    /// Makes the page of a tab that is looked at for the first time.
    using Maker = std::function<void(Tab&)>;

    EditorGroup(Maker maker, const QString& emptySentence, QWidget* parent = nullptr);

    int count() const { return int(m_tabs.size()); }
    const Tab& tab(int index) const { return m_tabs[std::size_t(index)]; }
    const std::vector<Tab>& tabs() const { return m_tabs; }
    int find(const ObjectKey& key, const QString& viewId) const;     ///< −1: not here
    int indexOf(const Editor* editor) const;
    int previewTab() const;
    int currentIndex() const;
    const Tab* current() const;                                      ///< null without tabs
    Panel* currentPanel() const;

    int add(Tab tab, int at = -1);         ///< takes the page, if there is one; −1: behind the last
    Tab take(int index);                   ///< out of the group; the page lives on, hidden and without a parent
    /// Many at once: only the page of the current one is made.
    void setTabs(std::vector<Tab> tabs, int current);
    std::vector<Tab> takeAll();
    void setCurrent(int index);
    void moveCurrent(int direction);       ///< along the strip
    void keep(int index);                  ///< a preview becomes a tab of its own
    void setKey(int index, const ObjectKey& key);
    void setEmptySentence(const QString& sentence);
    /// Keys and new tabs go to the active group.
    void setActive(bool active);
    void focusPage();
    Arrangement::Node arrangement() const;

    DropZone dropZoneAt(const QPoint& position) const;

signals:
    void currentChanged();
    void activated();                      ///< by a click into its strip or its empty ground
    void closeRequested(int index);
    void menuRequested(int index, const QPoint& global);
    void draggedOut(int index, const QPoint& global);
    void droppedOutside(int index, const QPoint& global);
    void dragEnded();

protected:
    void mousePressEvent(QMouseEvent* event) override;

private:
    QWidget* makeStrip();
    void paintGround();
    void insert(int index, Tab tab);
    Tab remove(int index);
    void becameCurrent();
    void takeRowWidget();
    void refreshTitle(const Editor* editor);

    Maker m_maker;
    EditorTabBar* m_bar = nullptr;
    QHBoxLayout* m_row = nullptr;
    QWidget* m_rowWidget = nullptr;
    QWidget* m_rowOwner = nullptr;
    QStackedWidget* m_pages;
    EmptyState* m_empty;
    std::vector<Tab> m_tabs;
    bool m_changing = false;
};

} // namespace camwright
