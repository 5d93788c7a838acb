#include "app/window/application.h"

#include "app/window/composition.h"
#include "app/window/mainwindow.h"
#include "app/window/realservices.h"
#include "app/window/screenshots.h"
#include "app/window/screenwatch.h"
#include "app/window/untilidle.h"
#include "editors/words/words.h"

#include <QApplication>
#include <QCommandLineParser>
#include <QTextStream>

namespace camwright {

namespace {

/// The window and its workspace; a change of language makes the window anew.
class Session : public QObject {
public:
    explicit Session(Services services) : m_workspace(std::move(services), registerEverything) { makeWindow(); }

    Workspace& workspace() { return m_workspace; }
    MainWindow& window() { return *m_window; }

private:
    void makeWindow()
    {
        m_window = std::make_unique<MainWindow>(m_workspace);
        connect(m_window.get(), &MainWindow::languageRequested, this, &Session::changeLanguage, Qt::QueuedConnection);
        m_window->show();
    }

    void changeLanguage(const QString& language)
    {
        if (!words::setLanguage(*QCoreApplication::instance(), language)) {
            m_workspace.context.notify(Severity::Warning, QCoreApplication::translate("Program", "The texts of this language are not installed."));
            return;
        }
        m_workspace.settings.setLanguage(language);
        const Arrangement opened = m_window->editors().arrangement();
        const QByteArray geometry = m_window->saveGeometry();
        QApplication::setQuitOnLastWindowClosed(false);
        m_window.reset();
        m_workspace.retranslate();
        makeWindow();
        m_window->restoreGeometry(geometry);
        m_window->editors().arrange(opened, EditorArea::Missing::Open);
        QApplication::setQuitOnLastWindowClosed(true);
    }

    Workspace m_workspace;
    std::unique_ptr<MainWindow> m_window;
};

void readOptions(QCommandLineParser& parser, const QApplication& application)
{
    parser.setApplicationDescription(QStringLiteral("Camwright: engineering tool for small motion controllers."));
    parser.addHelpOption();
    parser.addVersionOption();
    parser.addPositionalArgument(QStringLiteral("PROJECT"), QStringLiteral("Project folder to open."), QStringLiteral("[PROJECT]"));
    parser.addOption({QStringLiteral("demo"), QStringLiteral("Opens the project, goes online with its virtual controller and runs it."), QStringLiteral("DIR")});
    parser.addOption({QStringLiteral("screenshot"), QStringLiteral("Saves pictures of every view and ends."), QStringLiteral("DIR")});
    parser.addOption({QStringLiteral("until-idle"), QStringLiteral("Ends when the window stands and the project is checked: for timing the start.")});
    parser.addOption({QStringLiteral("theme"), QStringLiteral("light or dark."), QStringLiteral("NAME")});
    parser.addOption({QStringLiteral("lang"), QStringLiteral("en, zh or ru."), QStringLiteral("CODE")});
    parser.process(application);
}

} // namespace

int runWindow(int argc, char** argv)
{
    QApplication application(argc, argv);
    QCoreApplication::setOrganizationName(QStringLiteral("camwright"));
    QCoreApplication::setApplicationName(QStringLiteral("camwright"));
    QCoreApplication::setApplicationVersion(QStringLiteral(CAMWRIGHT_VERSION));
    QCommandLineParser parser;
    readOptions(parser, application);

    Settings settings;
    const QString wantedTheme = parser.value(QStringLiteral("theme"));
    if (!wantedTheme.isEmpty() && wantedTheme != QLatin1String("light") && wantedTheme != QLatin1String("dark")) {
        QTextStream(stderr) << "--theme is light or dark\n";
        return 2;
    }
    theme().setKind(wantedTheme.isEmpty() ? settings.themeKind() : wantedTheme == QLatin1String("dark") ? Theme::Kind::Dark : Theme::Kind::Light);
    theme().applyToApplication();
    const QString wantedLanguage = parser.isSet(QStringLiteral("lang")) ? parser.value(QStringLiteral("lang")) : settings.language();
    if (!words::setLanguage(application, wantedLanguage) && parser.isSet(QStringLiteral("lang"))) {
        QTextStream(stderr) << "--lang: no texts for \"" << wantedLanguage << "\"\n";
        return 2;
    }

    RealServices real;
    Session session(real.services());
    MainWindow& window = session.window();
    const bool demo = parser.isSet(QStringLiteral("demo"));
    const QString project = demo ? parser.value(QStringLiteral("demo")) : parser.positionalArguments().value(0);
    const QString pictures = parser.value(QStringLiteral("screenshot"));
    window.setKeepsLayouts(pictures.isEmpty());
    if (!pictures.isEmpty() && !project.isEmpty())
        Screenshots::saveStartPage(window, pictures);
    if (!project.isEmpty())
        QTimer::singleShot(0, &window, [&window, project, demo] { demo ? window.runDemo(project) : void(window.openProject(project)); });

    std::unique_ptr<ScreenWatch> screenWatch; // after the first picture: it must not wait for a bus
    QTimer::singleShot(0, &session, [&session, &screenWatch] { screenWatch = std::make_unique<ScreenWatch>(session.workspace().context, ScreenWatch::buses()); });

    std::unique_ptr<Screenshots> screenshots;
    if (!pictures.isEmpty()) {
        screenshots = std::make_unique<Screenshots>(session.workspace(), window, pictures);
        QObject::connect(screenshots.get(), &Screenshots::done, &application, [](bool saved) { QCoreApplication::exit(saved ? 0 : 1); });
        QTimer::singleShot(50, screenshots.get(), &Screenshots::start);
    }
    std::unique_ptr<UntilIdle> untilIdle;
    if (parser.isSet(QStringLiteral("until-idle"))) {
        // Behind the timer that opens the project, which was started before.
        QTimer::singleShot(0, &window, [&] {
            untilIdle = std::make_unique<UntilIdle>(window, session.workspace().checks);
            QObject::connect(untilIdle.get(), &UntilIdle::idle, &application, &QCoreApplication::quit);
        });
    }
    return QApplication::exec();
}

} // namespace camwright
