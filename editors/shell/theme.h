#pragma once

#include <QColor>
#include <QFont>
#include <QObject>
#include <QPalette>
#include <QString>

namespace camwright {

/// A named colour. State is never colour alone: a width, a glyph or a word goes with it.
enum class Role {
    Background, Surface, Raised, Line, FineLine, Text, Dim, Faint,
    Accent, AccentSoft, OnAccent, Ok, OkSoft, Warn, WarnSoft, Error, ErrorSoft, OnError,
    Energised, Idle, Forced, ForcedSoft, Simulated, Real, Channel1, Channel2, Channel3, Channel4,
    Count
};

/// Colours, fonts and sizes of the whole program, light and dark. One instance, `theme()`, on the interface's thread;
/// widgets that paint themselves ask it in paintEvent and repaint on changed().
class Theme : public QObject {
    Q_OBJECT
public:
    enum class Kind { Light, Dark };

    Kind kind() const { return m_kind; }
    bool isDark() const { return m_kind == Kind::Dark; }
    void setKind(Kind kind);

    QColor color(Role role) const { return colorOf(m_kind, role); }
    static QColor colorOf(Kind kind, Role role);
    /// "#1463c8", for rich text and style sheets.
    QString name(Role role) const { return color(role).name(); }

    QFont font() const;                ///< the interface's
    QFont smallFont() const;           ///< captions, table heads, status bar: one pixel smaller
    QFont boldFont() const;            ///< semi-bold
    QFont titleFont() const;           ///< headings of a page
    QFont monoFont() const;            ///< code and numbers in tables, without ligatures
    QFont digitsFont() const;          ///< the large position display

    QPalette palette() const;
    QString styleSheet() const;        ///< for the application
    void applyToApplication();         ///< style, palette, font, style sheet

    // Sizes in device-independent pixels.
    static constexpr int Grid = 4, FieldHeight = 28, RowGap = 8, GroupMargin = 16, TableRow = 25, TreeRow = 24, HeaderHeight = 30;

signals:
    void changed();

private:
    Kind m_kind = Kind::Light;
};

Theme& theme();

/// WCAG contrast of two opaque colours, 1 … 21.
double contrast(const QColor& first, const QColor& second);

} // namespace camwright
