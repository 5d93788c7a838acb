#include "app/window/docviewer.h"
#include "app/window/mainwindow.h"
#include "app/window/newprojectdialog.h"
#include "editors/log/logpanel.h"
#include "editors/shell/problemsview.h"
#include "editors/words/shipped.h"
#include "editors/words/words.h"
#include "fakelink.h"

#include <QContextMenuEvent>
#include <QMenu>
#include <QMenuBar>
#include <QSettings>
#include <QSignalSpy>
#include <QStandardPaths>
#include <QTableView>
#include <QTemporaryDir>
#include <QTextBrowser>
#include <QtTest>

using namespace camwright;

namespace {

Services servicesThatFind(Diagnostics found)
{
    Services out;
    out.check = [found](const Project&) { return found; };
    out.build = [](const Project&, Job&) { return BuildOutcome{}; };
    out.connectTo = [](const std::string&, const std::string&) -> Result<std::unique_ptr<ControllerLink>> { return std::unique_ptr<ControllerLink>(new FakeLink); };
    return out;
}

void registerProblemsAndLog(Registry& registry, ActionCatalogue&)
{
    registry.add(PanelFactory{QStringLiteral("problems"), QStringLiteral("Problems"), QStringLiteral("problems"), PanelArea::Bottom, 10,
        [](Context& context) -> Panel* { return new ProblemsView(context); }});
    registry.add(PanelFactory{QStringLiteral("log"), QStringLiteral("Log"), QStringLiteral("log"), PanelArea::Bottom, 20,
        [](Context& context) -> Panel* { return new LogPanel(context); }});
}

} // namespace

