#include "editors/shell/theme.h"

#include <QApplication>
#include <QFile>
#include <QFontDatabase>
#include <QPointer>
#include <QProxyStyle>
#include <QRegularExpression>
#include <QStyle>
#include <QStyleFactory>

#include <array>
#include <cmath>

static void initStyleResource() { Q_INIT_RESOURCE(camwright_style); }

namespace camwright {

namespace {

struct RoleRow {
    const char* name;
    const char* light;
    const char* dark;
};

// One row a role, in the order of the enumeration.
constexpr std::array<RoleRow, std::size_t(Role::Count)> Roles = {{
    {"background", "#eef0f3", "#14181e"},
    {"surface", "#ffffff", "#1b2129"},
    {"raised", "#f7f8fa", "#222933"},
    {"line", "#d5dae1", "#343d4a"},
    {"fineline", "#e6e9ee", "#2a323d"},
    {"text", "#1b2430", "#e4e9f0"},
    {"dim", "#5d6a7a", "#9aa7b8"},
    {"faint", "#8f9bab", "#6b7889"},
    {"accent", "#1463c8", "#5aa2ff"},
    {"accentsoft", "#dfeafa", "#1d3350"},
    {"onaccent", "#ffffff", "#0c1724"},
    {"ok", "#147a45", "#4cc38a"},
    {"oksoft", "#dcf2e5", "#173a2a"},
    {"warn", "#925d00", "#e5b454"},
    {"warnsoft", "#fcefd2", "#3d3117"},
    {"error", "#c22f2f", "#ff7b72"},
    {"errorsoft", "#fbe3e1", "#47211f"},
    {"onerror", "#ffffff", "#2a0b09"},
    {"energised", "#1463c8", "#5aa2ff"},
    {"idle", "#6b7786", "#7d8998"},
    {"forced", "#b0338c", "#e889cf"},
    {"forcedsoft", "#f8e2f2", "#44253b"},
    {"simulated", "#1463c8", "#5aa2ff"},
    {"real", "#a65300", "#ffb066"},
    {"channel1", "#1463c8", "#5aa2ff"},
    {"channel2", "#c2571a", "#ff9e64"},
    {"channel3", "#16814a", "#4cc38a"},
    {"channel4", "#8a3fb5", "#c99bff"},
}};

/// Fusion without lines under the menus' letters; they stay usable with Alt.
class WindowStyle : public QProxyStyle {
public:
    WindowStyle() : QProxyStyle(QStyleFactory::create(QStringLiteral("Fusion"))) {}

