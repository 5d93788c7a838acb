#include "core/checks/projectcheck.h"

#include "core/base/utf8.h"
#include "core/checks/fieldcheck.h"
#include "core/model/fieldlist.h"

#include <algorithm>
#include <charconv>
#include <tuple>

namespace camwright {

namespace {

std::string folded(std::string_view name)
{
    std::string out(name);
    for (char& c : out) {
        if (c >= 'A' && c <= 'Z')
            c = static_cast<char>(c - 'A' + 'a');
    }
    return out;
}

/// Latin beside Greek or Cyrillic, whose letters look alike.
bool mixesAlphabets(std::string_view name)
{
    bool latin = false, other = false;
    for (std::size_t at = 0; at < name.size();) {
        const auto point = codePointAt(name, at);
        const char32_t c = point ? point->value : 0;
        latin = latin || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
        other = other || (c >= 0x370 && c <= 0x52F);
        at += point ? point->length : 1;
    }
    return latin && other;
}

/// The n of "rows[n].name", so that row 2 comes before row 10; 0 for other fields.
std::size_t rowOf(std::string_view field)
{
    std::size_t row = 0;
    if (field.starts_with("rows["))
        std::from_chars(field.data() + 5, field.data() + field.size(), row);
    return row;
}

template <class Range, class Name>
std::string listOf(const Range& range, Name name)
{
    std::string out;
    for (const auto& entry : range)
        out += (out.empty() ? "" : ", ") + name(entry);
    return out;
}

std::string selectableModels(const Family& family)
{
    std::vector<std::string> names;
    for (const ControllerModel& model : family.models()) {
        if (model.selectable)
            names.push_back(model.name);
    }
    return listOf(names, [](const std::string& name) { return name; });
}

} // namespace

Validation ProjectCheck::run()
{
    m_valid.m_project = m_project;
    m_valid.m_name = m_project.name();
    checkNames();
    checkController();
    checkAxes();
    checkNetworks();
    checkBusLoad();
    checkPrograms();
    checkVariables();
    std::sort(m_out.begin(), m_out.end(), [](const Diagnostic& a, const Diagnostic& b) {
        const std::size_t rowA = rowOf(a.place.field), rowB = rowOf(b.place.field);
        return std::tie(a.place.object, rowA, a.place, a.code, a.arguments) < std::tie(b.place.object, rowB, b.place, b.code, b.arguments);
    });
    Validation out{std::nullopt, std::move(m_out)};
    if (!hasErrors(out.diagnostics))
        out.project = std::move(m_valid);
    return out;
}

void ProjectCheck::report(Code code, std::vector<std::string> arguments, Place place, std::optional<Place> related)
{
    m_out.push_back({code, std::move(arguments), std::move(place), std::move(related)});
}

/// Axis and program names are found by name everywhere, and in languages that take upper and lower case as equal.
void ProjectCheck::checkNames()
{
    std::map<std::pair<ObjectKind, std::string>, ObjectKey> seen;
    for (const auto& [key, object] : m_project.all()) {
        if (key.kind == ObjectKind::Project || key.kind == ObjectKind::Controller)
            continue;
        const Place place{key, {}, {}, {}};
        if (key.name.empty())
            report(Code::NameEmpty, {}, place);
        checkAlphabet(place, key.name);
        const auto [first, added] = seen.emplace(std::pair(key.kind, folded(key.name)), key);
        if (!added)
            report(Code::NameTwice, {key.name}, place, Place{first->second, {}, {}, {}});
    }
}

void ProjectCheck::checkAlphabet(const Place& place, const std::string& name)
{
    if (mixesAlphabets(name))
        report(Code::NameMixesAlphabets, {name}, place);
}

void ProjectCheck::checkController()
{
    const auto* settings = m_project.content<ControllerSettings>(controllerKey());
    if (!settings) {
        report(Code::ControllerMissing, {}, Place{projectKey(), {}, {}, {}});
        return;
    }
    visitFields(*settings, FieldCheck(controllerKey(), m_out));
    m_valid.m_family = findFamily(settings->family);
    if (!m_valid.m_family) {
        const std::string known = listOf(families(), [](const Family* family) { return family->id(); });
        report(Code::FamilyUnknown, {settings->family, known}, Place{controllerKey(), "family", {}, {}});
    } else {
        m_valid.m_model = m_valid.m_family->findModel(settings->model);
        if (!m_valid.m_model || !m_valid.m_model->selectable) {
            m_valid.m_model = nullptr;
            report(Code::ModelUnknown, {settings->model, m_valid.m_family->displayName(), selectableModels(*m_valid.m_family)},
                   Place{controllerKey(), "model", {}, {}});
        }
    }
    const std::int64_t periodUs = settings->scanPeriodUs.valueOr(0), watchdogMs = settings->watchdogMs.valueOr(500);
    m_valid.m_scanPeriod = std::chrono::microseconds(std::clamp<std::int64_t>(periodUs, 0, 1'000'000));
    m_valid.m_watchdog = std::chrono::milliseconds(std::clamp<std::int64_t>(watchdogMs, 1, 60'000));
    if (periodUs > 0 && m_valid.m_watchdog <= m_valid.m_scanPeriod) // TS-TIM-04; for Kinco it follows from the words
        report(Code::WatchdogTooShort, {std::to_string(watchdogMs), numberText(static_cast<double>(periodUs) / 1000)},
               Place{controllerKey(), "watchdog_ms", {}, {}});
}

void ProjectCheck::checkPrograms()
{
    const ObjectKey* main = nullptr;
    for (const ObjectPtr& object : m_project.objects(ObjectKind::Program)) {
        const auto& program = std::get<Program>(object->content);
        const Place place{object->key, "role", {}, {}};
        if (program.role == ProgramRole::Main) {
            if (main)
                report(Code::SecondMainProgram, {main->name, object->key.name}, place, Place{*main, "role", {}, {}});
            else
                main = &object->key;
        } else if (m_valid.m_model && !object->key.name.empty() && !isIdentifier(object->key.name)) {
            report(Code::NameNotIdentifier, {object->key.name}, Place{object->key, {}, {}, {}});
        }
        m_valid.m_programs.push_back({object->key, program.role, program.language, program.source});
    }
    if (!main)
        report(Code::NoMainProgram, {}, Place{projectKey(), {}, {}, {}});
    const auto first = std::find_if(m_valid.m_programs.begin(), m_valid.m_programs.end(),
                                    [](const ValidProgram& program) { return program.role == ProgramRole::Main; });
    if (first != m_valid.m_programs.end())
        std::rotate(m_valid.m_programs.begin(), first, first + 1);
}

namespace {

/// Letters and then digits, as every address of a name's characters: worth asking the family, which takes its time to say
/// what is wrong with all others.
bool looksLikeAddress(std::string_view name)
{
    const std::size_t digits = name.find_first_of("0123456789");
    return digits > 0 && digits <= 3 && name.find_first_not_of("0123456789", digits) == std::string_view::npos;
}

} // namespace

/// A letter first, then letters, digits or _ (TS-VAR-03; the same for Kinco, whose sheets are silent; _ first is refused
/// on TS600, where system variables begin with it).
bool ProjectCheck::isIdentifier(const std::string& name) const
{
    for (std::size_t at = 0; at < name.size();) {
        const auto point = codePointAt(name, at);
        if (!point || isInvisible(point->value) || point->value == 0xA0 || point->value == 0x3000)
            return false;
        const char c = name[at];
        const bool letter = point->value >= 0x80 || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
        const bool digit = c >= '0' && c <= '9';
        if (at == 0 ? !letter : !letter && !digit && c != '_')
            return false;
        at += point->length;
    }
    static constexpr std::string_view Reserved[] = {"true", "false", "on", "off", "null", "array", "struct", "at", "retain", "var_global", "end_var"};
    const std::string word = folded(name);
    return !name.empty() && std::find(std::begin(Reserved), std::end(Reserved), word) == std::end(Reserved) && !dataTypeByName(name)
        && !m_valid.m_family->catalogue().find(name)
        && !(looksLikeAddress(name) && m_valid.m_family->parseAddress(name, *m_valid.m_model, AddressMode::Typed));
}

Validation validate(const Project& project)
{
    return ProjectCheck(project).run();
}

Diagnostics checkProject(const Project& project)
{
    return validate(project).diagnostics;
}

} // namespace camwright
