#include "app/window/recentlist.h"

#include "editors/shell/icons.h"

#include <QContextMenuEvent>
#include <QDir>
#include <QFileInfo>
#include <QHeaderView>
#include <QKeyEvent>
#include <QLocale>
#include <QMenu>
#include <QPainter>
#include <QStyledItemDelegate>

namespace camwright {

namespace {

enum { PathRole = Qt::UserRole, SecondRole, IconRole, InkRole };

class RecentDelegate : public QStyledItemDelegate {
public:
    using QStyledItemDelegate::QStyledItemDelegate;

    void paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const override
    {
        painter->save();
        const bool selected = (option.state & QStyle::State_Selected) && option.widget && option.widget->hasFocus();
        painter->fillRect(option.rect, theme().color(selected ? Role::AccentSoft : Role::Surface));
        if (index.row() + 1 < index.model()->rowCount())
            painter->fillRect(QRect(option.rect.left(), option.rect.bottom(), option.rect.width(), 1), theme().color(Role::FineLine));
        QRect area = option.rect.adjusted(index.column() == 0 ? 16 : 8, 0, index.column() == 3 ? -16 : -8, 0);
        const QString iconName = index.data(IconRole).toString();
        if (!iconName.isEmpty()) {
            paintIcon(*painter, QRectF(area.left(), area.center().y() - 6, 14, 14), iconName, Role(index.data(InkRole).toInt()));
            area.setLeft(area.left() + 22);
        }
        painter->setFont(index.column() == 0 ? theme().boldFont() : index.column() == 3 ? theme().smallFont() : theme().font());
        painter->setPen(theme().color(index.column() == 3 ? Role::Dim : Role::Text));
        const QString text = painter->fontMetrics().elidedText(index.data().toString(), Qt::ElideRight, area.width());
        painter->drawText(area, Qt::AlignVCenter | (index.column() == 3 ? Qt::AlignRight : Qt::AlignLeft), text);
        const QString second = index.data(SecondRole).toString();
        if (!second.isEmpty()) {
            area.setLeft(area.left() + painter->fontMetrics().horizontalAdvance(text) + 8);
            painter->setFont(theme().smallFont());
            painter->setPen(theme().color(Role::Dim));
            painter->drawText(area, Qt::AlignVCenter | Qt::AlignLeft, painter->fontMetrics().elidedText(second, Qt::ElideMiddle, area.width()));
        }
        painter->restore();
    }
};

struct StateWords {
    QString text;
    QString icon;
    Role ink;
};

StateWords stateWords(const RecentProject& project)
{
    switch (project.state) {
    case LastState::Errors: return {RecentList::tr("%n errors", nullptr, project.problems), QStringLiteral("error"), Role::Error};
    case LastState::Warnings: return {RecentList::tr("%n warnings", nullptr, project.problems), QStringLiteral("warning"), Role::Warn};
    case LastState::RanVirtual: return {RecentList::tr("Ran on the virtual controller"), QStringLiteral("run"), Role::Simulated};
    case LastState::RanReal: return {RecentList::tr("Same program on %1").arg(project.address), QStringLiteral("plug"), Role::Real};
    case LastState::UnsavedKept: return {RecentList::tr("Unsaved edits kept, opening restores them"), QStringLiteral("undo"), Role::Simulated};
    case LastState::Edited: return {RecentList::tr("Saved, no problems"), QStringLiteral("check"), Role::Ok};
    case LastState::Unknown: break;
    }
    return {};
}

QString shortFolder(const QString& path)
{
    const QString folder = QFileInfo(path).path();
    const QString home = QDir::homePath();
    return folder.startsWith(home) ? QLatin1Char('~') + folder.mid(home.size()) : folder;
}

} // namespace

QString whenText(const QDateTime& time, const QDateTime& now)
{
    const qint64 days = time.date().daysTo(now.date());
    const QLocale locale;
    if (days == 0)
        return RecentList::tr("Today %1").arg(time.toString(QStringLiteral("HH:mm")));
    if (days == 1)
        return RecentList::tr("Yesterday");
    if (days < 300)
        return locale.toString(time.date(), QStringLiteral("d MMM"));
    return locale.toString(time.date(), QStringLiteral("d MMM yyyy"));
}

RecentList::RecentList(QWidget* parent) : QTableWidget(0, 4, parent)
{
    setObjectName(QStringLiteral("recentProjects"));
    setAccessibleName(tr("Recent projects"));
    setHorizontalHeaderLabels({tr("Project"), tr("Controller"), tr("Last state"), tr("Opened")});
    horizontalHeader()->setDefaultAlignment(Qt::AlignLeft | Qt::AlignVCenter);
    horizontalHeaderItem(3)->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
    horizontalHeader()->setSectionResizeMode(QHeaderView::Fixed);
    horizontalHeader()->setSectionResizeMode(2, QHeaderView::Stretch);
    horizontalHeader()->setHighlightSections(false);
    horizontalHeader()->setFixedHeight(28);
    horizontalHeader()->setStyleSheet(QStringLiteral("QHeaderView::section { background: %1; } QHeaderView::section:first { padding-left: 16px; } "
                                                     "QHeaderView::section:last { padding-right: 16px; }").arg(theme().name(Role::Raised)));
    horizontalHeader()->resizeSection(0, 264);
    horizontalHeader()->resizeSection(1, 196);
    horizontalHeader()->resizeSection(3, 120);
    verticalHeader()->hide();
    verticalHeader()->setDefaultSectionSize(34);
    setShowGrid(false);
    setEditTriggers(NoEditTriggers);
    setSelectionBehavior(SelectRows);
    setSelectionMode(SingleSelection);
    setTabKeyNavigation(false);
    setFrameShape(QFrame::NoFrame);
    setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setItemDelegate(new RecentDelegate(this));
    connect(this, &QTableWidget::cellClicked, this, [this](int row) { emit chosen(item(row, 0)->data(PathRole).toString()); });
    connect(&theme(), &Theme::changed, this, [this] {
        horizontalHeader()->setStyleSheet(QStringLiteral("QHeaderView::section { background: %1; }").arg(theme().name(Role::Raised)));
    });
}

void RecentList::fill(const QList<RecentProject>& projects)
{
    setRowCount(int(projects.size()));
    for (int row = 0; row < projects.size(); ++row) {
        const RecentProject& project = projects[row];
        auto* name = new QTableWidgetItem(project.name);
        name->setData(PathRole, project.path);
        name->setData(SecondRole, shortFolder(project.path));
        name->setToolTip(project.path);
        setItem(row, 0, name);
        setItem(row, 1, new QTableWidgetItem(project.controller));
        const StateWords words = stateWords(project);
        auto* state = new QTableWidgetItem(words.text);
        state->setData(IconRole, words.icon);
        state->setData(InkRole, int(words.ink));
        setItem(row, 2, state);
        setItem(row, 3, new QTableWidgetItem(whenText(project.opened, QDateTime::currentDateTime())));
    }
    setFixedHeight(28 + 34 * rowCount());
    clearSelection();
}

void RecentList::keyPressEvent(QKeyEvent* event)
{
    if ((event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter) && currentRow() >= 0)
        emit chosen(item(currentRow(), 0)->data(PathRole).toString());
    else if (event->key() == Qt::Key_Delete && currentRow() >= 0)
        emit forgetRequested(item(currentRow(), 0)->data(PathRole).toString());
    else
        QTableWidget::keyPressEvent(event);
}

void RecentList::contextMenuEvent(QContextMenuEvent* event)
{
    const int row = rowAt(viewport()->mapFromGlobal(event->globalPos()).y());
    if (row < 0)
        return;
    const QString path = item(row, 0)->data(PathRole).toString();
    QMenu menu(this);
    menu.addAction(tr("Open"), this, [this, path] { emit chosen(path); });
    menu.addAction(tr("Remove From This List"), this, [this, path] { emit forgetRequested(path); });
    menu.exec(event->globalPos());
}

} // namespace camwright
