#include "editors/shell/actions.h"
#include "editors/shell/icons.h"
#include "editors/shell/theme.h"

#include <QtTest>

using namespace camwright;

class ThemeTest : public QObject {
    Q_OBJECT

private slots:
    /// WCAG AA: 4.5 to 1 for every colour text is written in, on every ground it is written on.
    void textHasContrast_data()
    {
        QTest::addColumn<int>("ink");
        QTest::addColumn<int>("ground");
        const auto row = [](const char* name, Role ink, Role ground) { QTest::newRow(name) << int(ink) << int(ground); };
        row("text on background", Role::Text, Role::Background);
        row("text on surface", Role::Text, Role::Surface);
        row("text on selection", Role::Text, Role::AccentSoft);
        row("dim on background", Role::Dim, Role::Background);
        row("dim on surface", Role::Dim, Role::Surface);
        row("dim on raised", Role::Dim, Role::Raised);
        row("dim on selection", Role::Dim, Role::AccentSoft);
        row("accent on background", Role::Accent, Role::Background);
        row("accent on surface", Role::Accent, Role::Surface);
        row("accent on accent soft", Role::Accent, Role::AccentSoft);
        row("on accent", Role::OnAccent, Role::Accent);
        row("ok on surface", Role::Ok, Role::Surface);
        row("ok on ok soft", Role::Ok, Role::OkSoft);
        row("warn on surface", Role::Warn, Role::Surface);
        row("warn on warn soft", Role::Warn, Role::WarnSoft);
        row("error on surface", Role::Error, Role::Surface);
        row("error on error soft", Role::Error, Role::ErrorSoft);
        row("on error", Role::OnError, Role::Error);
        row("forced on surface", Role::Forced, Role::Surface);
        row("forced on forced soft", Role::Forced, Role::ForcedSoft);
        row("real on warn soft", Role::Real, Role::WarnSoft);
        row("simulated on accent soft", Role::Simulated, Role::AccentSoft);
    }

    void textHasContrast()
    {
        QFETCH(int, ink);
        QFETCH(int, ground);
        for (const Theme::Kind kind : {Theme::Kind::Light, Theme::Kind::Dark}) {
            const double ratio = contrast(Theme::colorOf(kind, Role(ink)), Theme::colorOf(kind, Role(ground)));
            QVERIFY2(ratio >= 4.5, qPrintable(QString("%1: %2").arg(kind == Theme::Kind::Dark ? "dark" : "light").arg(ratio)));
        }
    }

    void styleSheetHasNoUnknownWord()
    {
        const QString sheet = theme().styleSheet();
        QVERIFY(!sheet.isEmpty());
        QVERIFY(!sheet.contains(QLatin1Char('@')) || sheet.indexOf("Words after @") >= 0);
        QVERIFY(sheet.contains("#1463c8"));
    }

    void everyIconDraws()
    {
        QVERIFY(iconNames().size() >= 45);
        for (const QString& name : iconNames()) {
            const QImage image = iconPixmap(name, 16, Role::Text).toImage();
            bool inked = false;
            for (int y = 0; y < image.height() && !inked; ++y) {
                for (int x = 0; x < image.width() && !inked; ++x)
                    inked = qAlpha(image.pixel(x, y)) > 60;
            }
            QVERIFY2(inked, qPrintable(name));
        }
    }

    void iconFollowsTheTheme()
    {
        theme().setKind(Theme::Kind::Light);
        const QImage light = icon("run").pixmap(16, 16).toImage();
        theme().setKind(Theme::Kind::Dark);
        const QImage dark = icon("run").pixmap(16, 16).toImage();
        theme().setKind(Theme::Kind::Light);
        QVERIFY(light != dark);
    }

    void unavailableActionTellsItsReason()
    {
        ActionCatalogue actions;
        actions.add({"test.run", "Run", "Starts the program.", "run", "F5", Availability::Online | Availability::Idle});
        actions.setState(Availability::Idle, [](const QString&) { return false; });
        QVERIFY(!actions.action("test.run")->isEnabled());
        QVERIFY(actions.action("test.run")->toolTip().contains("No controller is connected."));
        actions.setState(Availability::Idle | Availability::Online, [](const QString&) { return false; });
        QVERIFY(actions.action("test.run")->isEnabled());
        QVERIFY(actions.action("test.run")->toolTip().contains("F5"));
    }
};

QTEST_MAIN(ThemeTest)
#include "tst_theme.moc"
