#pragma once

#include <QWidget>

namespace camwright {

/// Paints one of our drawings (resources/start) in the colours of the theme. Words in it are painted by us, so that they
/// are translated.
void paintDrawing(QPainter& painter, const QRectF& rect, const QString& name);

/// The demo machine: a slide on a screw and an indexing table, with their positions.
class DemoDrawing : public QWidget {
    Q_OBJECT
public:
    explicit DemoDrawing(QWidget* parent = nullptr);
    QSize sizeHint() const override { return {500, 228}; }

protected:
    void paintEvent(QPaintEvent* event) override;
};

} // namespace camwright
