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
#include <QGuiApplication>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QMessageBox>
#include <QPushButton>
#include <QShortcut>
#include <QStackedWidget>
#include <QTableView>
#include <QTreeWidget>

#include <map>
#include <utility>

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
    connect(&context.document(), &ProjectDocument::draftChanged, this, [this](const ObjectKey& changed) {
        if (changed == this->key() && !hasUnapplied())
            showRecovered();
    });
    showRecovered();
}

void NetworkEditor::setKey(const ObjectKey& key)
{
    const bool unapplied = hasUnapplied();
    Editor::setKey(key);
    m_applied = MotionNetworkDraft::of(context().document().project(), key);
    m_draft.setNetworkKey(key);
    change(unapplied ? m_draft : m_applied);
}

void NetworkEditor::addShortcut(const QKeySequence& keys, void (NetworkEditor::*slot)())
{
    auto* shortcut = new QShortcut(keys, this);
    shortcut->setContext(Qt::WidgetWithChildrenShortcut);
    connect(shortcut, &QShortcut::activated, this, slot);
}

// The draft

void NetworkEditor::change(MotionNetworkDraft draft)
{
    const bool sameShape = draft.axes().size() == m_draft.axes().size();
    m_draft = std::move(draft);
    keepDraft();
    if (!sameShape)
        m_row = std::min<int>(m_row, static_cast<int>(m_draft.axes().size()));
    rebuildTree();
    refreshPages();
    refreshState();
}

/// The document keeps what is not applied, and nothing of what is not in the window any more.
void NetworkEditor::keepDraft()
{
    std::map<ObjectKey, ObjectPtr> drafts;
    if (hasUnapplied()) {
        drafts[key()] = m_draft.appliedTo(context().document().project()).find(key());
        for (const DraftAxis& axis : m_draft.axes())
            drafts[axis.object.key] = std::make_shared<const Object>(axis.object);
    }
    for (const ObjectKey& kept : std::exchange(m_kept, {})) {
        if (!drafts.contains(kept))
            context().document().setDraft(kept, nullptr);
    }
    for (const auto& [key, draft] : drafts) {
        m_kept.insert(key);
        context().document().setDraft(key, draft);
    }
}

/// What an interrupted session had not applied stands in the window again.
void NetworkEditor::showRecovered()
{
    const ObjectPtr network = context().document().draft(key());
    if (!network)
        return;
    MotionNetworkDraft draft = m_draft;
    draft.setNetwork(std::get<Network>(network->content));
    for (std::size_t i = 0; i < draft.axes().size(); ++i) {
        if (const ObjectPtr axis = context().document().draft(draft.axes()[i].object.key))
            draft.setAxis(i, std::get<Axis>(axis->content));
    }
    change(std::move(draft));
}

bool NetworkEditor::hasUnapplied() const
{
    return !(m_draft == m_applied);
}

void NetworkEditor::documentChanged(const ProjectChange& projectChange)
{
    const bool concerns = projectChange.touches(ObjectKind::Axis) || projectChange.touches(key());
    if (!concerns || !context().document().object(key())) // renamed: setKey() follows; removed: the view goes
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
    keepDraft();
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
