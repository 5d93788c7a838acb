#pragma once

#include <QAbstractButton>

namespace camwright {

/// A controller family on the start page: picture, name, one sentence, its buses.
class FamilyCard : public QAbstractButton {
    Q_OBJECT
public:
    FamilyCard(const QString& drawing, const QString& name, const QString& sentence, const QString& buses, const QString& busIcon, QWidget* parent = nullptr);
    /// Not offered in this version; the reason stands where the buses would.
    void setMissing(const QString& reason);
    QSize sizeHint() const override { return {214, 178}; }

protected:
    void paintEvent(QPaintEvent* event) override;
    void enterEvent(QEnterEvent* event) override;
    void leaveEvent(QEvent* event) override;

private:
    QString m_drawing;
    QString m_sentence;
    QString m_buses;
    QString m_busIcon;
};

} // namespace camwright
