#pragma once

#include "core/base/diagnostic.h"
#include "core/language/source/dialect.h"

#include <Qsci/qsciscintilla.h>

#include <map>

namespace camwright {

class IlLexer;

/// A value shown behind a line of text, quietly: it is no text and cannot be selected.
struct LineValue {
    QString label;          ///< the operand's name; empty where a line has one value only
    QString text;           ///< "TRUE", "12.5"
    bool energised = false; ///< a BOOL that is on: colour, and the operand in the text is marked too
    bool forced = false;    ///< an F stands before it
    int offset = 0;         ///< of the operand in the whole text, bytes
    int length = 0;

    bool operator==(const LineValue&) const = default;
};

/// The text of a program: QScintilla without its own undo (the project's undo is the only one), with our colours, error
/// underlines and margins. Positions are UTF-8 bytes from the start, as everywhere in core.
class IlCodeView : public QsciScintilla {
    Q_OBJECT
public:
    explicit IlCodeView(const Dialect& dialect, QWidget* parent = nullptr);

    QByteArray source() const;
    /// Replaces only what differs, so that cursor, scrolling and folding of the rest stay. Announces nothing.
    void setSource(const QByteArray& text);
    void showDiagnostics(const Diagnostics& diagnostics);
    /// The diagnostics under a position, worst first.
    std::vector<const Diagnostic*> diagnosticsAt(int position) const;

    /// Values behind lines, by line from 0, instead of all earlier ones. Stale ones are dimmed, slanted and framed by dashes.
    void setLineValues(const std::map<int, std::vector<LineValue>>& values, bool stale);
    const std::map<int, std::vector<LineValue>>& lineValues() const { return m_values; }
    bool lineValuesAreStale() const { return m_valuesStale; }
    /// The first and last line that can be seen, from 0.
    std::pair<int, int> visibleLines() const;
    /// A lamp in the margin of a line that has a quick fix; -1: none. A click on it emits fixesRequested().
    void setFixLine(int line);
    int fixLine() const { return m_fixLine; }
    QPoint pointOf(int position) const;                             ///< on the screen, below the text there

    int position() const;
    void selectRange(const TextRange& range);
    TextRange selectedRange() const;
    int positionOf(std::uint32_t line, std::uint32_t column) const; ///< both from 1
    QByteArray wordAt(int position) const;                          ///< with % . # _ " as part of it

signals:
    /// The user changed the text: `removed` bytes at `offset` gave way to `inserted`.
    void edited(std::size_t offset, std::size_t removed, const QByteArray& inserted);
    /// The pointer rests on a position; -1 when it leaves.
    void hovered(int position, const QPoint& globalPoint);
    void fixesRequested(int line);
    void viewChanged(); ///< other lines can be seen than before

protected:
    void keyPressEvent(QKeyEvent* event) override;
    void contextMenuEvent(QContextMenuEvent* event) override;
    void changeEvent(QEvent* event) override;
    void paintEvent(QPaintEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

private:
    void applyTheme();
    void setUpMargins();
    void setUpIndicators();
    void noteModified(int position, int type, const char* text, int length);
    void updateNumberMargin();
    void paintLineValues();

    IlLexer* m_lexer;
    Diagnostics m_diagnostics;
    bool m_quiet = false;
    std::map<int, std::vector<LineValue>> m_values;
    bool m_valuesStale = false;
    int m_fixLine = -1;
};

} // namespace camwright
