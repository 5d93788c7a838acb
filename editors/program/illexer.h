#pragma once

#include "core/language/source/token.h"

#include <Qsci/qscilexercustom.h>

namespace camwright {

/// Colours instruction list as the language's own tokenizer splits it. Keeps one number a line, so an edit colours again
/// only what changed.
class IlLexer : public QsciLexerCustom {
    Q_OBJECT
public:
    IlLexer(const Dialect& dialect, QObject* parent);

    const char* language() const override { return "Instruction List"; }
    QString description(int style) const override;
    void styleText(int start, int end) override;
    /// Takes the theme's colours anew.
    void applyTheme();

private:
    void styleLine(const QByteArray& text, int line, LineState& state);

    const Dialect& m_dialect;
};

} // namespace camwright
