#include "app/window/palette.h"

#include "editors/document/projecttreemodel.h"
#include "editors/shell/actions.h"
#include "editors/shell/context.h"
#include "editors/shell/icons.h"
#include "editors/shell/widgets.h"
#include "editors/words/words.h"

#include <QKeyEvent>
#include <QLineEdit>
#include <QListView>
#include <QPainter>
#include <QStandardItemModel>
#include <QStyledItemDelegate>
#include <QVBoxLayout>

#include <algorithm>

namespace camwright {

namespace {

constexpr int MaxShown = 60;

class EntryDelegate : public QStyledItemDelegate {
public:
    using QStyledItemDelegate::QStyledItemDelegate;

    QSize sizeHint(const QStyleOptionViewItem&, const QModelIndex&) const override { return {100, 30}; }
    void paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const override
    {
        painter->save();
        painter->setRenderHint(QPainter::Antialiasing);
        const bool selected = option.state & QStyle::State_Selected;
        if (selected) {
            painter->setPen(Qt::NoPen);
            painter->setBrush(theme().color(Role::AccentSoft));
            painter->drawRoundedRect(option.rect.adjusted(4, 1, -4, -1), 4, 4);
        }
        QRect area = option.rect.adjusted(14, 0, -14, 0);
        paintIcon(*painter, QRectF(area.left(), area.center().y() - 7, 16, 16), index.data(Qt::UserRole + 1).toString(), selected ? Role::Accent : Role::Dim);
        area.setLeft(area.left() + 26);
        painter->setFont(theme().smallFont());
        painter->setPen(theme().color(Role::Dim));
        const QString detail = index.data(Qt::UserRole).toString();
        painter->drawText(area, Qt::AlignRight | Qt::AlignVCenter, detail);
        area.setRight(area.right() - painter->fontMetrics().horizontalAdvance(detail) - 12);
        painter->setFont(theme().font());
        painter->setPen(theme().color(Role::Text));
        painter->drawText(area, Qt::AlignLeft | Qt::AlignVCenter, painter->fontMetrics().elidedText(index.data().toString(), Qt::ElideRight, area.width()));
        painter->restore();
    }
};

} // namespace

int matchScore(const QString& typed, const QString& text)
{
    int score = 0;
    int at = -1;
    for (const QChar wanted : typed) {
        if (wanted.isSpace())
            continue;
        const int next = int(text.indexOf(wanted, at + 1, Qt::CaseInsensitive));
        if (next < 0)
            return -1;
        const bool wordStart = next == 0 || !text[next - 1].isLetterOrNumber() || (text[next].isUpper() && text[next - 1].isLower());
        score += next == at + 1 ? 4 : 0;
        score += wordStart ? 6 : 0;
        score -= std::min(next - at - 1, 5);
        at = next;
    }
    return std::max(0, 100 + score - int(text.size()) / 4);
}

Palette::Palette(const QString& title, const QString& placeholder, std::vector<PaletteEntry> entries, QWidget* parent)
    : QDialog(parent, Qt::Popup | Qt::FramelessWindowHint), m_entries(std::move(entries))
{
    setObjectName(QStringLiteral("palette"));
    setWindowTitle(title);
    setAttribute(Qt::WA_DeleteOnClose);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(8, 8, 8, 8);
    m_line = new QLineEdit(this);
    describe(m_line, "paletteLine", title);
    m_line->setPlaceholderText(placeholder);
    m_line->addAction(icon(QStringLiteral("search"), Role::Dim), QLineEdit::LeadingPosition);
    m_line->installEventFilter(this);
    m_list = new QListView(this);
    describe(m_list, "paletteList", tr("Found"));
    m_list->setFocusPolicy(Qt::NoFocus);
    m_list->setEditTriggers(QAbstractItemView::NoEditTriggers);
    m_list->setItemDelegate(new EntryDelegate(m_list));
    m_list->setUniformItemSizes(true);
    m_list->setMouseTracking(true);
    m_model = new QStandardItemModel(this);
    m_list->setModel(m_model);
    column->addWidget(m_line);
    column->addWidget(m_list);
    setStyleSheet(QStringLiteral("#palette { border: 1px solid %1; background: %2; }").arg(theme().name(Role::Line), theme().name(Role::Surface)));
    resize(560, 420);
    if (parent) {
        const QPoint top = parent->mapToGlobal(QPoint((parent->width() - width()) / 2, 70));
        move(top);
    }
    connect(m_line, &QLineEdit::textChanged, this, &Palette::refill);
    connect(m_line, &QLineEdit::returnPressed, this, &Palette::choose);
    connect(m_list, &QListView::clicked, this, &Palette::choose);
    refill();
    m_line->setFocus();
}

void Palette::refill()
{
    const QString typed = m_line->text().trimmed();
    std::vector<std::pair<int, std::size_t>> fits;
    for (std::size_t i = 0; i < m_entries.size(); ++i) {
        const int score = typed.isEmpty() ? 0 : matchScore(typed, m_entries[i].text);
        if (score >= 0)
            fits.emplace_back(-score, i);
    }
    std::sort(fits.begin(), fits.end());
    if (fits.size() > MaxShown)
        fits.resize(MaxShown);
    m_shown.clear();
    m_model->clear();
    for (const auto& [score, i] : fits) {
        m_shown.push_back(i);
        auto* item = new QStandardItem(m_entries[i].text);
        item->setData(m_entries[i].detail, Qt::UserRole);
        item->setData(m_entries[i].iconName, Qt::UserRole + 1);
        item->setAccessibleText(m_entries[i].text + QLatin1String(", ") + m_entries[i].detail);
        m_model->appendRow(item);
    }
    m_list->setCurrentIndex(m_model->index(0, 0));
}

void Palette::choose()
{
    const int row = m_list->currentIndex().row();
    if (row < 0 || row >= int(m_shown.size()))
        return;
    const auto go = m_entries[m_shown[std::size_t(row)]].go;
    close();
    go();
}

bool Palette::eventFilter(QObject* watched, QEvent* event)
{
    if (watched == m_line && event->type() == QEvent::KeyPress) {
        const int key = static_cast<QKeyEvent*>(event)->key();
        const int rows = m_model->rowCount();
        if ((key == Qt::Key_Down || key == Qt::Key_Up) && rows > 0) {
            const int step = key == Qt::Key_Down ? 1 : -1;
            m_list->setCurrentIndex(m_model->index((m_list->currentIndex().row() + step + rows) % rows, 0));
            return true;
        }
    }
    return QDialog::eventFilter(watched, event);
}

std::vector<PaletteEntry> findableObjects(Context& context)
{
    std::vector<PaletteEntry> out;
    ProjectTreeModel tree(context.document());
    Context* target = &context;
    for (const auto& [key, object] : context.document().project().all()) {
        if (key.kind == ObjectKind::Project)
            continue;
        const QModelIndex index = tree.indexOf(key);
        out.push_back({index.data().toString(), sectionTitle(key.kind), index.data(ProjectTreeModel::IconRole).toString(), [target, key = key] { target->open(key); }});
        const auto* table = std::get_if<VariableTable>(&object->content);
        for (std::size_t row = 0; table && row < table->rowCount(); ++row) {
            const Variable& variable = table->row(row);
            const Place place{key, "rows[" + std::to_string(row) + "]", {}, {}};
            out.push_back({QString::fromStdString(variable.name), QString::fromStdString(variable.address), QStringLiteral("variables"),
                [target, place] { target->reveal(place); }});
        }
    }
    return out;
}

std::vector<PaletteEntry> findableActions(Context& context)
{
    std::vector<PaletteEntry> out;
    for (const ActionRow& row : context.actions().rows()) {
        QAction* action = context.actions().action(QString::fromLatin1(row.id));
        if (!action->isEnabled())
            continue;
        out.push_back({words::plainName(action->text()), action->shortcut().toString(QKeySequence::NativeText), QString::fromLatin1(row.icon), [action] { action->trigger(); }});
    }
    return out;
}

} // namespace camwright
