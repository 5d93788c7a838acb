#pragma once

#include "editors/shell/theme.h"

#include <QWidget>

namespace camwright {

/// A lamp with what it stands for and its state in words: filled and bold while on, an empty ring while off.
class Lamp : public QWidget {
    Q_OBJECT
public:
    Lamp(const QString& name, const char* objectName, QWidget* parent = nullptr);
    /// `onRole`: the colour while on.
    void setState(bool on, const QString& word, Role onRole);
    QString word() const { return m_word; }
    bool isOn() const { return m_on; }
    QSize sizeHint() const override;
    QSize minimumSizeHint() const override { return sizeHint(); }

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    QString m_name, m_word;
    bool m_on = false;
    Role m_onRole = Role::Ok;
};

} // namespace camwright
