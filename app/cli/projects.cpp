#include "app/cli/projects.h"

#include "app/cli/exitcode.h"
#include "app/cli/verbs.h"
#include "core/checks/checkproject.h"
#include "core/family/family.h"
#include "core/language/compile.h"
#include "core/language/stprograms.h"
#include "core/storage/objecttext.h"
#include "core/storage/projectreader.h"

#include <QDir>
#include <QFileInfo>
#include <QSaveFile>

namespace camwright::cli {

namespace {

/// Diagnostics of a project name objects; people want the file and the line in it.
void printAll(Invocation& call, const QString& path, const LoadedProject& loaded, const Diagnostics& diagnostics)
{
    for (Diagnostic d : diagnostics) {
        if (d.place.file.empty())
            d.place = filePlace(d.place, loaded.project, loaded.files);
        if (!d.place.file.empty() && !path.isEmpty())
            d.place.file = QDir::cleanPath(path + QLatin1Char('/') + QString::fromStdString(d.place.file)).toStdString();
        call.out.diagnostic(d);
    }
}

void printAtPath(Invocation& call, const QString& path, const Diagnostics& diagnostics)
{
    for (const Diagnostic& each : diagnostics) {
        Diagnostic d = each;
        if (!d.place.file.empty())
            d.place.file = QDir::cleanPath(path + QLatin1Char('/') + QString::fromStdString(d.place.file)).toStdString();
        call.out.diagnostic(d);
    }
}

struct Checked {
    int status = Done;
    std::optional<CompileResult> result;
    std::size_t errors = 0, warnings = 0;
};

void count(Checked& out, const Diagnostics& diagnostics)
{
    for (const Diagnostic& d : diagnostics) {
        out.errors += d.severity() == Severity::Error;
        out.warnings += d.severity() == Severity::Warning;
    }
}

/// Reads, validates and compiles; prints every diagnostic on the way.
Checked compileProject(Invocation& call, const QString& path, const BuildOptions& options)
{
    Checked out;
    const auto loaded = readProject(call, path);
    if (!loaded) {
        out.status = CannotRead;
        return out;
    }
    printAtPath(call, path, loaded->notes);
    const Validation validation = validate(loaded->project);
    printAll(call, path, *loaded, validation.diagnostics);
    count(out, validation.diagnostics);
    if (validation.project) {
        Job job;
        out.result = compile(*validation.project, options, job);
        printAll(call, path, *loaded, out.result->diagnostics);
        count(out, out.result->diagnostics);
    } else {
        for (const ObjectPtr& program : loaded->project.objects(ObjectKind::Program)) {
            const Diagnostics found = checkProgramText(loaded->project, program->key, std::get<Program>(program->content).source);
            printAll(call, path, *loaded, found);
            count(out, found);
        }
    }
    out.status = out.errors == 0 ? Done : AnswerIsNo;
    return out;
}

QString counted(std::size_t number, const char* what)
{
    return QStringLiteral("%1 %2%3").arg(QString::number(number), QLatin1String(what), QLatin1String(number == 1 ? "" : "s"));
}

void summary(Invocation& call, const Checked& checked)
{
    if (call.out.asJson()) {
        call.out.json()["errors"] = checked.errors;
        call.out.json()["warnings"] = checked.warnings;
        return;
    }
    const QString errors = checked.errors == 0 ? QStringLiteral("No errors") : counted(checked.errors, "error");
    call.out.line(errors + QStringLiteral(", ") + counted(checked.warnings, "warning") + QLatin1Char('.'));
}

} // namespace

std::optional<LoadedProject> readProject(Invocation& call, const QString& path)
{
    PosixFileSystem files;
    auto loaded = openProject(files, path.toStdString());
    if (loaded)
        return std::move(*loaded);
    printAtPath(call, path, loaded.error());
    return std::nullopt;
}

BuiltProject buildProject(Invocation& call, const QString& path)
{
    Checked checked = compileProject(call, path, BuildOptions{});
    BuiltProject out;
    out.status = checked.status;
    if (checked.status != Done || !checked.result || !checked.result->image) {
        out.status = out.status == Done ? AnswerIsNo : out.status;
        summary(call, checked);
        return out;
    }
    out.image = write(*checked.result->image);
    out.program = programHash(*checked.result->image);
    return out;
}

int cannotWrite(const QString& file)
{
    std::fprintf(stderr, "camwright-cli: '%s' cannot be written. Check that its folder exists and may be written to.\n", qUtf8Printable(file));
    return CannotRead;
}

namespace {

/// A file of Structured Text outside of any project.
int checkLooseFile(Invocation& call, const QString& path)
{
    PosixFileSystem files;
    const auto text = files.read(path.toStdString(), LargestProjectFile);
    if (!text) {
        call.out.diagnostic(text.error());
        return CannotRead;
    }
    Checked checked;
    const Diagnostics found = checkLooseSt(*text, path.toStdString());
    for (const Diagnostic& d : found)
        call.out.diagnostic(d);
    count(checked, found);
    summary(call, checked);
    return checked.errors == 0 ? Done : AnswerIsNo;
}

} // namespace

int runCheck(Invocation& call)
{
    if (call.words[0].endsWith(QLatin1String(".st"), Qt::CaseInsensitive) && QFileInfo(call.words[0]).isFile())
        return checkLooseFile(call, call.words[0]);
    const Checked checked = compileProject(call, call.words[0], BuildOptions{.forVirtualController = false, .archive = {}});
    if (checked.status != CannotRead)
        summary(call, checked);
    return checked.status;
}

int runBuild(Invocation& call)
{
    const BuiltProject built = buildProject(call, call.words[0]);
    if (!built)
        return built.status;
    if (call.has("out")) {
        QSaveFile file(call.value("out"));
        if (!file.open(QIODevice::WriteOnly) || file.write(reinterpret_cast<const char*>(built.image.data()), qint64(built.image.size())) < 0
            || !file.commit())
            return cannotWrite(call.value("out"));
    }
    call.out.json()["program"] = toHex(built.program);
    call.out.json()["bytes"] = built.image.size();
    call.out.line(QStringLiteral("Built: program %1, %2 bytes.").arg(QString::fromStdString(shortHex(built.program))).arg(built.image.size()));
    return Done;
}

void addBuildOptions(QCommandLineParser& options)
{
    options.addOption({QStringLiteral("out"), QStringLiteral("File for the controller image."), QStringLiteral("FILE")});
}

int runConvert(Invocation& call)
{
    const auto loaded = readProject(call, call.words[0]);
    if (!loaded)
        return CannotRead;
    PosixFileSystem files;
    const KnownFiles from = call.has("canonical") ? KnownFiles{} : loaded->files;
    const auto written = createProject(files, call.words[1].toStdString(), loaded->project, from);
    if (!written) {
        call.out.diagnostic(written.error());
        return written.error().code == Code::AlreadyAProject ? AnswerIsNo : CannotRead;
    }
    call.out.line(QStringLiteral("Wrote %1 files to %2.").arg(written->size()).arg(call.words[1]));
    call.out.json()["files"] = written->size();
    return Done;
}

void addConvertOptions(QCommandLineParser& options)
{
    options.addOption({QStringLiteral("canonical"), QStringLiteral("Write every file canonically, also those that did not change.")});
}

namespace {

Project emptyProject(const QString& name, const Family& family, const ControllerModel& model)
{
    const auto add = [](Project project, ObjectKey key, ObjectContent content) {
        return project.with(key, std::make_shared<const Object>(Object{key, 0, std::move(content), {}}));
    };
    ControllerSettings controller;
    controller.family = std::string(family.id());
    controller.model = std::string(model.name);
    Project project = Project().withName(name.toStdString());
    project = add(std::move(project), {ObjectKind::Controller, "controller"}, controller);
    if (model.axesMax > 0)
        project = add(std::move(project), {ObjectKind::Network, "CANopen"}, Network{});
    return add(std::move(project), {ObjectKind::Program, "Main"}, Program{});
}

int unknownChoice(Invocation& call, const QString& what, const QString& given, const QStringList& known)
{
    Q_UNUSED(call);
    return wrongUsage(QStringLiteral("there is no %1 '%2'. Known: %3.").arg(what, given, known.join(QStringLiteral(", "))));
}

} // namespace

int runNew(Invocation& call)
{
    const Family* family = findFamily(call.value("family").toStdString());
    if (!family) {
        QStringList known;
        for (const Family* f : families())
            known << QString::fromUtf8(f->id().data(), qsizetype(f->id().size()));
        return unknownChoice(call, QStringLiteral("family"), call.value("family"), known);
    }
    const ControllerModel* model = call.has("model") ? family->findModel(call.value("model").toStdString()) : &family->models().front();
    if (!model) {
        QStringList known;
        for (const ControllerModel& m : family->models())
            known << QString::fromStdString(std::string(m.name));
        return unknownChoice(call, QStringLiteral("model"), call.value("model"), known);
    }
    PosixFileSystem files;
    const QString path = call.words[0];
    const QString name = call.has("name") ? call.value("name") : QFileInfo(QDir::cleanPath(path)).fileName();
    const auto written = createProject(files, path.toStdString(), emptyProject(name, *family, *model));
    if (!written) {
        call.out.diagnostic(written.error());
        return written.error().code == Code::AlreadyAProject ? AnswerIsNo : CannotRead;
    }
    call.out.line(QStringLiteral("Made %1 for a %2.").arg(path, QString::fromStdString(std::string(model->name))));
    return Done;
}

void addNewOptions(QCommandLineParser& options)
{
    options.addOption({QStringLiteral("family"), QStringLiteral("Controller family: kinco, invt, koyo."), QStringLiteral("FAMILY"), QStringLiteral("kinco")});
    options.addOption({QStringLiteral("model"), QStringLiteral("Controller model; the family's first without it."), QStringLiteral("MODEL")});
    options.addOption({QStringLiteral("name"), QStringLiteral("Name of the project; the folder's without it."), QStringLiteral("NAME")});
}

} // namespace camwright::cli
