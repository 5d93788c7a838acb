#pragma once

#include <QKeySequenceEdit>

namespace camwright {

/// Takes the next stroke as a key, at once. Escape gives up, Tab goes on to the next field.
class KeyField : public QKeySequenceEdit {
    Q_OBJECT
public:
    explicit KeyField(QWidget* parent = nullptr);
    /// What the field shows until another key is pressed.
    void setKey(const QKeySequence& key);

signals:
    void pressed(const QKeySequence& key);

protected:
    void keyPressEvent(QKeyEvent* event) override;
    void keyReleaseEvent(QKeyEvent* event) override;
    void focusOutEvent(QFocusEvent* event) override;

private:
    QKeySequence m_key;
};

} // namespace camwright
