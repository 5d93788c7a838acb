#include "app/window/drawing.h"

#include "editors/shell/theme.h"

#include <QFile>
#include <QPainter>
#include <QRegularExpression>
#include <QSvgRenderer>

static void initStartResource() { Q_INIT_RESOURCE(camwright_start); }

namespace camwright {

namespace {

QByteArray coloured(const QString& name)
{
    initStartResource();
    QFile file(QStringLiteral(":/start/%1.svg").arg(name));
    if (!file.open(QIODevice::ReadOnly))
        return {};
    QString text = QString::fromUtf8(file.readAll());
    const std::pair<const char*, Role> words[] = {{"@accentsoft", Role::AccentSoft}, {"@accent", Role::Accent}, {"@dim", Role::Dim},
        {"@surface", Role::Surface}, {"@fineline", Role::FineLine}, {"@faint", Role::Faint}, {"@line", Role::Line},
        {"@channel1", Role::Channel1}, {"@channel2", Role::Channel2}};
    for (const auto& [word, role] : words)
        text.replace(QLatin1String(word), theme().name(role));
    return text.toUtf8();
}

} // namespace

void paintDrawing(QPainter& painter, const QRectF& rect, const QString& name)
{
    QSvgRenderer renderer(coloured(name));
    painter.setRenderHint(QPainter::Antialiasing);
    renderer.render(&painter, rect);
}

DemoDrawing::DemoDrawing(QWidget* parent) : QWidget(parent)
{
    setFixedSize(sizeHint());
    setAccessibleName(tr("Drawing of the demo machine: a feed slide on a screw and an indexing table"));
    connect(&theme(), &Theme::changed, this, qOverload<>(&QWidget::update));
}

void DemoDrawing::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    paintDrawing(painter, rect(), QStringLiteral("demo"));
    const auto words = [&](const QRectF& area, int align, const QString& text, const QFont& font, Role role) {
        painter.setFont(font);
        painter.setPen(theme().color(role));
        painter.drawText(area, align | Qt::AlignVCenter, text);
    };
    QFont number = theme().monoFont();
    number.setWeight(QFont::DemiBold);
    words({148, 21, 70, 28}, Qt::AlignLeft, QStringLiteral("Feed"), theme().font(), Role::Dim);
    words({178, 21, 70, 28}, Qt::AlignRight, QStringLiteral("250.0"), number, Role::Text);
    words({253, 21, 28, 28}, Qt::AlignLeft, QStringLiteral("mm"), theme().smallFont(), Role::Dim);
    words({340, 21, 60, 28}, Qt::AlignLeft, QStringLiteral("Turn"), theme().font(), Role::Dim);
    words({370, 21, 70, 28}, Qt::AlignRight, QStringLiteral("90.0"), number, Role::Text);
    words({445, 21, 28, 28}, Qt::AlignLeft, QStringLiteral("°"), theme().smallFont(), Role::Dim);
    words({86, 188, 220, 20}, Qt::AlignHCenter, tr("linear, 100 mm a turn"), theme().smallFont(), Role::Dim);
    words({310, 188, 180, 20}, Qt::AlignHCenter, tr("rotary, 45° a turn"), theme().smallFont(), Role::Dim);
}

} // namespace camwright
