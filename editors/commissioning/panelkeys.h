#pragma once

#include <QObject>
#include <QSet>

class QKeyEvent;

namespace camwright {

/// The keys of commissioning, wherever the focus is (CONTRACTS 23): Esc and Space stop, F1 to F4 jog while held. They are
/// taken from the whole application only while a panel is armed or moves an axis; otherwise this object sees nothing.
class PanelKeys : public QObject {
    Q_OBJECT
public:
    enum class Mode { Off, StopOnly, StopAndJog };

    explicit PanelKeys(QObject* parent = nullptr);
    ~PanelKeys() override;

    Mode mode() const { return m_mode; }
    void setMode(Mode mode);

    bool eventFilter(QObject* watched, QEvent* event) override;

signals:
    void stopPressed();
    void jogPressed(int index);     ///< 0 … 3: −−, −, +, ++
    void jogReleased(int index);

private:
    bool takes(const QKeyEvent& event) const;
    bool pressed(const QKeyEvent& event);
    bool released(const QKeyEvent& event);
    void refreshFilter();

    Mode m_mode = Mode::Off;
    QSet<int> m_down;               ///< keys that went down as ours; nobody else sees them until they are up
    bool m_installed = false;
};

} // namespace camwright
