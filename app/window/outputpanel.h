#pragma once

#include "editors/shell/panel.h"

class QPlainTextEdit;

namespace camwright {

/// What checks, builds and downloads said, in order, with the time.
class OutputPanel : public Panel {
    Q_OBJECT
public:
    explicit OutputPanel(Context& context, QWidget* parent = nullptr);

private:
    QPlainTextEdit* m_text;
};

} // namespace camwright
