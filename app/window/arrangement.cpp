#include "app/window/arrangement.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

#include <algorithm>

namespace camwright {

namespace {

constexpr int DeepestNesting = 8;
constexpr int MostWindows = 16;

std::optional<ObjectKind> kindFrom(const QString& name)
{
    for (int kind = 0; *kindName(ObjectKind(kind)); ++kind) {
        if (name == QLatin1String(kindName(ObjectKind(kind))))
            return ObjectKind(kind);
    }
    return std::nullopt;
}

QJsonObject toJson(const Arrangement::Tab& tab)
{
    QJsonObject out{{QStringLiteral("view"), tab.viewId}};
    if (tab.key != ObjectKey{}) {
        out.insert(QStringLiteral("kind"), QString::fromLatin1(kindName(tab.key.kind)));
        out.insert(QStringLiteral("name"), QString::fromStdString(tab.key.name));
    }
    if (tab.preview)
        out.insert(QStringLiteral("preview"), true);
    return out;
}

QJsonObject toJson(const Arrangement::Node& node)
{
    QJsonArray list;
    if (node.parts.empty()) {
        for (const Arrangement::Tab& tab : node.tabs)
            list.append(toJson(tab));
        return {{QStringLiteral("tabs"), list}, {QStringLiteral("current"), node.current}};
    }
    QJsonArray sizes;
    for (const int size : node.sizes)
        sizes.append(size);
    for (const Arrangement::Node& part : node.parts)
        list.append(toJson(part));
    return {{QStringLiteral("parts"), list}, {QStringLiteral("horizontal"), node.horizontal}, {QStringLiteral("sizes"), sizes}};
}

std::optional<Arrangement::Tab> tabFrom(const QJsonObject& json)
{
    Arrangement::Tab out;
    out.viewId = json.value(QStringLiteral("view")).toString();
    out.preview = json.value(QStringLiteral("preview")).toBool();
    if (out.viewId.isEmpty())
        return std::nullopt;
    if (json.contains(QStringLiteral("name"))) {
        const auto kind = kindFrom(json.value(QStringLiteral("kind")).toString());
        if (!kind)
            return std::nullopt;
        out.key = {*kind, json.value(QStringLiteral("name")).toString().toStdString()};
    }
    return out;
}

std::optional<Arrangement::Node> nodeFrom(const QJsonObject& json, int depth)
{
    Arrangement::Node out;
    if (depth > DeepestNesting)
        return std::nullopt;
    for (const QJsonValue& value : json.value(QStringLiteral("tabs")).toArray()) {
        const auto tab = tabFrom(value.toObject());
        if (!tab)
            return std::nullopt;
        out.tabs.push_back(*tab);
    }
    out.current = std::clamp(json.value(QStringLiteral("current")).toInt(), 0, std::max(0, int(out.tabs.size()) - 1));
    for (const QJsonValue& value : json.value(QStringLiteral("parts")).toArray()) {
        auto part = nodeFrom(value.toObject(), depth + 1);
        if (!part)
            return std::nullopt;
        out.parts.push_back(std::move(*part));
    }
    out.horizontal = json.value(QStringLiteral("horizontal")).toBool(true);
    for (const QJsonValue& value : json.value(QStringLiteral("sizes")).toArray())
        out.sizes.append(value.toInt());
    const bool both = !out.tabs.empty() && !out.parts.empty();
    if (both || out.sizes.size() != qsizetype(out.parts.size()))
        return std::nullopt;
    return out;
}

bool hasTabs(const Arrangement::Node& node)
{
    return !node.tabs.empty() || std::any_of(node.parts.begin(), node.parts.end(), hasTabs);
}

} // namespace

bool Arrangement::isEmpty() const
{
    return !hasTabs(main) && std::none_of(windows.begin(), windows.end(), [](const Window& window) { return hasTabs(window.root); });
}

QByteArray Arrangement::toBytes() const
{
    QJsonArray list;
    for (const Window& window : windows)
        list.append(QJsonObject{{QStringLiteral("geometry"), QString::fromLatin1(window.geometry.toBase64())}, {QStringLiteral("root"), toJson(window.root)}});
    return QJsonDocument(QJsonObject{{QStringLiteral("main"), toJson(main)}, {QStringLiteral("windows"), list}}).toJson(QJsonDocument::Compact);
}

std::optional<Arrangement> Arrangement::fromBytes(const QByteArray& bytes)
{
    const QJsonObject json = QJsonDocument::fromJson(bytes).object();
    auto main = nodeFrom(json.value(QStringLiteral("main")).toObject(), 0);
    const QJsonArray list = json.value(QStringLiteral("windows")).toArray();
    if (!json.contains(QStringLiteral("main")) || !main || list.size() > MostWindows)
        return std::nullopt;
    Arrangement out;
    out.main = std::move(*main);
    for (const QJsonValue& value : list) {
        const QJsonObject object = value.toObject();
        auto root = nodeFrom(object.value(QStringLiteral("root")).toObject(), 0);
        if (!root)
            return std::nullopt;
        out.windows.push_back({QByteArray::fromBase64(object.value(QStringLiteral("geometry")).toString().toLatin1()), std::move(*root)});
    }
    return out;
}

} // namespace camwright
