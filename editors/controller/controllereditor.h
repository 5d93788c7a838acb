#pragma once

#include "core/model/objects.h"
#include "editors/document/projectchange.h"
#include "editors/shell/editor.h"

class QComboBox;
class QLabel;
class QTableWidget;

namespace camwright {

class QuantityField;
class Switch;

/// The controller's page: model, scan period, watchdog, and what the chosen model offers.
class ControllerEditor : public Editor {
    Q_OBJECT
public:
    ControllerEditor(Context& context, ObjectKey key, QWidget* parent = nullptr);

    QString title() const override;
    QString iconName() const override { return QStringLiteral("controller"); }
    void reveal(const Place& place) override;

private:
    QWidget* buildForm();
    QWidget* buildLimits();
    void documentChanged(const ProjectChange& change);
    void refresh();
    void refreshProblems();
    QWidget* buildStrictRow(QWidget* page);
    void refreshLimits(const ControllerSettings& settings);

    QComboBox* m_model = nullptr;
    QLabel* m_modelProblem = nullptr;
    QLabel* m_family = nullptr;
    QuantityField* m_scanPeriod = nullptr;
    QuantityField* m_watchdog = nullptr;
    Switch* m_strict = nullptr;
    QWidget* m_strictRow = nullptr;
    QLabel* m_strictProblem = nullptr;
    QTableWidget* m_limits = nullptr;
};

} // namespace camwright
