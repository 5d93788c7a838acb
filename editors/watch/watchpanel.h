#pragma once

#include "editors/document/projectchange.h"
#include "editors/shell/panel.h"

class QComboBox;
class QStackedLayout;

namespace camwright {

class WatchView;

/// The watch dock: one of the project's watch lists with live values.
class WatchPanel : public Panel {
    Q_OBJECT
public:
    explicit WatchPanel(Context& context, QWidget* parent = nullptr);

    QWidget* tabRowWidget() override;
    bool can(const QString& actionId) const override;
    void perform(const QString& actionId) override;
    WatchView& view() const { return *m_view; }

private:
    void refreshLists();
    void addList();
    void choose(int index);
    void documentChanged(const ProjectChange& change);

    WatchView* m_view;
    QWidget* m_tools;
    QComboBox* m_lists;
    QStackedLayout* m_layers;
};

} // namespace camwright
