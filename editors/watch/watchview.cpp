#include "editors/watch/watchview.h"

#include "editors/shell/actions.h"
#include "editors/shell/context.h"
#include "editors/shell/control.h"
#include "editors/shell/theme.h"
#include "editors/shell/widgets.h"
#include "editors/watch/historydelegate.h"
#include "editors/watch/namedelegate.h"
#include "editors/watch/variablelookup.h"
#include "editors/watch/watchmodel.h"

#include <QApplication>
#include <QClipboard>
#include <QHeaderView>
#include <QMenu>
#include <QTableView>
#include <QVBoxLayout>

#include <set>

namespace camwright {

namespace {

constexpr Time RefreshPeriod = 100ms;

} // namespace

WatchView::WatchView(Context& context, const ObjectKey& key, QWidget* parent)
    : QWidget(parent), m_context(context), m_model(new WatchModel(context.document(), key, this)), m_table(new QTableView(this)),
      m_banner(new Banner(Severity::Information, QString(), this))
{
    buildTable();
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    layout->addWidget(m_banner);
    layout->addWidget(m_table, 1);
    setFocusProxy(m_table);

    connect(m_model, &WatchModel::expressionsChanged, this, &WatchView::resubscribe);
    connect(m_model, &WatchModel::writeRequested, this, &WatchView::write);
    connect(&context, &Context::linkAboutToChange, this, &WatchView::unsubscribe);
    connect(&context, &Context::linkChanged, this, &WatchView::stateChanged);
    connect(&context, &Context::linkStateChanged, this, &WatchView::stateChanged);
    connect(&context, &Context::programMatchesChanged, this, &WatchView::stateChanged);
    stateChanged();
}

WatchView::~WatchView()
{
    unsubscribe();
    m_table->selectionModel()->disconnect(this); // its last words, while a name was typed, are for nobody
}

WatchView* WatchView::focused()
{
    for (QWidget* widget = QApplication::focusWidget(); widget; widget = widget->parentWidget()) {
        if (auto* view = qobject_cast<WatchView*>(widget))
            return view;
    }
    return nullptr;
}

void WatchView::buildTable()
{
    describe(m_table, "watchTable", tr("Watched values"), tr("Values of the controller; type a new value to write it, F7 forces it"));
    m_table->setModel(m_model);
    m_table->setShowGrid(false);
    m_table->setEditTriggers(QAbstractItemView::DoubleClicked | QAbstractItemView::EditKeyPressed | QAbstractItemView::AnyKeyPressed);
    m_table->verticalHeader()->hide();
    m_table->verticalHeader()->setDefaultSectionSize(Theme::TableRow);
    m_table->horizontalHeader()->setStretchLastSection(true);
    m_table->setItemDelegateForColumn(WatchModel::Name, new NameDelegate(m_context.document(), m_table));
    m_table->setItemDelegateForColumn(WatchModel::History, new HistoryDelegate(*m_model, m_table));
    m_table->setColumnWidth(WatchModel::Name, 230);
    m_table->setColumnWidth(WatchModel::Type, 80);
    m_table->setColumnWidth(WatchModel::CurrentValue, 150);
    m_table->setColumnWidth(WatchModel::NewValue, 120);
    m_table->setColumnWidth(WatchModel::History, 160);
    m_table->setContextMenuPolicy(Qt::CustomContextMenu);
    connect(m_table, &QWidget::customContextMenuRequested, this, [this](const QPoint& point) { showMenu(m_table->viewport()->mapToGlobal(point)); });
    connect(m_table->selectionModel(), &QItemSelectionModel::selectionChanged, this, &WatchView::abilitiesChanged);
}

void WatchView::setKey(const ObjectKey& key)
{
    m_model->setKey(key);
}

// The controller

void WatchView::stateChanged()
{
    const bool online = m_context.isOnline();
    const bool different = online && !m_context.programMatches();
    m_banner->setVisible(different);
    m_banner->setSentence(tr("The controller runs another program than this project; its values are not shown. Download the project to see them."));
    resubscribe();
}

void WatchView::unsubscribe()
{
    ++m_generation;
    if (m_context.link() && m_subscription)
        m_context.link()->unsubscribe(*m_subscription);
    m_subscription.reset();
    m_model->setStale(true);
}

void WatchView::resubscribe()
{
    unsubscribe();
    const bool lost = m_context.link() && m_context.link()->state() == LinkState::Lost;
    if (lost) // the last values stay, dimmed
        return;
    if (!m_context.isOnline() || !m_context.programMatches()) {
        m_model->forgetValues();
        return;
    }
    std::set<std::string> expressions;
    for (const WatchRow& row : m_model->rows()) {
        if (!row.expression.empty())
            expressions.insert(row.expression);
    }
    // Asked one by one: a name the program does not know must not hide the others.
    auto waiting = std::make_shared<std::size_t>(expressions.size());
    QPointer<WatchView> self(this);
    const unsigned generation = m_generation;
    for (const std::string& expression : expressions) {
        m_context.link()->describe({expression}, [self, waiting, generation, name = expression](const Result<std::vector<DataType>>& types) {
            if (!self || self->m_generation != generation)
                return;
            self->m_model->setType(name, types ? Result<DataType>(types->front()) : Result<DataType>(types.error()));
            if (--*waiting == 0)
                self->subscribeKnown();
        });
    }
}

void WatchView::subscribeKnown()
{
    std::set<std::string> names;
    for (int row = 0; row < static_cast<int>(m_model->rows().size()); ++row) {
        if (const WatchedValue* watched = m_model->watched(row); watched && watched->type)
            names.insert(m_model->rows()[static_cast<std::size_t>(row)].expression);
    }
    if (!names.empty() && m_context.link())
        m_subscription = m_context.link()->subscribe({names.begin(), names.end()}, RefreshPeriod,
            [this](const MonitorUpdate& update) { m_model->update(update.values); });
}

void WatchView::report(const Result<void>& done)
{
    if (!done)
        m_context.notify(done.error());
}

void WatchView::write(const QString& expression, const Value& value)
{
    QPointer<WatchView> self(this);
    withControl(m_context, this, [self, expression, value] {
        self->m_context.link()->write(expression.toStdString(), value, [self](const Result<void>& done) {
            if (self)
                self->report(done);
        });
    });
}

void WatchView::forceSelected()
{
    QPointer<WatchView> self(this);
    for (const int row : selectedRows()) {
        const WatchedValue* watched = m_model->watched(row);
        if (!watched || !watched->type)
            continue;
        const QString typed = m_model->typedValue(row);
        auto value = typed.isEmpty() && watched->value ? Result<Value>(watched->value->value) : parseValue(*watched->type, typed.toStdString());
        if (!value) {
            m_context.notify(value.error());
            continue;
        }
        withControl(m_context, this, [self, name = m_model->rows()[static_cast<std::size_t>(row)].expression, value = *value] {
            self->m_context.link()->force(name, value, [self](const Result<void>& done) {
                if (self)
                    self->report(done);
            });
        });
    }
}

void WatchView::releaseSelected()
{
    QPointer<WatchView> self(this);
    for (const int row : selectedRows()) {
        withControl(m_context, this, [self, name = m_model->rows()[static_cast<std::size_t>(row)].expression] {
            self->m_context.link()->release(name, [self](const Result<void>& done) {
                if (self)
                    self->report(done);
            });
        });
    }
}

// Rows

std::vector<int> WatchView::selectedRows() const
{
    std::set<int> out;
    for (const QModelIndex& index : m_table->selectionModel()->selectedIndexes()) {
        if (index.row() < static_cast<int>(m_model->rows().size()))
            out.insert(index.row());
    }
    return {out.begin(), out.end()};
}

void WatchView::removeSelected()
{
    m_model->remove(selectedRows());
}

bool WatchView::can(const QString& id) const
{
    if (id == QLatin1String("edit.copy") || id == QLatin1String("edit.cut") || id == QLatin1String("edit.delete"))
        return !selectedRows().empty();
    if (id == QLatin1String("go.references"))
        return selectedRows().size() == 1;
    return id == QLatin1String("edit.paste") || id == QLatin1String("edit.selectAll");
}

void WatchView::perform(const QString& id)
{
    const std::vector<int> rows = selectedRows();
    if (id == QLatin1String("edit.copy") || id == QLatin1String("edit.cut")) {
        QStringList lines;
        for (const int row : rows)
            lines << QString::fromStdString(m_model->rows()[static_cast<std::size_t>(row)].expression);
        QApplication::clipboard()->setText(lines.join(QLatin1Char('\n')));
    }
    if (id == QLatin1String("edit.cut") || id == QLatin1String("edit.delete"))
        m_model->remove(rows);
    if (id == QLatin1String("edit.selectAll"))
        m_table->selectAll();
    if (id == QLatin1String("go.references") && rows.size() == 1) {
        const std::string& expression = m_model->rows()[static_cast<std::size_t>(rows.front())].expression;
        m_context.findReferences({Place{m_model->key(), "rows[" + std::to_string(rows.front()) + "]", {}, {}}, QString::fromStdString(expression)});
    }
    if (id != QLatin1String("edit.paste"))
        return;
    std::vector<WatchRow> pasted;
    for (const QString& line : QApplication::clipboard()->text().split(QLatin1Char('\n'))) {
        if (const QString name = line.section(QLatin1Char('\t'), 0, 0).trimmed(); !name.isEmpty())
            pasted.push_back({name.toStdString(), {}});
    }
    m_model->add(rows.empty() ? static_cast<int>(m_model->rows().size()) : rows.back() + 1, pasted);
}

void WatchView::showMenu(const QPoint& globalPoint)
{
    QMenu menu(this);
    const std::vector<int> rows = selectedRows();
    const bool live = m_context.isOnline() && m_context.programMatches() && !rows.empty();
    menu.addAction(tr("Force"), this, &WatchView::forceSelected)->setEnabled(live);
    menu.addAction(tr("Release"), this, &WatchView::releaseSelected)->setEnabled(live);
    QMenu* format = menu.addMenu(tr("Show As"));
    const std::pair<QString, const char*> Formats[] = {{tr("Decimal"), ""}, {tr("Hexadecimal (16#)"), "hex"}, {tr("Binary (2#)"), "bin"}, {tr("Octal (8#)"), "oct"}};
    for (const auto& [text, name] : Formats)
        format->addAction(text, this, [this, rows, name = name] { m_model->setFormat(rows, name); });
    format->setEnabled(!rows.empty());
    menu.addSeparator();
    menu.addAction(tr("Remove"), this, &WatchView::removeSelected)->setEnabled(!rows.empty());
    menu.exec(globalPoint);
}

} // namespace camwright
