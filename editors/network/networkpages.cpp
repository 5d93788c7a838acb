// The parts of the motion network's window.
#include "editors/network/networkeditor.h"

#include "core/checks/checkproject.h"
#include "editors/network/axisclipboard.h"
#include "editors/network/axislistmodel.h"
#include "editors/shell/axisform.h"
#include "editors/shell/context.h"
#include "editors/shell/icons.h"
#include "editors/shell/quantityfield.h"
#include "editors/shell/widgets.h"

#include <QComboBox>
#include <QFormLayout>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QMenu>
#include <QPushButton>
#include <QScrollArea>
#include <QScrollBar>
#include <QSplitter>
#include <QStackedWidget>
#include <QTableView>
#include <QTreeWidget>

namespace camwright {

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
    m_list->setShowGrid(false);
    constexpr int RowsAlwaysSeen = 3;
    m_list->setMinimumHeight(m_list->horizontalHeader()->sizeHint().height() + RowsAlwaysSeen * Theme::TableRow + m_list->horizontalScrollBar()->sizeHint().height() + 2 * m_list->frameWidth());
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

} // namespace camwright
