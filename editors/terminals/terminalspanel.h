#pragma once

#include "core/online/controllerlink.h"
#include "editors/shell/panel.h"

#include <QPointer>

#include <map>
#include <optional>

class QGridLayout;
class QLabel;
class QScrollArea;
class QStackedLayout;

namespace camwright {

class EmptyState;
class TerminalLamp;

/// The virtual controller's terminals: inputs to switch, outputs as lamps, with the variables bound to them. A real
/// controller has none here: its inputs are wired (CONTRACTS 23).
class TerminalsPanel : public Panel {
    Q_OBJECT
public:
    explicit TerminalsPanel(Context& context, QWidget* parent = nullptr);
    ~TerminalsPanel() override;

private:
    void follow();
    void leave();
    void unsubscribe();
    void load(const std::vector<TerminalInfo>& terminals);
    void addTerminals(QGridLayout* grid, const QString& title, bool inputs, const std::vector<TerminalInfo>& terminals);
    void update(const MonitorUpdate& update);
    void switchInput(const QString& name, bool on);
    void refreshNames();
    QString symbolOf(const std::string& address) const;

    QStackedLayout* m_layers;
    EmptyState* m_empty;
    QScrollArea* m_scroll;
    std::map<std::string, TerminalLamp*> m_lamps;
    std::optional<SubscriptionId> m_subscription;
    unsigned m_generation = 0; ///< counts what was shown, so that late answers are dropped
};

} // namespace camwright
