#pragma once

#include "core/online/controllerlink.h"

#include <QWidget>

class QComboBox;

namespace camwright {

class QuantityField;

/// How a recording starts and how long it is: trigger, level, part before the trigger, length; "at once" records without end.
class TriggerBar : public QWidget {
    Q_OBJECT
public:
    explicit TriggerBar(QWidget* parent = nullptr);

    void setChannels(const std::vector<std::string>& channels);
    /// Fills in all but the channels.
    void apply(TraceSetup& setup) const;
    /// The first field whose entry is not legal and would count; null: all are.
    QuantityField* wrongField() const;

private:
    void refresh();

    QComboBox* m_kind;
    QComboBox* m_channel;
    QuantityField* m_level;
    QuantityField* m_pre;
    QuantityField* m_length;
};

} // namespace camwright
