#include "app/window/keyspage.h"

#include "app/window/keybook.h"
#include "app/window/keyfield.h"
#include "app/window/keytable.h"
#include "editors/shell/widgets.h"

#include <QComboBox>
#include <QCoreApplication>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLineEdit>
#include <QSortFilterProxyModel>
#include <QTableView>
#include <QVBoxLayout>

namespace camwright {

KeysPage::KeysPage(KeyBook& keys, const ActionCatalogue& actions, QWidget* parent) : QWidget(parent), m_keys(keys), m_actions(actions)
{
    setObjectName(QStringLiteral("keysPage"));
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 12, 0, 0);
    column->setSpacing(8);
    column->addWidget(makeMapRow());
    column->addWidget(makeTable(), 1);
    column->addWidget(makeFields());
    m_banner = new Banner(Severity::Warning, {}, this);
    m_take = m_banner->addButton(tr("Take the Key"));
    describe(m_take, "takeKey", tr("Take the Key"), tr("The other action loses it."));
    m_banner->hide();
    column->addWidget(m_banner);
    connect(m_take, &QPushButton::clicked, this, [this] { assign(m_wantedField, m_wanted); });
    connect(&keys, &KeyBook::changed, this, &KeysPage::refresh);
    m_table->selectRow(0);
    refresh();
}

QWidget* KeysPage::makeMapRow()
{
    auto* out = new QWidget(this);
    auto* row = new QHBoxLayout(out);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(8);
    m_map = new QComboBox(out);
    describe(m_map, "keyMap", tr("Key map"), tr("Keys you know from another tool. Each map remembers what you change in it."));
    for (const KeyMap& map : keyMaps())
        m_map->addItem(QCoreApplication::translate("KeyMaps", map.name), QString::fromLatin1(map.id));
    m_map->setMinimumWidth(180);
    m_mapWords = new QLabel(out);
    m_mapWords->setProperty("tone", "caption");
    m_filter = new QLineEdit(out);
    describe(m_filter, "keyFilter", tr("Find an action or a key"), tr("Shows the actions whose name or key has these letters."));
    m_filter->setPlaceholderText(tr("Find an action or a key"));
    m_filter->setFixedWidth(220);
    row->addWidget(m_map);
    row->addWidget(m_mapWords, 1);
    row->addWidget(m_filter);
    connect(m_map, &QComboBox::activated, this, [this](int index) { m_keys.setMap(m_map->itemData(index).toString()); });
    connect(m_filter, &QLineEdit::textChanged, this, [this](const QString& text) {
        m_rows->setFilterFixedString(text);
        if (!m_table->currentIndex().isValid() && m_rows->rowCount() > 0)
            m_table->selectRow(0);
    });
    return out;
}

QWidget* KeysPage::makeTable()
{
    m_rows = new QSortFilterProxyModel(this);
    m_rows->setSourceModel(new KeyTableModel(m_actions, m_keys, this));
    m_rows->setFilterCaseSensitivity(Qt::CaseInsensitive);
    m_rows->setFilterKeyColumn(-1);
    m_table = new QTableView(this);
    describe(m_table, "keyTable", tr("Actions and their keys"));
    m_table->setModel(m_rows);
    m_table->setSelectionBehavior(QAbstractItemView::SelectRows);
    m_table->setSelectionMode(QAbstractItemView::SingleSelection);
    m_table->setEditTriggers(QAbstractItemView::NoEditTriggers);
    m_table->setTabKeyNavigation(false);
    m_table->setShowGrid(false);
    m_table->verticalHeader()->hide();
    m_table->verticalHeader()->setDefaultSectionSize(Theme::TableRow);
    m_table->horizontalHeader()->setSectionResizeMode(KeyTableModel::Name, QHeaderView::Stretch);
    m_table->setColumnWidth(KeyTableModel::Keys, 210);
    m_table->setColumnWidth(KeyTableModel::Changed, 90);
    m_table->setMinimumHeight(260);
    connect(m_table->selectionModel(), &QItemSelectionModel::currentRowChanged, this, &KeysPage::refresh);
    connect(m_table, &QTableView::activated, this, [this] { m_fields[0]->setFocus(); });
    return m_table;
}

