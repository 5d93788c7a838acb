#include "core/storage/journal.h"
#include "core/storage/objecttext.h"
#include "core/storage/projectstore.h"
#include "tests/core/storage/memoryfilesystem.h"

#include <cstdlib>
#include <string_view>

using namespace camwright;

namespace {

void require(bool condition)
{
    if (!condition)
        std::abort();
}

/// An edit such as a document makes, so that writing into the text read is tried too.
Object edited(Object object)
{
    ++object.order;
    if (object.key.kind == ObjectKind::Project || object.key.kind == ObjectKind::Controller)
        object.order = 0;
    if (auto* axis = std::get_if<Axis>(&object.content)) {
        axis->comment += "edited";
        axis->simulation.inertiaRatio = 7.5;
    } else if (auto* watch = std::get_if<WatchTable>(&object.content)) {
        watch->rows.push_back({"Start", "hex", {}});
    } else if (auto* table = std::get_if<VariableTable>(&object.content)) {
        *table = table->replaced(table->rowCount() / 2, 0, {Variable{"New", DataType::Int, "%VW0", "", true, "c"}});
    } else if (auto* program = std::get_if<Program>(&object.content)) {
        program->source += "LD %M0.0\n";
    }
    return object;
}

/// What is read is written canonically and read again as the same; what was not edited stays as it stood.
void tryObject(const ObjectKey& key, std::string_view text)
{
    const auto object = fromText(key, text, "f");
    if (!object) {
        require(!object.error().empty());
        for (const Diagnostic& error : object.error())
            require(error.place.range.isValid() && error.place.file == "f");
        return;
    }
    const auto again = fromText(key, toText(*object));
    require(again.ok() && *again == *object);
    require(toTextKeeping(*object, text) == text);
    const Object other = edited(*object);
    const auto kept = fromText(key, toTextKeeping(other, text));
    require(kept.ok() && *kept == other);
}

/// A folder whose private files come from a stranger: opening it never fails for their sake and writes nothing but them.
void tryPrivateFile(const std::string& name, std::string_view text)
{
    MemoryFileSystem files;
    require(createProject(files, "/p", Project().withName("x")).ok());
    files.folders.insert("/p/.camwright/save");
    files.files["/p/.camwright/save/0"] = "format = 1\nname = \"staged\"\n";
    files.files["/p/.camwright/" + name] = text;
    const auto loaded = openProject(files, "/p");
    for (const auto& [path, content] : files.files)
        require(path.starts_with("/p/"));
    if (loaded)
        (void)readJournal(files, "/p", loaded->project);
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    if (size == 0)
        return 0;
    const std::string_view text(reinterpret_cast<const char*>(data) + 1, size - 1);
    switch (data[0]) {
    case 'p': tryObject(projectKey(), text); break;
    case 'c': tryObject(controllerKey(), text); break;
    case 'a': tryObject({ObjectKind::Axis, "x"}, text); break;
    case 'n': tryObject({ObjectKind::Network, "x"}, text); break;
    case 'i': tryObject({ObjectKind::Program, "x"}, text); break;
    case 'v': tryObject({ObjectKind::VariableTable, "x"}, text); break;
    case 'w': tryObject({ObjectKind::WatchTable, "x"}, text); break;
    case 'j': tryPrivateFile("journal.1", text); break;
    case 's': tryPrivateFile("save/commit", text); break;
    default: break;
    }
    return 0;
}
