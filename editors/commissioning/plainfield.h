#pragma once

#include <QWidget>

namespace camwright {

class QuantityField;

/// Holds a field without the room that fields keep for their dot: here none has a default, and the columns align with
/// buttons. The field takes the holder's width.
class PlainField : public QWidget {
    Q_OBJECT
public:
    PlainField(QuantityField* field, int smallestWidth, QWidget* parent = nullptr);
    QSize sizeHint() const override;
    QSize minimumSizeHint() const override { return sizeHint(); }

protected:
    bool event(QEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

private:
    QuantityField* m_field;
    int m_smallestWidth;
};

} // namespace camwright
