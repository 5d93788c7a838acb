#pragma once

#include "app/window/settings.h"

#include <QTableWidget>

namespace camwright {

/// Recent projects: name and folder, controller, how it stood when it was closed, when that was.
class RecentList : public QTableWidget {
    Q_OBJECT
public:
    explicit RecentList(QWidget* parent = nullptr);
    void fill(const QList<RecentProject>& projects);

signals:
    void chosen(const QString& path);
    void forgetRequested(const QString& path);

protected:
    void keyPressEvent(QKeyEvent* event) override;
    void contextMenuEvent(QContextMenuEvent* event) override;
};

/// "Today 09:12", "Yesterday", "18 Nov".
QString whenText(const QDateTime& time, const QDateTime& now);

} // namespace camwright
