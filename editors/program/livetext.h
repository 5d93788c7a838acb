#pragma once

#include "core/language/assist/liveoperands.h"
#include "core/online/controllerlink.h"
#include "core/base/place.h"

#include <QDateTime>
#include <QObject>
#include <QTimer>

#include <map>
#include <optional>

namespace camwright {

class Context;
class IlCodeView;

/// The controller's values inside the text of a program: asks for what the lines in view name, by one subscription that
/// follows scrolling and editing, and hands the view what to show. Values are kept, marked as old, when the connection is
/// lost or the project no longer is what the controller runs. Nothing waits: values come when the link pushes them.
class LiveText : public QObject {
    Q_OBJECT
public:
    LiveText(Context& context, IlCodeView& view, ObjectKey key);
    ~LiveText() override;

    void setKey(const ObjectKey& key);
    /// Only what is shown is asked for.
    void setActive(bool active);
    /// The sentence that explains old values; empty while they are live or there are none.
    QString notice() const { return m_notice; }
    /// What is known of the operand at a position of the text: "Start TRUE", with its time if it is old. Empty if nothing is.
    QString valueAt(int position) const;

signals:
    void noticeChanged();

private:
    enum class State { Off, Live, Lost, Different };

    State stateNow() const;
    void refresh();
    void readOperands();
    std::vector<std::string> names() const;
    void subscribe(std::vector<std::string> names);
    void unsubscribe();
    void take(const MonitorUpdate& update);
    void show();
    void setNotice(const QString& sentence);
    std::optional<MonitoredValue> valueOf(const LiveOperand& operand) const;

    Context& m_context;
    IlCodeView& m_view;
    ObjectKey m_key;
    bool m_active = true;
    State m_state = State::Off;
    std::vector<LiveOperand> m_operands;            ///< of the lines in view
    std::map<std::string, MonitoredValue> m_values; ///< the newest of every name seen, by name
    QDateTime m_newest;                             ///< when a value came last
    std::vector<std::string> m_names;               ///< subscribed to
    std::optional<SubscriptionId> m_subscription;
    unsigned m_generation = 0;                      ///< counts subscriptions, so that late updates are dropped
    QTimer m_delay;                                 ///< scrolling comes in bursts
    QString m_notice;
};

} // namespace camwright
