#pragma once

#include <QWidget>

namespace camwright {

/// A position in large digits with its unit. The digits shrink before they would be cut.
class BigDigits : public QWidget {
    Q_OBJECT
public:
    explicit BigDigits(QWidget* parent = nullptr);
    void setValue(const QString& digits, const QString& unit);
    QSize sizeHint() const override { return {200, 44}; }
    QSize minimumSizeHint() const override { return {150, 44}; }

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    QString m_digits, m_unit;
};

} // namespace camwright
