#include "editors/document/editcommands.h"

#include "core/base/codes.h"

#include <QCoreApplication>

#include <algorithm>
#include <cctype>

namespace camwright {

namespace {

QString quoted(const std::string& name)
{
    return QString::fromStdString(name);
}

bool sameName(const std::string& a, const std::string& b)
{
    return QString::fromStdString(a).compare(QString::fromStdString(b), Qt::CaseInsensitive) == 0;
}

bool taken(const Project& project, ObjectKind kind, const std::string& name, const std::string& except = {})
{
    for (const ObjectPtr& object : project.objects(kind)) {
        if (object->key.name != except && sameName(object->key.name, name))
            return true;
    }
    return false;
}

Place placeIn(const std::string& source, const ObjectKey& key, std::size_t offset)
{
    const auto end = source.begin() + static_cast<std::ptrdiff_t>(std::min(offset, source.size()));
    const auto line = static_cast<std::uint32_t>(1 + std::count(source.begin(), end, '\n'));
    const std::size_t start = source.rfind('\n', offset == 0 ? 0 : offset - 1);
    const std::size_t column = offset == 0 || start == std::string::npos || start >= offset ? offset : offset - start - 1;
    const auto column1 = static_cast<std::uint32_t>(column + 1);
    return {key, "source", {line, column1, line, column1}, {}};
}

} // namespace

bool editText(ProjectDocument& document, const ObjectKey& program, std::size_t offset, std::size_t length, std::string inserted)
{
    const Program* content = document.content<Program>(program);
    if (!content || offset > content->source.size())
        return false;
    std::string removed = content->source.substr(offset, length);
    ProjectEdit edit;
    edit.label = QCoreApplication::translate("Commands", "Edit program \"%1\"").arg(quoted(program.name));
    edit.properties.insert("source");
    edit.place = placeIn(content->source, program, offset);
    edit.mergeKey = QStringLiteral("text:") + quoted(program.name);
    const bool endsRun = inserted.find('\n') != std::string::npos || inserted.size() > 1 || removed.size() > 1;
    if (endsRun)
        document.closeMerge();
    edit.deltas.push_back(TextDelta{program, offset, std::move(removed), std::move(inserted)});
    const bool pushed = document.push(std::move(edit));
    if (endsRun)
        document.closeMerge();
    return pushed;
}

ObjectKey addObject(ProjectDocument& document, Object object)
{
    object.key.name = freeName(document.project(), object.key.kind, object.key.name);
    object.order = document.project().nextOrder(object.key.kind);
    const ObjectKey key = object.key;
    ProjectEdit edit;
    edit.label = QCoreApplication::translate("Commands", "Add \"%1\"").arg(quoted(key.name));
    edit.deltas.push_back(ObjectDelta{key, nullptr, std::make_shared<const Object>(std::move(object))});
    edit.place = Place{key, {}, {}, {}};
    document.push(std::move(edit));
    return key;
}

bool removeObjects(ProjectDocument& document, std::span<const ObjectKey> keys)
{
    ProjectEdit edit;
    for (const ObjectKey& key : keys) {
        if (const ObjectPtr object = document.object(key)) {
            edit.deltas.push_back(ObjectDelta{key, object, nullptr});
            edit.place = Place{key, {}, {}, {}};
        }
    }
    edit.label = edit.deltas.size() == 1 ? QCoreApplication::translate("Commands", "Delete \"%1\"").arg(quoted(keyOf(edit.deltas.front()).name))
                                         : QCoreApplication::translate("Commands", "Delete %n objects", nullptr, int(edit.deltas.size()));
    return document.push(std::move(edit));
}

ObjectKey duplicateObject(ProjectDocument& document, const ObjectKey& key)
{
    const ObjectPtr original = document.object(key);
    if (!original)
        return {};
    Object copy = *original;
    if (auto* axis = std::get_if<Axis>(&copy.content))
        axis->number = freeAxisNumber(document.project());
    return addObject(document, std::move(copy));
}

Result<void> checkName(const Project& project, const ObjectKey& key, const std::string& name)
{
    const auto isWord = [](unsigned char c) { return std::isalnum(c) != 0 || c == '_' || c >= 0x80; };
    const bool identifier = !name.empty() && std::all_of(name.begin(), name.end(), isWord) && std::isdigit(static_cast<unsigned char>(name[0])) == 0;
    const bool blank = std::all_of(name.begin(), name.end(), [](unsigned char c) { return std::isspace(c) != 0; });
    // Programs are called by their names; the others may be quoted (CONTRACTS 18).
    if (blank || (key.kind == ObjectKind::Program && !identifier))
        return diagnostic(Code::NameNotIdentifier, {name}, Place{key, "name", {}, {}});
    if (taken(project, key.kind, name, key.name))
        return diagnostic(Code::NameTwice, {name}, Place{key, "name", {}, {}});
    return {};
}

Result<void> renameObject(ProjectDocument& document, const ObjectKey& key, const std::string& name)
{
    const ObjectPtr before = document.object(key);
    if (!before || name == key.name)
        return {};
    if (auto legal = checkName(document.project(), key, name); !legal)
        return legal;
    Object after = *before;
    after.key.name = name;
    ProjectEdit edit;
    edit.label = QCoreApplication::translate("Commands", "Rename \"%1\" to \"%2\"").arg(quoted(key.name), quoted(name));
    edit.place = Place{after.key, "name", {}, {}};
    edit.deltas.push_back(ObjectDelta{key, before, nullptr});
    edit.deltas.push_back(ObjectDelta{after.key, nullptr, std::make_shared<const Object>(after)});
    document.push(std::move(edit));
    return {};
}

std::string freeName(const Project& project, ObjectKind kind, const std::string& wanted)
{
    if (!taken(project, kind, wanted))
        return wanted;
    std::string stem = wanted;
    while (!stem.empty() && std::isdigit(static_cast<unsigned char>(stem.back())) != 0)
        stem.pop_back();
    for (int n = 2;; ++n) {
        std::string candidate = stem + std::to_string(n);
        if (!taken(project, kind, candidate))
            return candidate;
    }
}

std::int64_t freeAxisNumber(const Project& project)
{
    std::set<std::int64_t> used;
    for (const ObjectPtr& object : project.objects(ObjectKind::Axis)) {
        const auto* axis = std::get_if<Axis>(&object->content);
        if (axis && axis->number.isValid())
            used.insert(axis->number.value());
    }
    std::int64_t number = 1;
    while (used.contains(number))
        ++number;
    return number;
}

Object newObject(const Project& project, ObjectKind kind)
{
    Object out;
    switch (kind) {
    case ObjectKind::Axis: {
        Axis axis;
        axis.number = freeAxisNumber(project);
        out.content = axis;
        out.key.name = "Axis1";
        break;
    }
    case ObjectKind::Network: out.content = Network{}; out.key.name = "CANopen"; break;
    case ObjectKind::Program: {
        const bool first = project.objects(ObjectKind::Program).empty();
        out.content = Program{first ? ProgramRole::Main : ProgramRole::Subroutine, ProgramLanguage::InstructionList, {}};
        out.key.name = first ? "Main" : "Sub1";
        break;
    }
    case ObjectKind::VariableTable: out.content = VariableTable{}; out.key.name = "Globals"; break;
    case ObjectKind::WatchTable: out.content = WatchTable{}; out.key.name = "Watch1"; break;
    case ObjectKind::Controller: out.content = ControllerSettings{}; break;
    case ObjectKind::Project: out.content = ProjectSettings{}; break;
    }
    out.key.kind = kind;
    if (!out.key.name.empty())
        out.key.name = freeName(project, kind, out.key.name);
    return out;
}

} // namespace camwright
