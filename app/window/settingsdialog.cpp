#include "app/window/settingsdialog.h"

#include "editors/shell/widgets.h"
#include "editors/words/words.h"

#include <QComboBox>
#include <QFormLayout>
#include <QPushButton>
#include <QVBoxLayout>

namespace camwright {

SettingsDialog::SettingsDialog(Settings& settings, QWidget* parent) : QDialog(parent)
{
    setObjectName(QStringLiteral("settingsDialog"));
    setWindowTitle(tr("Settings"));
    setMinimumWidth(420);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(20, 18, 20, 16);
    column->setSpacing(16);
    auto* form = new QFormLayout;
    form->setHorizontalSpacing(16);
    form->setVerticalSpacing(10);
    auto* themes = new SegmentedControl(tr("Theme"), this);
    themes->setObjectName(QStringLiteral("settingsTheme"));
    themes->addSegment(tr("System"), {}, tr("Follows the desktop."));
    themes->addSegment(tr("Light"));
    themes->addSegment(tr("Dark"));
    themes->setCurrentIndex(int(settings.themeChoice()));
    auto* languages = new QComboBox(this);
    describe(languages, "settingsLanguage", tr("Language"), tr("Of the window, the messages and the help of instructions. Switches at once."));
    for (const QString& language : words::languages())
        languages->addItem(words::languageName(language), language);
    languages->setCurrentIndex(languages->findData(words::currentLanguage()));
    languages->setFixedWidth(180);
    form->addRow(tr("Theme"), themes);
    form->addRow(tr("Language"), languages);
    column->addLayout(form);
    column->addStretch();
    auto* close = new QPushButton(tr("Close"), this);
    describe(close, "settingsClose", tr("Close"));
    close->setDefault(true);
    column->addWidget(close, 0, Qt::AlignRight);
    connect(close, &QPushButton::clicked, this, &QDialog::accept);
    connect(themes, &SegmentedControl::chosen, this, [this, &settings](int index) {
        settings.setThemeChoice(Settings::ThemeChoice(index));
        emit themeChosen();
    });
    connect(languages, &QComboBox::activated, this, [this, languages](int index) { emit languageChosen(languages->itemData(index).toString()); });
}

} // namespace camwright
