#pragma once

#include "core/base/diagnostic.h"
#include "core/model/objects.h"

#include <QWidget>

#include <map>

class QFormLayout;
class QLabel;
class QLineEdit;

namespace camwright {

class QuantityField;
class SegmentedControl;

/// The fields of a motion network's axis (KS-MCN), for the network's window and for the axis's own page. It shows an axis
/// and says what the user made of it; it changes nothing itself.
class AxisForm : public QWidget {
    Q_OBJECT
public:
    explicit AxisForm(QWidget* parent = nullptr);

    void setAxis(const std::string& name, const Axis& axis);
    /// Sentences below the fields they belong to; those of other objects are left out.
    void setProblems(const ObjectKey& key, const Diagnostics& diagnostics);
    const Axis& axis() const { return m_axis; }
    QString axisName() const;
    void focusField(const std::string& field);

signals:
    /// `field` is the key of core/model/fieldlist.h.
    void edited(const std::string& field, const camwright::Axis& axis);
    void nameEdited(const QString& name);

private:
    void addNumbers();
    void addMechanics();
    void addSupervision();
    QuantityField* addField(const QString& label, const char* field, struct QuantitySpec spec);
    QWidget* addGuardingChoice();
    void refresh();
    void refreshUnits();
    void showGuarding(bool advanced);

    Axis m_axis;
    bool m_advanced = false; ///< the user asked for the guarding fields
    QFormLayout* m_rows;
    QLineEdit* m_name;
    QLabel* m_nameProblem;
    SegmentedControl* m_type;
    SegmentedControl* m_guarding;
    std::map<std::string, QuantityField*> m_fields;
};

} // namespace camwright
