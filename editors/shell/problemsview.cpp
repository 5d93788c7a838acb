#include "editors/shell/problemsview.h"

#include "editors/shell/actions.h"
#include "editors/shell/context.h"
#include "editors/shell/explain.h"
#include "editors/shell/fixes.h"
#include "editors/shell/icons.h"
#include "editors/shell/widgets.h"
#include "editors/words/words.h"

#include <QApplication>
#include <QClipboard>
#include <QHeaderView>
#include <QMenu>
#include <QPainter>
#include <QStackedWidget>
#include <QStyledItemDelegate>
#include <QTableView>
#include <QVBoxLayout>

namespace camwright {

namespace {

constexpr int FixSign = 16; // the lamp behind a sentence that has a quick fix

class ProblemDelegate : public QStyledItemDelegate {
public:
    ProblemDelegate(const Context& context, const ProblemsModel& model, QObject* parent)
        : QStyledItemDelegate(parent), m_context(context), m_model(model)
    {
    }

    void paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const override
    {
        const bool selected = option.state & QStyle::State_Selected;
        painter->save();
        if (selected)
            painter->fillRect(option.rect, theme().color(Role::AccentSoft));
        painter->setPen(theme().color(Role::FineLine));
        painter->drawLine(option.rect.bottomLeft(), option.rect.bottomRight());
        QRect area = option.rect.adjusted(12, 0, -8, 0);
        painter->setPen(theme().color(Role::Text));
        painter->setFont(theme().font());
        if (index.column() == ProblemsModel::SentenceColumn) {
            const auto severity = Severity(index.data(ProblemsModel::SeverityRole).toInt());
            const QString sign = severity == Severity::Error ? QStringLiteral("error") : severity == Severity::Warning ? QStringLiteral("warning") : QStringLiteral("info");
            const Role role = severity == Severity::Error ? Role::Error : severity == Severity::Warning ? Role::Warn : Role::Accent;
            paintIcon(*painter, QRectF(area.left(), area.center().y() - 7, 16, 16), sign, role);
            area.adjust(24, 0, 0, 0);
            if (mayFix(m_context, m_model.problem(index.row()).code)) {
                paintIcon(*painter, QRectF(area.right() - FixSign, area.center().y() - 7, FixSign, FixSign), QStringLiteral("quick-fix"), Role::Accent);
                area.adjust(0, 0, -FixSign - 4, 0);
            }
        } else {
            painter->setPen(theme().color(Role::Dim));
            if (index.column() == ProblemsModel::CodeColumn)
                painter->setFont(theme().monoFont());
        }
        painter->drawText(area, Qt::AlignVCenter, painter->fontMetrics().elidedText(index.data().toString(), Qt::ElideRight, area.width()));
        painter->restore();
    }

private:
    const Context& m_context;
    const ProblemsModel& m_model;
};

} // namespace

ProblemsView::ProblemsView(Context& context, QWidget* parent) : Panel(context, parent), m_model(context.document())
{
    setObjectName(QStringLiteral("problemsView"));
    m_table = new QTableView(this);
    describe(m_table, "problemsTable", tr("Problems"),
        tr("What is wrong with the project. Enter goes to the place, F1 explains the message, and a lamp tells that there is a quick fix."));
    m_table->setModel(&m_model);
    m_table->setItemDelegate(new ProblemDelegate(context, m_model, m_table));
    m_table->setSelectionBehavior(QAbstractItemView::SelectRows);
    m_table->setEditTriggers(QAbstractItemView::NoEditTriggers);
    m_table->setShowGrid(false);
    m_table->setTabKeyNavigation(false);
    m_table->setWordWrap(false);
    m_table->verticalHeader()->hide();
    m_table->verticalHeader()->setDefaultSectionSize(Theme::TableRow + 1);
    m_table->horizontalHeader()->setDefaultAlignment(Qt::AlignLeft | Qt::AlignVCenter);
    m_table->horizontalHeader()->setSectionResizeMode(QHeaderView::Stretch);
    m_table->horizontalHeader()->setSectionResizeMode(ProblemsModel::PlaceColumn, QHeaderView::Interactive);
    m_table->horizontalHeader()->resizeSection(ProblemsModel::PlaceColumn, 230);
    m_table->horizontalHeader()->setSectionResizeMode(ProblemsModel::CodeColumn, QHeaderView::Fixed);
    m_table->horizontalHeader()->resizeSection(ProblemsModel::CodeColumn, 84);
    m_table->horizontalHeader()->setHighlightSections(false);
    connect(m_table, &QTableView::activated, this, [this](const QModelIndex& index) { go(index.row()); });
    connect(m_table, &QTableView::doubleClicked, this, [this](const QModelIndex& index) { go(index.row()); });
    m_explain = new Explain(context, m_table, [this](int row) { return std::optional(m_model.problem(row).code); });
    m_explain->setMenu([this](QMenu& menu) {
        menu.addAction(tr("Go to Its Place") + QStringLiteral("\tEnter"), this, [this] { go(m_table->currentIndex().row()); });
        if (QAction* fixes = this->context().actions().action(QStringLiteral("edit.quickFix")))
            menu.addAction(fixes);
        menu.addAction(icon(QStringLiteral("copy")), tr("Copy") + QStringLiteral("\tCtrl+C"), this, &ProblemsView::copySelected);
        menu.addSeparator();
    });

    connect(m_table->selectionModel(), &QItemSelectionModel::currentChanged, this, &Panel::abilitiesChanged);

    m_pages = new QStackedWidget(this);
    m_pages->addWidget(new EmptyState(QStringLiteral("check"), tr("No problems. Checks run as you type.")));
    m_pages->addWidget(m_table);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->addWidget(m_pages);
    connect(&m_model, &QAbstractItemModel::modelReset, this, &ProblemsView::refresh);
    refresh();
}

void ProblemsView::refresh()
{
    m_pages->setCurrentIndex(m_model.rowCount() > 0 ? 1 : 0);
    emit badgeChanged();
}

int ProblemsView::badge() const
{
    return m_model.rowCount();
}

void ProblemsView::go(int row)
{
    if (row >= 0 && row < m_model.rowCount())
        context().reveal(m_model.problem(row).place);
}

void ProblemsView::step(int direction)
{
    const int count = m_model.rowCount();
    if (count == 0)
        return;
    const QModelIndex current = m_table->currentIndex();
    const int row = current.isValid() ? (current.row() + direction + count) % count : direction > 0 ? 0 : count - 1;
    m_table->selectRow(row);
    go(row);
}

void ProblemsView::fix(int row)
{
    if (row < 0 || row >= m_model.rowCount())
        return;
    const QRect area = m_table->visualRect(m_model.index(row, ProblemsModel::SentenceColumn));
    const Diagnostic problem = m_model.problem(row);
    showFixes(context(), {problem}, m_table, m_table->viewport()->mapToGlobal(area.bottomLeft() + QPoint(36, 0)));
}

bool ProblemsView::can(const QString& actionId) const
{
    if (actionId == QLatin1String("help.explain"))
        return m_explain->can();
    if (actionId == QLatin1String("edit.quickFix")) {
        const int row = m_table->currentIndex().row();
        return row >= 0 && row < m_model.rowCount() && mayFix(context(), m_model.problem(row).code);
    }
    return actionId == QLatin1String("edit.copy") && m_table->selectionModel()->hasSelection();
}

void ProblemsView::perform(const QString& actionId)
{
    if (actionId == QLatin1String("edit.copy"))
        copySelected();
    else if (actionId == QLatin1String("help.explain"))
        m_explain->explain();
    else if (actionId == QLatin1String("edit.quickFix"))
        fix(m_table->currentIndex().row());
}

void ProblemsView::copySelected() const
{
    QStringList lines;
    for (const QModelIndex& index : m_table->selectionModel()->selectedRows()) {
        const Diagnostic& problem = m_model.problem(index.row());
        lines << QStringLiteral("%1 %2: %3").arg(words::codeId(problem.code), words::placeText(problem.place), words::sentence(problem));
    }
    QApplication::clipboard()->setText(lines.join(QLatin1Char('\n')));
}

} // namespace camwright
