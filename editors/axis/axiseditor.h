#pragma once

#include "core/model/objects.h"
#include "editors/document/projectchange.h"
#include "editors/shell/editor.h"

#include <map>

class QGridLayout;
class QLabel;

namespace camwright {

class AxisForm;
class QuantityField;
class TransmissionView;

/// The page of one axis: its fields take effect at once, the drawing and the results follow; below, the machine that the
/// virtual controller simulates behind it.
class AxisEditor : public Editor {
    Q_OBJECT
public:
    AxisEditor(Context& context, ObjectKey key, QWidget* parent = nullptr);

    QString iconName() const override;
    void setKey(const ObjectKey& key) override;
    void reveal(const Place& place) override;

private:
    QWidget* buildResults();
    QWidget* buildSimulation();
    void documentChanged(const ProjectChange& change);
    void refresh();
    void refreshResults(const Axis& axis);
    void refreshProblems();
    void changeField(const std::string& field, const Axis& axis);
    void rename(const QString& name);

    QLabel* m_title;
    QLabel* m_subtitle;
    TransmissionView* m_drawing;
    AxisForm* m_form;
    std::map<std::string, QuantityField*> m_simulation;
    std::vector<QLabel*> m_results;
    QuantityField* m_speed = nullptr;
};

} // namespace camwright
