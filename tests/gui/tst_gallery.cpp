// Renders every view to pictures for people to look at, and fails on clipped words and controls without a name.
#include "app/window/composition.h"
#include "app/window/docviewer.h"
#include "app/window/downloaddialog.h"
#include "app/window/mainwindow.h"
#include "app/window/newprojectdialog.h"
#include "app/window/settingsdialog.h"
#include "editors/document/editcommands.h"
#include "editors/words/words.h"
#include "fakelink.h"

#include <QAbstractButton>
#include <QAbstractItemView>
#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QStandardPaths>
#include <QPushButton>
#include <QTabBar>
#include <QTableView>
#include <QTemporaryDir>
#include <QtTest>

using namespace camwright;

namespace {

Project demoProject()
{
    Project out = emptyProject("kinco", "KS101M-04DX", "kinco-feeder");
    Axis feed;
    feed.mechanicalEquivalent = 100.0;
    Axis turn;
    turn.number = 2;
    turn.type = AxisType::Rotary;
    turn.mechanicalEquivalent = 45.0;
    out = out.withContent({ObjectKind::Axis, "Feed"}, feed);
    out = out.withContent({ObjectKind::Axis, "Turn"}, turn);
    out = out.withContent({ObjectKind::Program, "Main"},
        Program{ProgramRole::Main, ProgramLanguage::InstructionList, "(* Start and stop *)\n(* Network 0 *)\nLD %I0.0\nOR %M0.0\nANDN %I0.1\nST %M0.0\n"});
    out = out.withContent({ObjectKind::VariableTable, "Globals"},
        VariableTable::of({{"Start", DataType::Bool, "%I0.0", "", false, "Start button"}, {"Stop", DataType::Bool, "%I0.1", "", false, "Stop button"},
            {"Run", DataType::Bool, "%M0.0", "", false, "The machine runs"}, {"FeedTarget", DataType::Real, "%VR100", "250.0", true, "Where the next part goes"}}));
    out = out.withContent({ObjectKind::WatchTable, "Watch"}, WatchTable{{{"axis.Feed.position", "", {}}, {"Run", "", {}}, {"%I0.3", "", {}}}});
    return out;
}

Diagnostics demoProblems()
{
    Diagnostics out{diagnostic(Code::AddressShared, {"Run", "Stop", "%M0.0"}, Place{{ObjectKind::VariableTable, "Globals"}, "rows[2]", {}, {}})};
    out.push_back(diagnostic(Code::FieldOutOfRange, {"70000", "guard_time_ms", "0", "65535"}, Place{{ObjectKind::Axis, "Feed"}, "guard_time_ms", {}, {}}));
    return out;
}

Services fakeServices()
{
    Services out;
    out.check = [](const Project&) { return demoProblems(); };
    out.build = [](const Project&, Job&) { return BuildOutcome{{}, DownloadPackage{Bytes(4096), FakeLink::hash}}; };
    out.connectTo = [](const std::string&, const std::string&) -> Result<std::unique_ptr<ControllerLink>> { return std::unique_ptr<ControllerLink>(new FakeLink); };
    return out;
}

QString pictureFolder()
{
    return QDir(QStringLiteral(CAMWRIGHT_BIN_DIR)).filePath(QStringLiteral("../screenshots"));
}

QString pathOf(const QWidget* widget)
{
    QStringList out;
    for (; widget; widget = widget->parentWidget())
        out.prepend(widget->objectName().isEmpty() ? QString::fromLatin1(widget->metaObject()->className()) : widget->objectName());
    return out.mid(std::max(0, int(out.size()) - 5)).join(QLatin1Char('/'));
}

/// Words that do not fit where they stand.
QStringList clippedWords(const QWidget& window)
{
    QStringList out;
    for (const QLabel* label : window.findChildren<QLabel*>()) {
        if (!label->isVisible() || label->text().isEmpty() || label->wordWrap() || label->textFormat() == Qt::RichText)
            continue;
        if (label->fontMetrics().horizontalAdvance(label->text()) > label->width() + 2)
            out << pathOf(label) + QStringLiteral(": \"%1\"").arg(label->text());
    }
    for (const QAbstractButton* button : window.findChildren<QAbstractButton*>()) {
        if (!button->isVisible() || button->text().isEmpty() || button->minimumSizeHint().isEmpty())
            continue;
        if (button->width() + 1 < std::min(button->minimumSizeHint().width(), button->sizeHint().width()))
            out << pathOf(button) + QStringLiteral(": \"%1\"").arg(button->text());
    }
    return out;
}

/// Controls that a screen reader could not tell.
QStringList namelessControls(const QWidget& window)
{
    QStringList out;
    for (const QWidget* widget : window.findChildren<QWidget*>()) {
        const bool control = qobject_cast<const QAbstractButton*>(widget) || qobject_cast<const QLineEdit*>(widget)
            || qobject_cast<const QComboBox*>(widget) || qobject_cast<const QAbstractItemView*>(widget) || qobject_cast<const QTabBar*>(widget);
        if (!control || !widget->isVisible() || widget->objectName().startsWith(QLatin1String("qt_")))
            continue;
        const auto* button = qobject_cast<const QAbstractButton*>(widget);
        const QWidget* parent = widget->parentWidget();
        const bool partOfAnother = qobject_cast<const QComboBox*>(parent) || qobject_cast<const QLineEdit*>(parent)
            || (parent && (qobject_cast<const QAbstractItemView*>(parent) || qobject_cast<const QTabBar*>(parent)))
            || (parent && qobject_cast<const QAbstractItemView*>(parent->parentWidget()));
        if (partOfAnother || widget->inherits("QHeaderView") || widget->inherits("QTableCornerButton"))
            continue;
        if (widget->accessibleName().isEmpty() && !(button && !button->text().isEmpty()))
            out << pathOf(widget);
    }
    return out;
}

} // namespace

class GalleryTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase()
    {
        QStandardPaths::setTestModeEnabled(true);
        QCoreApplication::setOrganizationName("camwright-test");
        QCoreApplication::setApplicationName("gallery");
        QCoreApplication::setApplicationVersion("0.1.0");
        QDir().mkpath(pictureFolder());
        QSettings().clear();
    }

    void everyViewIsComplete_data()
    {
        QTest::addColumn<bool>("dark");
        QTest::addColumn<QString>("language");
        QTest::newRow("light-en") << false << "en";
        QTest::newRow("dark-en") << true << "en";
        QTest::newRow("light-zh") << false << "zh";
        QTest::newRow("light-ru") << false << "ru";
    }

    void everyViewIsComplete()
    {
        QFETCH(bool, dark);
        QFETCH(QString, language);
        QVERIFY(words::setLanguage(*qApp, language));
        theme().setKind(dark ? Theme::Kind::Dark : Theme::Kind::Light);
        theme().applyToApplication();
        m_suffix = QString::fromLatin1(QTest::currentDataTag());

        QTemporaryDir dir;
        Workspace workspace(fakeServices(), registerEverything);
        RecentProject recent;
        recent.path = dir.filePath("kinco-feeder");
        QVERIFY(workspace.document.create(demoProject(), recent.path).ok());
        workspace.document.close();
        recent.name = "kinco-feeder";
        recent.controller = "Kinco KS101M-04DX";
        recent.state = LastState::RanVirtual;
        recent.opened = QDateTime::currentDateTime();
        workspace.settings.remember(recent);
        MainWindow window(workspace);
        window.resize(1440, 900);
        window.show();
        QVERIFY(QTest::qWaitForWindowExposed(&window));
        look(window, "start");

        QVERIFY(window.openProject(recent.path));
        QTRY_VERIFY(!workspace.document.diagnostics().empty());
        window.showPanel("problems");
        for (const EditorFactory& factory : workspace.registry.editors())
            lookAtEditor(workspace, window, factory, "offline");
        workspace.connection.connectTo("local");
        QVERIFY(workspace.context.isOnline());
        workspace.workbench.build();
        QTRY_VERIFY(workspace.context.programMatches());
        for (const EditorFactory& factory : workspace.registry.editors())
            lookAtEditor(workspace, window, factory, "online");
        for (const PanelFactory& factory : workspace.registry.panels()) {
            if (factory.area == PanelArea::Left)
                continue;
            window.showPanel(factory.id);
            look(window, "panel-" + factory.id);
        }
        lookAtRecording(window);
        lookAtSplits(workspace, window);
        lookAtDialogs(workspace, window);
        QCOMPARE(m_complaints.join("\n"), QString());
        workspace.connection.disconnectNow();
    }

