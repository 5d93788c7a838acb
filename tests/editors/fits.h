#pragma once

#include <QAbstractButton>
#include <QCoreApplication>
#include <QDir>
#include <QLabel>
#include <QPixmap>
#include <QWidget>

namespace camwright {

/// The texts of visible labels and buttons that do not fit where they stand.
inline QStringList cutTexts(const QWidget& view)
{
    QStringList out;
    for (const QLabel* label : view.findChildren<QLabel*>()) {
        if (label->isVisible() && !label->wordWrap() && !label->text().isEmpty() && label->width() + 1 < label->sizeHint().width())
            out << label->text();
    }
    for (const QAbstractButton* button : view.findChildren<QAbstractButton*>()) {
        if (button->isVisible() && button->width() + 1 < std::min(button->sizeHint().width(), button->minimumSizeHint().width()))
            out << button->text();
    }
    return out;
}

/// For people to look at, among the gallery's pictures.
inline bool savePicture(QWidget& view, const QString& name)
{
    const QString folder = QCoreApplication::applicationDirPath() + QStringLiteral("/../screenshots");
    return QDir().mkpath(folder) && view.grab().save(folder + QLatin1Char('/') + name + QStringLiteral(".png"));
}

} // namespace camwright
