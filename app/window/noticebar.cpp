#include "app/window/noticebar.h"

#include "editors/shell/icons.h"
#include "editors/shell/widgets.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QToolButton>

namespace camwright {

namespace {

constexpr int NoteMs = 6000;

} // namespace

NoticeBar::NoticeBar(QWidget* parent) : QFrame(parent)
{
    setObjectName(QStringLiteral("noticeBar"));
    setAccessibleName(tr("Message"));
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(12, 4, 6, 4);
    row->setSpacing(8);
    m_sign = new QLabel(this);
    m_text = new QLabel(this);
    m_text->setWordWrap(true);
    m_text->setTextInteractionFlags(Qt::TextSelectableByMouse);
    auto* close = new QToolButton(this);
    close->setIcon(icon(QStringLiteral("close"), Role::Dim));
    describe(close, "noticeClose", tr("Close the message"));
    row->addWidget(m_sign);
    row->addWidget(m_text, 1);
    row->addWidget(close);
    m_timer.setSingleShot(true);
    connect(&m_timer, &QTimer::timeout, this, &QWidget::hide);
    connect(close, &QToolButton::clicked, this, &QWidget::hide);
    connect(&theme(), &Theme::changed, this, &NoticeBar::refresh);
    hide();
}

void NoticeBar::tell(Severity severity, const QString& sentence)
{
    m_severity = severity;
    m_text->setText(sentence);
    refresh();
    show();
    if (severity == Severity::Information)
        m_timer.start(NoteMs);
    else
        m_timer.stop();
}

void NoticeBar::refresh()
{
    const bool error = m_severity == Severity::Error;
    const bool warning = m_severity == Severity::Warning;
    const Role ink = error ? Role::Error : warning ? Role::Warn : Role::Accent;
    const Role ground = error ? Role::ErrorSoft : warning ? Role::WarnSoft : Role::AccentSoft;
    m_sign->setPixmap(iconPixmap(error ? QStringLiteral("error") : warning ? QStringLiteral("warning") : QStringLiteral("info"), 16, ink, devicePixelRatioF()));
    setStyleSheet(QStringLiteral("#noticeBar { background: %1; border: none; border-top: 1px solid %2; }").arg(theme().name(ground), theme().name(ink)));
}

} // namespace camwright
