#include "editors/trace/tracepanel.h"

#include "core/online/valuename.h"
#include "editors/shell/context.h"
#include "editors/shell/icons.h"
#include "editors/shell/quantityfield.h"
#include "editors/shell/widgets.h"
#include "editors/trace/channellist.h"
#include "editors/trace/scopeplot.h"
#include "editors/trace/tracecsv.h"
#include "editors/trace/tracestatistics.h"
#include "editors/trace/triggerbar.h"

#include <QComboBox>
#include <QFileDialog>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSaveFile>
#include <QShortcut>
#include <QSplitter>
#include <QStackedWidget>
#include <QTableView>
#include <QVBoxLayout>

#include <algorithm>

namespace camwright {

namespace {

constexpr int RedrawMs = 33;
constexpr double FirstSpan = 10.0; // seconds of a live recording in view
constexpr std::uint64_t KeptRows = 3'600'000; // an hour of milliseconds

} // namespace

TracePanel::TracePanel(Context& context, QWidget* parent)
    : Panel(context, parent), m_buffer(KeptRows), m_plot(new ScopePlot(m_buffer, this)), m_channels(new ChannelListModel(m_buffer, this))
{
    auto* split = new QSplitter(Qt::Horizontal, this);
    split->setChildrenCollapsible(false);
    split->addWidget(buildChannels());
    split->addWidget(buildCurves());
    split->setStretchFactor(1, 1);
    split->setSizes({380, 1000});
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(8, 6, 8, 4);
    layout->setSpacing(4);
    layout->addWidget(buildTopBar());
    layout->addWidget(split, 1);
    layout->addWidget(buildStatistics());
    connectParts();
    refreshPresets();
    refreshState();
    m_redraw.setInterval(RedrawMs);
}

QWidget* TracePanel::buildTopBar()
{
    auto* bar = new QWidget(this);
    m_record = new QPushButton(bar);
    describe(m_record, "recordTrace", tr("Record"), tr("Start or end a recording of the channels"));
    m_presets = new QComboBox(bar);
    describe(m_presets, "tracePresets", tr("Preset"), tr("Fills in the channels that belong together"));
    m_trigger = new TriggerBar(bar);
    m_live = new SegmentedControl(tr("Live"), bar);
    m_live->setObjectName(QStringLiteral("liveOrPause"));
    m_live->addSegment(tr("Live"), QStringLiteral("run"), tr("The newest samples stay in view"));
    m_live->addSegment(tr("Pause"), QStringLiteral("pause"), tr("The view stays; the recording goes on"));
    m_live->setCurrentIndex(0);
    m_arrangement = new SegmentedControl(tr("Arrangement"), bar);
    m_arrangement->setObjectName(QStringLiteral("traceArrangement"));
    m_arrangement->addSegment(tr("Stacked"), {}, tr("A lane for each channel"));
    m_arrangement->addSegment(tr("Overlaid"), {}, tr("All channels in one lane"));
    m_arrangement->setCurrentIndex(0);
    m_state = new Pill(bar);
    auto* fit = new QPushButton(icon(QStringLiteral("zoom-fit")), tr("Fit"), bar);
    describe(fit, "fitTrace", tr("Fit"), tr("Show the whole recording (double-click in the curves)"));
    connect(fit, &QPushButton::clicked, this, [this] { setLive(false); m_plot->fit(); });
    m_export = new QPushButton(icon(QStringLiteral("export")), tr("CSV..."), bar);
    describe(m_export, "exportTrace", tr("Export as CSV"), tr("Write the recording to a CSV file"));
    connect(m_export, &QPushButton::clicked, this, &TracePanel::exportCsv);
    auto* row = new QHBoxLayout(bar);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(8);
    for (QWidget* widget : std::initializer_list<QWidget*>{m_record, m_presets, m_trigger, m_state})
        row->addWidget(widget);
    row->addStretch();
    for (QWidget* widget : std::initializer_list<QWidget*>{m_arrangement, m_live, fit, m_export})
        row->addWidget(widget);
    return bar;
}

QWidget* TracePanel::buildChannels()
{
    auto* side = new QWidget(this);
    side->setMinimumWidth(220);
    m_list = new QTableView(side);
    describe(m_list, "traceChannels", tr("Channels"), tr("What is recorded; the mark shows or hides a curve"));
    m_list->setModel(m_channels);
    m_list->setSelectionBehavior(QAbstractItemView::SelectRows);
    m_list->setShowGrid(false);
    m_list->setTextElideMode(Qt::ElideLeft); // the end of a name tells more
    m_list->verticalHeader()->hide();
    m_list->verticalHeader()->setDefaultSectionSize(Theme::TableRow);
    m_list->horizontalHeader()->setSectionResizeMode(ChannelListModel::Name, QHeaderView::Stretch);
    m_list->setColumnWidth(ChannelListModel::AtA, 80);
    m_list->setColumnWidth(ChannelListModel::AtB, 80);
    m_newChannel = new QLineEdit(side);
    describe(m_newChannel, "newChannel", tr("Add a channel"), tr("Address, variable or axis value like axis.Feed.position; Enter adds it"));
    m_newChannel->setPlaceholderText(tr("Add a channel"));
    auto* layout = new QVBoxLayout(side);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(4);
    layout->addWidget(m_list, 1);
    layout->addWidget(m_newChannel);
    return side;
}

QWidget* TracePanel::buildCurves()
{
    m_curves = new QStackedWidget(this);
    m_empty = new EmptyState(QStringLiteral("trace"), {}, m_curves);
    m_curves->addWidget(m_empty);
    m_curves->addWidget(m_plot);
    return m_curves;
}

QWidget* TracePanel::buildStatistics()
{
    m_statistics = new QLabel(this);
    m_statistics->setObjectName(QStringLiteral("traceStatistics"));
    m_statistics->setFont(theme().monoFont());
    m_statistics->setTextInteractionFlags(Qt::TextSelectableByMouse);
    return m_statistics;
}

void TracePanel::connectParts()
{
    connect(m_record, &QPushButton::clicked, this, [this] { m_recording ? stop() : start(); });
    connect(m_presets, &QComboBox::activated, this, &TracePanel::presetChosen);
    connect(m_newChannel, &QLineEdit::returnPressed, this, [this] {
        QStringList names;
        for (const std::string& name : splitValueNames(m_newChannel->text().toStdString()))
            names << QString::fromStdString(name);
        addChannels(names);
        m_newChannel->clear();
    });
    connect(m_live, &SegmentedControl::chosen, this, [this](int index) { setLive(index == 0); });
    connect(m_arrangement, &SegmentedControl::chosen, this, [this](int index) { m_plot->setOverlaid(index == 1); });
    connect(m_plot, &ScopePlot::cursorsMoved, this, &TracePanel::refreshStatistics);
    connect(m_plot, &ScopePlot::userNavigated, this, [this] { setLive(false); });
    connect(m_channels, &ChannelListModel::shownChanged, this, [this](int row, bool shown) {
        if (m_channels->recorded(row) >= 0)
            m_plot->setLaneVisible(static_cast<std::size_t>(m_channels->recorded(row)), shown);
    });
    connect(m_list->selectionModel(), &QItemSelectionModel::selectionChanged, this, [this] {
        m_plot->setSelected(static_cast<std::size_t>(std::max(0, selectedChannel())));
        refreshStatistics();
    });
    auto* remove = new QShortcut(QKeySequence::Delete, m_list);
    remove->setContext(Qt::WidgetShortcut);
    connect(remove, &QShortcut::activated, this, &TracePanel::removeSelectedChannels);
    connect(&m_redraw, &QTimer::timeout, this, &TracePanel::refreshPlot);
    connect(&context().document(), &ProjectDocument::changed, this, [this](const ProjectChange& change) {
        if (change.everything) // the channels of another project mean nothing here
            addChannelsAnew({});
        if (change.listChanged || change.everything)
            refreshPresets();
    });
    connect(&context(), &Context::linkStateChanged, this, [this](LinkState state) {
        m_recording = m_recording && state == LinkState::Online; // a lost link never resumes a recording by itself
        refreshState();
    });
    connect(&context(), &Context::linkChanged, this, &TracePanel::refreshState);
}

// Channels

void TracePanel::refreshPresets()
{
    m_presets->clear();
    m_presets->addItem(tr("Preset"));
    for (const ObjectPtr& axis : context().document().project().objects(ObjectKind::Axis))
        m_presets->addItem(tr("Move of %1").arg(QString::fromStdString(axis->key.name)), QString::fromStdString(axis->key.name));
    m_presets->setEnabled(m_presets->count() > 1);
    if (m_channels->channels().empty() && m_presets->count() > 1)
        presetChosen(1);
}

void TracePanel::presetChosen(int index)
{
    if (index <= 0)
        return;
    const std::string axis = m_presets->itemData(index).toString().toStdString();
    QStringList names;
    for (const char* value : {"setPosition", "position", "velocity", "followingError", "torque", "state"})
        names << QString::fromStdString(axisValueName(axis, value));
    addChannelsAnew(names);
    m_presets->setCurrentIndex(0);
}

void TracePanel::addChannelsAnew(const QStringList& names)
{
    m_channels->setChannels({});
    addChannels(names);
}

void TracePanel::addChannels(const QStringList& names)
{
    std::vector<std::string> channels = m_channels->channels();
    for (const QString& name : names) {
        const std::string text = name.trimmed().toStdString();
        if (!text.empty() && std::ranges::find(channels, text) == channels.end())
            channels.push_back(text);
    }
    m_channels->setChannels(channels);
    m_trigger->setChannels(channels);
    refreshState();
}

void TracePanel::removeSelectedChannels()
{
    std::vector<std::string> left;
    for (int row = 0; row < m_channels->rowCount(); ++row) {
        if (!m_list->selectionModel()->isRowSelected(row))
            left.push_back(m_channels->channels()[static_cast<std::size_t>(row)]);
    }
    m_channels->setChannels(left);
    m_trigger->setChannels(left);
    refreshState();
}

int TracePanel::selectedChannel() const
{
    const QModelIndexList rows = m_list->selectionModel()->selectedRows();
    const int row = rows.isEmpty() ? 0 : rows.first().row();
    return row < m_channels->rowCount() ? m_channels->recorded(row) : -1;
}

// Recording

void TracePanel::start()
{
    if (!context().isOnline() || m_channels->channels().empty())
        return;
    if (QuantityField* wrong = m_trigger->wrongField()) {
        wrong->lineEdit()->setFocus(Qt::OtherFocusReason);
        context().notify(Severity::Error, wrong->problem());
        return;
    }
    TraceSetup setup;
    setup.channels = m_channels->channels();
    m_trigger->apply(setup);
    m_buffer.clear();
    const std::string& running = context().status().family;
    m_family = running.empty() ? context().document().project().controller().family : running;
    m_channels->setFamily(m_family);
    m_plot->setFamily(m_family);
    m_plot->rebuild(); // the curves of the recording before do not stand for this one
    m_recording = m_isFirstLook = true;
    setLive(true);
    QPointer<TracePanel> self(this);
    context().link()->startTrace(
        setup, [self](const SampleBlock& block) { if (self) self->take(block); },
        [self](const Result<void>& started) {
            if (!self || started)
                return;
            self->m_recording = false;
            self->context().notify(started.error());
            self->refreshState();
        });
    m_redraw.start();
    refreshState();
}

void TracePanel::stop()
{
    m_recording = false;
    if (context().link())
        context().link()->stopTrace([](const Result<void>&) {}); // a link that is gone has stopped it already
    refreshState();
}

void TracePanel::take(const SampleBlock& block)
{
    m_buffer.append(block);
    m_dirty = true;
    if (!block.last)
        return;
    m_recording = false;
    refreshPlot();
    setLive(false);
    m_plot->fit();
    m_plot->placeCursorsInView();
    refreshState();
}

void TracePanel::refreshPlot()
{
    if (!m_recording)
        m_redraw.stop();
    if (!std::exchange(m_dirty, false))
        return;
    m_plot->refresh(m_following);
    for (int row = 0; row < m_channels->rowCount(); ++row) {
        if (m_channels->recorded(row) >= 0)
            m_plot->setLaneVisible(static_cast<std::size_t>(m_channels->recorded(row)), m_channels->isShown(row));
    }
    if (std::exchange(m_isFirstLook, false)) {
        const double newest = m_plot->timeRange().upper;
        if (m_plot->timeRange().size() <= 1.0)
            m_plot->setTimeRange(QCPRange(newest - FirstSpan, newest));
        m_plot->placeCursorsInView();
    }
    refreshStatistics();
    refreshState();
}

// Showing

void TracePanel::setLive(bool live)
{
    m_following = live;
    m_live->setCurrentIndex(live ? 0 : 1);
}

void TracePanel::refreshState()
{
    const bool online = context().isOnline();
    const bool able = online && context().link()->capabilities().trace && !m_channels->channels().empty();
    m_record->setEnabled(m_recording || able);
    m_record->setText(m_recording ? tr("End") : tr("Record"));
    m_record->setIcon(icon(m_recording ? QStringLiteral("stop") : QStringLiteral("run")));
    m_export->setEnabled(m_buffer.rows() > 0);
    if (m_recording && m_buffer.triggerCycle() < 0 && m_buffer.rows() == 0)
        m_state->setContent(tr("waiting"), Role::Warn, Role::WarnSoft);
    else if (m_recording)
        m_state->setContent(tr("recording, %1 samples").arg(m_buffer.rows()), Role::Ok, Role::OkSoft);
    else if (!online)
        m_state->setContent(tr("offline"), Role::Dim, Role::FineLine);
    else
        m_state->setContent(m_buffer.rows() > 0 ? tr("%1 samples").arg(m_buffer.rows()) : tr("ready"), Role::Dim, Role::FineLine);
    m_state->updateGeometry();
    refreshEmpty();
}

void TracePanel::refreshEmpty()
{
    m_curves->setCurrentIndex(m_buffer.rows() > 0 ? 1 : 0);
    if (m_recording)
        m_empty->setSentence(tr("The curves appear as soon as the recording has samples."));
    else if (m_channels->channels().empty())
        m_empty->setSentence(tr("Add a channel or choose a preset, then press Record to see it in every motion cycle."));
    else if (!context().isOnline())
        m_empty->setSentence(tr("Go online, then press Record to see the channels in every motion cycle."));
    else
        m_empty->setSentence(tr("Press Record to see the channels in every motion cycle."));
}

void TracePanel::refreshStatistics()
{
    const std::uint64_t a = m_plot->cursorCycle(0), b = m_plot->cursorCycle(1);
    m_channels->setCursors(a, b);
    const int channel = selectedChannel();
    if (channel < 0 || m_buffer.rows() == 0) {
        m_statistics->setText(tr("Record, then drag the two cursors to measure."));
        return;
    }
    const ChannelInfo& info = m_buffer.channels()[static_cast<std::size_t>(channel)];
    if (const StateNames names = StateNames::of(info, m_family); names.hasNames()) {
        m_statistics->setText(stateSummary(static_cast<std::size_t>(channel), names));
        return;
    }
    const TraceStatistics s = statisticsBetween(m_buffer, static_cast<std::size_t>(channel), a, b);
    const auto number = [](double value) { return QString::number(value, 'f', 3); };
    const auto optional = [&](const std::optional<double>& value) { return value ? number(*value) : QStringLiteral("–"); };
    const auto known = [&](double value) { return s.samples ? number(value) : QStringLiteral("–"); };
    const QString unit = QString::fromStdString(info.unit);
    m_statistics->setText(tr("%1   A %2   B %3   Δt %4 s   Δy %5 %6   min %7   max %8   mean %9")
        .arg(QString::fromStdString(info.name), optional(s.atA), optional(s.atB), number(s.deltaTime), optional(s.deltaValue()), unit,
            known(s.minimum), known(s.maximum), known(s.mean))
        + tr("   RMS %1   slope %2 %3/s").arg(known(s.rms), known(s.slope), unit));
}

/// A mean of states means nothing: their names do.
QString TracePanel::stateSummary(std::size_t channel, const StateNames& names) const
{
    const std::uint64_t a = m_plot->cursorCycle(0), b = m_plot->cursorCycle(1);
    const auto name = [&](std::uint64_t cycle) {
        const auto value = m_buffer.valueAt(channel, cycle);
        return value ? names.name(*value) : QStringLiteral("–");
    };
    const double apart = (static_cast<double>(b) - static_cast<double>(a)) * static_cast<double>(m_buffer.cycleNs()) * 1e-9;
    return tr("%1   A %2   B %3   Δt %4 s").arg(QString::fromStdString(m_buffer.channels()[channel].name), name(a), name(b), QString::number(apart, 'f', 3));
}

QByteArray TracePanel::toCsv() const
{
    return traceCsv(m_buffer);
}

void TracePanel::exportCsv()
{
    const QString file = QFileDialog::getSaveFileName(this, tr("Export the Recording"), QStringLiteral("trace.csv"), tr("CSV files (*.csv)"));
    if (!file.isEmpty())
        exportTo(file);
}

bool TracePanel::exportTo(const QString& file)
{
    QSaveFile out(file);
    const QByteArray csv = toCsv();
    const bool written = out.open(QIODevice::WriteOnly) && out.write(csv) == csv.size() && out.commit();
    if (written)
        context().notify(Severity::Information, tr("The recording is in \"%1\".").arg(file));
    else
        context().notify(Severity::Error, tr("\"%1\" cannot be written: %2. Choose another folder.").arg(file, out.errorString()));
    return written;
}

} // namespace camwright