/// F1, the context menu and the Help menu open the page about a message, in the user's language.
class ExplainTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase()
    {
        QStandardPaths::setTestModeEnabled(true);
        QCoreApplication::setOrganizationName("camwright-test");
        QCoreApplication::setApplicationName("explain");
    }

    void init()
    {
        QSettings().clear();
        m_dir = std::make_unique<QTemporaryDir>();
        m_workspace = std::make_unique<Workspace>(
            servicesThatFind({diagnostic(Code::NoMainProgram), diagnostic(Code::AxisNumberTwice, {"1", "Feed", "Turn"})}), registerProblemsAndLog);
        QVERIFY(m_workspace->document.create(emptyProject("kinco", "KS101M-04DX", "two"), m_dir->filePath("two")).ok());
        m_window = std::make_unique<MainWindow>(*m_workspace);
        m_window->show();
        QApplication::setActiveWindow(m_window.get());
        QVERIFY(QTest::qWaitForWindowActive(m_window.get()));
        m_window->showPanel(QStringLiteral("problems"));
        m_table = m_window->findChild<QTableView*>("problemsTable");
        QVERIFY(m_table);
        QTRY_COMPARE(m_table->model()->rowCount(), 2);
    }

    void cleanup()
    {
        m_window.reset();
        m_workspace.reset();
        words::setLanguage(*QCoreApplication::instance(), "en");
    }

    void keyOpensThePageOfTheCurrentMessage()
    {
        select(1);
        QTest::keyClick(m_table, Qt::Key_F1);
        QVERIFY2(shownPage().startsWith(codeIn(1) + ": "), qPrintable(shownPage()));
    }

    void keyElsewhereOpensTheDocumentation()
    {
        m_table->setFocus();
        m_table->setCurrentIndex({});
        QTest::keyClick(m_table, Qt::Key_F1);
        QVERIFY(m_window->findChild<DocViewer*>());
        QVERIFY(!shownPage().startsWith("CW"));
    }

    void nextPageTakesTheSameWindow()
    {
        select(0);
        QTest::keyClick(m_table, Qt::Key_F1);
        select(1);
        QTest::keyClick(m_table, Qt::Key_F1);
        QCOMPARE(m_window->findChildren<DocViewer*>().size(), 1);
        QVERIFY(shownPage().startsWith(codeIn(1)));
    }

    void pageIsInTheLanguageOfTheUser()
    {
        QVERIFY(words::setLanguage(*QCoreApplication::instance(), "zh"));
        select(0);
        QTest::keyClick(m_table, Qt::Key_F1);
        QVERIFY2(shownPage().contains(QStringLiteral("解决办法。")), qPrintable(shownPage()));
    }

    void languageWithoutThePageFallsBackToEnglish()
    {
        QCOMPARE(words::explanationPath("CW0001", "xx"), sharedPath("diagnostics/en/CW0001.md"));
        QVERIFY(words::explanationPath("CW9999", "en").isEmpty());
    }

    void menuOffersThePage()
    {
        select(0);
        bool offered = false;
        QTimer::singleShot(0, this, [&offered] {
            auto* menu = qobject_cast<QMenu*>(QApplication::activePopupWidget());
            auto* action = menu ? menu->findChild<QAction*>("explainMessage") : nullptr;
            offered = action != nullptr;
            if (action)
                action->trigger();
            if (menu)
                menu->close();
        });
        const QPoint point = m_table->visualRect(m_table->currentIndex()).center();
        QContextMenuEvent event(QContextMenuEvent::Mouse, point, m_table->viewport()->mapToGlobal(point));
        QApplication::sendEvent(m_table->viewport(), &event);
        QVERIFY(offered);
        QVERIFY2(shownPage().startsWith(codeIn(0)), qPrintable(codeIn(0) + " is not the page: " + shownPage()));
    }

    void helpMenuExplainsOnlyWhereAMessageIsSelected()
    {
        QAction* action = m_workspace->actions.action("help.explain");
        m_table->setFocus();
        m_table->setCurrentIndex({});
        openMenuWith(action);
        QVERIFY(!action->isEnabled());
        select(0);
        openMenuWith(action);
        QVERIFY(action->isEnabled());
        action->trigger();
        QVERIFY(shownPage().startsWith(codeIn(0)));
    }

    void entriesOfTheLogAreExplainedToo()
    {
        m_workspace->connection.connectTo("local");
        m_window->showPanel(QStringLiteral("log"));
        m_table = m_window->findChild<QTableView*>("controllerLog");
        QVERIFY(m_table);
        QTRY_COMPARE(m_table->model()->rowCount(), 1);
        select(0);
        QTest::keyClick(m_table, Qt::Key_F1);
        QVERIFY2(shownPage().startsWith("CW0002: "), qPrintable(shownPage()));
    }

    void armedPanelKeepsTheKey()
    {
        m_workspace->connection.connectTo("local");
        select(0);
        QObject panel;
        m_workspace->context.arm(&panel);
        QSignalSpy asked(&m_workspace->context, &Context::explainRequested);
        QTest::keyClick(m_table, Qt::Key_F1);
        QCOMPARE(asked.size(), 0);
        QVERIFY(!m_window->findChild<DocViewer*>());
    }

private:
    void select(int row)
    {
        QApplication::setActiveWindow(m_window.get());
        m_table->setFocus();
        QTRY_COMPARE(QApplication::focusWidget(), m_table);
        m_table->selectRow(row);
    }

    /// As a click on the menu's title does, then away again.
    void openMenuWith(QAction* action)
    {
        for (const QAction* title : m_window->menuBar()->actions()) {
            if (!title->menu()->actions().contains(action))
                continue;
            title->menu()->popup(m_window->mapToGlobal(QPoint(10, 30)));
            title->menu()->close();
            return;
        }
        QFAIL("in no menu");
    }

    QString codeIn(int row) const { return m_table->model()->index(row, ProblemsModel::CodeColumn).data().toString(); }

    QString shownPage() const
    {
        const auto* text = m_window->findChild<QTextBrowser*>("docText");
        return text ? text->toPlainText() : QString();
    }

    std::unique_ptr<QTemporaryDir> m_dir;
    std::unique_ptr<Workspace> m_workspace;
    std::unique_ptr<MainWindow> m_window;
    QTableView* m_table = nullptr;
};

QTEST_MAIN(ExplainTest)
#include "tst_explain.moc"
