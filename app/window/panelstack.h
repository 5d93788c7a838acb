#pragma once

#include "editors/shell/context.h"
#include "editors/shell/panel.h"
#include "editors/shell/registry.h"

#include <QWidget>

class QHBoxLayout;
class QStackedWidget;
class QTabBar;

namespace camwright {

/// A dock: panels in one strip of tabs with their badges. Panels are made when they are first shown.
class PanelStack : public QWidget {
    Q_OBJECT
public:
    PanelStack(Context& context, const std::vector<PanelFactory>& panels, const QString& accessibleName, QWidget* parent = nullptr);

    bool has(const QString& id) const;
    void showPanel(const QString& id);
    QString currentId() const;
    Panel* current() const;
    Panel* panel(const QString& id);       ///< makes it if need be; null when not of this dock
    /// A page in front that follows the current editor: its properties. Null takes it away.
    void setExtraPage(QWidget* page, const QString& name);
    bool isEmpty() const { return m_entries.empty() && !m_extra; }

signals:
    void currentChanged();
    void abilitiesChanged();

private:
    struct Entry {
        PanelFactory factory;
        Panel* panel = nullptr;
    };
    void becameCurrent();
    void refreshBadge(int entry);
    int extraTabs() const { return m_extra ? 1 : 0; }

    Context& m_context;
    std::vector<Entry> m_entries;
    QTabBar* m_bar;
    QHBoxLayout* m_row;
    QWidget* m_rowWidget = nullptr;
    Panel* m_rowOwner = nullptr;
    QStackedWidget* m_pages;
    QWidget* m_extra = nullptr;
};

} // namespace camwright
