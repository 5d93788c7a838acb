#include "app/window/downloaddialog.h"

#include "editors/shell/context.h"
#include "editors/shell/widgets.h"
#include "editors/words/words.h"

#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QPointer>
#include <QProgressBar>
#include <QPushButton>
#include <QTableWidget>
#include <QVBoxLayout>

namespace camwright {

DownloadDialog::DownloadDialog(Context& context, DownloadPackage package, QWidget* parent)
    : QDialog(parent), m_context(context), m_package(std::move(package))
{
    setObjectName(QStringLiteral("downloadDialog"));
    setWindowTitle(tr("Download"));
    setAttribute(Qt::WA_DeleteOnClose);
    resize(560, 380);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(20, 18, 20, 16);
    column->setSpacing(12);
    m_head = new QLabel(tr("Asking the controller what would change."), this);
    m_head->setFont(theme().boldFont());
    m_head->setWordWrap(true);
    column->addWidget(m_head);
    m_table = new QTableWidget(0, 2, this);
    describe(m_table, "downloadPlan", tr("Download plan"), tr("What the download changes, stops and loses."));
    m_table->setHorizontalHeaderLabels({tr("What"), tr("Effect")});
    m_table->horizontalHeader()->setSectionResizeMode(0, QHeaderView::ResizeToContents);
    m_table->horizontalHeader()->setSectionResizeMode(1, QHeaderView::Stretch);
    m_table->horizontalHeader()->setDefaultAlignment(Qt::AlignLeft | Qt::AlignVCenter);
    m_table->verticalHeader()->hide();
    m_table->verticalHeader()->setDefaultSectionSize(Theme::TableRow + 2);
    m_table->setEditTriggers(QAbstractItemView::NoEditTriggers);
    m_table->setSelectionMode(QAbstractItemView::NoSelection);
    m_table->setShowGrid(false);
    column->addWidget(m_table, 1);
    m_progress = new QProgressBar(this);
    m_progress->setAccessibleName(tr("Progress of the download"));
    m_progress->setRange(0, 1000);
    m_progress->setTextVisible(false);
    m_progress->hide();
    column->addWidget(m_progress);
    m_message = new QLabel(this);
    m_message->setWordWrap(true);
    m_message->hide();
    column->addWidget(m_message);
    auto* buttons = new QHBoxLayout;
    buttons->addStretch();
    m_keep = new QPushButton(tr("Keep It"), this);
    describe(m_keep, "downloadKeep", tr("Keep it"), tr("Leaves the controller's program as it is."));
    m_go = new QPushButton(tr("Overwrite the Controller"), this);
    describe(m_go, "downloadGo", tr("Overwrite the controller"), tr("Sends the program. The controller stands in STOP afterwards."));
    makePrimary(m_go);
    m_go->setEnabled(false);
    m_go->setDefault(true);
    buttons->addWidget(m_keep);
    buttons->addWidget(m_go);
    column->addLayout(buttons);
    connect(m_keep, &QPushButton::clicked, this, &DownloadDialog::reject);
    connect(m_go, &QPushButton::clicked, this, &DownloadDialog::start);
    connect(&context, &Context::linkAboutToChange, this, [this] {
        m_sending = false;
        close();
    });
    QPointer<DownloadDialog> self(this);
    m_request = context.link()->planDownload(m_package, [self](Result<DownloadPlan> plan) {
        if (!self)
            return;
        if (plan)
            self->showPlan(*plan);
        else
            self->tell(words::sentence(plan.error()), true);
    });
}

void DownloadDialog::showPlan(const DownloadPlan& plan)
{
    m_head->setText(plan.sameProgram ? tr("The controller already has this program. Sending it again changes only what is listed.")
            : plan.mustStop          ? tr("The controller's program is replaced. It stops first, and stands in STOP afterwards.")
                                     : tr("The controller's program is replaced. It stands in STOP afterwards."));
    m_table->setRowCount(int(plan.lines.size()));
    for (int row = 0; row < int(plan.lines.size()); ++row) {
        const PlanLine& line = plan.lines[std::size_t(row)];
        const QString effect = line.message.arguments.empty() ? QString::fromStdString(line.effect) : words::sentence(line.message);
        m_table->setItem(row, 0, new QTableWidgetItem(QString::fromStdString(line.what)));
        m_table->setItem(row, 1, new QTableWidgetItem(effect));
    }
    if (plan.lines.empty()) {
        m_table->setRowCount(1);
        m_table->setItem(0, 0, new QTableWidgetItem(tr("nothing")));
        m_table->setItem(0, 1, new QTableWidgetItem(tr("nothing changes")));
    }
    m_go->setEnabled(true);
    m_go->setFocus();
}

void DownloadDialog::start()
{
    m_sending = true;
    m_go->setEnabled(false);
    m_keep->setText(tr("Cancel"));
    m_keep->setToolTip(tr("Ends the transfer; the old program stays as it is."));
    m_progress->show();
    m_head->setText(tr("Sending. The old program stays until the last byte is verified."));
    QPointer<DownloadDialog> self(this);
    m_request = m_context.link()->download(
        m_package, [self](double fraction) { if (self) self->m_progress->setValue(int(fraction * 1000)); },
        [self](Result<void> result) { if (self) self->finished(result); });
}

void DownloadDialog::finished(const Result<void>& result)
{
    m_sending = false;
    if (!result) {
        tell(words::sentence(result.error()), true);
        m_keep->setText(tr("Close"));
        return;
    }
    m_context.notify(Severity::Information, tr("Downloaded. The controller stands in STOP."));
    emit downloaded();
    accept();
}

void DownloadDialog::tell(const QString& sentence, bool error)
{
    m_message->setProperty("tone", error ? "error" : "dim");
    m_message->setText(sentence);
    m_message->show();
    if (error)
        m_head->setText(tr("Nothing was changed."));
    m_progress->hide();
}

void DownloadDialog::reject()
{
    if (m_context.link())
        m_context.link()->cancel(m_request);
    if (m_sending)
        m_context.notify(Severity::Information, tr("Download cancelled. The controller keeps its program."));
    QDialog::reject();
}

} // namespace camwright
