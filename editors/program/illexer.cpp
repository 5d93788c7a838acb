#include "editors/program/illexer.h"

#include "editors/shell/theme.h"

#include <Qsci/qsciscintilla.h>

namespace camwright {

namespace {

constexpr int DefaultStyle = 0;

int styleOf(TokenKind kind)
{
    return static_cast<int>(kind) + 1;
}

Role roleOf(TokenKind kind)
{
    switch (kind) {
    case TokenKind::Mnemonic: return Role::Accent;
    case TokenKind::Number:
    case TokenKind::TypedConstant: return Role::Channel2;
    case TokenKind::Comment: return Role::Dim;
    case TokenKind::NetworkHeader: return Role::Dim;
    case TokenKind::Pin: return Role::Channel4;
    case TokenKind::Symbol: return Role::Channel3;
    case TokenKind::Missing:
    case TokenKind::Invalid: return Role::Error;
    default: return Role::Text;
    }
}

constexpr TokenKind Kinds[] = {TokenKind::Mnemonic, TokenKind::Address, TokenKind::Number, TokenKind::TypedConstant, TokenKind::Symbol,
    TokenKind::Pin, TokenKind::Separator, TokenKind::Missing, TokenKind::Empty, TokenKind::Comment, TokenKind::NetworkHeader,
    TokenKind::Group, TokenKind::Invalid};

} // namespace

IlLexer::IlLexer(const Dialect& dialect, QObject* parent)
    : QsciLexerCustom(parent), m_dialect(dialect)
{
    applyTheme();
}

QString IlLexer::description(int style) const
{
    // QScintilla asks until a style has no description; the words show nowhere.
    return style <= styleOf(Kinds[std::size(Kinds) - 1]) ? QStringLiteral("token %1").arg(style) : QString();
}

void IlLexer::applyTheme()
{
    // Scintilla counts in points, the theme in pixels.
    QFont mono = theme().monoFont();
    mono.setPointSizeF(QFontInfo(mono).pointSizeF());
    setDefaultFont(mono);
    setDefaultPaper(theme().color(Role::Surface));
    setDefaultColor(theme().color(Role::Text));
    setFont(mono, -1);
    setPaper(theme().color(Role::Surface), -1);
    setColor(theme().color(Role::Text), DefaultStyle);
    for (const TokenKind kind : Kinds) {
        QFont font = mono;
        font.setBold(kind == TokenKind::NetworkHeader || kind == TokenKind::Mnemonic);
        font.setItalic(kind == TokenKind::Comment);
        setFont(font, styleOf(kind));
        setColor(theme().color(roleOf(kind)), styleOf(kind));
    }
}

void IlLexer::styleLine(const QByteArray& text, int line, LineState& state)
{
    std::vector<Token> tokens;
    std::string_view view(text.constData(), static_cast<std::size_t>(text.size()));
    while (!view.empty() && (view.back() == '\n' || view.back() == '\r'))
        view.remove_suffix(1);
    state = tokenizeLine(m_dialect, view, state, tokens);
    editor()->SendScintilla(QsciScintilla::SCI_SETLINESTATE, static_cast<unsigned long>(line), static_cast<long>(state));
    std::uint32_t at = 0;
    for (const Token& token : tokens) {
        if (token.column > at)
            setStyling(static_cast<int>(token.column - at), DefaultStyle);
        setStyling(static_cast<int>(token.length), styleOf(token.kind));
        at = token.column + token.length;
    }
    setStyling(static_cast<int>(static_cast<std::uint32_t>(text.size()) - at), DefaultStyle);
}

void IlLexer::styleText(int start, int end)
{
    QsciScintilla* const view = editor();
    if (!view)
        return;
    int line = static_cast<int>(view->SendScintilla(QsciScintilla::SCI_LINEFROMPOSITION, start));
    const int position = static_cast<int>(view->SendScintilla(QsciScintilla::SCI_POSITIONFROMLINE, static_cast<unsigned long>(line)));
    LineState state = line == 0 ? LineState::Code
        : static_cast<LineState>(view->SendScintilla(QsciScintilla::SCI_GETLINESTATE, static_cast<unsigned long>(line - 1)));
    startStyling(position);
    const int lines = static_cast<int>(view->SendScintilla(QsciScintilla::SCI_GETLINECOUNT));
    for (int at = position; line < lines && at <= end; ++line) {
        const int next = static_cast<int>(line + 1 < lines ? view->SendScintilla(QsciScintilla::SCI_POSITIONFROMLINE, static_cast<unsigned long>(line) + 1)
                                                           : view->SendScintilla(QsciScintilla::SCI_GETLENGTH));
        styleLine(next > at ? view->bytes(at, next).chopped(1) : QByteArray(), line, state);
        at = next;
    }
}

} // namespace camwright
