#include "editors/project/projecttreedelegate.h"

#include "core/base/codes.h"
#include "editors/document/projecttreemodel.h"
#include "editors/shell/icons.h"

#include <QPainter>

namespace camwright {

namespace {

constexpr int IconSize = 16;
constexpr int IconGap = 6;

/// Right-hand texts of numbers and states stand in the fixed font, words in the interface's.
QFont detailFont(const QString& text)
{
    const bool number = std::any_of(text.begin(), text.end(), [](QChar c) { return c.isDigit(); });
    QFont out = number ? theme().monoFont() : theme().smallFont();
    out.setPixelSize(11);
    return out;
}

} // namespace

void ProjectTreeDelegate::paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const
{
    const bool selected = option.state & QStyle::State_Selected;
    const bool hovered = option.state & QStyle::State_MouseOver;
    const bool section = index.data(ProjectTreeModel::IsSectionRole).toBool();
    const bool empty = section && index.model()->rowCount(index) == 0;
    painter->save();
    painter->setRenderHint(QPainter::Antialiasing);
    if (selected || hovered) {
        QRectF row = option.rect;
        row.setLeft(4);
        row.setRight(option.widget ? option.widget->width() - 4 : row.right());
        painter->setPen(Qt::NoPen);
        painter->setBrush(theme().color(selected ? Role::AccentSoft : Role::Raised));
        painter->drawRoundedRect(row, 4, 4);
    }
    QRect area = option.rect.adjusted(2, 0, -8, 0);
    const Role ink = selected ? Role::Accent : empty ? Role::Dim : Role::Text;
    paintIcon(*painter, QRectF(area.left(), area.center().y() - IconSize / 2.0 + 1, IconSize, IconSize),
        index.data(ProjectTreeModel::IconRole).toString(), selected ? Role::Accent : Role::Dim);
    area.setLeft(area.left() + IconSize + IconGap);

    const QString glyph = index.data(ProjectTreeModel::DetailIconRole).toString();
    if (!glyph.isEmpty()) {
        paintIcon(*painter, QRectF(area.right() - 11, area.center().y() - 5, 12, 12), glyph, selected ? Role::Accent : Role::Dim);
        area.setRight(area.right() - 16);
    }
    const int problem = index.data(ProjectTreeModel::ProblemRole).toInt();
    if (problem >= int(Severity::Warning)) {
        const bool error = problem == int(Severity::Error);
        paintIcon(*painter, QRectF(area.right() - 13, area.center().y() - 6, 14, 14), error ? QStringLiteral("error") : QStringLiteral("warning"),
            error ? Role::Error : Role::Warn);
        area.setRight(area.right() - 20);
    }
    const QString detail = index.data(ProjectTreeModel::DetailRole).toString();
    if (!detail.isEmpty()) {
        painter->setFont(detailFont(detail));
        painter->setPen(theme().color(Role::Dim));
        painter->drawText(area, Qt::AlignVCenter | Qt::AlignRight, detail);
        area.setRight(area.right() - painter->fontMetrics().horizontalAdvance(detail) - 8);
    }
    painter->setFont(selected ? theme().boldFont() : theme().font());
    painter->setPen(theme().color(ink));
    painter->drawText(area, Qt::AlignVCenter | Qt::AlignLeft,
        painter->fontMetrics().elidedText(index.data().toString(), Qt::ElideRight, area.width()));
    painter->restore();
}

QSize ProjectTreeDelegate::sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const
{
    return {QStyledItemDelegate::sizeHint(option, index).width(), Theme::TreeRow};
}

void ProjectTreeDelegate::updateEditorGeometry(QWidget* editor, const QStyleOptionViewItem& option, const QModelIndex&) const
{
    editor->setGeometry(option.rect.adjusted(IconSize + 2, -2, -4, 2));
}

} // namespace camwright
