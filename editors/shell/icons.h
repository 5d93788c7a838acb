#pragma once

#include "editors/shell/theme.h"

#include <QIcon>
#include <QPixmap>
#include <QStringList>

namespace camwright {

/// Our own icons: resources/icons/NAME.svg, 16 grid, 1.5 stroke, drawn in one colour of the theme at the moment of
/// painting, so an icon follows a change of theme. Disabled icons are drawn faint. `icon("axis-linear")`.
QIcon icon(const QString& name, Role role = Role::Text);
/// For paint code: the icon as a pixmap of `size` device-independent pixels.
QPixmap iconPixmap(const QString& name, int size, Role role, qreal devicePixelRatio = 1.0);
void paintIcon(QPainter& painter, const QRectF& rect, const QString& name, Role role);
bool hasIcon(const QString& name);
QStringList iconNames();

} // namespace camwright
