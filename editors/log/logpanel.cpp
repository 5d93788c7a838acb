#include "editors/log/logpanel.h"

#include "editors/log/logmodel.h"
#include "editors/shell/context.h"
#include "editors/shell/explain.h"
#include "editors/shell/icons.h"
#include "editors/shell/theme.h"
#include "editors/shell/widgets.h"
#include "editors/words/words.h"

#include <QClipboard>
#include <QGuiApplication>
#include <QHeaderView>
#include <QMenu>
#include <QStackedLayout>
#include <QTableView>

#include <algorithm>

namespace camwright {

LogPanel::LogPanel(Context& context, QWidget* parent)
    : Panel(context, parent), m_model(new LogModel(this)), m_table(new QTableView(this)), m_layers(new QStackedLayout(this))
{
    describe(m_table, "controllerLog", tr("Controller log"), tr("What the controller reported, newest first. F1 explains an entry."));
    m_table->setModel(m_model);
    m_table->setSelectionBehavior(QAbstractItemView::SelectRows);
    m_table->setShowGrid(false);
    m_table->verticalHeader()->hide();
    m_table->verticalHeader()->setDefaultSectionSize(Theme::TableRow);
    m_table->horizontalHeader()->setStretchLastSection(true);
    m_table->horizontalHeader()->setDefaultAlignment(Qt::AlignLeft | Qt::AlignVCenter);
    m_table->setColumnWidth(LogModel::When, 130);
    m_table->setColumnWidth(LogModel::Cycle, 90);
    m_table->setColumnWidth(LogModel::CodeId, 100);
    m_explain = new Explain(context, m_table, [this](int row) { return std::optional(m_model->entry(row).message.code); });
    m_explain->setMenu([this](QMenu& menu) {
        menu.addAction(icon(QStringLiteral("copy")), tr("Copy") + QStringLiteral("\tCtrl+C"), this, &LogPanel::copySelected);
        menu.addSeparator();
    });
    m_layers->addWidget(new EmptyState(QStringLiteral("log"), tr("Go online to see what the controller reports."), this));
    m_layers->addWidget(m_table);

    connect(&context, &Context::linkAboutToChange, this, &LogPanel::leave);
    connect(&context, &Context::linkChanged, this, &LogPanel::follow);
    connect(&context, &Context::linkStateChanged, this, [this](LinkState state) {
        if (state == LinkState::Online)
            follow();
    });
    follow();
}

LogPanel::~LogPanel()
{
    forget();
}

void LogPanel::forget()
{
    if (context().link() && m_token != 0)
        context().link()->forget(m_token);
    m_token = 0;
}

void LogPanel::leave()
{
    forget();
    m_model->clear();
    m_layers->setCurrentIndex(0);
}

void LogPanel::follow()
{
    ControllerLink* link = context().link();
    if (!link || !context().isOnline())
        return;
    m_layers->setCurrentIndex(1);
    const std::uint64_t next = m_model->nextSequence();
    if (m_token == 0)
        m_token = link->onLog([this](const LogEntry& entry) { m_model->add({entry}); });
    QPointer<LogPanel> self(this);
    link->log(next, [self](const Result<std::vector<LogEntry>>& entries) {
        if (self && entries)
            self->m_model->add(*entries);
    });
}

bool LogPanel::can(const QString& id) const
{
    if (id == QLatin1String("help.explain"))
        return m_explain->can();
    return id == QLatin1String("edit.copy") && m_table->selectionModel()->hasSelection();
}

void LogPanel::perform(const QString& id)
{
    if (id == QLatin1String("edit.copy"))
        copySelected();
    else if (id == QLatin1String("help.explain"))
        m_explain->explain();
}

void LogPanel::copySelected() const
{
    QStringList lines;
    QModelIndexList rows = m_table->selectionModel()->selectedRows();
    std::ranges::sort(rows, {}, &QModelIndex::row); // as they stand, not as they were picked
    for (const QModelIndex& index : rows) {
        const LogEntry& entry = m_model->entry(index.row());
        lines << QStringLiteral("%1 s\t%2\t%3\t%4").arg(seconds(entry.time), 0, 'f', 3).arg(entry.cycle)
                     .arg(words::codeId(entry.message.code), words::sentence(entry.message));
    }
    QGuiApplication::clipboard()->setText(lines.join(QLatin1Char('\n')));
}

} // namespace camwright
