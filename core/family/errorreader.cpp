#include "core/family/errorreader.h"

#include "core/family/csv.h"

namespace camwright {

namespace {

constexpr std::string_view ErrorColumns[] = {"scope", "field", "kind", "code", "level", "category", "instruction", "basis",
    "text_en", "text_zh", "text_ru", "cause_en", "cause_zh", "cause_ru", "remedy_en", "remedy_zh", "remedy_ru", "sources"};
constexpr std::string_view CategoryColumns[] = {"first", "last", "reserved", "device", "type", "en", "zh", "ru"};

using Level = ErrorText::Level;
constexpr std::pair<std::string_view, Level> Levels[] = {{"", Level::Unspecified}, {"warning", Level::Warning},
    {"general", Level::General}, {"serious", Level::Serious}};
constexpr std::pair<std::string_view, ErrorText::Kind> Kinds[] = {{"code", ErrorText::Kind::Code}, {"bit", ErrorText::Kind::Bit}};
constexpr std::pair<std::string_view, bool> Bases[] = {{"manual", true}, {"ours", false}};

Text textOf(const CsvRow& row, const std::string& stem)
{
    return {row.text(stem + "_en"), row.text(stem + "_zh"), row.text(stem + "_ru")};
}

/// One row may name several scopes, separated by blanks (the MC instructions share their codes).
void addError(CsvRow& row, FamilyData& out)
{
    ErrorText error;
    error.field = row.text("field");
    error.kind = row.choice<ErrorText::Kind>("kind", Kinds);
    error.code = row.count<std::uint32_t>("code");
    error.level = row.choice<Level>("level", Levels);
    error.category = row.text("category");
    error.instruction = row.text("instruction");
    error.fromManual = row.choice<bool>("basis", Bases);
    error.text = textOf(row, "text");
    error.cause = textOf(row, "cause");
    error.remedy = textOf(row, "remedy");
    error.sources = row.text("sources");
    for (const std::string& scope : row.words("scope")) {
        error.scope = scope;
        if (error.kind == ErrorText::Kind::Code && !out.errorCodes.emplace(std::pair(scope, error.code), out.errors.size()).second)
            row.duplicate("code");
        out.errors.push_back(error);
    }
}

void addCategory(CsvRow& row, FamilyData& out)
{
    ErrorCategory category;
    category.first = static_cast<std::uint16_t>(row.integer("first", 0, 0xFFFF));
    category.last = static_cast<std::uint16_t>(row.integer("last", category.first, 0xFFFF));
    category.reserved = row.flag("reserved");
    category.device = row.text("device");
    category.type = row.text("type");
    category.module = {row.text("en"), row.text("zh"), row.text("ru")};
    out.errorCategories.push_back(std::move(category));
}

void forEachRow(std::string_view name, std::string_view text, std::span<const std::string_view> columns, FamilyData& out,
    Diagnostics& diagnostics, void (*use)(CsvRow&, FamilyData&))
{
    const auto table = CsvTable::read(name, text, columns);
    if (!table) {
        diagnostics.insert(diagnostics.end(), table.error().begin(), table.error().end());
        return;
    }
    for (std::size_t i = 0; i < table->rowCount(); ++i) {
        CsvRow row(*table, i, diagnostics);
        use(row, out);
    }
}

} // namespace

void readErrors(const FamilyFiles& files, FamilyData& out, Diagnostics& diagnostics)
{
    forEachRow("errors.csv", files("errors.csv"), ErrorColumns, out, diagnostics, addError);
    if (!files("error_categories.csv").empty())
        forEachRow("error_categories.csv", files("error_categories.csv"), CategoryColumns, out, diagnostics, addCategory);
}

} // namespace camwright
