// Layouts of the main window: kept per screen and preset, those of the editors per project too.
#include "app/window/mainwindow.h"

#include "app/window/panelstack.h"

#include <QDataStream>
#include <QIODevice>
#include <QSplitter>
#include <QStackedWidget>
#include <QTabBar>

namespace camwright {

namespace {

QString presetKey(Layout layout)
{
    static const char* keys[] = {"configure", "program", "commission", "analyse"};
    return QString::fromLatin1(keys[int(layout)]);
}

} // namespace

void MainWindow::setLayoutPreset(Layout layout)
{
    if (layout != m_layout)
        saveLayout();
    restoreLayout(layout);
    refreshActions();
}

void MainWindow::saveLayout()
{
    if (m_pages->currentIndex() == 0 || !m_keepsLayouts)
        return;
    QByteArray bytes;
    QDataStream out(&bytes, QIODevice::WriteOnly);
    out << m_left->isVisibleTo(m_across) << m_right->isVisibleTo(m_across) << m_bottom->isVisibleTo(m_down) << m_across->saveState()
        << m_down->saveState() << m_left->saveState() << m_bottom->currentId();
    m_workspace.settings.setLayout(presetKey(m_layout), bytes);
    if (const Arrangement editors = m_editors->arrangement(); m_workspace.document.isOpen())
        m_workspace.settings.setEditors(m_workspace.document.path(), presetKey(m_layout), editors.toBytes());
}

bool MainWindow::restoreEditors(EditorArea::Missing missing)
{
    const auto kept = Arrangement::fromBytes(m_workspace.settings.editors(m_workspace.document.path(), presetKey(m_layout)));
    if (!kept || kept->isEmpty())
        return false;
    m_editors->arrange(*kept, missing);
    return m_editors->count() > 0;
}

void MainWindow::restoreLayout(Layout layout)
{
    m_layout = layout;
    m_presets->setCurrentIndex(int(layout));
    setDefaultLayout(layout);
    restoreDocks(layout);
    if (!m_workspace.document.isOpen())
        return;
    restoreEditors(EditorArea::Missing::LeaveClosed);
    showPresetView(layout);
}

void MainWindow::restoreDocks(Layout layout)
{
    QDataStream in(m_workspace.settings.layout(presetKey(layout)));
    bool left = false, right = false, bottom = false;
    QByteArray across, down, inLeft;
    QString panel;
    in >> left >> right >> bottom >> across >> down >> inLeft >> panel;
    if (in.status() != QDataStream::Ok)
        return;
    m_left->setVisible(left);
    m_right->setVisible(right && !m_right->isEmpty());
    m_bottom->setVisible(bottom);
    m_across->restoreState(across);
    m_down->restoreState(down);
    m_left->restoreState(inLeft);
    m_bottom->showPanel(panel);
}

void MainWindow::setDefaultLayout(Layout layout)
{
    const bool side = layout == Layout::Configure || layout == Layout::Program;
    m_left->setVisible(true);
    m_right->setVisible(side && !m_right->isEmpty());
    m_bottom->setVisible(true);
    m_across->setSizes({236, 936, 268});
    const int foot[] = {100, 190, 380, 560};
    m_down->setSizes({800 - foot[int(layout)], foot[int(layout)]});
    m_left->setSizes({600, 180});
    const QString shown = layout == Layout::Program ? QStringLiteral("watch") : layout == Layout::Configure ? QStringLiteral("problems")
        : m_bottom->has(QStringLiteral("trace"))    ? QStringLiteral("trace")
                                                    : QStringLiteral("log");
    m_bottom->showPanel(shown);
}

/// What a layout is for is in sight at once.
void MainWindow::showPresetView(Layout layout)
{
    if (layout == Layout::Analyse)
        showPanel(QStringLiteral("trace"));
    if (layout != Layout::Commission)
        return;
    const auto axes = m_workspace.document.project().objects(ObjectKind::Axis);
    if (!axes.empty() && m_workspace.registry.view(QStringLiteral("axis.commissioning")))
        m_editors->open(axes.front()->key, QStringLiteral("axis.commissioning"), false);
}

} // namespace camwright
