#pragma once

#include "editors/document/problemsmodel.h"
#include "editors/shell/panel.h"

class QTableView;
class QStackedWidget;

namespace camwright {

class Explain;

/// What is wrong with the project: a row a problem; Enter or double-click goes to the place, F1 explains the message.
class ProblemsView : public Panel {
    Q_OBJECT
public:
    explicit ProblemsView(Context& context, QWidget* parent = nullptr);
    int badge() const override;
    /// Goes to the next (+1) or previous (-1) problem and shows it.
    void step(int direction);
    bool can(const QString& actionId) const override;
    void perform(const QString& actionId) override;

private:
    void go(int row);
    void fix(int row);
    void copySelected() const;
    void refresh();

    ProblemsModel m_model;
    QTableView* m_table;
    QStackedWidget* m_pages;
    Explain* m_explain;
};

} // namespace camwright
