#pragma once

#include "core/base/codes.h"

#include <QFrame>
#include <QTimer>

class QLabel;

namespace camwright {

/// The last thing the program said, above the status line. Notes go away by themselves, errors stay until closed.
class NoticeBar : public QFrame {
    Q_OBJECT
public:
    explicit NoticeBar(QWidget* parent = nullptr);
    void tell(Severity severity, const QString& sentence);

private:
    void refresh();

    Severity m_severity = Severity::Information;
    QLabel* m_sign;
    QLabel* m_text;
    QTimer m_timer;
};

} // namespace camwright
