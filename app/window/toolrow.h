#pragma once

#include "app/window/connection.h"
#include "app/window/settings.h"
#include "editors/shell/context.h"

#include <QFrame>

class QComboBox;
class QHBoxLayout;
class QLabel;
class QToolButton;

namespace camwright {

/// The row of tools: file, undo, check and build, the controller's address with Online, Download, Run, Stop, and search.
class ToolRow : public QFrame {
    Q_OBJECT
public:
    ToolRow(Context& context, Connection& connection, Settings& settings, QWidget* parent = nullptr);
    QString address() const;              ///< as typed: "local", "tcp://…"
    void refreshAddresses();

private:
    QToolButton* addButton(QHBoxLayout* row, const QString& actionId, bool withText);
    void addSeparator(QHBoxLayout* row);
    void refresh();

    Context& m_context;
    Connection& m_connection;
    Settings& m_settings;
    QComboBox* m_address;
    QLabel* m_lamp;
    QToolButton* m_online;
    QToolButton* m_search;
};

} // namespace camwright
