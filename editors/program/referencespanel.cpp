#include "editors/program/referencespanel.h"

#include "editors/program/referencesmodel.h"
#include "editors/shell/widgets.h"

#include <QClipboard>
#include <QGuiApplication>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QKeyEvent>
#include <QStackedLayout>
#include <QTableView>

namespace camwright {

namespace {

constexpr int FollowDelayMs = 300;

/// Bytes before a place of a text, lines and columns from 1.
std::size_t offsetOf(const std::string& text, const TextRange& range)
{
    std::size_t at = 0;
    for (std::uint32_t line = 1; line < range.line; ++line) {
        const std::size_t end = text.find('\n', at);
        if (end == std::string::npos)
            return text.size();
        at = end + 1;
    }
    return std::min(at + (range.column == 0 ? 0 : range.column - 1), text.size());
}

} // namespace

ReferencesPanel::ReferencesPanel(Context& context, QWidget* parent)
    : Panel(context, parent), m_model(new ReferencesModel(this)), m_table(new QTableView(this)),
      m_empty(new EmptyState(QStringLiteral("references"), tr("Shift+F12 at a name or an address lists where it is used."), this)),
      m_layers(new QStackedLayout(this)), m_tools(new QWidget(this)), m_summary(new QLabel(m_tools))
{
    setObjectName(QStringLiteral("referencesPanel"));
    buildTable();
    m_layers->addWidget(m_empty);
    m_layers->addWidget(m_table);
    auto* row = new QHBoxLayout(m_tools);
    row->setContentsMargins(0, 0, 0, 0);
    row->addWidget(m_summary);
    m_summary->setObjectName(QStringLiteral("referencesSummary"));
    m_delay.setSingleShot(true);
    m_delay.setInterval(FollowDelayMs);
    connect(&m_delay, &QTimer::timeout, this, &ReferencesPanel::follow);
    connect(&context, &Context::referencesRequested, this, [this] {
        m_takeFocus = true;
        follow();
    });
    connect(&context.document(), &ProjectDocument::changed, this, [this] { m_delay.start(); });
    m_takeFocus = !(context.sought() == Selection());
    follow();
}

void ReferencesPanel::buildTable()
{
    describe(m_table, "referencesTable", tr("References"), tr("Where the thing is used. Enter goes to the place, Esc back to where you asked."));
    m_table->setModel(m_model);
    m_table->setSelectionBehavior(QAbstractItemView::SelectRows);
    m_table->setEditTriggers(QAbstractItemView::NoEditTriggers);
    m_table->setShowGrid(false);
    m_table->setTabKeyNavigation(false);
    m_table->setWordWrap(false);
    m_table->verticalHeader()->hide();
    m_table->verticalHeader()->setDefaultSectionSize(Theme::TableRow);
    m_table->horizontalHeader()->setStretchLastSection(true);
    m_table->horizontalHeader()->setHighlightSections(false);
    m_table->setColumnWidth(ReferencesModel::Use, 230);
    m_table->setColumnWidth(ReferencesModel::Where, 260);
    m_table->installEventFilter(this);
    connect(m_table, &QTableView::activated, this, [this](const QModelIndex& index) { go(index.row()); });
    connect(m_table, &QTableView::doubleClicked, this, [this](const QModelIndex& index) { go(index.row()); });
    connect(m_table->selectionModel(), &QItemSelectionModel::selectionChanged, this, &Panel::abilitiesChanged);
}

ReferencesPanel::Found ReferencesPanel::search(const Project& project, const Selection& sought)
{
    const auto known = contextOf(project);
    if (!known)
        return {};
    std::optional<ReferenceTarget> target;
    const auto* program = project.content<Program>(sought.place.object);
    if (program && sought.place.range.isValid())
        target = targetAt(*known, sought.place.object.name, program->source, offsetOf(program->source, sought.place.range));
    // Edits above the place move it away; the word is still what was asked for.
    const std::string symbol = sought.symbol.toStdString();
    const auto named = symbol.empty() ? std::nullopt : targetNamed(*known, symbol);
    if (!target || (named && match(*named, *target) == ReferenceMatch::None))
        target = named ? named : target;
    if (!target)
        return {};
    return {QString::fromStdString(nameOf(*known, *target)), referencesTo(*target, crossReference(project))};
}

void ReferencesPanel::follow()
{
    const Selection sought = context().sought();
    if (sought == Selection() || (!isVisible() && !m_takeFocus))
        return;
    if (m_running) {
        m_again = true;
        return;
    }
    m_running = true;
    context().runInBackground<Found>(this, [project = context().document().project(), sought] { return search(project, sought); },
        [this](const Found& found) {
            m_running = false;
            take(found);
            if (m_again) {
                m_again = false;
                follow();
            }
        });
}

void ReferencesPanel::take(const Found& found)
{
    const int row = m_table->currentIndex().row();
    m_model->setReferences(found.references);
    m_layers->setCurrentIndex(found.references.empty() ? 0 : 1);
    m_empty->setSentence(found.name.isEmpty() ? tr("\"%1\" is no variable, address, axis or subroutine.").arg(context().sought().symbol)
                                              : tr("Nothing uses %1.").arg(found.name));
    m_summary->setText(found.references.empty() ? QString()
            : tr("%1: read %2, written %3, overlaps %4").arg(found.name).arg(m_model->count(UseKind::Reads)).arg(m_model->count(UseKind::Writes)).arg(m_model->overlaps()));
    if (!found.references.empty())
        m_table->selectRow(std::clamp(row, 0, m_model->rowCount() - 1));
    if (m_takeFocus && !found.references.empty())
        m_table->setFocus(Qt::OtherFocusReason);
    m_takeFocus = false;
    emit badgeChanged();
    emit abilitiesChanged();
    emit listed();
}

void ReferencesPanel::go(int row)
{
    if (row >= 0 && row < m_model->rowCount())
        context().reveal(m_model->reference(row).use.place);
}

bool ReferencesPanel::eventFilter(QObject* watched, QEvent* event)
{
    if (watched == m_table && event->type() == QEvent::KeyPress && static_cast<QKeyEvent*>(event)->key() == Qt::Key_Escape
        && context().sought().place != Place()) {
        context().reveal(context().sought().place);
        return true;
    }
    return Panel::eventFilter(watched, event);
}

void ReferencesPanel::showEvent(QShowEvent* event)
{
    Panel::showEvent(event);
    m_delay.start(); // the project may have changed meanwhile
}

int ReferencesPanel::badge() const
{
    return m_model->rowCount();
}

bool ReferencesPanel::can(const QString& actionId) const
{
    return actionId == QLatin1String("edit.copy") && m_table->selectionModel()->hasSelection();
}

void ReferencesPanel::perform(const QString& actionId)
{
    if (actionId == QLatin1String("edit.copy"))
        copySelected();
}

void ReferencesPanel::copySelected() const
{
    QStringList lines;
    for (const QModelIndex& index : m_table->selectionModel()->selectedRows()) {
        QStringList cells;
        for (int column = 0; column < ReferencesModel::ColumnCount; ++column)
            cells << index.siblingAtColumn(column).data().toString();
        lines << cells.join(QLatin1Char('\t'));
    }
    QGuiApplication::clipboard()->setText(lines.join(QLatin1Char('\n')));
}

} // namespace camwright