QWidget* KeysPage::makeFields()
{
    auto* out = new QWidget(this);
    auto* row = new QHBoxLayout(out);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(8);
    m_name = new QLabel(out);
    m_name->setProperty("tone", "heading");
    m_name->setMinimumWidth(160);
    row->addWidget(m_name, 1);
    const QString names[] = {tr("Key"), tr("Second key")};
    for (int i = 0; i < 2; ++i) {
        m_fields[i] = new KeyField(out);
        describe(m_fields[i], i == 0 ? "firstKey" : "secondKey", names[i], tr("Press the key here. A function key, or one with Ctrl or Alt; Escape gives up."));
        if (auto* line = m_fields[i]->findChild<QLineEdit*>())
            line->setAccessibleName(names[i]);
        m_fields[i]->setFixedWidth(130);
        row->addWidget(m_fields[i]);
        connect(m_fields[i], &KeyField::pressed, this, [this, i](const QKeySequence& key) { pressed(i, key); });
    }
    m_remove = new QPushButton(tr("Remove"), out);
    describe(m_remove, "removeKeys", tr("Remove"), tr("The action has no key then."));
    m_reset = new QPushButton(tr("Reset"), out);
    describe(m_reset, "resetKeys", tr("Reset"), tr("Back to the keys of the map."));
    m_resetAll = new QPushButton(tr("Reset All"), out);
    describe(m_resetAll, "resetAllKeys", tr("Reset All"), tr("Every action back to the keys of the map."));
    for (QPushButton* button : {m_remove, m_reset, m_resetAll}) {
        button->setAutoDefault(false);
        row->addWidget(button);
    }
    connect(m_remove, &QPushButton::clicked, this, [this] { m_keys.change(currentAction(), {}); });
    connect(m_reset, &QPushButton::clicked, this, [this] { m_keys.reset(currentAction()); });
    connect(m_resetAll, &QPushButton::clicked, this, [this] { m_keys.resetAll(); });
    return out;
}

QString KeysPage::currentAction() const
{
    return m_table->currentIndex().data(KeyTableModel::ActionRole).toString();
}

QString KeysPage::nameOf(const QString& action) const
{
    for (const ActionRow& row : m_actions.rows()) {
        if (action == QLatin1String(row.id))
            return ActionCatalogue::plainName(row);
    }
    return action;
}

void KeysPage::refresh()
{
    m_map->setCurrentIndex(m_map->findData(m_keys.map()));
    m_mapWords->setText(QCoreApplication::translate("KeyMaps", keyMaps()[std::size_t(m_map->currentIndex())].description));
    const QString action = currentAction();
    const auto keys = m_keys.keys(action);
    m_name->setText(nameOf(action));
    for (int i = 0; i < 2; ++i) {
        m_fields[i]->setKey(i < keys.size() ? keys[i] : QKeySequence());
        m_fields[i]->setEnabled(!action.isEmpty());
    }
    m_remove->setEnabled(!keys.isEmpty());
    m_reset->setEnabled(m_keys.isChanged(action));
    m_resetAll->setEnabled(m_keys.hasChanges());
    m_banner->hide();
}

void KeysPage::pressed(int field, const QKeySequence& key)
{
    m_wantedField = field;
    m_wanted = key;
    const QString holder = m_keys.holder(key), shown = key.toString(QKeySequence::NativeText);
    if (!isUsableKey(key))
        say(tr("%1 alone is for typing. Hold Ctrl or Alt with it, or choose a function key.").arg(shown), false);
    else if (!holder.isEmpty() && holder != currentAction())
        say(tr("%1 is the key of \"%2\".").arg(shown, nameOf(holder)), true);
    else
        assign(field, key);
}

void KeysPage::assign(int field, const QKeySequence& key)
{
    QList<QKeySequence> keys = m_keys.keys(currentAction());
    keys.removeAll(key);
    if (field < keys.size())
        keys[field] = key;
    else
        keys << key;
    m_keys.change(currentAction(), keys);
}

void KeysPage::say(const QString& sentence, bool offerTaking)
{
    m_banner->setSentence(sentence);
    m_take->setVisible(offerTaking);
    m_banner->show();
}

} // namespace camwright
