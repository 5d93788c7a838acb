#include "editors/network/networkeditor.h"

#include "core/checks/checkproject.h"
#include "editors/network/axisclipboard.h"
#include "editors/network/axislistmodel.h"
#include "editors/shell/axisform.h"
#include "editors/shell/context.h"
#include "editors/shell/icons.h"
#include "editors/shell/quantityfield.h"
#include "editors/shell/widgets.h"
#include "editors/words/words.h"

#include <QClipboard>
#include <QComboBox>
#include <QFormLayout>
#include <QGuiApplication>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QMenu>
#include <QMessageBox>
#include <QPushButton>
#include <QScrollArea>
#include <QShortcut>
#include <QSplitter>
#include <QStackedWidget>
#include <QTableView>
#include <QTreeWidget>

namespace camwright {

NetworkEditor::NetworkEditor(Context& context, ObjectKey key, QWidget* parent)
    : Editor(context, std::move(key), parent), m_applied(MotionNetworkDraft::of(context.document().project(), this->key())), m_draft(m_applied)
{
    auto* columns = new QHBoxLayout;
    columns->setContentsMargins(0, 0, 0, 0);
    columns->setSpacing(0);
    columns->addWidget(buildTree());
    columns->addWidget(buildPages(), 1);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    layout->addLayout(columns, 1);
    layout->addWidget(buildButtons());

    addShortcut(QKeySequence(Qt::ALT | Qt::Key_N), &NetworkEditor::addAxis); // KS-MCN-03: both
    addShortcut(QKeySequence(Qt::ALT | Qt::Key_A), &NetworkEditor::addAxis);
    connect(&context.document(), &ProjectDocument::changed, this, &NetworkEditor::documentChanged);
    connect(QGuiApplication::clipboard(), &QClipboard::dataChanged, this, &NetworkEditor::refreshState);
    rebuildTree();
    refreshPages();
    refreshState();
}

void NetworkEditor::addShortcut(const QKeySequence& keys, void (NetworkEditor::*slot)())
{
    auto* shortcut = new QShortcut(keys, this);
    shortcut->setContext(Qt::WidgetWithChildrenShortcut);
    connect(shortcut, &QShortcut::activated, this, slot);
}

// Building

QWidget* NetworkEditor::buildTree()
{
    auto* side = new QWidget(this);
    side->setFixedWidth(248);
    side->setAutoFillBackground(true);
    m_tree = new QTreeWidget(side);
    describe(m_tree, "networkTree", tr("Network"), tr("The master and its axes"));
    m_tree->setHeaderHidden(true);
    m_tree->setContextMenuPolicy(Qt::CustomContextMenu);
    connect(m_tree, &QTreeWidget::currentItemChanged, this, &NetworkEditor::selectionMoved);
    connect(m_tree, &QWidget::customContextMenuRequested, this, [this](const QPoint& point) {
        QMenu menu(this);
        menu.addAction(icon(QStringLiteral("plus")), tr("Add Axis"), this, &NetworkEditor::addAxis);
        menu.addAction(icon(QStringLiteral("copy")), tr("Copy"), this, &NetworkEditor::copyAxis)->setEnabled(currentAxis() >= 0);
        menu.addAction(icon(QStringLiteral("paste")), tr("Paste"), this, &NetworkEditor::pasteAxis)->setEnabled(axisFromClipboard().has_value());
        menu.addSeparator();
        menu.addAction(icon(QStringLiteral("trash")), tr("Delete"), this, &NetworkEditor::removeAxis)->setEnabled(currentAxis() >= 0);
        menu.exec(m_tree->viewport()->mapToGlobal(point));
    });
    const auto button = [&](const char* name, const QString& iconName, const QString& text, const QString& tip, void (NetworkEditor::*slot)()) {
        auto* out = new QPushButton(icon(iconName), text, side);
        describe(out, name, text, tip);
        connect(out, &QPushButton::clicked, this, slot);
        return out;
    };
    m_add = button("addAxis", QStringLiteral("plus"), tr("Add"), tr("Add an axis with default values (Alt+N)"), &NetworkEditor::addAxis);
    m_delete = button("deleteAxis", QStringLiteral("trash"), tr("Delete"), tr("Delete the selected axis (Del)"), &NetworkEditor::removeAxis);
    m_copy = button("copyAxis", QStringLiteral("copy"), tr("Copy"), tr("Copy the selected axis (Ctrl+C)"), &NetworkEditor::copyAxis);
    m_paste = button("pasteAxis", QStringLiteral("paste"), tr("Paste"), tr("Add an axis equal to the copied one, with the next number (Ctrl+V)"), &NetworkEditor::pasteAxis);
    auto* grid = new QGridLayout;
    grid->setSpacing(Theme::Grid);
    grid->addWidget(m_add, 0, 0);
    grid->addWidget(m_delete, 0, 1);
    grid->addWidget(m_copy, 1, 0);
    grid->addWidget(m_paste, 1, 1);
    auto* layout = new QVBoxLayout(side);
    layout->setContentsMargins(8, 8, 8, 8);
    layout->addWidget(m_tree, 1);
    layout->addLayout(grid);
    return side;
}

QWidget* NetworkEditor::buildPages()
{
    auto* split = new QSplitter(Qt::Vertical, this);
    split->setChildrenCollapsible(false);
    m_pages = new QStackedWidget(split);
    m_pages->addWidget(buildMasterPage());
    m_pages->addWidget(buildAxisPage());
    auto* scroll = new QScrollArea(split);
    scroll->setWidgetResizable(true);
    scroll->setFrameShape(QFrame::NoFrame);
    scroll->setWidget(m_pages);
    split->addWidget(scroll);
    split->addWidget(buildListPage());
    split->setStretchFactor(0, 3);
    split->setStretchFactor(1, 1);
    return split;
}

QWidget* NetworkEditor::buildMasterPage()
{
    auto* page = new QWidget(this);
    m_baudrate = new QComboBox(page);
    describe(m_baudrate, "baudrate", tr("Baud rate"), tr("Must be the same in every node of the bus (KS-MCN)"));
    for (const std::int64_t rate : offeredBaudrates())
        m_baudrate->addItem(rate >= 1000000 ? tr("%1 Mbit/s").arg(rate / 1000000) : tr("%1 kbit/s").arg(rate / 1000), QVariant::fromValue(qlonglong(rate)));
    m_baudrate->setFixedWidth(150);
    connect(m_baudrate, &QComboBox::activated, this, [this](int index) {
        MotionNetworkDraft draft = m_draft;
        Network network = draft.network();
        network.baudrate = m_baudrate->itemData(index).toLongLong();
        network.sdoTimeoutMs = proposedSdoTimeoutMs(network.baudrate.value()); // a proposal; the user may change it
        draft.setNetwork(network);
        change(std::move(draft));
    });
    QuantitySpec quantity;
    quantity.name = tr("SDO time-out");
    quantity.unit = tr("ms");
    quantity.integer = true;
    quantity.help = tr("How long the master waits for the answer to a parameter request. A value is proposed on each change of the baud rate.");
    quantity.reference = QStringLiteral("KS-COM-04");
    if (const auto range = fieldRange(ObjectKind::Network, "sdo_timeout_ms")) {
        quantity.minimum = range->low;
        quantity.maximum = range->high;
    }
    m_sdoTimeout = new QuantityField(quantity, page);
    m_sdoTimeout->setObjectName(QStringLiteral("sdo_timeout_ms"));
    m_sdoTimeout->setFieldWidth(150);
    connect(m_sdoTimeout, &QuantityField::edited, this, [this] {
        MotionNetworkDraft draft = m_draft;
        Network network = draft.network();
        network.sdoTimeoutMs = m_sdoTimeout->integerField();
        draft.setNetwork(network);
        change(std::move(draft));
    });
    auto* form = new QFormLayout;
    form->setHorizontalSpacing(20);
    form->setVerticalSpacing(Theme::RowGap);
    form->setFieldGrowthPolicy(QFormLayout::FieldsStayAtSizeHint);
    auto* indented = new QHBoxLayout;
    indented->setContentsMargins(12, 0, 0, 0);
    indented->addWidget(m_baudrate);
    form->addRow(tr("Baud rate"), indented);
    form->addRow(tr("SDO time-out"), m_sdoTimeout);
    auto* layout = new QVBoxLayout(page);
    layout->setContentsMargins(24, 16, 24, 16);
    layout->addWidget(new SectionHeader(tr("CANopen Master"), tr("The controller on the bus of its drives"), page));
    layout->addLayout(form);
    layout->addStretch();
    return page;
}

QWidget* NetworkEditor::buildAxisPage()
{
    auto* page = new QWidget(this);
    m_axisForm = new AxisForm(page);
    m_axisForm->setObjectName(QStringLiteral("axisForm"));
    connect(m_axisForm, &AxisForm::edited, this, [this](const std::string&, const Axis& axis) {
        if (currentAxis() < 0)
            return;
        MotionNetworkDraft draft = m_draft;
        draft.setAxis(static_cast<std::size_t>(currentAxis()), axis);
        change(std::move(draft));
    });
    connect(m_axisForm, &AxisForm::nameEdited, this, [this](const QString& name) {
        if (currentAxis() < 0)
            return;
        MotionNetworkDraft draft = m_draft;
        draft.setName(static_cast<std::size_t>(currentAxis()), name.trimmed().toStdString());
        change(std::move(draft));
    });
    auto* layout = new QVBoxLayout(page);
    layout->setContentsMargins(24, 16, 24, 16);
    auto* header = new SectionHeader(tr("Axis"), tr("A drive on the bus and the mechanics behind it"), page);
    layout->addWidget(header);
    layout->addWidget(m_axisForm);
    layout->addStretch();
    return page;
}

QWidget* NetworkEditor::buildListPage()
{
    auto* page = new QWidget(this);
    m_listModel = new AxisListModel(this);
    m_list = new QTableView(page);
    describe(m_list, "axisList", tr("All axes"), tr("Every axis with its parameters; double-click to edit one"));
    m_list->setModel(m_listModel);
    m_list->setSelectionBehavior(QAbstractItemView::SelectRows);
    m_list->setSelectionMode(QAbstractItemView::SingleSelection);
    m_list->verticalHeader()->hide();
    m_list->verticalHeader()->setDefaultSectionSize(Theme::TableRow);
    m_list->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    m_list->horizontalHeader()->setStretchLastSection(true);
    m_list->setShowGrid(false);
    connect(m_list, &QTableView::activated, this, [this](const QModelIndex& index) { selectRow(index.row() + 1); });
    auto* layout = new QVBoxLayout(page);
    layout->setContentsMargins(24, 8, 24, 8);
    layout->addWidget(new SectionHeader(tr("Axis List"), {}, page));
    layout->addWidget(m_list, 1);
    return page;
}

QWidget* NetworkEditor::buildButtons()
{
    auto* bar = new QWidget(this);
    bar->setObjectName(QStringLiteral("applyBar"));
    m_message = new QLabel(bar);
    m_message->setObjectName(QStringLiteral("networkMessage"));
    m_message->setWordWrap(true);
    const auto button = [&](const char* name, const QString& text, const QString& tip, auto slot) {
        auto* out = new QPushButton(text, bar);
        describe(out, name, text, tip);
        connect(out, &QPushButton::clicked, this, slot);
        return out;
    };
    m_renumber = button("renumberAxes", tr("Number from 1"), tr("Give the axes the numbers 1, 2, 3 … in this order"), &NetworkEditor::renumber);
    m_ok = button("okNetwork", tr("OK"), tr("Apply and close"), &NetworkEditor::applyAndClose);
    m_apply = button("applyNetwork", tr("Apply"), tr("Put the changes into the project"), [this] { applyDraft(); });
    m_cancel = button("cancelNetwork", tr("Cancel"), tr("Drop what was changed since the last Apply"), &NetworkEditor::dropDraft);
    makePrimary(m_apply);
    auto* layout = new QHBoxLayout(bar);
    layout->setContentsMargins(16, 8, 16, 8);
    layout->addWidget(m_message, 1);
    for (QPushButton* b : {m_renumber, m_ok, m_apply, m_cancel})
        layout->addWidget(b);
    return bar;
}

// The draft

void NetworkEditor::change(MotionNetworkDraft draft)
{
    const bool sameShape = draft.axes().size() == m_draft.axes().size();
    m_draft = std::move(draft);
    context().document().setDraft(key(), hasUnapplied() ? m_draft.appliedTo(context().document().project()).find(key()) : nullptr);
    for (const DraftAxis& axis : m_draft.axes())
        context().document().setDraft(axis.object.key, hasUnapplied() ? std::make_shared<const Object>(axis.object) : nullptr);
    if (!sameShape)
        m_row = std::min<int>(m_row, static_cast<int>(m_draft.axes().size()));
    rebuildTree();
    refreshPages();
    refreshState();
}

bool NetworkEditor::hasUnapplied() const
{
    return !(m_draft == m_applied);
}

void NetworkEditor::documentChanged(const ProjectChange& projectChange)
{
    if (!projectChange.touches(ObjectKind::Axis) && !projectChange.touches(key()))
        return;
    const bool unapplied = hasUnapplied();
    m_applied = MotionNetworkDraft::of(context().document().project(), key());
    if (!unapplied) // what stands unapplied in the window is the user's and stays
        m_draft = m_applied;
    m_row = std::min<int>(m_row, static_cast<int>(m_draft.axes().size()));
    rebuildTree();
    refreshPages();
    refreshState();
}

void NetworkEditor::addAxis()
{
    MotionNetworkDraft draft = m_draft;
    m_row = static_cast<int>(draft.addAxis()) + 1;
    change(std::move(draft));
}

void NetworkEditor::removeAxis()
{
    if (currentAxis() < 0)
        return;
    MotionNetworkDraft draft = m_draft;
    draft.removeAxis(static_cast<std::size_t>(currentAxis()));
    change(std::move(draft));
}

void NetworkEditor::copyAxis()
{
    if (currentAxis() >= 0)
        copyAxisToClipboard(m_draft.axes()[static_cast<std::size_t>(currentAxis())].object);
}

void NetworkEditor::pasteAxis()
{
    const auto copied = axisFromClipboard();
    if (!copied)
        return;
    MotionNetworkDraft draft = m_draft;
    m_row = static_cast<int>(draft.pasteAxis(*copied)) + 1;
    change(std::move(draft));
}

void NetworkEditor::renumber()
{
    MotionNetworkDraft draft = m_draft;
    draft.renumber();
    change(std::move(draft));
}

bool NetworkEditor::applyDraft()
{
    const Diagnostics problems = m_draft.problems(context().document().project());
    for (const Diagnostic& d : problems) {
        if (d.severity() != Severity::Error)
            continue;
        reveal(d.place);
        refreshState();
        return false;
    }
    const MotionNetworkDraft draft = m_draft;
    m_applied = draft;
    draft.apply(context().document(), tr("Change the motion network"));
    context().document().setDraft(key(), nullptr);
    for (const DraftAxis& axis : draft.axes())
        context().document().setDraft(axis.object.key, nullptr);
    refreshState();
    return true;
}

void NetworkEditor::applyAndClose()
{
    if (applyDraft())
        emit closeRequested();
}

void NetworkEditor::dropDraft()
{
    change(m_applied);
    emit closeRequested();
}

bool NetworkEditor::mayClose()
{
    if (!hasUnapplied())
        return true;
    QMessageBox box(QMessageBox::Question, tr("Unapplied Changes"), tr("The motion network has changes that were not applied to the project."), QMessageBox::NoButton, this);
    QPushButton* apply = box.addButton(tr("Apply"), QMessageBox::AcceptRole);
    QPushButton* drop = box.addButton(tr("Drop the Changes"), QMessageBox::DestructiveRole);
    box.addButton(tr("Stay Here"), QMessageBox::RejectRole);
    box.exec();
    if (box.clickedButton() == apply)
        return applyDraft();
    if (box.clickedButton() != drop)
        return false;
    change(m_applied);
    return true;
}

// Showing

int NetworkEditor::currentAxis() const
{
    return m_row - 1;
}

void NetworkEditor::rebuildTree()
{
    m_building = true;
    m_tree->clear();
    auto* root = new QTreeWidgetItem(m_tree, {tr("CANopen Master")});
    root->setIcon(0, icon(QStringLiteral("network")));
    for (const DraftAxis& axis : m_draft.axes()) {
        const QString number = axis.axis().number.isValid() ? QString::number(axis.axis().number.value()) : QStringLiteral("?");
        auto* item = new QTreeWidgetItem(root, {QStringLiteral("%1  %2").arg(number, QString::fromStdString(axis.object.key.name))});
        const bool rotary = axis.axis().type.valueOr(AxisType::Linear) == AxisType::Rotary;
        item->setIcon(0, icon(rotary ? QStringLiteral("axis-rotary") : QStringLiteral("axis-linear")));
    }
    root->setExpanded(true);
    m_building = false;
    selectRow(m_row);
}

void NetworkEditor::selectRow(int row)
{
    QTreeWidgetItem* root = m_tree->topLevelItem(0);
    m_tree->setCurrentItem(row == 0 ? root : root->child(row - 1));
}

void NetworkEditor::selectionMoved()
{
    QTreeWidgetItem* item = m_tree->currentItem();
    if (m_building || !item)
        return;
    m_row = item->parent() ? item->parent()->indexOfChild(item) + 1 : 0;
    refreshPages();
    refreshState();
    emit positionChanged();
}

void NetworkEditor::refreshPages()
{
    m_pages->setCurrentIndex(currentAxis() < 0 ? 0 : 1);
    const Network& network = m_draft.network();
    m_baudrate->setCurrentIndex(network.baudrate.isValid() ? m_baudrate->findData(QVariant::fromValue(qlonglong(network.baudrate.value()))) : -1);
    m_sdoTimeout->setField(network.sdoTimeoutMs);
    m_listModel->setDraft(m_draft);
    const Diagnostics problems = m_draft.problems(context().document().project());
    if (currentAxis() >= 0) {
        const DraftAxis& axis = m_draft.axes()[static_cast<std::size_t>(currentAxis())];
        m_axisForm->setAxis(axis.object.key.name, axis.axis());
        m_axisForm->setProblems(axis.object.key, problems);
        m_list->selectRow(currentAxis());
    } else {
        m_list->clearSelection();
    }
}

void NetworkEditor::refreshState()
{
    const Diagnostics problems = m_draft.problems(context().document().project());
    const auto error = std::ranges::find(problems, Severity::Error, &Diagnostic::severity);
    const bool gap = std::ranges::any_of(problems, [](const Diagnostic& d) { return d.code == Code::AxisNumberGap || d.code == Code::AxisNumberTwice; });
    m_renumber->setVisible(gap);
    if (error != problems.end()) {
        m_message->setStyleSheet(QStringLiteral("color: %1").arg(theme().name(Role::Error)));
        m_message->setText(words::sentence(*error));
    } else {
        m_message->setStyleSheet(QStringLiteral("color: %1").arg(theme().name(Role::Dim)));
        m_message->setText(hasUnapplied() ? tr("Not applied yet.") : QString());
    }
    m_apply->setEnabled(hasUnapplied());
    m_cancel->setEnabled(true);
    m_delete->setEnabled(currentAxis() >= 0);
    m_copy->setEnabled(currentAxis() >= 0);
    m_paste->setEnabled(axisFromClipboard().has_value());
    emit abilitiesChanged();
}

// The window's actions

void NetworkEditor::reveal(const Place& place)
{
    for (std::size_t i = 0; i < m_draft.axes().size(); ++i) {
        if (m_draft.axes()[i].object.key != place.object)
            continue;
        selectRow(static_cast<int>(i) + 1);
        m_axisForm->focusField(place.field);
        return;
    }
    selectRow(0);
    (place.field == "sdo_timeout_ms" ? static_cast<QWidget*>(m_sdoTimeout->lineEdit()) : m_baudrate)->setFocus(Qt::OtherFocusReason);
}

Place NetworkEditor::place() const
{
    if (currentAxis() >= 0)
        return Place{m_draft.axes()[static_cast<std::size_t>(currentAxis())].object.key, {}, {}, {}};
    return Place{key(), {}, {}, {}};
}

bool NetworkEditor::can(const QString& id) const
{
    if (id == QLatin1String("edit.copy") || id == QLatin1String("edit.delete"))
        return currentAxis() >= 0;
    return id == QLatin1String("edit.paste") && axisFromClipboard().has_value();
}

void NetworkEditor::perform(const QString& id)
{
    if (id == QLatin1String("edit.copy"))
        copyAxis();
    else if (id == QLatin1String("edit.paste"))
        pasteAxis();
    else if (id == QLatin1String("edit.delete"))
        removeAxis();
}

} // namespace camwright
