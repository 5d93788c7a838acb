#pragma once

#include "app/window/settings.h"

#include <QDialog>

namespace camwright {

class ActionCatalogue;
class KeyBook;

/// Theme, language and keys. All take effect at once and are remembered.
class SettingsDialog : public QDialog {
    Q_OBJECT
public:
    SettingsDialog(Settings& settings, KeyBook& keys, const ActionCatalogue& actions, QWidget* parent);

signals:
    void themeChosen();
    void languageChosen(const QString& language);

private:
    QWidget* makeGeneralPage(Settings& settings);
};

} // namespace camwright
