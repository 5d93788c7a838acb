#pragma once

#include "core/online/controllerlink.h"

#include <QWidget>

class QLabel;

namespace camwright {

class Lamp;

/// The row of lamps below the panel: limits, home switch, drive, error. Each has its glyph and its word.
class LampStrip : public QWidget {
    Q_OBJECT
public:
    explicit LampStrip(QWidget* parent = nullptr);
    void present(const AxisStatus& axis, const std::string& family, const std::string& model);

private:
    Lamp* m_lower;
    Lamp* m_upper;
    Lamp* m_home;
    Lamp* m_drive;
    Lamp* m_error;
    QLabel* m_name;
};

} // namespace camwright
