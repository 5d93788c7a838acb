#include "editors/shell/icons.h"

#include <QDir>
#include <QFile>
#include <QHash>
#include <QIconEngine>
#include <QPainter>
#include <QSvgRenderer>

static void initIconResource() { Q_INIT_RESOURCE(camwright_icons); }

namespace camwright {

namespace {

QString pathOf(const QString& name)
{
    return QStringLiteral(":/icons/%1.svg").arg(name);
}

/// The drawing with its one colour put in.
QSvgRenderer& renderer(const QString& name, const QColor& color)
{
    static QHash<QString, std::shared_ptr<QSvgRenderer>> cache;
    const QString key = name + color.name();
    auto& entry = cache[key];
    if (!entry) {
        initIconResource();
        QFile file(pathOf(name));
        QByteArray bytes;
        if (file.open(QIODevice::ReadOnly))
            bytes = file.readAll();
        bytes.replace("currentColor", color.name().toLatin1());
        entry = std::make_shared<QSvgRenderer>(bytes);
    }
    return *entry;
}

class ThemeIconEngine : public QIconEngine {
public:
    ThemeIconEngine(QString name, Role role) : m_name(std::move(name)), m_role(role) {}

    void paint(QPainter* painter, const QRect& rect, QIcon::Mode mode, QIcon::State) override
    {
        paintIcon(*painter, rect, m_name, mode == QIcon::Disabled ? Role::Faint : m_role);
    }
    QPixmap pixmap(const QSize& size, QIcon::Mode mode, QIcon::State state) override
    {
        QPixmap out(size);
        out.fill(Qt::transparent);
        QPainter painter(&out);
        paint(&painter, QRect(QPoint(0, 0), size), mode, state);
        return out;
    }
    QIconEngine* clone() const override { return new ThemeIconEngine(m_name, m_role); }
    QString key() const override { return QStringLiteral("camwright"); }
    QString iconName() override { return m_name; }
    bool isNull() override { return !hasIcon(m_name); }

private:
    QString m_name;
    Role m_role;
};

} // namespace

QIcon icon(const QString& name, Role role)
{
    return hasIcon(name) ? QIcon(new ThemeIconEngine(name, role)) : QIcon();
}

QPixmap iconPixmap(const QString& name, int size, Role role, qreal devicePixelRatio)
{
    QPixmap out(QSizeF(size * devicePixelRatio, size * devicePixelRatio).toSize());
    out.fill(Qt::transparent);
    QPainter painter(&out);
    paintIcon(painter, QRectF(QPointF(0, 0), QSizeF(out.size())), name, role);
    painter.end();
    out.setDevicePixelRatio(devicePixelRatio);
    return out;
}

void paintIcon(QPainter& painter, const QRectF& rect, const QString& name, Role role)
{
    if (!hasIcon(name))
        return;
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    const qreal side = std::min(rect.width(), rect.height());
    const QRectF square(rect.center() - QPointF(side / 2, side / 2), QSizeF(side, side));
    renderer(name, theme().color(role)).render(&painter, square);
    painter.restore();
}

bool hasIcon(const QString& name)
{
    initIconResource();
    return !name.isEmpty() && QFile::exists(pathOf(name));
}

QStringList iconNames()
{
    initIconResource();
    QStringList out;
    for (const QString& file : QDir(QStringLiteral(":/icons")).entryList({QStringLiteral("*.svg")}))
        out << file.chopped(4);
    return out;
}

} // namespace camwright
