#include "editors/variables/variableseditor.h"

#include "editors/shell/actions.h"
#include "editors/shell/context.h"
#include "editors/shell/theme.h"
#include "editors/shell/widgets.h"
#include "editors/variables/typedelegate.h"
#include "editors/variables/variablesmodel.h"

#include <QClipboard>
#include <QGuiApplication>
#include <QHeaderView>
#include <QLineEdit>
#include <QMenu>
#include <QSortFilterProxyModel>
#include <QTableView>
#include <QVBoxLayout>

#include <charconv>

namespace camwright {

VariablesEditor::VariablesEditor(Context& context, ObjectKey key, QWidget* parent)
    : Editor(context, std::move(key), parent), m_model(new VariablesModel(context.document(), this->key(), this)),
      m_filtered(new QSortFilterProxyModel(this)), m_filter(new QLineEdit(this)), m_table(new QTableView(this))
{
    describe(m_filter, "variablesFilter", tr("Filter"), tr("Show only rows that contain this text in any column"));
    m_filter->setPlaceholderText(tr("Filter"));
    m_filter->setClearButtonEnabled(true);
    m_filter->setFixedWidth(240);
    m_filtered->setSourceModel(m_model);
    m_filtered->setFilterKeyColumn(-1);
    m_filtered->setFilterCaseSensitivity(Qt::CaseInsensitive);
    connect(m_filter, &QLineEdit::textChanged, m_filtered, &QSortFilterProxyModel::setFilterFixedString);

    describe(m_table, "variablesTable", tr("Variables"), tr("Global variables; the last row adds one"));
    m_table->setModel(m_filtered);
    m_table->setItemDelegateForColumn(VariablesModel::Type, new TypeDelegate(m_table));
    m_table->setShowGrid(false);
    m_table->setAlternatingRowColors(false);
    m_table->setEditTriggers(QAbstractItemView::DoubleClicked | QAbstractItemView::EditKeyPressed | QAbstractItemView::AnyKeyPressed);
    m_table->verticalHeader()->hide();
    m_table->verticalHeader()->setDefaultSectionSize(Theme::TableRow);
    m_table->horizontalHeader()->setStretchLastSection(true);
    m_table->horizontalHeader()->setDefaultAlignment(Qt::AlignLeft | Qt::AlignVCenter);
    m_table->setColumnWidth(VariablesModel::Name, 180);
    m_table->setColumnWidth(VariablesModel::Type, 90);
    m_table->setColumnWidth(VariablesModel::Address, 110);
    m_table->setColumnWidth(VariablesModel::Initial, 110);
    m_table->setColumnWidth(VariablesModel::Retain, 80);
    m_table->setContextMenuPolicy(Qt::CustomContextMenu);
    connect(m_table, &QWidget::customContextMenuRequested, this, [this](const QPoint& point) { showMenu(m_table->viewport()->mapToGlobal(point)); });
    connect(m_table->selectionModel(), &QItemSelectionModel::selectionChanged, this, &Editor::abilitiesChanged);
    connect(m_table->selectionModel(), &QItemSelectionModel::currentChanged, this, &Editor::positionChanged);
    connect(m_model, &QAbstractItemModel::rowsInserted, this, &Editor::positionChanged);
    connect(m_model, &QAbstractItemModel::rowsRemoved, this, &Editor::positionChanged);

    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(16, 12, 16, 12);
    layout->addWidget(m_filter);
    layout->addWidget(m_table, 1);
    setFocusProxy(m_table);
}

void VariablesEditor::setKey(const ObjectKey& key)
{
    Editor::setKey(key);
    m_model->setKey(key);
}

void VariablesEditor::reveal(const Place& place)
{
    constexpr std::string_view Prefix = "rows[";
    int row = 0;
    if (!place.field.starts_with(Prefix)
        || std::from_chars(place.field.data() + Prefix.size(), place.field.data() + place.field.size(), row).ec != std::errc{})
        return;
    m_filter->clear();
    const int column = place.field.ends_with("address") ? VariablesModel::Address : place.field.ends_with("type") ? VariablesModel::Type
        : place.field.ends_with("initial") ? VariablesModel::Initial : VariablesModel::Name;
    const QModelIndex index = m_filtered->mapFromSource(m_model->index(row, column));
    m_table->setCurrentIndex(index);
    m_table->scrollTo(index);
    m_table->setFocus();
}

QString VariablesEditor::positionText() const
{
    return tr("%n variable(s)", nullptr, static_cast<int>(m_model->rows().size()));
}

std::vector<int> VariablesEditor::selectedRows() const
{
    std::vector<int> out;
    for (const QModelIndex& index : m_table->selectionModel()->selectedIndexes()) {
        const int row = m_filtered->mapToSource(index).row();
        if (row < static_cast<int>(m_model->rows().size()) && std::ranges::find(out, row) == out.end())
            out.push_back(row);
    }
    std::ranges::sort(out);
    return out;
}

bool VariablesEditor::can(const QString& id) const
{
    if (id == QLatin1String("edit.copy") || id == QLatin1String("edit.cut") || id == QLatin1String("edit.delete"))
        return !selectedRows().empty();
    if (id == QLatin1String("go.references"))
        return selectedRows().size() == 1;
    return id == QLatin1String("edit.paste") || id == QLatin1String("edit.selectAll") || id == QLatin1String("edit.find");
}

void VariablesEditor::perform(const QString& id)
{
    const std::vector<int> rows = selectedRows();
    if (id == QLatin1String("edit.copy") || id == QLatin1String("edit.cut"))
        QGuiApplication::clipboard()->setText(m_model->toText(rows));
    if (id == QLatin1String("edit.cut") || id == QLatin1String("edit.delete"))
        m_model->removeVariables(rows);
    if (id == QLatin1String("edit.paste"))
        m_model->insert(rows.empty() ? static_cast<int>(m_model->rows().size()) : rows.back() + 1, VariablesModel::fromText(QGuiApplication::clipboard()->text()));
    if (id == QLatin1String("edit.selectAll"))
        m_table->selectAll();
    if (id == QLatin1String("edit.find"))
        m_filter->setFocus();
    if (id == QLatin1String("go.references") && rows.size() == 1) {
        const Variable& variable = m_model->rows()[static_cast<std::size_t>(rows.front())];
        context().findReferences({Place{key(), "rows[" + std::to_string(rows.front()) + "]", {}, {}}, QString::fromStdString(variable.name)});
    }
}

void VariablesEditor::showMenu(const QPoint& globalPoint)
{
    QMenu menu(this);
    for (const char* id : {"edit.cut", "edit.copy", "edit.paste", "edit.delete"}) {
        if (QAction* action = context().actions().action(QString::fromLatin1(id)))
            menu.addAction(action);
    }
    menu.exec(globalPoint);
}

} // namespace camwright
