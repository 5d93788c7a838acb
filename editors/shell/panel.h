#pragma once

#include <QString>
#include <QWidget>

#include <functional>

namespace camwright {

class Context;

/// A tool view in a dock: problems, watch, log, instructions.
class Panel : public QWidget {
    Q_OBJECT
public:
    Panel(Context& context, QWidget* parent = nullptr);
    Context& context() const { return m_context; }
    /// A number shown as a badge at the panel's tab; 0 none.
    virtual int badge() const { return 0; }
    /// Widgets for the right end of the dock's tab row while this panel is current. May be null.
    virtual QWidget* tabRowWidget() { return nullptr; }
    virtual bool can(const QString& actionId) const { Q_UNUSED(actionId); return false; }
    virtual void perform(const QString& actionId) { Q_UNUSED(actionId); }

signals:
    void badgeChanged();
    void abilitiesChanged();                             ///< can() answers differently now

private:
    Context& m_context;
};

enum class PanelArea { Left, LeftBottom, Right, Bottom, Center };

struct PanelFactory {
    QString id;                ///< "watch"
    QString name;              ///< translated, the tab's text
    QString iconName;
    PanelArea area = PanelArea::Bottom;
    int order = 0;             ///< in its area
    std::function<Panel*(Context&)> create;
};

} // namespace camwright
