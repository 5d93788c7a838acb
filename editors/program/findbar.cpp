#include "editors/program/findbar.h"

#include "editors/shell/icons.h"
#include "editors/shell/theme.h"

#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QToolButton>
#include <QVBoxLayout>

namespace camwright {

namespace {

QHBoxLayout* newRow()
{
    auto* row = new QHBoxLayout;
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(Theme::Grid);
    return row;
}

QLineEdit* newField(const QString& name, const QString& placeholder, QWidget* parent)
{
    auto* field = new QLineEdit(parent);
    field->setObjectName(name);
    field->setPlaceholderText(placeholder);
    field->setAccessibleName(placeholder);
    field->setToolTip(placeholder);
    field->setClearButtonEnabled(true);
    field->setFont(theme().monoFont());
    field->setFixedWidth(280);
    return field;
}

} // namespace

FindBar::FindBar(QWidget* parent)
    : QWidget(parent), m_find(newField(QStringLiteral("findText"), tr("Find"), this)),
      m_replace(newField(QStringLiteral("replaceText"), tr("Replace with"), this)),
      m_case(option(QStringLiteral("Aa"), QStringLiteral("findMatchCase"), tr("Tell upper from lower case"))),
      m_word(option(QStringLiteral("W"), QStringLiteral("findWholeWord"), tr("Whole words only; %M0.1 is one word"))),
      m_expression(option(QStringLiteral(".*"), QStringLiteral("findRegularExpression"), tr("Regular expression; \\1 in the replacement stands for the first group"))),
      m_count(new QLabel(this)), m_replaceRow(new QWidget(this))
{
    setObjectName(QStringLiteral("findBar"));
    m_count->setObjectName(QStringLiteral("findCount"));
    auto* previous = button(QStringLiteral("arrow-up"), QStringLiteral("findPrevious"), tr("Previous hit"));
    auto* next = button(QStringLiteral("arrow-down"), QStringLiteral("findNext"), tr("Next hit (Enter)"));
    auto* close = button(QStringLiteral("close"), QStringLiteral("findClose"), tr("Close (Esc)"));

    auto* findRow = newRow();
    for (QWidget* widget : std::initializer_list<QWidget*>{m_find, m_case, m_word, m_expression, previous, next, m_count})
        findRow->addWidget(widget);
    findRow->addStretch();
    findRow->addWidget(close);

    auto* one = new QPushButton(tr("Replace"), m_replaceRow);
    auto* all = new QPushButton(tr("Replace All"), m_replaceRow);
    one->setObjectName(QStringLiteral("replaceOne"));
    all->setObjectName(QStringLiteral("replaceAll"));
    one->setToolTip(tr("Replace this hit and go to the next"));
    all->setToolTip(tr("Replace every hit; one step to undo"));
    auto* replaceRow = newRow();
    replaceRow->addWidget(m_replace);
    replaceRow->addWidget(one);
    replaceRow->addWidget(all);
    replaceRow->addStretch();
    m_replaceRow->setLayout(replaceRow);

    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(8, 6, 8, 6);
    layout->setSpacing(Theme::Grid);
    layout->addLayout(findRow);
    layout->addWidget(m_replaceRow);

    connect(m_find, &QLineEdit::textChanged, this, &FindBar::queryChanged);
    for (QToolButton* toggle : {m_case, m_word, m_expression})
        connect(toggle, &QToolButton::toggled, this, &FindBar::queryChanged);
    connect(next, &QToolButton::clicked, this, [this] { emit findRequested(true); });
    connect(previous, &QToolButton::clicked, this, [this] { emit findRequested(false); });
    connect(close, &QToolButton::clicked, this, &FindBar::closed);
    connect(one, &QPushButton::clicked, this, &FindBar::replaceRequested);
    connect(all, &QPushButton::clicked, this, &FindBar::replaceAllRequested);
}

QToolButton* FindBar::option(const QString& text, const QString& name, const QString& toolTip)
{
    auto* toggle = new QToolButton(this);
    toggle->setObjectName(name);
    toggle->setText(text);
    toggle->setToolTip(toolTip);
    toggle->setAccessibleName(toolTip);
    toggle->setCheckable(true);
    return toggle;
}

QToolButton* FindBar::button(const QString& iconName, const QString& name, const QString& toolTip)
{
    auto* out = new QToolButton(this);
    out->setObjectName(name);
    out->setIcon(icon(iconName));
    out->setToolTip(toolTip);
    out->setAccessibleName(toolTip);
    out->setAutoRaise(true);
    return out;
}

SearchQuery FindBar::query() const
{
    return {m_find->text(), m_case->isChecked(), m_word->isChecked(), m_expression->isChecked()};
}

QString FindBar::replacement() const
{
    return m_replace->text();
}

void FindBar::open(const QString& text, bool withReplace)
{
    m_replaceRow->setVisible(withReplace);
    show();
    if (!text.isEmpty() && !text.contains(QLatin1Char('\n')))
        m_find->setText(text);
    m_find->setFocus(Qt::ShortcutFocusReason);
    m_find->selectAll();
    emit queryChanged();
}

void FindBar::showCount(int current, int total)
{
    m_count->setStyleSheet({});
    if (m_find->text().isEmpty())
        m_count->clear();
    else if (total == 0)
        m_count->setText(tr("not found"));
    else
        m_count->setText(current > 0 ? tr("%1 of %2").arg(current).arg(total) : tr("%n hit(s)", nullptr, total));
}

void FindBar::showError(const QString& sentence)
{
    m_count->setStyleSheet(QStringLiteral("color: %1").arg(theme().name(Role::Error)));
    m_count->setText(sentence);
}

void FindBar::keyPressEvent(QKeyEvent* event)
{
    if (event->key() == Qt::Key_Escape)
        emit closed();
    else if (event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter)
        m_replace->hasFocus() ? emit replaceRequested() : emit findRequested(!(event->modifiers() & Qt::ShiftModifier));
    else
        QWidget::keyPressEvent(event);
}

} // namespace camwright
