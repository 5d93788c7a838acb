#include "editors/network/axisclipboard.h"

#include "core/storage/objecttext.h"

#include <QClipboard>
#include <QGuiApplication>
#include <QMimeData>

namespace camwright {

namespace {

constexpr const char* AxisMimeType = "application/x-camwright-axis";

} // namespace

void copyAxisToClipboard(const Object& axis)
{
    const QByteArray text = QByteArray::fromStdString(toText(axis));
    auto* data = new QMimeData;
    data->setText(QString::fromUtf8(text));
    data->setData(QString::fromLatin1(AxisMimeType), QByteArray::fromStdString(axis.key.name) + '\n' + text);
    QGuiApplication::clipboard()->setMimeData(data);
}

std::optional<Object> axisFromClipboard()
{
    const QMimeData* data = QGuiApplication::clipboard()->mimeData();
    if (!data || !data->hasFormat(QString::fromLatin1(AxisMimeType)))
        return std::nullopt;
    const QByteArray bytes = data->data(QString::fromLatin1(AxisMimeType));
    const qsizetype line = bytes.indexOf('\n');
    if (line <= 0)
        return std::nullopt;
    const ObjectKey key{ObjectKind::Axis, bytes.left(line).toStdString()};
    auto object = fromText(key, bytes.mid(line + 1).toStdString());
    if (!object || !std::holds_alternative<Axis>(object->content))
        return std::nullopt;
    return std::move(*object);
}

} // namespace camwright
