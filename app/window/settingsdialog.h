#pragma once

#include "app/window/settings.h"

#include <QDialog>

namespace camwright {

/// Theme and language. Both take effect at once and are remembered.
class SettingsDialog : public QDialog {
    Q_OBJECT
public:
    SettingsDialog(Settings& settings, QWidget* parent);

signals:
    void themeChosen();
    void languageChosen(const QString& language);
};

} // namespace camwright
