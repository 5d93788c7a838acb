#pragma once

#include "core/online/controllerlink.h"

#include <QPointer>
#include <QWidget>

#include <optional>

class QTableView;

namespace camwright {

class Banner;
class Context;
class WatchModel;

/// A watch table with live values: typed entry writes, F7 forces, Alt+F7 releases all. Used by the panel and the editor.
class WatchView : public QWidget {
    Q_OBJECT
public:
    WatchView(Context& context, const ObjectKey& key, QWidget* parent = nullptr);
    ~WatchView() override;

    /// The one the keyboard is in; null if it is elsewhere.
    static WatchView* focused();

    WatchModel& model() const { return *m_model; }
    QTableView* table() const { return m_table; }
    void setKey(const ObjectKey& key);
    std::vector<int> selectedRows() const;

    void forceSelected();
    void releaseSelected();
    void removeSelected();
    bool can(const QString& actionId) const;
    void perform(const QString& actionId);

signals:
    void abilitiesChanged();

private:
    void buildTable();
    void resubscribe();
    void subscribeKnown();
    void unsubscribe();
    void stateChanged();
    void write(const QString& expression, const Value& value);
    void showMenu(const QPoint& globalPoint);
    void report(const Result<void>& done);

    Context& m_context;
    WatchModel* m_model;
    QTableView* m_table;
    Banner* m_banner;
    std::optional<SubscriptionId> m_subscription;
    unsigned m_generation = 0; ///< counts resubscriptions, so that late answers are dropped
};

} // namespace camwright
