#include "editors/commissioning/jogpad.h"

#include "editors/commissioning/numbers.h"
#include "editors/commissioning/plainfield.h"
#include "editors/shell/quantityfield.h"
#include "editors/shell/theme.h"
#include "editors/shell/widgets.h"

#include <QHBoxLayout>
#include <QSlider>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>

namespace camwright {

namespace {

constexpr int FirstCapPercent = 5;
constexpr double SlowShare = 0.1;          // of the cap, for the single − and +
constexpr int FieldWidth = 104;

QuantitySpec named(const QString& name)
{
    QuantitySpec out;
    out.name = name;
    return out;
}

} // namespace

JogPad::JogPad(QWidget* parent) : QWidget(parent)
{
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(6);
    column->addWidget(buildHead());
    column->addWidget(buildButtons());
    column->addWidget(buildCap());
    refresh();
}

QWidget* JogPad::buildHead()
{
    auto* head = new QWidget(this);
    auto* row = new QHBoxLayout(head);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(8);
    auto* title = new QLabel(tr("Jog"), head);
    title->setProperty("tone", "group");
    m_mode = new SegmentedControl(tr("Way of jogging"), head);
    m_mode->setObjectName(QStringLiteral("jogMode"));
    m_mode->addSegment(tr("Hold"), {}, tr("The axis moves while the button or key is held, and stops on release."));
    m_mode->addSegment(tr("Step"), {}, tr("Each press moves the axis by the step size."));
    m_hint = new QLabel(head);
    m_hint->setProperty("tone", "caption");
    m_hint->setWordWrap(true);
    m_step = new QuantityField(named(tr("Step size")), head);
    m_step->setObjectName(QStringLiteral("stepSize"));
    row->addWidget(title);
    row->addWidget(m_mode);
    row->addWidget(m_hint, 1);
    m_stepHolder = new PlainField(m_step, FieldWidth, head);
    m_stepHolder->setFixedWidth(FieldWidth);
    row->addWidget(m_stepHolder);
    connect(m_mode, &SegmentedControl::chosen, this, [this] {
        letGoAll();
        refresh();
    });
    return head;
}

QWidget* JogPad::buildButtons()
{
    auto* holder = new QWidget(this);
    auto* row = new QHBoxLayout(holder);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(8);
    const QString names[] = {tr("Jog fast backwards"), tr("Jog slowly backwards"), tr("Jog slowly forwards"), tr("Jog fast forwards")};
    const char* objectNames[] = {"jogFastMinus", "jogMinus", "jogPlus", "jogFastPlus"};
    for (int index = 0; index < 4; ++index) {
        auto* button = new HoldButton(names[index], holder);
        button->setObjectName(QLatin1String(objectNames[index]));
        button->setFixedHeight(52);
        button->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
        connect(button, &HoldButton::held, this, [this, index] { held(index); });
        connect(button, &HoldButton::letGone, this, [this] {
            if (!isStepping())
                emit jogEnded();
        });
        m_buttons[static_cast<std::size_t>(index)] = button;
        row->addWidget(button);
    }
    return holder;
}

QWidget* JogPad::buildCap()
{
    auto* holder = new QWidget(this);
    auto* row = new QHBoxLayout(holder);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(8);
    auto* label = new QLabel(tr("Speed cap"), holder);
    label->setProperty("tone", "dim");
    m_slider = new QSlider(Qt::Horizontal, holder);
    describe(m_slider, "speedCap", tr("Speed cap in per cent of the maximum speed"), tr("No speed of this panel is higher. It starts at 5 %; raise it when the axis behaves."));
    m_slider->setRange(1, 100);
    m_slider->setPageStep(5);
    m_slider->setValue(FirstCapPercent);
    m_slider->setMinimumWidth(80);
    m_percent = new QLabel(holder);
    QFont bold = theme().monoFont();
    bold.setWeight(QFont::DemiBold);
    m_percent->setFont(bold);
    m_percent->setObjectName(QStringLiteral("capPercent"));
    m_capText = new QLabel(holder);
    m_capText->setProperty("tone", "dim");
    m_capText->setObjectName(QStringLiteral("capSpeed"));
    auto* of = new QLabel(tr("Maximum"), holder);
    of->setProperty("tone", "dim");
    m_maximumField = new QuantityField(named(tr("Maximum speed")), holder);
    m_maximumField->setObjectName(QStringLiteral("maximumSpeed"));
    row->addWidget(label);
    row->addWidget(m_slider, 1);
    row->addWidget(m_percent);
    row->addWidget(m_capText);
    row->addSpacing(4);
    row->addWidget(of);
    auto* maximum = new PlainField(m_maximumField, FieldWidth, holder);
    maximum->setFixedWidth(FieldWidth);
    row->addWidget(maximum);
    connect(m_slider, &QSlider::valueChanged, this, &JogPad::capMoved);
    connect(m_maximumField, &QuantityField::edited, this, &JogPad::maximumEdited);
    return holder;
}

void JogPad::setLimits(const AxisLimits& limits)
{
    if (limits == m_limits && m_maximum > 0)
        return;
    const bool first = m_maximum <= 0 || limits.unit != m_limits.unit || limits.perTurn != m_limits.perTurn;
    m_limits = limits;
    QuantitySpec maximum = named(tr("Maximum speed"));
    maximum.unit = tr("%1/s").arg(limits.unit);
    maximum.minimum = limits.perTurn * 1e-4;
    maximum.maximum = limits.highestSpeed;
    maximum.perTurn = limits.perTurn;
    maximum.help = tr("What the speed cap is a share of. A larger one leaves the cap where it is.");
    m_maximumField->setSpec(maximum);
    QuantitySpec step = named(tr("Step size"));
    step.unit = limits.unit;
    step.minimum = 0;
    step.perTurn = limits.perTurn;
    step.help = tr("How far one press moves the axis.");
    m_step->setSpec(step);
    if (first) {
        m_maximum = limits.firstMaxSpeed;
        m_maximumField->setValue(m_maximum);
        m_step->setValue(1);
        setCap(m_maximum * FirstCapPercent / 100);
    }
    refresh();
}

void JogPad::setMovable(bool movable, const QString& why)
{
    for (HoldButton* button : m_buttons) {
        button->setEnabled(movable);
        button->setToolTip(movable ? button->accessibleName() : why);
    }
}

double JogPad::speed(int index) const
{
    const double size = index == 0 || index == 3 ? m_cap : m_cap * SlowShare;
    return index < 2 ? -size : size;
}

bool JogPad::isStepping() const
{
    return m_mode->currentIndex() == 1;
}

double JogPad::step() const
{
    return m_step->problem().isEmpty() ? m_step->valueOr(0) : 0;
}

void JogPad::held(int index)
{
    for (int other = 0; other < 4; ++other) {
        if (other != index && m_buttons[static_cast<std::size_t>(other)]->isHeld()) {
            letGoAll(); // two at once are a contradiction: neither moves
            return;
        }
    }
    if (!isStepping())
        emit jogWanted(speed(index));
    else if (step() > 0)
        emit stepWanted(index < 2 ? -step() : step(), std::abs(speed(index)));
}

void JogPad::hold(int index)
{
    m_buttons[static_cast<std::size_t>(index)]->hold();
}

void JogPad::letGo(int index)
{
    m_buttons[static_cast<std::size_t>(index)]->letGo();
}

void JogPad::letGoAll()
{
    for (HoldButton* button : m_buttons)
        button->letGo();
}

void JogPad::capMoved(int percent)
{
    setCap(m_maximum * percent / 100);
}

void JogPad::maximumEdited()
{
    if (!m_maximumField->problem().isEmpty() || !(m_maximumField->valueOr(0) > 0))
        return; // the field says what is wrong; the last good one counts
    m_maximum = m_maximumField->valueOr(0);
    setCap(std::min(m_cap, m_maximum));
    const QSignalBlocker quiet(m_slider);
    m_slider->setValue(std::max(1, static_cast<int>(std::lround(m_cap / m_maximum * 100))));
}

void JogPad::setCap(double cap)
{
    if (cap != m_cap)
        letGoAll(); // what moves now began under another cap
    m_cap = cap;
    refresh();
    emit capChanged();
}

void JogPad::refresh()
{
    const QString unit = tr("%1/s").arg(m_limits.unit);
    const QString glyphs[] = {QStringLiteral("−−"), QStringLiteral("−"), QStringLiteral("+"), QStringLiteral("++")};
    for (int index = 0; index < 4; ++index) {
        const double size = std::abs(speed(index));
        m_buttons[static_cast<std::size_t>(index)]->setCaption(glyphs[index], QStringLiteral("%1 %2").arg(shownNumber(size, size < 10 ? 2 : 1), unit), QStringLiteral("F%1").arg(index + 1));
    }
    const double share = m_maximum > 0 ? m_cap / m_maximum * 100 : 0;
    m_percent->setText(QStringLiteral("%1 %").arg(shownNumber(share, share < 1 && share > 0 ? 1 : 0)));
    m_capText->setText(QStringLiteral("%1 %2").arg(shownNumber(m_cap, 1), unit));
    m_hint->setText(isStepping() ? tr("each press moves one step") : tr("hold to run, release to stop"));
    m_stepHolder->setVisible(isStepping());
}

} // namespace camwright
