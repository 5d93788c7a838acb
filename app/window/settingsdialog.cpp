#include "app/window/settingsdialog.h"

#include "app/window/keyspage.h"
#include "editors/shell/widgets.h"
#include "editors/words/words.h"

#include <QComboBox>
#include <QFormLayout>
#include <QPushButton>
#include <QTabWidget>
#include <QVBoxLayout>

namespace camwright {

SettingsDialog::SettingsDialog(Settings& settings, KeyBook& keys, const ActionCatalogue& actions, QWidget* parent) : QDialog(parent)
{
    setObjectName(QStringLiteral("settingsDialog"));
    setWindowTitle(tr("Settings"));
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(20, 14, 20, 16);
    column->setSpacing(12);
    auto* pages = new QTabWidget(this);
    describe(pages, "settingsPages", tr("Pages of the settings"));
    pages->tabBar()->setAccessibleName(tr("Pages of the settings"));
    pages->addTab(makeGeneralPage(settings), tr("General"));
    pages->addTab(new KeysPage(keys, actions), tr("Keys"));
    column->addWidget(pages, 1);
    auto* close = new QPushButton(tr("Close"), this);
    describe(close, "settingsClose", tr("Close"));
    close->setDefault(true);
    column->addWidget(close, 0, Qt::AlignRight);
    connect(close, &QPushButton::clicked, this, &QDialog::accept);
    resize(860, 560);
}

QWidget* SettingsDialog::makeGeneralPage(Settings& settings)
{
    auto* out = new QWidget;
    auto* form = new QFormLayout(out);
    form->setContentsMargins(0, 16, 0, 0);
    form->setHorizontalSpacing(16);
    form->setVerticalSpacing(10);
    auto* themes = new SegmentedControl(tr("Theme"), out);
    themes->setObjectName(QStringLiteral("settingsTheme"));
    themes->addSegment(tr("System"), {}, tr("Follows the desktop."));
    themes->addSegment(tr("Light"));
    themes->addSegment(tr("Dark"));
    themes->setCurrentIndex(int(settings.themeChoice()));
    auto* languages = new QComboBox(out);
    describe(languages, "settingsLanguage", tr("Language"), tr("Of the window, the messages and the help of instructions. Switches at once."));
    for (const QString& language : words::languages())
        languages->addItem(words::languageName(language), language);
    languages->setCurrentIndex(languages->findData(words::currentLanguage()));
    languages->setFixedWidth(180);
    form->addRow(tr("Theme"), themes);
    form->addRow(tr("Language"), languages);
    connect(themes, &SegmentedControl::chosen, this, [this, &settings](int index) {
        settings.setThemeChoice(Settings::ThemeChoice(index));
        emit themeChosen();
    });
    connect(languages, &QComboBox::activated, this, [this, languages](int index) { emit languageChosen(languages->itemData(index).toString()); });
    return out;
}

} // namespace camwright
