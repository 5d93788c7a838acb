#include "editors/trace/triggerbar.h"

#include "editors/shell/quantityfield.h"
#include "editors/shell/theme.h"
#include "editors/shell/widgets.h"

#include <QComboBox>
#include <QHBoxLayout>

#include <algorithm>

namespace camwright {

namespace {

QuantityField* field(const char* objectName, const QString& name, const QString& unit, double value, double low, double high, const QString& help, QWidget* parent)
{
    QuantitySpec spec;
    spec.name = name;
    spec.unit = unit;
    spec.minimum = low;
    spec.maximum = high;
    spec.help = help;
    auto* out = new QuantityField(spec, parent);
    out->setObjectName(QString::fromLatin1(objectName));
    out->setFieldWidth(96);
    out->setValue(value);
    return out;
}

} // namespace

TriggerBar::TriggerBar(QWidget* parent)
    : QWidget(parent), m_kind(new QComboBox(this)), m_channel(new QComboBox(this)),
      m_level(field("triggerLevel", tr("Trigger level"), {}, 0.5, -1e12, 1e12, tr("Value at which the recording is triggered."), this)),
      m_pre(field("preTrigger", tr("Part before the trigger"), tr("%"), 20, 0, 100, tr("How much of the recording lies before the trigger."), this)),
      m_length(field("traceLength", tr("Length"), tr("s"), 2, 0.01, 600, tr("Length of a triggered recording."), this))
{
    describe(m_kind, "triggerKind", tr("Trigger"), tr("What starts the recording"));
    m_kind->addItem(tr("At once, live"), int(TriggerKind::Immediate));
    m_kind->addItem(tr("Rising edge of"), int(TriggerKind::RisingEdge));
    m_kind->addItem(tr("Falling edge of"), int(TriggerKind::FallingEdge));
    m_kind->addItem(tr("Above level"), int(TriggerKind::Above));
    m_kind->addItem(tr("Below level"), int(TriggerKind::Below));
    describe(m_channel, "triggerChannel", tr("Trigger channel"), tr("Value that is watched for the trigger"));
    m_channel->setEditable(true);
    m_channel->setMinimumWidth(180);
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(Theme::Grid);
    for (QWidget* widget : std::initializer_list<QWidget*>{m_kind, m_channel, m_level, m_pre, m_length})
        row->addWidget(widget);
    connect(m_kind, &QComboBox::currentIndexChanged, this, &TriggerBar::refresh);
    refresh();
}

void TriggerBar::setChannels(const std::vector<std::string>& channels)
{
    const QString text = m_channel->currentText();
    m_channel->clear();
    for (const std::string& name : channels)
        m_channel->addItem(QString::fromStdString(name));
    if (!text.isEmpty())
        m_channel->setCurrentText(text);
}

void TriggerBar::refresh()
{
    const bool triggered = m_kind->currentData().toInt() != int(TriggerKind::Immediate);
    for (QWidget* widget : std::initializer_list<QWidget*>{m_channel, m_level, m_pre, m_length})
        widget->setVisible(triggered);
}

QuantityField* TriggerBar::wrongField() const
{
    for (QuantityField* field : {m_level, m_pre, m_length}) {
        if (!field->isHidden() && !field->problem().isEmpty())
            return field;
    }
    return nullptr;
}

void TriggerBar::apply(TraceSetup& setup) const
{
    setup.trigger = static_cast<TriggerKind>(m_kind->currentData().toInt());
    if (setup.trigger == TriggerKind::Immediate) {
        setup.samples = 0;
        return;
    }
    setup.triggerChannel = m_channel->currentText().trimmed().toStdString();
    setup.triggerLevel = m_level->valueOr(0.5);
    setup.preTrigger = std::clamp(m_pre->valueOr(20) / 100, 0.0, 1.0);
    setup.samples = static_cast<std::uint32_t>(std::clamp(m_length->valueOr(2) * 1000 / setup.stride, 10.0, 600000.0));
}

} // namespace camwright
