#include "app/window/toolrow.h"

#include "editors/shell/actions.h"
#include "editors/shell/icons.h"
#include "editors/shell/widgets.h"
#include "editors/words/words.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPainter>
#include <QStyle>
#include <QToolButton>

namespace camwright {

namespace {

/// Looks like a field, is a button: a glass, words, the key.
class SearchButton : public QToolButton {
public:
    using QToolButton::QToolButton;
    QSize sizeHint() const override { return {210, 28}; }
    void setKey(const QString& key)
    {
        m_key = key;
        update();
    }

protected:
    void paintEvent(QPaintEvent*) override
    {
        QPainter painter(this);
        painter.setRenderHint(QPainter::Antialiasing);
        painter.setPen(theme().color(underMouse() || hasFocus() ? Role::Accent : Role::Line));
        painter.setBrush(theme().color(Role::Raised));
        painter.drawRoundedRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5), 5, 5);
        paintIcon(painter, QRectF(9, height() / 2.0 - 8, 16, 16), QStringLiteral("search"), Role::Dim);
        painter.setPen(theme().color(Role::Dim));
        painter.setFont(theme().font());
        painter.drawText(rect().adjusted(33, 0, -50, 0), Qt::AlignVCenter | Qt::AlignLeft, text());
        painter.setFont(theme().smallFont());
        painter.drawText(rect().adjusted(0, 0, -9, 0), Qt::AlignVCenter | Qt::AlignRight, m_key);
    }

private:
    QString m_key;
};

} // namespace

ToolRow::ToolRow(Context& context, Connection& connection, Settings& settings, QWidget* parent)
    : QFrame(parent), m_context(context), m_connection(connection), m_settings(settings)
{
    setObjectName(QStringLiteral("toolRow"));
    setFixedHeight(40);
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(10, 0, 10, 0);
    row->setSpacing(4);
    for (const char* id : {"file.new", "file.open", "file.save"})
        addButton(row, QString::fromLatin1(id), false);
    addSeparator(row);
    for (const char* id : {"edit.undo", "edit.redo"})
        addButton(row, QString::fromLatin1(id), false);
    addSeparator(row);
    for (const char* id : {"project.check", "project.build"})
        addButton(row, QString::fromLatin1(id), true);
    addSeparator(row);
    m_address = new QComboBox(this);
    describe(m_address, "address", tr("Controller's address"),
        tr("<b>Controller's address</b><br>local: the virtual controller of this project. tcp://HOST[:PORT]: a controller on the network."));
    m_address->setEditable(true);
    m_address->setInsertPolicy(QComboBox::NoInsert);
    m_address->setFixedWidth(256);
    m_address->lineEdit()->setFont(theme().monoFont());
    m_address->lineEdit()->setTextMargins(14, 0, 0, 0);
    m_lamp = new QLabel(m_address);
    m_lamp->setFixedSize(12, 12);
    m_lamp->move(8, 8);
    m_lamp->setAttribute(Qt::WA_TransparentForMouseEvents);
    row->addWidget(m_address);
    m_online = new QToolButton(this);
    describe(m_online, "onlineButton", tr("Online"));
    m_online->setText(QLatin1Char(' ') + tr("Online"));
    m_online->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    m_online->setIconSize({16, 16});
    m_online->setFixedHeight(28);
    row->addWidget(m_online);
    for (const char* id : {"online.download", "online.run", "online.stop"})
        addButton(row, QString::fromLatin1(id), true);
    row->addStretch();
    auto* search = new SearchButton(this);
    m_search = search;
    describe(m_search, "searchButton", tr("Find anything"));
    const auto showKey = [search, find = context.actions().action(QStringLiteral("go.anything"))] {
        search->setKey(find->shortcut().toString(QKeySequence::NativeText));
        search->setToolTip(find->toolTip());
    };
    showKey();
    connect(&context.actions(), &ActionCatalogue::keysChanged, search, showKey);
    m_search->setText(tr("Find anything"));
    row->addWidget(m_search);
    connect(m_search, &QToolButton::clicked, context.actions().action(QStringLiteral("go.anything")), &QAction::trigger);
    connect(m_online, &QToolButton::clicked, this, [this] {
        const bool offline = m_connection.state() == LinkState::Offline;
        m_context.actions().action(offline ? QStringLiteral("online.connect") : QStringLiteral("online.disconnect"))->trigger();
    });
    connect(m_address->lineEdit(), &QLineEdit::returnPressed, context.actions().action(QStringLiteral("online.connect")), &QAction::trigger);
    connect(&connection, &Connection::stateChanged, this, &ToolRow::refresh);
    connect(&context, &Context::linkChanged, this, &ToolRow::refresh);
    connect(&context.document(), &ProjectDocument::pathChanged, this, &ToolRow::refresh);
    connect(&theme(), &Theme::changed, this, &ToolRow::refresh);
    refreshAddresses();
}

