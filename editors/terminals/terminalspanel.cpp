#include "editors/terminals/terminalspanel.h"

#include "editors/shell/context.h"
#include "editors/shell/control.h"
#include "editors/shell/theme.h"
#include "editors/shell/widgets.h"
#include "editors/terminals/terminallamp.h"

#include <QGridLayout>
#include <QLabel>
#include <QScrollArea>
#include <QStackedLayout>

namespace camwright {

namespace {

constexpr int Columns = 4;
constexpr Time RefreshPeriod = 50ms;

QString offlineSentence()
{
    return TerminalsPanel::tr("Go online with the virtual controller to switch its inputs and see its outputs.");
}

} // namespace

TerminalsPanel::TerminalsPanel(Context& context, QWidget* parent)
    : Panel(context, parent), m_layers(new QStackedLayout(this)), m_scroll(new QScrollArea(this))
{
    m_empty = new EmptyState(QStringLiteral("controller"), offlineSentence(), this);
    m_scroll->setObjectName(QStringLiteral("terminals"));
    m_scroll->setWidgetResizable(true);
    m_scroll->setFrameShape(QFrame::NoFrame);
    m_layers->addWidget(m_empty);
    m_layers->addWidget(m_scroll);
    connect(&context, &Context::linkAboutToChange, this, &TerminalsPanel::leave);
    connect(&context, &Context::linkStateChanged, this, [this](LinkState state) { state == LinkState::Online ? follow() : leave(); });
    connect(&context, &Context::linkChanged, this, &TerminalsPanel::follow);
    connect(&context, &Context::programMatchesChanged, this, [this] { leave(); follow(); }); // another program, other terminals
    connect(&context.document(), &ProjectDocument::changed, this, [this](const ProjectChange& change) {
        if (change.touches(ObjectKind::VariableTable))
            refreshNames();
    });
    follow();
}

TerminalsPanel::~TerminalsPanel()
{
    unsubscribe();
}

void TerminalsPanel::unsubscribe()
{
    ++m_generation;
    if (context().link() && m_subscription)
        context().link()->unsubscribe(*m_subscription);
    m_subscription.reset();
}

void TerminalsPanel::leave()
{
    unsubscribe();
    m_empty->setSentence(offlineSentence());
    m_lamps.clear();
    delete m_scroll->takeWidget();
    m_layers->setCurrentIndex(0);
}

void TerminalsPanel::follow()
{
    ControllerLink* link = context().link();
    if (!link || !context().isOnline() || m_subscription)
        return;
    if (!link->capabilities().terminals) {
        m_empty->setSentence(tr("A real controller's inputs are wired. Force a value in the watch table instead."));
        return;
    }
    QPointer<TerminalsPanel> self(this);
    link->terminals([self, generation = ++m_generation](const Result<std::vector<TerminalInfo>>& terminals) {
        if (self && terminals && self->m_generation == generation)
            self->load(*terminals);
    });
}

void TerminalsPanel::load(const std::vector<TerminalInfo>& terminals)
{
    if (terminals.empty()) {
        m_empty->setSentence(tr("The controller has no program yet. Download one to see its terminals."));
        return;
    }
    auto* page = new QWidget;
    auto* grid = new QGridLayout(page);
    grid->setContentsMargins(16, 12, 16, 12);
    grid->setSpacing(8);
    addTerminals(grid, tr("Inputs"), true, terminals);
    addTerminals(grid, tr("Outputs"), false, terminals);
    grid->setColumnStretch(Columns, 1);
    grid->setRowStretch(grid->rowCount(), 1);
    m_scroll->setWidget(page);
    m_layers->setCurrentIndex(1);
    refreshNames();

    std::vector<std::string> names;
    for (const auto& [name, lamp] : m_lamps)
        names.push_back(name);
    m_subscription = context().link()->subscribe(names, RefreshPeriod, [this](const MonitorUpdate& newest) { update(newest); });
}

void TerminalsPanel::addTerminals(QGridLayout* grid, const QString& title, bool inputs, const std::vector<TerminalInfo>& terminals)
{
    int row = grid->rowCount();
    int column = 0;
    for (const TerminalInfo& terminal : terminals) {
        if (terminal.isInput != inputs)
            continue;
        if (column == 0 && row == grid->rowCount()) {
            grid->addWidget(new SectionHeader(title, inputs ? tr("click to switch") : QString()), row, 0, 1, Columns);
            ++row;
        }
        auto* lamp = new TerminalLamp(QString::fromStdString(terminal.name), inputs);
        connect(lamp, &TerminalLamp::switched, this, [this, name = lamp->address()](bool on) { switchInput(name, on); });
        grid->addWidget(lamp, row, column);
        m_lamps[terminal.name] = lamp;
        if (++column == Columns) {
            column = 0;
            ++row;
        }
    }
}

void TerminalsPanel::update(const MonitorUpdate& newest)
{
    for (const MonitoredValue& value : newest.values) {
        if (const auto lamp = m_lamps.find(value.name); lamp != m_lamps.end())
            lamp->second->setOn(value.value.asBool(), value.forced);
    }
}

void TerminalsPanel::switchInput(const QString& name, bool on)
{
    withControl(context(), this, [this, name, on] {
        QPointer<TerminalsPanel> self(this);
        context().link()->write(name.toStdString(), Value::ofBool(on), [self](const Result<void>& done) {
            if (self && !done)
                self->context().notify(done.error());
        });
    });
}

QString TerminalsPanel::symbolOf(const std::string& address) const
{
    for (const ObjectPtr& table : context().document().project().objects(ObjectKind::VariableTable)) {
        for (const auto& chunk : std::get<VariableTable>(table->content).chunks) {
            for (const Variable& variable : *chunk) {
                if (variable.address == address)
                    return QString::fromStdString(variable.name);
            }
        }
    }
    return {};
}

void TerminalsPanel::refreshNames()
{
    for (const auto& [name, lamp] : m_lamps)
        lamp->setSymbol(symbolOf(name));
}

} // namespace camwright