private:
    void lookAtEditor(Workspace& workspace, MainWindow& window, const EditorFactory& factory, const QString& how)
    {
        const auto objects = workspace.document.project().objects(factory.kind);
        if (objects.empty())
            return;
        workspace.context.open(objects.front()->key, factory.viewId);
        QVERIFY2(window.editors().current(), qPrintable(factory.viewId));
        look(window, "editor-" + factory.viewId + "-" + how);
    }

    void lookAtRecording(MainWindow& window)
    {
        window.setLayoutPreset(Layout::Analyse);
        auto* channel = window.findChild<QLineEdit*>("newChannel");
        QTest::keyClicks(channel, "%I0.0");
        QTest::keyClick(channel, Qt::Key_Return);
        QTest::mouseClick(window.findChild<QPushButton*>("recordTrace"), Qt::LeftButton);
        QTest::qWait(120); // the oscilloscope redraws 30 times a second
        QTest::mouseClick(window.findChild<QPushButton*>("fitTrace"), Qt::LeftButton);
        window.findChild<QTableView*>("traceChannels")->selectRow(5);
        look(window, "trace-states");
        window.setLayoutPreset(Layout::Program);
    }

    void lookAtSplits(Workspace& workspace, MainWindow& window)
    {
        window.setLayoutPreset(Layout::Program);
        workspace.context.open({ObjectKind::Program, "Main"});
        workspace.actions.action("view.splitRight")->trigger();
        workspace.context.open({ObjectKind::VariableTable, "Globals"});
        workspace.actions.action("view.splitDown")->trigger();
        look(window, "editors-split");
        workspace.actions.action("view.ownWindow")->trigger();
        auto* own = qobject_cast<QWidget*>(window.editors().activeGroup().window());
        QVERIFY(own && own != &window);
        look(*own, "editors-own-window");
        window.editors().unite();
    }

    void lookAtDialogs(Workspace& workspace, MainWindow& window)
    {
        NewProjectDialog create("kinco", "/tmp", &window);
        create.show();
        look(create, "dialog-new");
        create.close();
        SettingsDialog settings(workspace.settings, workspace.keys, workspace.actions, &window);
        settings.show();
        look(settings, "dialog-settings");
        settings.findChild<QTabWidget*>("settingsPages")->setCurrentIndex(1);
        QTest::keyClick(settings.findChild<QWidget*>("firstKey"), Qt::Key_P, Qt::ControlModifier);
        look(settings, "dialog-settings-keys");
        settings.close();
        auto* download = new DownloadDialog(workspace.context, DownloadPackage{Bytes(10), FakeLink::hash}, &window);
        download->show();
        look(*download, "dialog-download");
        download->close();
        workspace.context.explain(Code::UnterminatedComment);
        auto* page = window.findChild<DocViewer*>();
        QVERIFY(page);
        look(*page, "dialog-explain");
        page->close();
    }

    void look(QWidget& window, const QString& name)
    {
        QCoreApplication::processEvents();
        QCoreApplication::sendPostedEvents();
        QCoreApplication::processEvents();
        QVERIFY(window.grab().save(QDir(pictureFolder()).filePath(name + "-" + m_suffix + ".png")));
        for (const QString& words : clippedWords(window))
            m_complaints << QStringLiteral("%1: clipped %2").arg(name, words);
        for (const QString& control : namelessControls(window))
            m_complaints << QStringLiteral("%1: no accessible name: %2").arg(name, control);
        m_complaints.removeDuplicates();
    }

    QString m_suffix;
    QStringList m_complaints;
};

QTEST_MAIN(GalleryTest)
#include "tst_gallery.moc"
