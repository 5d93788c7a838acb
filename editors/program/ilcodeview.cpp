#include "editors/program/ilcodeview.h"

#include "editors/program/illexer.h"
#include "editors/program/indicators.h"
#include "editors/shell/icons.h"
#include "editors/shell/theme.h"

#include <QKeyEvent>
#include <QScrollBar>

#include <algorithm>

namespace camwright {

namespace {

constexpr int LineMargin = 0, MarkerMargin = 1, FixMargin = 2;
constexpr int ErrorMarker = 1, WarningMarker = 2, FixMarker = 3;
constexpr int HoverDelayMs = 400;
constexpr int IndicatorAlpha = 60;

bool isWordByte(char c)
{
    return (c >= '0' && c <= '9') || (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') || c == '%' || c == '.' || c == '#' || c == '_'
        || static_cast<unsigned char>(c) >= 0x80;
}

} // namespace

IlCodeView::IlCodeView(const Dialect& dialect, QWidget* parent)
    : QsciScintilla(parent), m_lexer(new IlLexer(dialect, this))
{
    setUtf8(true);
    setEolMode(EolUnix);
    setLexer(m_lexer);
    setTabWidth(8);
    setIndentationsUseTabs(false);
    setAutoIndent(true);
    setCaretLineVisible(true);
    setWrapMode(WrapNone);
    setScrollWidth(1);
    setScrollWidthTracking(true);
    SendScintilla(SCI_SETUNDOCOLLECTION, 0UL);
    SendScintilla(SCI_SETMOUSEDWELLTIME, static_cast<unsigned long>(HoverDelayMs));
    SendScintilla(SCI_SETEXTRAASCENT, 2UL);
    SendScintilla(SCI_SETEXTRADESCENT, 2UL);
    setUpMargins();
    setUpIndicators();
    applyTheme();

    connect(this, &QsciScintillaBase::SCN_MODIFIED, this,
        [this](int position, int type, const char* text, int length) { noteModified(position, type, text, length); });
    connect(this, &QsciScintillaBase::SCN_DWELLSTART, this,
        [this](int position, int x, int y) { emit hovered(position, viewport()->mapToGlobal(QPoint(x, y))); });
    connect(this, &QsciScintillaBase::SCN_DWELLEND, this, [this](int, int, int) { emit hovered(-1, {}); });
    connect(this, &QsciScintilla::linesChanged, this, &IlCodeView::updateNumberMargin);
    connect(&theme(), &Theme::changed, this, &IlCodeView::applyTheme);
    connect(verticalScrollBar(), &QScrollBar::valueChanged, this, &IlCodeView::viewChanged);
    connect(this, &QsciScintilla::marginClicked, this, [this](int margin, int line, Qt::KeyboardModifiers) {
        if (margin == FixMargin && line == m_fixLine)
            emit fixesRequested(line);
    });
}

void IlCodeView::setUpMargins()
{
    setMarginType(LineMargin, QsciScintilla::NumberMargin);
    setMarginLineNumbers(LineMargin, true);
    setMarginType(MarkerMargin, SymbolMargin);
    setMarginWidth(MarkerMargin, 20);
    setMarginMarkerMask(MarkerMargin, (1 << ErrorMarker) | (1 << WarningMarker));
    setMarginType(FixMargin, SymbolMargin);
    setMarginWidth(FixMargin, 20);
    setMarginMarkerMask(FixMargin, 1 << FixMarker);
    setMarginSensitivity(FixMargin, true);
    for (int margin = 3; margin < 5; ++margin)
        setMarginWidth(margin, 0);
}

void IlCodeView::setUpIndicators()
{
    indicatorDefine(SquiggleLowIndicator, ErrorIndicator);
    indicatorDefine(SquiggleLowIndicator, WarningIndicator);
    setIndicatorDrawUnder(true, ErrorIndicator);
    setIndicatorDrawUnder(true, WarningIndicator);
    for (const int indicator : {SearchIndicator, EnergisedIndicator}) {
        indicatorDefine(StraightBoxIndicator, indicator);
        setIndicatorDrawUnder(true, indicator);
    }
}

void IlCodeView::applyTheme()
{
    m_lexer->applyTheme();
    setCaretForegroundColor(theme().color(Role::Text));
    setCaretLineBackgroundColor(theme().color(Role::Raised));
    setSelectionBackgroundColor(theme().color(Role::AccentSoft));
    resetSelectionForegroundColor();
    setMarginsFont(m_lexer->defaultFont());
    setMarginsForegroundColor(theme().color(Role::Dim));
    setMarginsBackgroundColor(theme().color(Role::Raised));
    setIndicatorForegroundColor(theme().color(Role::Error), ErrorIndicator);
    setIndicatorForegroundColor(theme().color(Role::Warn), WarningIndicator);
    markerDefine(iconPixmap(QStringLiteral("error"), 14, Role::Error, devicePixelRatioF()), ErrorMarker);
    markerDefine(iconPixmap(QStringLiteral("warning"), 14, Role::Warn, devicePixelRatioF()), WarningMarker);
    markerDefine(iconPixmap(QStringLiteral("quick-fix"), 14, Role::Accent, devicePixelRatioF()), FixMarker);
    for (const auto& [indicator, role] : {std::pair{EnergisedIndicator, Role::Energised}, {SearchIndicator, Role::Warn}}) {
        QColor colour = theme().color(role); // the text must stay readable on it
        colour.setAlpha(IndicatorAlpha);
        setIndicatorForegroundColor(colour, indicator);
        setIndicatorOutlineColor(colour, indicator);
    }
    setPaper(theme().color(Role::Surface));
    updateNumberMargin();
}

void IlCodeView::setFixLine(int line)
{
    // Edits above a line carry its mark along.
    const bool stands = line < 0 ? m_fixLine < 0 : (markersAtLine(line) & (1U << FixMarker)) != 0;
    if (line == m_fixLine && stands)
        return;
    markerDeleteAll(FixMarker);
    m_fixLine = line;
    if (line >= 0)
        markerAdd(line, FixMarker);
}

void IlCodeView::updateNumberMargin()
{
    setMarginWidth(LineMargin, QString::number(std::max(lines(), 99)) + QStringLiteral("00"));
}

void IlCodeView::changeEvent(QEvent* event)
{
    QsciScintilla::changeEvent(event);
    if (event->type() == QEvent::FontChange)
        updateNumberMargin();
}

QByteArray IlCodeView::source() const
{
    const int length = static_cast<int>(SendScintilla(SCI_GETLENGTH));
    return length == 0 ? QByteArray() : bytes(0, length).chopped(1);
}

void IlCodeView::setSource(const QByteArray& text)
{
    const QByteArray old = source();
    if (old == text)
        return;
    const auto [oldFirst, newFirst] = std::mismatch(old.begin(), old.end(), text.begin(), text.end());
    qsizetype prefix = oldFirst - old.begin();
    const qsizetype most = std::min(old.size(), text.size()) - prefix;
    qsizetype suffix = 0;
    while (suffix < most && old[old.size() - 1 - suffix] == text[text.size() - 1 - suffix])
        ++suffix;
    // Never cut a character in two: step back to its first byte, forward to its last.
    while (prefix > 0 && (static_cast<unsigned char>(text[prefix < text.size() ? prefix : prefix - 1]) & 0xC0) == 0x80)
        --prefix;
    while (suffix > 0 && (static_cast<unsigned char>(text[text.size() - suffix]) & 0xC0) == 0x80)
        --suffix;
    m_quiet = true;
    const bool readOnly = isReadOnly();
    setReadOnly(false);
    SendScintilla(SCI_SETTARGETSTART, static_cast<unsigned long>(prefix));
    SendScintilla(SCI_SETTARGETEND, static_cast<unsigned long>(old.size() - suffix));
    const QByteArray middle = text.mid(prefix, text.size() - suffix - prefix);
    SendScintilla(SCI_REPLACETARGET, static_cast<uintptr_t>(middle.size()), middle.constData());
    setReadOnly(readOnly);
    m_quiet = false;
}

void IlCodeView::noteModified(int position, int type, const char* text, int length)
{
    if (m_quiet)
        return;
    if (type & SC_MOD_INSERTTEXT)
        emit edited(static_cast<std::size_t>(position), 0, QByteArray(text, length));
    else if (type & SC_MOD_DELETETEXT)
        emit edited(static_cast<std::size_t>(position), static_cast<std::size_t>(length), {});
}

void IlCodeView::keyPressEvent(QKeyEvent* event)
{
    if (event->matches(QKeySequence::Undo) || event->matches(QKeySequence::Redo)) {
        event->ignore(); // the project's undo, one for all editors
        return;
    }
    QsciScintilla::keyPressEvent(event);
}

void IlCodeView::contextMenuEvent(QContextMenuEvent* event)
{
    event->ignore(); // the editor has one of its own, with undo as it really is
}

// Diagnostics

void IlCodeView::showDiagnostics(const Diagnostics& diagnostics)
{
    m_diagnostics = diagnostics;
    const int last = lines();
    clearIndicatorRange(0, 0, last, 0, ErrorIndicator);
    clearIndicatorRange(0, 0, last, 0, WarningIndicator);
    markerDeleteAll(ErrorMarker);
    markerDeleteAll(WarningMarker);
    for (const Diagnostic& d : m_diagnostics) {
        if (!d.place.range.isValid() || d.severity() == Severity::Information)
            continue;
        const bool error = d.severity() == Severity::Error;
        const int from = positionOf(d.place.range.line, d.place.range.column);
        const int to = std::max(from + 1, positionOf(d.place.range.endLine, d.place.range.endColumn));
        SendScintilla(SCI_SETINDICATORCURRENT, static_cast<unsigned long>(error ? ErrorIndicator : WarningIndicator));
        SendScintilla(SCI_INDICATORFILLRANGE, static_cast<unsigned long>(from), static_cast<long>(to - from));
        markerAdd(static_cast<int>(d.place.range.line) - 1, error ? ErrorMarker : WarningMarker);
    }
}

std::vector<const Diagnostic*> IlCodeView::diagnosticsAt(int position) const
{
    std::vector<const Diagnostic*> out;
    for (const Diagnostic& d : m_diagnostics) {
        if (!d.place.range.isValid())
            continue;
        const int from = positionOf(d.place.range.line, d.place.range.column);
        const int to = std::max(from + 1, positionOf(d.place.range.endLine, d.place.range.endColumn));
        if (position >= from && position <= to)
            out.push_back(&d);
    }
    std::ranges::sort(out, [](const Diagnostic* a, const Diagnostic* b) { return std::pair(a->severity(), b->place) > std::pair(b->severity(), a->place); });
    return out;
}

// Places

std::pair<int, int> IlCodeView::visibleLines() const
{
    const auto first = SendScintilla(SCI_GETFIRSTVISIBLELINE);
    const auto count = SendScintilla(SCI_LINESONSCREEN);
    const auto line = [this](long visible) { return static_cast<int>(SendScintilla(SCI_DOCLINEFROMVISIBLE, static_cast<unsigned long>(visible))); };
    return {line(first), std::min(line(first + count), lines() - 1)};
}

QPoint IlCodeView::pointOf(int position) const
{
    const auto x = SendScintilla(SCI_POINTXFROMPOSITION, 0UL, static_cast<long>(position));
    const auto y = SendScintilla(SCI_POINTYFROMPOSITION, 0UL, static_cast<long>(position)) + SendScintilla(SCI_TEXTHEIGHT, 0UL);
    return viewport()->mapToGlobal(QPoint(static_cast<int>(x), static_cast<int>(y)));
}

int IlCodeView::position() const
{
    return static_cast<int>(SendScintilla(SCI_GETCURRENTPOS));
}

int IlCodeView::positionOf(std::uint32_t line, std::uint32_t column) const
{
    if (line == 0)
        return 0;
    const auto row = static_cast<unsigned long>(line - 1);
    const int start = static_cast<int>(SendScintilla(SCI_POSITIONFROMLINE, row));
    if (start < 0)
        return static_cast<int>(SendScintilla(SCI_GETLENGTH));
    const int end = static_cast<int>(SendScintilla(SCI_GETLINEENDPOSITION, row));
    return std::min(start + static_cast<int>(column == 0 ? 0 : column - 1), end);
}

void IlCodeView::selectRange(const TextRange& range)
{
    const int from = positionOf(range.line, range.column);
    const int to = range.endLine == 0 ? from : positionOf(range.endLine, range.endColumn);
    SendScintilla(SCI_ENSUREVISIBLEENFORCEPOLICY, static_cast<unsigned long>(range.line == 0 ? 0 : range.line - 1));
    SendScintilla(SCI_SETSEL, static_cast<unsigned long>(from), static_cast<long>(to));
    SendScintilla(SCI_VERTICALCENTRECARET);
}

TextRange IlCodeView::selectedRange() const
{
    const auto placeOf = [this](unsigned long position) {
        const auto line = static_cast<std::uint32_t>(SendScintilla(SCI_LINEFROMPOSITION, position));
        const auto start = SendScintilla(SCI_POSITIONFROMLINE, static_cast<unsigned long>(line));
        return std::pair{line + 1, static_cast<std::uint32_t>(static_cast<long>(position) - start) + 1};
    };
    const auto [line, column] = placeOf(static_cast<unsigned long>(SendScintilla(SCI_GETSELECTIONSTART)));
    const auto [endLine, endColumn] = placeOf(static_cast<unsigned long>(SendScintilla(SCI_GETSELECTIONEND)));
    return {line, column, endLine, endColumn};
}

QByteArray IlCodeView::wordAt(int position) const
{
    const QByteArray text = source();
    if (position < 0 || position > text.size())
        return {};
    qsizetype from = position, to = position;
    while (from > 0 && isWordByte(text[from - 1]))
        --from;
    while (to < text.size() && isWordByte(text[to]))
        ++to;
    return text.mid(from, to - from);
}

} // namespace camwright
