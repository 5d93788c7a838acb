#include "editors/program/livetext.h"

#include "core/online/messages.h"
#include "editors/program/ilcodeview.h"
#include "editors/shell/context.h"

#include <QLocale>
#include <QPointer>

#include <algorithm>
#include <set>

namespace camwright {

namespace {

constexpr int FollowDelayMs = 40;
constexpr Time Period = 100ms;

LineState stateBefore(const IlCodeView& view, int line)
{
    return line == 0 ? LineState::Code
                     : static_cast<LineState>(view.SendScintilla(QsciScintilla::SCI_GETLINESTATE, static_cast<unsigned long>(line - 1)));
}

int startOf(const IlCodeView& view, int line)
{
    return static_cast<int>(view.SendScintilla(QsciScintilla::SCI_POSITIONFROMLINE, static_cast<unsigned long>(line)));
}

QString textOf(const Value& value)
{
    return QString::fromStdString(formatValue(value));
}

} // namespace

LiveText::LiveText(Context& context, IlCodeView& view, ObjectKey key)
    : QObject(&view), m_context(context), m_view(view), m_key(std::move(key))
{
    m_delay.setSingleShot(true);
    m_delay.setInterval(FollowDelayMs);
    connect(&m_delay, &QTimer::timeout, this, &LiveText::refresh);
    const auto later = [this] { m_delay.start(); };
    connect(&view, &IlCodeView::viewChanged, this, later);
    connect(&context.document(), &ProjectDocument::changed, this, later);
    connect(&context, &Context::linkAboutToChange, this, &LiveText::unsubscribe);
    const auto anew = [this] {
        unsubscribe();
        refresh();
    };
    connect(&context, &Context::linkChanged, this, anew);
    connect(&context, &Context::linkStateChanged, this, anew);
    connect(&context, &Context::programMatchesChanged, this, anew);
    refresh();
}

LiveText::~LiveText()
{
    unsubscribe();
}

void LiveText::setKey(const ObjectKey& key)
{
    m_key = key;
}

void LiveText::setActive(bool active)
{
    if (m_active == active)
        return;
    m_active = active;
    if (!active)
        unsubscribe();
    m_delay.start();
}

LiveText::State LiveText::stateNow() const
{
    const ControllerLink* link = m_context.link();
    if (!link || link->state() == LinkState::Offline || link->state() == LinkState::Connecting)
        return State::Off;
    if (link->state() == LinkState::Lost)
        return State::Lost;
    return m_context.programMatches() ? State::Live : State::Different;
}

void LiveText::refresh()
{
    m_state = stateNow();
    if (m_state == State::Off)
        m_values.clear();
    readOperands();
    if (m_state != State::Live || !m_active) {
        unsubscribe();
    } else if (std::vector<std::string> wanted = names(); wanted != m_names || !m_subscription) {
        unsubscribe();
        subscribe(std::move(wanted));
    }
    show();
}

void LiveText::readOperands()
{
    m_operands.clear();
    const auto known = m_state == State::Off ? std::nullopt : contextOf(m_context.document().project());
    if (!known)
        return;
    const auto [first, last] = m_view.visibleLines();
    const int begin = startOf(m_view, first);
    const int end = static_cast<int>(m_view.SendScintilla(QsciScintilla::SCI_GETLINEENDPOSITION, static_cast<unsigned long>(last)));
    if (begin < 0 || end <= begin)
        return;
    const QByteArray text = m_view.bytes(begin, end).chopped(1);
    m_operands = liveOperands(*known, {text.constData(), static_cast<std::size_t>(text.size())}, stateBefore(m_view, first), static_cast<std::uint32_t>(first + 1));
}

std::vector<std::string> LiveText::names() const
{
    std::set<std::string> out;
    for (const LiveOperand& operand : m_operands)
        if (out.size() + operand.names.size() <= message::MaximumNames)
            out.insert(operand.names.begin(), operand.names.end());
    return {out.begin(), out.end()};
}

void LiveText::subscribe(std::vector<std::string> wanted)
{
    m_names = std::move(wanted);
    if (m_names.empty() || !m_context.link())
        return;
    QPointer<LiveText> self(this);
    const unsigned generation = m_generation;
    m_subscription = m_context.link()->subscribe(m_names, Period, [self, generation](const MonitorUpdate& update) {
        if (self && self->m_generation == generation)
            self->take(update);
    });
}

void LiveText::unsubscribe()
{
    ++m_generation;
    if (m_context.link() && m_subscription)
        m_context.link()->unsubscribe(*m_subscription);
    m_subscription.reset();
    m_names.clear();
}

void LiveText::take(const MonitorUpdate& update)
{
    for (const MonitoredValue& value : update.values)
        m_values[value.name] = value;
    m_newest = QDateTime::currentDateTime();
    show();
}

std::optional<MonitoredValue> LiveText::valueOf(const LiveOperand& operand) const
{
    std::vector<Value> parts;
    bool forced = false;
    for (const std::string& name : operand.names) {
        const auto found = m_values.find(name);
        if (found == m_values.end())
            return std::nullopt;
        parts.push_back(found->second.value);
        forced = forced || found->second.forced;
    }
    return MonitoredValue{operand.names.front(), liveValue(operand, parts), forced};
}

void LiveText::show()
{
    std::map<int, std::vector<LineValue>> lines;
    for (const LiveOperand& operand : m_operands) {
        const int line = static_cast<int>(operand.line) - 1;
        const auto known = valueOf(operand);
        if (!known)
            continue;
        const bool on = known->value.type == DataType::Bool && known->value.asBool();
        lines[line].push_back({QString::fromStdString(operand.pin), textOf(known->value), on, known->forced,
            startOf(m_view, line) + static_cast<int>(operand.column), static_cast<int>(operand.length)});
    }
    for (auto& [line, values] : lines)
        if (values.size() == 1)
            values.front().label.clear();
    m_view.setLineValues(lines, m_state != State::Live);
    const QString time = QLocale().toString(m_newest.time(), QLocale::ShortFormat);
    if (m_values.empty() || m_state == State::Live || m_state == State::Off)
        setNotice({});
    else if (m_state == State::Lost)
        setNotice(tr("The connection to the controller is lost. The values shown are those of %1.").arg(time));
    else
        setNotice(tr("The project was changed since the download. The values shown are those of %1, before the change.").arg(time));
}

void LiveText::setNotice(const QString& sentence)
{
    if (sentence == m_notice)
        return;
    m_notice = sentence;
    emit noticeChanged();
}

QString LiveText::valueAt(int position) const
{
    for (const LiveOperand& operand : m_operands) {
        const int begin = startOf(m_view, static_cast<int>(operand.line) - 1) + static_cast<int>(operand.column);
        const auto known = position >= begin && position <= begin + static_cast<int>(operand.length) ? valueOf(operand) : std::nullopt;
        if (!known)
            continue;
        const QString value = QStringLiteral("%1 = %2").arg(QString::fromStdString(known->name), textOf(known->value));
        return m_state == State::Live ? value : tr("%1, at %2").arg(value, QLocale().toString(m_newest.time(), QLocale::ShortFormat));
    }
    return {};
}

} // namespace camwright
