#pragma once

#include "app/window/mainwindow.h"
#include "app/window/newprojectdialog.h"
#include "editors/shell/editor.h"
#include "editors/shell/registry.h"
#include "fakelink.h"

#include <QStringList>

namespace camwright {

inline const ObjectKey Feed{ObjectKind::Axis, "Feed"};
inline const ObjectKey Turn{ObjectKind::Axis, "Turn"};

/// An editor that only notes what it was asked.
class PlainEditor : public Editor {
public:
    using Editor::Editor;
    QString iconName() const override { return QStringLiteral("axis-linear"); }
    void reveal(const Place& place) override { revealed = place; }
    Place place() const override { return {key(), revealed.field, {}, {}}; }
    bool can(const QString& id) const override { return id == QLatin1String("edit.find"); }
    void perform(const QString& id) override { performed << id; }
    Place revealed;
    QStringList performed;
};

inline void registerPlain(Registry& registry, ActionCatalogue&)
{
    for (const ObjectKind kind : {ObjectKind::Axis, ObjectKind::Program}) {
        registry.add(EditorFactory{kind == ObjectKind::Axis ? QStringLiteral("axis") : QStringLiteral("program"), kind, QStringLiteral("Plain"), QStringLiteral("axis-linear"),
            [](Context& context, const ObjectKey& key) -> Editor* { return new PlainEditor(context, key); }});
    }
}

inline Services fakeServices()
{
    Services out;
    out.check = [](const Project&) { return Diagnostics{}; };
    out.build = [](const Project& project, Job&) {
        BuildOutcome result;
        if (project.find(Feed))
            result.package = DownloadPackage{Bytes(16), FakeLink::hash};
        else
            result.diagnostics = {diagnostic(Code::NoMainProgram)};
        return result;
    };
    out.connectTo = [](const std::string&, const std::string&) -> Result<std::unique_ptr<ControllerLink>> { return std::unique_ptr<ControllerLink>(new FakeLink); };
    return out;
}

inline Project twoAxes()
{
    Axis second;
    second.number = 2;
    return emptyProject("kinco", "KS101M-04DX", "two").withContent(Feed, Axis{}).withContent(Turn, second);
}

} // namespace camwright
