#pragma once

#include "core/base/diagnostic.h"
#include "core/language/source/dialect.h"

#include <Qsci/qsciscintilla.h>

namespace camwright {

class IlLexer;

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

protected:
    void keyPressEvent(QKeyEvent* event) override;
    void contextMenuEvent(QContextMenuEvent* event) override;
    void changeEvent(QEvent* event) override;

private:
    void applyTheme();
    void setUpMargins();
    void setUpIndicators();
    void noteModified(int position, int type, const char* text, int length);
    void updateNumberMargin();

    IlLexer* m_lexer;
    Diagnostics m_diagnostics;
    bool m_quiet = false;
};

} // namespace camwright
