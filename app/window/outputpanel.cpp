#include "app/window/outputpanel.h"

#include "editors/shell/context.h"
#include "editors/shell/theme.h"
#include "editors/shell/widgets.h"

#include <QPlainTextEdit>
#include <QTime>
#include <QVBoxLayout>

namespace camwright {

OutputPanel::OutputPanel(Context& context, QWidget* parent) : Panel(context, parent)
{
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    m_text = new QPlainTextEdit(this);
    describe(m_text, "outputText", tr("Output"), tr("What checks, builds and downloads said."));
    m_text->setReadOnly(true);
    m_text->setFrameShape(QFrame::NoFrame);
    m_text->setStyleSheet(QStringLiteral("border: none; padding: 6px 8px;"));
    m_text->setFont(theme().monoFont());
    m_text->setMaximumBlockCount(5000);
    m_text->setPlaceholderText(tr("Nothing was built or downloaded yet."));
    column->addWidget(m_text);
    connect(&context, &Context::outputAdded, this,
        [this](const QString& line) { m_text->appendPlainText(QTime::currentTime().toString(QStringLiteral("HH:mm:ss  ")) + line); });
}

} // namespace camwright