    int styleHint(StyleHint hint, const QStyleOption* option, const QWidget* widget, QStyleHintReturn* returned) const override
    {
        return hint == SH_UnderlineShortcut ? 0 : QProxyStyle::styleHint(hint, option, widget, returned);
    }
};

/// The system's font; where the system has made no choice of its own, Inter if it is there.
QFont baseFont()
{
    static const QFont font = [] {
        QFont out = QApplication::font();
        const QStringList unchosen{QStringLiteral("Sans"), QStringLiteral("Sans Serif"), QStringLiteral("DejaVu Sans")};
        if (unchosen.contains(out.family()) && QFontDatabase::families().contains(QLatin1String("Inter")))
            out.setFamily(QStringLiteral("Inter"));
        else if (unchosen.contains(out.family()))
            out.setFamily(QStringLiteral("DejaVu Sans"));
        out.setFamilies({out.family(), QStringLiteral("Noto Sans"), QStringLiteral("DejaVu Sans"), QStringLiteral("WenQuanYi Micro Hei")});
        out.setPixelSize(out.family() == QLatin1String("DejaVu Sans") ? 12 : 13);
        out.setStyleHint(QFont::SansSerif);
        return out;
    }();
    return font;
}

QFont sized(int pixels, QFont::Weight weight = QFont::Normal)
{
    QFont out = baseFont();
    out.setPixelSize(pixels);
    out.setWeight(weight);
    return out;
}

QFont mono(int pixels, QFont::Weight weight = QFont::Normal)
{
    QFont out(QStringLiteral("DejaVu Sans Mono"));
    out.setFamilies({QStringLiteral("DejaVu Sans Mono"), QStringLiteral("WenQuanYi Micro Hei Mono"), QStringLiteral("monospace")});
    out.setStyleHint(QFont::Monospace);
    out.setPixelSize(pixels);
    out.setWeight(weight);
    return out;
}

} // namespace

QColor Theme::colorOf(Kind kind, Role role)
{
    const RoleRow& row = Roles[std::size_t(role)];
    return QColor(QLatin1String(kind == Kind::Dark ? row.dark : row.light));
}

void Theme::setKind(Kind kind)
{
    if (kind == m_kind)
        return;
    m_kind = kind;
    applyToApplication();
    emit changed();
}

QFont Theme::font() const { return baseFont(); }
QFont Theme::smallFont() const { return sized(baseFont().pixelSize() - 1); }
QFont Theme::boldFont() const { return sized(baseFont().pixelSize(), QFont::DemiBold); }
QFont Theme::titleFont() const { return sized(baseFont().pixelSize() + 6, QFont::DemiBold); }
QFont Theme::monoFont() const { return mono(12); }
QFont Theme::digitsFont() const { return mono(34, QFont::DemiBold); }

QPalette Theme::palette() const
{
    QPalette out;
    out.setColor(QPalette::Window, color(Role::Background));
    out.setColor(QPalette::WindowText, color(Role::Text));
    out.setColor(QPalette::Base, color(Role::Surface));
    out.setColor(QPalette::AlternateBase, color(Role::Raised));
    out.setColor(QPalette::Text, color(Role::Text));
    out.setColor(QPalette::PlaceholderText, color(Role::Dim));
    out.setColor(QPalette::Button, color(Role::Raised));
    out.setColor(QPalette::ButtonText, color(Role::Text));
    out.setColor(QPalette::BrightText, color(Role::Error));
    out.setColor(QPalette::Highlight, color(Role::AccentSoft));
    out.setColor(QPalette::HighlightedText, color(Role::Text));
    out.setColor(QPalette::ToolTipBase, color(Role::Raised));
    out.setColor(QPalette::ToolTipText, color(Role::Text));
    out.setColor(QPalette::Link, color(Role::Accent));
    out.setColor(QPalette::LinkVisited, color(Role::Accent));
    out.setColor(QPalette::Light, color(Role::Raised));
    out.setColor(QPalette::Midlight, color(Role::FineLine));
    out.setColor(QPalette::Mid, color(Role::Line));
    out.setColor(QPalette::Dark, color(Role::Faint));
    for (const QPalette::ColorRole role : {QPalette::WindowText, QPalette::Text, QPalette::ButtonText, QPalette::HighlightedText})
        out.setColor(QPalette::Disabled, role, color(Role::Faint));
    return out;
}

QString Theme::styleSheet() const
{
    initStyleResource();
    QFile file(QStringLiteral(":/style/camwright.qss"));
    if (!file.open(QIODevice::ReadOnly))
        return {};
    QString sheet = QString::fromUtf8(file.readAll());
    static const QRegularExpression word(QStringLiteral("@([a-z0-9]+)"));
    QString out;
    qsizetype last = 0;
    for (auto it = word.globalMatch(sheet); it.hasNext();) {
        const QRegularExpressionMatch match = it.next();
        out += QStringView(sheet).mid(last, match.capturedStart() - last);
        last = match.capturedEnd();
        const QString wanted = match.captured(1);
        if (wanted == QLatin1String("theme")) {
            out += isDark() ? QLatin1String("dark") : QLatin1String("light");
            continue;
        }
        if (wanted == QLatin1String("small")) {
            out += QString::number(baseFont().pixelSize() - 1) + QLatin1String("px");
            continue;
        }
        for (std::size_t i = 0; i < Roles.size(); ++i) {
            if (wanted == QLatin1String(Roles[i].name))
                out += name(Role(i));
        }
    }
    return out + sheet.mid(last);
}

void Theme::applyToApplication()
{
    static QPointer<QStyle> ours;
    if (!ours)
        QApplication::setStyle(ours = new WindowStyle);
    QApplication::setFont(font());
    QApplication::setPalette(palette());
    qApp->setStyleSheet(styleSheet());
}

Theme& theme()
{
    static Theme instance;
    return instance;
}

double contrast(const QColor& first, const QColor& second)
{
    const auto luminance = [](const QColor& color) {
        const auto linear = [](double c) { return c <= 0.03928 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4); };
        return 0.2126 * linear(color.redF()) + 0.7152 * linear(color.greenF()) + 0.0722 * linear(color.blueF());
    };
    const double a = luminance(first);
    const double b = luminance(second);
    return (std::max(a, b) + 0.05) / (std::min(a, b) + 0.05);
}

} // namespace camwright