QToolButton* ToolRow::addButton(QHBoxLayout* row, const QString& actionId, bool withText)
{
    auto* button = new QToolButton(this);
    QAction* action = m_context.actions().action(actionId);
    button->setDefaultAction(action);
    button->setObjectName(actionId);
    const QString name = words::plainName(action->text());
    button->setAccessibleName(name);
    // A blank keeps the word off the icon.
    const QString shown = QLatin1Char(' ') + name;
    button->setText(shown);
    button->setIconSize({16, 16});
    button->setFixedHeight(28);
    button->setToolButtonStyle(withText ? Qt::ToolButtonTextBesideIcon : Qt::ToolButtonIconOnly);
    connect(action, &QAction::changed, button, [button, shown] { button->setText(shown); });
    row->addWidget(button);
    return button;
}

void ToolRow::addSeparator(QHBoxLayout* row)
{
    auto* line = new QFrame(this);
    line->setProperty("surface", "line");
    line->setFixedSize(1, 20);
    row->addSpacing(6);
    row->addWidget(line);
    row->addSpacing(6);
}

QString ToolRow::address() const
{
    const QString typed = m_address->currentText().trimmed();
    return typed.startsWith(QLatin1String("local")) || typed.isEmpty() ? QStringLiteral("local") : typed;
}

void ToolRow::refreshAddresses()
{
    const QString typed = m_address->currentText();
    m_address->clear();
    for (const QString& address : m_settings.addresses())
        m_address->addItem(address == QLatin1String("local") ? tr("local · virtual controller") : address);
    if (!typed.isEmpty())
        m_address->setEditText(typed);
    refresh();
}

void ToolRow::refresh()
{
    setStyleSheet(QStringLiteral("#toolRow { background: %1; border: none; border-bottom: 1px solid %2; } "
                                 "#toolRow QComboBox { background: %3; border-radius: 5px; } #toolRow QComboBox QLineEdit { border: none; background: transparent; padding: 0; min-height: 20px; } "
                                 "#toolRow QComboBox:disabled, #toolRow QComboBox:disabled QLineEdit { color: %4; }")
                      .arg(theme().name(Role::Surface), theme().name(Role::Line), theme().name(Role::Raised), theme().name(Role::Dim)));
    const LinkState state = m_connection.state();
    const bool offline = state == LinkState::Offline;
    const bool open = m_context.document().isOpen();
    m_address->setEnabled(open && offline);
    m_address->lineEdit()->setPlaceholderText(tr("no controller"));
    if (!open)
        m_address->setEditText({});
    else if (m_address->currentText().isEmpty())
        m_address->setCurrentIndex(0);
    m_address->lineEdit()->setCursorPosition(0);
    const bool simulated = !m_context.link() || m_context.link()->capabilities().simulated || m_connection.address() == QLatin1String("local");
    const Role ink = offline ? Role::Idle : state == LinkState::Lost ? Role::Error : simulated ? Role::Simulated : Role::Real;
    m_lamp->setPixmap(iconPixmap(offline ? QStringLiteral("ring") : simulated ? QStringLiteral("dot") : QStringLiteral("square"), 12, ink, devicePixelRatioF()));
    QAction* connectAction = m_context.actions().action(offline ? QStringLiteral("online.connect") : QStringLiteral("online.disconnect"));
    m_online->setIcon(icon(QStringLiteral("plug"), offline ? Role::Text : Role::OnAccent));
    m_online->setEnabled(open);
    m_online->setToolTip(connectAction->toolTip());
    m_online->setProperty("hot", !offline);
    m_online->style()->unpolish(m_online);
    m_online->style()->polish(m_online);
}

} // namespace camwright
