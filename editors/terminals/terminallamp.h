#pragma once

#include <QAbstractButton>

namespace camwright {

/// One terminal: a lamp with its address and name. An input is a button: a click switches it, and it stays; an output only
/// shows. On is filled and says 1, so that the state is never colour alone.
class TerminalLamp : public QAbstractButton {
    Q_OBJECT
public:
    TerminalLamp(const QString& address, bool isInput, QWidget* parent = nullptr);

    QString address() const { return m_address; }
    void setSymbol(const QString& symbol);
    void setOn(bool on, bool forced);
    bool isOn() const { return m_on; }
    QSize sizeHint() const override { return {168, 32}; }

signals:
    void switched(bool on); ///< by the user; the lamp changes when the controller says so

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    void refreshDescription();

    QString m_address, m_symbol;
    bool m_isInput;
    bool m_on = false;
    bool m_forced = false;
};

} // namespace camwright
