// Editors side by side, below one another and in windows of their own: by keys, by the mouse, and remembered.
#include "app/window/connectionstrip.h"
#include "app/window/dropzone.h"
#include "app/window/editortabbar.h"
#include "app/window/editorwindow.h"
#include "editors/document/editcommands.h"
#include "plainwindow.h"

#include <QSettings>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <QtTest>

using namespace camwright;

namespace {

const ObjectKey Lift{ObjectKind::Axis, "Lift"};

QStringList titles(const EditorGroup& group)
{
    QStringList out;
    for (const EditorGroup::Tab& tab : group.tabs())
        out << tab.title;
    return out;
}

} // namespace

class EditorSplitTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase()
    {
        QStandardPaths::setTestModeEnabled(true);
        QCoreApplication::setOrganizationName("camwright-test");
        QCoreApplication::setApplicationName("editorsplit");
    }

    void init()
    {
        QSettings().clear();
        m_dir = std::make_unique<QTemporaryDir>();
        m_workspace = std::make_unique<Workspace>(fakeServices(), registerPlain);
        Axis third;
        third.number = 3;
        QVERIFY(m_workspace->document.create(twoAxes().withContent(Lift, third), m_dir->filePath("three")).ok());
        makeWindow();
        for (const ObjectKey& key : {Feed, Turn, Lift})
            m_workspace->context.open(key);
    }

    void cleanup()
    {
        m_window.reset();
        m_workspace.reset();
    }

    // --- splitting by keys

    void splitsToTheRightByKey()
    {
        press(Qt::Key_R, Qt::ControlModifier | Qt::ShiftModifier);
        QCOMPARE(groups().size(), 2u);
        QCOMPARE(titles(*groups()[0]), (QStringList{"Feed", "Turn"}));
        QCOMPARE(titles(*groups()[1]), QStringList{"Lift"});
        QTRY_VERIFY(groups()[1]->mapToGlobal(QPoint()).x() > groups()[0]->mapToGlobal(QPoint()).x());
        QCOMPARE(area().current()->key(), Lift);
        QVERIFY(groups()[1]->isAncestorOf(QApplication::focusWidget()));
    }

    void splitsDownByKeyInsideASplit()
    {
        press(Qt::Key_R, Qt::ControlModifier | Qt::ShiftModifier);
        press(Qt::Key_F6, Qt::ShiftModifier);
        QCOMPARE(area().current()->key(), Turn);
        press(Qt::Key_D, Qt::ControlModifier | Qt::ShiftModifier);
        QCOMPARE(groups().size(), 3u);
        QCOMPARE(titles(*groups()[1]), QStringList{"Turn"});
        QTRY_VERIFY(groups()[1]->mapToGlobal(QPoint()).y() > groups()[0]->mapToGlobal(QPoint()).y());
        QCOMPARE(groups()[1]->mapToGlobal(QPoint()).x(), groups()[0]->mapToGlobal(QPoint()).x());
    }

    void loneTabLeavesAnEmptyGroupThatTakesTheNextEditor()
    {
        area().closeAll();
        m_workspace->context.open(Feed);
        press(Qt::Key_R, Qt::ControlModifier | Qt::ShiftModifier);
        QCOMPARE(groups().size(), 2u);
        QVERIFY(!area().current());
        m_workspace->context.open(Turn);
        QCOMPARE(titles(*groups()[1]), QStringList{"Turn"});
    }

    void emptyGroupIsClosedByTheCloseKey()
    {
        area().closeAll();
        m_workspace->context.open(Feed);
        area().split(Side::Below);
        press(Qt::Key_W, Qt::ControlModifier);
        QCOMPARE(groups().size(), 1u);
        QCOMPARE(area().current()->key(), Feed);
    }

    void movesTheTabToTheOtherGroupByKeyAndBack()
    {
        press(Qt::Key_R, Qt::ControlModifier | Qt::ShiftModifier);
        press(Qt::Key_F6);
        press(Qt::Key_F6, Qt::ControlModifier);
        QCOMPARE(titles(*groups()[0]), QStringList{"Feed"});
        QCOMPARE(titles(*groups()[1]), (QStringList{"Lift", "Turn"}));
        QCOMPARE(area().current()->key(), Turn);
        press(Qt::Key_F6, Qt::ControlModifier);
        QCOMPARE(titles(*groups()[0]), (QStringList{"Feed", "Turn"}));
    }

    void groupGoesWithItsLastTab()
    {
        press(Qt::Key_R, Qt::ControlModifier | Qt::ShiftModifier);
        press(Qt::Key_W, Qt::ControlModifier);
        QCOMPARE(groups().size(), 1u);
        QCOMPARE(area().current()->key(), Turn);
        QVERIFY(!m_workspace->actions.action("go.nextGroup")->isEnabled());
    }

    void tabsAreSteppedAndMovedByKeyInsideTheirGroup()
    {
        press(Qt::Key_Tab, Qt::ControlModifier);
        QCOMPARE(area().current()->key(), Feed);
        press(Qt::Key_PageDown, Qt::ControlModifier | Qt::ShiftModifier);
        QCOMPARE(titles(*groups()[0]), (QStringList{"Turn", "Feed", "Lift"}));
        QCOMPARE(area().current()->key(), Feed);
    }

    void objectOpenInAnotherGroupIsShownThere()
    {
        press(Qt::Key_R, Qt::ControlModifier | Qt::ShiftModifier);
        m_workspace->context.open(Feed);
        QCOMPARE(groups()[0]->count() + groups()[1]->count(), 3);
        QCOMPARE(&area().activeGroup(), groups()[0]);
        QCOMPARE(area().current()->key(), Feed);
    }

    void backGoesToTheGroupOfThePlace()
    {
        press(Qt::Key_R, Qt::ControlModifier | Qt::ShiftModifier);
        press(Qt::Key_F6);
        QCOMPARE(area().current()->key(), Turn);
        press(Qt::Key_Left, Qt::AltModifier);
        QCOMPARE(area().current()->key(), Lift);
        QCOMPARE(&area().activeGroup(), groups()[1]);
    }

    void uniteEndsEverySplit()
    {
        press(Qt::Key_R, Qt::ControlModifier | Qt::ShiftModifier);
        area().toggleOwnWindow();
        area().split(Side::Below);
        m_workspace->actions.action("view.unite")->trigger();
        QCOMPARE(groups().size(), 1u);
        QCOMPARE(groups()[0]->count(), 3);
    }

    // --- windows

    void tabGetsAWindowOfItsOwnByKeyAndComesBack()
    {
        press(Qt::Key_O, Qt::ControlModifier | Qt::ShiftModifier);
        EditorWindow* window = floating();
        QVERIFY(window);
        QVERIFY(window->isVisible());
        QCOMPARE(titles(*window->tree().groups().front()), QStringList{"Lift"});
        QVERIFY(area().isInOwnWindow());
        QTest::keyClick(window, Qt::Key_O, Qt::ControlModifier | Qt::ShiftModifier);
        QVERIFY(!floating());
        QCOMPARE(titles(*groups()[0]), (QStringList{"Feed", "Turn", "Lift"}));
        QCOMPARE(area().current()->key(), Lift);
    }

    void sameDocumentAndSameUndoInAWindowOfItsOwn()
    {
        press(Qt::Key_O, Qt::ControlModifier | Qt::ShiftModifier);
        editObject<Axis>(m_workspace->document, Lift, "Change guard time", "guard_time_ms", [](Axis& axis) { axis.guardTimeMs = 5; });
        EditorWindow* window = floating();
        QApplication::setActiveWindow(window);
        QTest::keyClick(window, Qt::Key_Z, Qt::ControlModifier);
        QCOMPARE(m_workspace->document.content<Axis>(Lift)->guardTimeMs.value(), 1000);
        QTest::keyClick(window, Qt::Key_S, Qt::ControlModifier);
        QVERIFY(!m_window->isWindowModified());
    }

    void closingTheWindowBringsItsTabsBack()
    {
        press(Qt::Key_O, Qt::ControlModifier | Qt::ShiftModifier);
        QVERIFY(floating()->close());
        QVERIFY(!floating());
        QCOMPARE(titles(*groups()[0]), (QStringList{"Feed", "Turn", "Lift"}));
    }

    void closingTheMainWindowClosesTheOthersAndLosesNothing()
    {
        press(Qt::Key_O, Qt::ControlModifier | Qt::ShiftModifier);
        QPointer<EditorWindow> window = floating();
        editObject<Axis>(m_workspace->document, Lift, "Change guard time", "guard_time_ms", [](Axis& axis) { axis.guardTimeMs = 5; });
        QTimer::singleShot(0, this, [] {
            for (QWidget* box : QApplication::topLevelWidgets()) {
                if (box->objectName() == "question")
                    QTest::keyClick(box, Qt::Key_Return); // "Save"
            }
        });
        QVERIFY(m_window->close());
        QVERIFY(!window || !window->isVisible());
        QFile file(m_dir->filePath("three/axes/Lift.toml"));
        QVERIFY(file.open(QIODevice::ReadOnly));
        QVERIFY(file.readAll().contains("guard_time_ms = 5"));
    }

    void keysOfTheMainWindowNeverActOnTheOther()
    {
        press(Qt::Key_O, Qt::ControlModifier | Qt::ShiftModifier);
        QWidget* outside = m_window->findChild<QTabBar*>("presets");
        QApplication::setActiveWindow(m_window.get());
        outside->setFocus();
        QTRY_VERIFY(!area().isInOwnWindow());
        press(Qt::Key_W, Qt::ControlModifier);
        QVERIFY(floating());
        QCOMPARE(titles(*groups()[0]), QStringList{"Feed"});
    }

    void otherWindowTellsWhichMachineIsMeant()
    {
        press(Qt::Key_O, Qt::ControlModifier | Qt::ShiftModifier);
        auto* strip = floating()->findChild<ConnectionStrip*>("connectionStrip");
        QVERIFY(strip);
        QVERIFY(!strip->isVisible());
        m_workspace->connection.connectTo("local");
        QVERIFY(strip->isVisible());
    }

    void windowGoesWithItsObject()
    {
        press(Qt::Key_O, Qt::ControlModifier | Qt::ShiftModifier);
        removeObjects(m_workspace->document, std::span(&Lift, 1));
        QVERIFY(!floating());
        QCOMPARE(area().count(), 2);
    }

    void closedProjectClosesTheWindows()
    {
        press(Qt::Key_O, Qt::ControlModifier | Qt::ShiftModifier);
        m_workspace->actions.action("file.close")->trigger();
        QVERIFY(!floating());
        QCOMPARE(area().count(), 0);
    }

    // --- the mouse

    void tabIsDraggedAlongTheStrip()
    {
        EditorTabBar* bar = barOf(0);
        QTest::mousePress(bar, Qt::LeftButton, {}, bar->tabRect(0).center());
        QTest::mouseMove(bar, bar->tabRect(1).center());
        QTest::mouseMove(bar, bar->tabRect(2).center() + QPoint(4, 0));
        QTest::mouseRelease(bar, Qt::LeftButton, {}, bar->tabRect(2).center() + QPoint(4, 0));
        QCOMPARE(titles(*groups()[0]), (QStringList{"Turn", "Lift", "Feed"}));
        QCOMPARE(area().current()->key(), Feed);
    }

    void tabDraggedOntoAnEdgeSplits_data()
    {
        QTest::addColumn<double>("x");
        QTest::addColumn<double>("y");
        QTest::addColumn<QStringList>("first");
        QTest::addColumn<bool>("sideBySide");
        QTest::newRow("left") << 0.02 << 0.5 << QStringList{"Turn"} << true;
        QTest::newRow("right") << 0.98 << 0.5 << QStringList{"Feed", "Lift"} << true;
        QTest::newRow("below") << 0.5 << 0.97 << QStringList{"Feed", "Lift"} << false;
        QTest::newRow("above") << 0.5 << 0.15 << QStringList{"Turn"} << false;
    }

    void tabDraggedOntoAnEdgeSplits()
    {
        QFETCH(double, x);
        QFETCH(double, y);
        QFETCH(QStringList, first);
        QFETCH(bool, sideBySide);
        EditorGroup* group = groups()[0];
        drag(0, 1, group->mapToGlobal(QPoint(int(group->width() * x), int(group->height() * y))));
        QCOMPARE(groups().size(), 2u);
        QCOMPARE(titles(*groups()[0]), first);
        QTRY_VERIFY(groups()[1]->mapToGlobal(QPoint()) != groups()[0]->mapToGlobal(QPoint()));
        const QPoint between = groups()[1]->mapToGlobal(QPoint()) - groups()[0]->mapToGlobal(QPoint());
        QCOMPARE(between.x() > 0, sideBySide);
        QCOMPARE(between.y() > 0, !sideBySide);
        QCOMPARE(area().current()->key(), Turn);
    }

    void tabDraggedIntoAnotherStripStandsWhereItWasDropped()
    {
        press(Qt::Key_R, Qt::ControlModifier | Qt::ShiftModifier);
        EditorTabBar* target = barOf(0);
        drag(1, 0, target->mapToGlobal(target->tabRect(0).center() - QPoint(8, 0)));
        QCOMPARE(groups().size(), 1u);
        QCOMPARE(titles(*groups()[0]), (QStringList{"Lift", "Feed", "Turn"}));
        QCOMPARE(area().current()->key(), Lift);
    }

    void tabDraggedOutGetsAWindowAndIsDraggedBack()
    {
        m_window->setGeometry(0, 0, 1000, 560);
        const QRect screen = QGuiApplication::primaryScreen()->geometry();
        QVERIFY(screen.height() > 600);
        drag(0, 1, QPoint(300, 590));
        EditorWindow* window = floating();
        QVERIFY(window);
        QCOMPARE(titles(*window->tree().groups().front()), QStringList{"Turn"});
        window->move(screen.width() - 60, screen.height() - 60); // away from the main window
        EditorGroup* main = groups()[0];
        auto* bar = window->findChild<EditorTabBar*>();
        dragFrom(*bar, 0, main->mapToGlobal(main->rect().center()));
        QVERIFY(!floating());
        QCOMPARE(titles(*groups()[0]), (QStringList{"Feed", "Lift", "Turn"}));
    }

    void escapePutsADraggedTabBack()
    {
        EditorTabBar* bar = barOf(0);
        EditorGroup* group = groups()[0];
        const QPoint edge = bar->mapFromGlobal(group->mapToGlobal(QPoint(group->width() - 5, group->height() / 2)));
        QTest::mousePress(bar, Qt::LeftButton, {}, bar->tabRect(1).center());
        QTest::mouseMove(bar, edge);
        auto* mark = group->findChild<QWidget*>("dropMark");
        QVERIFY(mark && mark->isVisible());
        QTest::keyClick(m_window.get(), Qt::Key_Escape);
        QVERIFY(!mark->isVisible());
        QTest::mouseRelease(bar, Qt::LeftButton, {}, edge);
        QCOMPARE(groups().size(), 1u);
        QCOMPARE(titles(*groups()[0]), (QStringList{"Feed", "Turn", "Lift"}));
    }

    void clickIntoAnotherGroupMakesItActive()
    {
        press(Qt::Key_R, Qt::ControlModifier | Qt::ShiftModifier);
        EditorTabBar* bar = barOf(0);
        QTest::mouseClick(bar, Qt::LeftButton, {}, bar->tabRect(0).center());
        QCOMPARE(area().current()->key(), Feed);
        QCOMPARE(&area().activeGroup(), groups()[0]);
    }

    void middleOfAPageTakesTheTabInAndItsEdgesSplit()
    {
        const QRect page(0, 32, 800, 400);
        QVERIFY(!dropZoneOfPage(page, page.center()).side);
        QCOMPARE(*dropZoneOfPage(page, {10, 200}).side, Side::Left);
        QCOMPARE(*dropZoneOfPage(page, {790, 200}).side, Side::Right);
        QCOMPARE(*dropZoneOfPage(page, {400, 40}).side, Side::Above);
        QCOMPARE(*dropZoneOfPage(page, {400, 425}).side, Side::Below);
        QCOMPARE(dropZoneOfPage(page, {790, 200}).area, QRect(400, 32, 400, 400));
    }

    // --- remembered

    void projectOpensAsItWasLeft()
    {
        press(Qt::Key_R, Qt::ControlModifier | Qt::ShiftModifier);
        press(Qt::Key_F6);
        press(Qt::Key_O, Qt::ControlModifier | Qt::ShiftModifier);
        const Arrangement left = area().arrangement();
        QCOMPARE(left.windows.size(), 1u);
        QVERIFY(m_workspace->document.save().ok());
        m_workspace->actions.action("file.close")->trigger();
        QVERIFY(m_window->openProject(m_dir->filePath("three")));
        const Arrangement now = area().arrangement();
        QCOMPARE(now.main.parts.size(), 2u);
        QVERIFY(now.main.parts == left.main.parts);
        QCOMPARE(now.windows.size(), 1u);
        QCOMPARE(now.windows[0].root.tabs.size(), 1u);
        QCOMPARE(now.windows[0].root.tabs[0].key, Turn);
    }

    void pagesOfRememberedTabsAreMadeWhenTheyAreLookedAt()
    {
        QVERIFY(m_workspace->document.save().ok());
        m_workspace->actions.action("file.close")->trigger();
        QVERIFY(m_window->openProject(m_dir->filePath("three")));
        QCOMPARE(titles(*groups()[0]), (QStringList{"Feed", "Turn", "Lift"}));
        QVERIFY(!groups()[0]->tab(0).page);
        QVERIFY(!groups()[0]->tab(1).page);
        QVERIFY(groups()[0]->tab(2).page);
        barOf(0)->setCurrentIndex(0);
        QVERIFY(groups()[0]->tab(0).page);
    }

    void everyLayoutHasItsOwnSplit()
    {
        press(Qt::Key_R, Qt::ControlModifier | Qt::ShiftModifier);
        press(Qt::Key_1, Qt::ControlModifier);
        QCOMPARE(groups().size(), 2u);
        area().unite();
        press(Qt::Key_2, Qt::ControlModifier);
        QCOMPARE(groups().size(), 2u);
        QCOMPARE(titles(*groups()[1]), QStringList{"Lift"});
        press(Qt::Key_1, Qt::ControlModifier);
        QCOMPARE(groups().size(), 1u);
        QCOMPARE(area().current()->key(), Lift);
    }

    void tabClosedInOneLayoutStaysClosedInTheOther()
    {
        press(Qt::Key_R, Qt::ControlModifier | Qt::ShiftModifier);
        press(Qt::Key_1, Qt::ControlModifier);
        press(Qt::Key_W, Qt::ControlModifier);
        press(Qt::Key_2, Qt::ControlModifier);
        QCOMPARE(area().count(), 2);
    }

    void resetLayoutEndsTheSplit()
    {
        press(Qt::Key_R, Qt::ControlModifier | Qt::ShiftModifier);
        m_workspace->actions.action("view.resetLayout")->trigger();
        QCOMPARE(groups().size(), 1u);
        QCOMPARE(area().count(), 3);
    }

    void arrangementSurvivesItsBytes()
    {
        Arrangement all;
        all.main.horizontal = false;
        all.main.sizes = {100, 300};
        all.main.parts.resize(2);
        all.main.parts[0].tabs = {{Feed, "axis", true}, {{}, "panel", false}};
        all.main.parts[0].current = 1;
        all.main.parts[1].tabs = {{{ObjectKind::Program, "Ход 1"}, "program", false}};
        all.windows.push_back({QByteArray("\x01\x00\xff", 3), {}});
        all.windows[0].root.tabs = {{Turn, "axis", false}};
        const auto again = Arrangement::fromBytes(all.toBytes());
        QVERIFY(again);
        QVERIFY(*again == all);
    }

    void damagedArrangementIsRefused()
    {
        for (const char* bytes : {"", "[]", "{}", "{\"main\":{\"parts\":[{}],\"sizes\":[]}}", "{\"main\":{\"tabs\":[{\"view\":\"\"}]}}",
                 "{\"main\":{\"tabs\":[{\"view\":\"axis\",\"kind\":\"moon\",\"name\":\"x\"}]}}", "{\"main\":{},\"windows\":[{\"root\":{\"tabs\":[{}]}}]}"})
            QVERIFY2(!Arrangement::fromBytes(bytes), bytes);
        QByteArray deep = "{}";
        for (int i = 0; i < 12; ++i)
            deep = "{\"parts\":[" + deep + "],\"sizes\":[1]}";
        QVERIFY(!Arrangement::fromBytes("{\"main\":" + deep + "}"));
    }

