#pragma once

#include "core/language/assist/crossreference.h"
#include "editors/shell/context.h"
#include "editors/shell/panel.h"

#include <QTimer>

class QLabel;
class QStackedLayout;
class QTableView;

namespace camwright {

class EmptyState;
class ReferencesModel;

/// The places of the project where a variable, an address, an axis or a subroutine is used. Enter or double-click goes there, Esc back
/// to where it was asked. The list follows the project while it is shown; it is made on a worker.
class ReferencesPanel : public Panel {
    Q_OBJECT
public:
    explicit ReferencesPanel(Context& context, QWidget* parent = nullptr);

    int badge() const override;
    QWidget* tabRowWidget() override { return m_tools; }
    bool can(const QString& actionId) const override;
    void perform(const QString& actionId) override;
    ReferencesModel& model() const { return *m_model; }

signals:
    void listed(); ///< a new list is shown

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;
    void showEvent(QShowEvent* event) override;

private:
    struct Found {
        QString name;             ///< of what was sought; empty when nothing stands there
        std::vector<Reference> references;
    };
    static Found search(const Project& project, const Selection& sought);

    void buildTable();
    void follow();
    void take(const Found& found);
    void go(int row);
    void copySelected() const;

    ReferencesModel* m_model;
    QTableView* m_table;
    EmptyState* m_empty;
    QStackedLayout* m_layers;
    QWidget* m_tools;
    QLabel* m_summary;
    QTimer m_delay;               ///< edits come in bursts
    bool m_running = false, m_again = false, m_takeFocus = false;
};

} // namespace camwright
