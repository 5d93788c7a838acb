#pragma once

#include "editors/shell/editor.h"

class QFrame;
class QLabel;
class QStackedLayout;

namespace camwright {

class EmptyState;
class LampStrip;
class MotionColumn;
class PanelControl;
class PanelKeys;
class PanelWatch;
class Readings;
class StateView;

/// Commissioning of one axis: readings, state diagram, and the panel that moves it (UI, "Commissioning panel"). Whatever
/// takes the user away from it disarms it; STOP and its keys are always at hand.
class CommissioningEditor : public Editor {
    Q_OBJECT
public:
    CommissioningEditor(Context& context, ObjectKey key, QWidget* parent = nullptr);
    ~CommissioningEditor() override;

    QString title() const override;
    QString iconName() const override;
    void setKey(const ObjectKey& key) override;
    void reveal(const Place& place) override;
    PanelControl& control() const { return *m_control; }

protected:
    void resizeEvent(QResizeEvent* event) override;

private:
    QWidget* buildPage();
    QWidget* buildRight();
    void connectSafety();
    void refresh();                     ///< after any change of link, status or arming
    void refreshLimits();
    void arrange();
    QString emptySentence() const;

    PanelControl* m_control;
    PanelKeys* m_keys;
    PanelWatch* m_watch;
    QStackedLayout* m_layers;
    EmptyState* m_empty;
    QWidget* m_page = nullptr;
    Readings* m_readings = nullptr;
    QFrame* m_stateLine = nullptr;
    StateView* m_state = nullptr;
    QStackedLayout* m_right = nullptr;
    MotionColumn* m_motion = nullptr;
    EmptyState* m_noMotion = nullptr;
    LampStrip* m_lamps = nullptr;
};

} // namespace camwright
