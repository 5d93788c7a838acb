#pragma once

#include "core/online/controllerlink.h"

#include <QDialog>

class QLabel;
class QProgressBar;
class QPushButton;
class QStackedWidget;
class QTableWidget;

namespace camwright {

class Context;

/// The plan of a download before the first byte moves, then its progress with cancel, then what came of it.
class DownloadDialog : public QDialog {
    Q_OBJECT
public:
    DownloadDialog(Context& context, DownloadPackage package, QWidget* parent);

signals:
    void downloaded();

protected:
    void reject() override;

private:
    void showPlan(const DownloadPlan& plan);
    void start();
    void finished(const Result<void>& result);
    void tell(const QString& sentence, bool error);

    Context& m_context;
    DownloadPackage m_package;
    RequestId m_request{};
    bool m_sending = false;
    QLabel* m_head;
    QTableWidget* m_table;
    QProgressBar* m_progress;
    QLabel* m_message;
    QPushButton* m_go;
    QPushButton* m_keep;
};

} // namespace camwright