private:
    void makeWindow()
    {
        m_window = std::make_unique<MainWindow>(*m_workspace);
        m_window->setGeometry(0, 0, 1200, 700);
        m_window->show();
        QVERIFY(QTest::qWaitForWindowExposed(m_window.get()));
    }

    EditorArea& area() const { return m_window->editors(); }
    std::vector<EditorGroup*> groups() const { return area().groups(); }
    EditorTabBar* barOf(int group) const { return groups()[std::size_t(group)]->findChild<EditorTabBar*>(); }

    static EditorWindow* floating()
    {
        for (QWidget* widget : QApplication::topLevelWidgets()) {
            if (auto* window = qobject_cast<EditorWindow*>(widget); window && window->isVisible())
                return window;
        }
        return nullptr;
    }

    void press(Qt::Key key, Qt::KeyboardModifiers modifiers = Qt::NoModifier)
    {
        QApplication::setActiveWindow(m_window.get());
        QVERIFY(QTest::qWaitForWindowActive(m_window.get()));
        QTest::keyClick(m_window.get(), key, modifiers);
    }

    void dragFrom(EditorTabBar& bar, int tab, const QPoint& global)
    {
        QTest::mousePress(&bar, Qt::LeftButton, {}, bar.tabRect(tab).center());
        QTest::mouseMove(&bar, bar.tabRect(tab).center() + QPoint(0, 60));
        QTest::mouseMove(&bar, bar.mapFromGlobal(global));
        QTest::mouseRelease(&bar, Qt::LeftButton, {}, bar.mapFromGlobal(global));
    }

    void drag(int group, int tab, const QPoint& global) { dragFrom(*barOf(group), tab, global); }

    std::unique_ptr<QTemporaryDir> m_dir;
    std::unique_ptr<Workspace> m_workspace;
    std::unique_ptr<MainWindow> m_window;
};

QTEST_MAIN(EditorSplitTest)
#include "tst_editorsplit.moc"
