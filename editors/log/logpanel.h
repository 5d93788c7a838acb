#pragma once

#include "editors/shell/panel.h"

class QStackedLayout;
class QTableView;

namespace camwright {

class Explain;
class LogModel;

/// The controller's log while online: starts and stops, faults, who connected, why an axis was stopped.
class LogPanel : public Panel {
    Q_OBJECT
public:
    explicit LogPanel(Context& context, QWidget* parent = nullptr);
    ~LogPanel() override;

    bool can(const QString& actionId) const override;
    void perform(const QString& actionId) override;

private:
    void copySelected() const;
    void follow();
    void leave();
    void forget();

    LogModel* m_model;
    QTableView* m_table;
    Explain* m_explain;
    QStackedLayout* m_layers;
    int m_token = 0;
};

} // namespace camwright
