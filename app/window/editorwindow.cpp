#include "app/window/editorwindow.h"

#include "app/window/editorgroup.h"
#include "app/window/grouptree.h"
#include "editors/shell/icons.h"

#include <QCloseEvent>
#include <QGuiApplication>
#include <QScreen>
#include <QVBoxLayout>

#include <algorithm>

namespace camwright {

EditorWindow::EditorWindow(EditorGroup* first) : m_column(new QVBoxLayout(this)), m_tree(new GroupTree(first))
{
    setObjectName(QStringLiteral("editorWindow"));
    setAttribute(Qt::WA_QuitOnClose, false);
    setAttribute(Qt::WA_StyledBackground);
    setWindowIcon(icon(QStringLiteral("cam"), Role::Accent));
    setMinimumSize(360, 240);
    m_column->setContentsMargins(0, 0, 0, 0);
    m_column->setSpacing(0);
    m_column->addWidget(m_tree, 1);
}

void EditorWindow::setHead(QWidget* head)
{
    m_column->insertWidget(0, head);
}

void EditorWindow::place(const QRect& wanted)
{
    QRect place = wanted;
    const QScreen* screen = QGuiApplication::screenAt(place.topLeft());
    if (!screen)
        screen = QGuiApplication::primaryScreen();
    const QRect room = screen->availableGeometry();
    place.setSize(place.size().boundedTo(room.size()));
    place.moveLeft(std::clamp(place.left(), room.left(), room.right() + 1 - place.width()));
    place.moveTop(std::clamp(place.top(), room.top(), room.bottom() + 1 - place.height()));
    setGeometry(place);
}

void EditorWindow::closeEvent(QCloseEvent* event)
{
    emit closing();
    event->accept();
}

} // namespace camwright
