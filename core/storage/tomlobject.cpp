#include "core/storage/tomlobject.h"

#include "core/model/fieldlist.h"
#include "core/storage/filenames.h"
#include "core/storage/projectstore.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace camwright {

namespace {

std::string_view axisTypeName(AxisType type)
{
    return type == AxisType::Rotary ? "rotary" : "linear";
}

bool hasOrder(ObjectKind kind)
{
    return kind != ObjectKind::Project && kind != ObjectKind::Controller;
}

// Writing

std::string textOf(const std::string& value) { return tomlString(value); }
std::string textOf(std::int64_t value) { return std::to_string(value); }
std::string textOf(double value) { return tomlNumber(value); }
std::string textOf(bool value) { return value ? "true" : "false"; }
std::string textOf(AxisType value) { return tomlString(axisTypeName(value)); }

template <class T>
std::string textOf(const Field<T>& field)
{
    return field.isValid() ? textOf(field.value()) : tomlString(field.text());
}

std::string rowsText(const WatchTable& table)
{
    if (table.rows.empty())
        return "[]";
    std::string out = "[\n";
    for (const WatchRow& row : table.rows) {
        out += "    { expression = " + tomlString(row.expression);
        if (!row.format.empty())
            out += ", format = " + tomlString(row.format);
        for (const auto& [key, value] : row.unknown)
            out += ", " + key + " = " + value;
        out += " },\n";
    }
    return out + "]";
}

struct LineWriter {
    TomlLines& lines;

    template <class T>
    void operator()(const char* key, const T& value) const
    {
        lines.emplace_back(key, textOf(value));
    }
    /// A choice that is off by default stands in the file only where it is on, or is not legal.
    void operator()(const char* key, const Field<bool>& value) const
    {
        if (!value.isValid() || value.value())
            lines.emplace_back(key, textOf(value));
    }
    void operator()(const char* key, const std::string& value) const
    {
        if (!value.empty() || std::string_view(key) != "comment")
            lines.emplace_back(key, textOf(value));
    }
};

void appendContent(TomlLines& lines, const ObjectContent& content)
{
    const LineWriter write{lines};
    if (const auto* project = std::get_if<ProjectSettings>(&content))
        visitFields(*project, write);
    else if (const auto* controller = std::get_if<ControllerSettings>(&content))
        visitFields(*controller, write);
    else if (const auto* axis = std::get_if<Axis>(&content))
        visitFields(*axis, write);
    else if (const auto* network = std::get_if<Network>(&content))
        visitFields(*network, write);
    else if (const auto* watch = std::get_if<WatchTable>(&content))
        lines.emplace_back("rows", rowsText(*watch));
}

// Reading

class ObjectReader {
public:
    ObjectReader(const ObjectKey& key, const std::vector<TomlLeaf>& leaves, const std::string& file) : m_key(key), m_file(file)
    {
        for (const TomlLeaf& leaf : leaves)
            m_leaves.emplace(leaf.path, &leaf.value);
    }

    Result<Object, Diagnostics> read()
    {
        Object out{m_key, 0, {}, {}};
        if (m_key.kind == ObjectKind::Project && !readFormat())
            return std::move(m_errors);
        if (hasOrder(m_key.kind))
            readOrder(out.order);
        if (isShortened(stemOf(m_key.name)))
            m_known.insert("name");
        out.content = readContent();
        keepUnknown(out.unknown);
        if (!m_errors.empty())
            return std::move(m_errors);
        return out;
    }

    template <class T>
    void operator()(const char* key, Field<T>& field)
    {
        const TomlValue* value = take(key);
        if (!value)
            return;
        if (value->kind == TomlValue::Kind::Array || value->kind == TomlValue::Kind::Table)
            fail(Code::SingleValueExpected, key, *value);
        else
            field = fieldOf(*value, T{});
    }
    void operator()(const char* key, std::string& text)
    {
        const TomlValue* value = take(key);
        if (value && value->kind != TomlValue::Kind::String)
            fail(Code::TextExpected, key, *value);
        else if (value)
            text = value->string;
    }

private:
    template <class T>
    T readFields()
    {
        T out;
        visitFields(out, *this);
        return out;
    }

    ObjectContent readContent()
    {
        switch (m_key.kind) {
        case ObjectKind::Controller: return readFields<ControllerSettings>();
        case ObjectKind::Axis: return readFields<Axis>();
        case ObjectKind::Network: return readFields<Network>();
        case ObjectKind::WatchTable: return readRows();
        default: return readFields<ProjectSettings>();
        }
    }

    bool readFormat()
    {
        const TomlValue* value = take("format");
        if (!value)
            fail(diagnostic(Code::FormatMissing, {std::to_string(ProjectFormat)}), {1, 1, 1, 1});
        else if (value->kind != TomlValue::Kind::Integer || value->integer < 1)
            fail(Code::WholeNumberExpected, "format", *value);
        else if (value->integer > ProjectFormat)
            fail(diagnostic(Code::NewerFormat, {std::to_string(value->integer), std::to_string(ProjectFormat)}), value->range);
        return m_errors.empty();
    }

    void readOrder(std::int64_t& order)
    {
        const TomlValue* value = take("order");
        if (value && value->kind != TomlValue::Kind::Integer)
            fail(Code::WholeNumberExpected, "order", *value);
        else if (value)
            order = value->integer;
    }

    WatchTable readRows()
    {
        WatchTable out;
        const TomlValue* value = take("rows");
        if (!value)
            return out;
        if (value->kind != TomlValue::Kind::Array)
            fail(Code::ListExpected, "rows", *value);
        for (std::size_t n = 0; n < value->elements.size(); ++n)
            out.rows.push_back(readRow("rows[" + std::to_string(n) + ']', value->elements[n]));
        return out;
    }

    WatchRow readRow(const std::string& path, const TomlValue& value)
    {
        WatchRow out;
        if (value.kind != TomlValue::Kind::Table)
            fail(Code::TableExpected, path, value);
        for (const auto& [key, member] : value.members) {
            std::string* text = key == "expression" ? &out.expression : key == "format" ? &out.format : nullptr;
            if (!text)
                out.unknown.emplace(tomlKey(key), member.text);
            else if (member.kind != TomlValue::Kind::String)
                fail(Code::TextExpected, path + '.' + key, member);
            else
                *text = member.string;
        }
        return out;
    }

    static Field<std::int64_t> fieldOf(const TomlValue& value, std::int64_t)
    {
        return value.kind == TomlValue::Kind::Integer ? Field<std::int64_t>(value.integer) : Field<std::int64_t>::typed(typedText(value));
    }
    static Field<double> fieldOf(const TomlValue& value, double)
    {
        if (value.kind == TomlValue::Kind::Integer)
            return static_cast<double>(value.integer);
        const bool legal = value.kind == TomlValue::Kind::Float && std::isfinite(value.number);
        return legal ? Field<double>(value.number) : Field<double>::typed(typedText(value));
    }
    static Field<bool> fieldOf(const TomlValue& value, bool)
    {
        return value.kind == TomlValue::Kind::Boolean ? Field<bool>(value.text == "true") : Field<bool>::typed(typedText(value));
    }
    static Field<AxisType> fieldOf(const TomlValue& value, AxisType)
    {
        for (const AxisType type : {AxisType::Linear, AxisType::Rotary}) {
            if (value.kind == TomlValue::Kind::String && value.string == axisTypeName(type))
                return type;
        }
        return Field<AxisType>::typed(typedText(value));
    }
    static std::string typedText(const TomlValue& value)
    {
        return value.kind == TomlValue::Kind::String ? value.string : value.text;
    }

    const TomlValue* take(const std::string& path)
    {
        m_known.insert(path);
        const auto found = m_leaves.find(path);
        return found == m_leaves.end() ? nullptr : found->second;
    }

    /// A key that is a table where we know a value, or the other way round, would make the file unreadable when written.
    void keepUnknown(UnknownKeys& unknown)
    {
        for (const auto& [path, value] : m_leaves) {
            if (m_known.contains(path))
                continue;
            for (const std::string& known : m_known) {
                if (path.starts_with(known + '.'))
                    fail(Code::SingleValueExpected, known, *value);
                else if (known.starts_with(path + '.'))
                    fail(Code::TableExpected, path, *value);
            }
            unknown.emplace(path, value->text);
        }
    }

    void fail(Code code, const std::string& path, const TomlValue& value)
    {
        Diagnostic error = diagnostic(code, {path});
        error.place.field = path;
        fail(std::move(error), value.range);
    }

    void fail(Diagnostic error, const TextRange& range)
    {
        error.place.object = m_key;
        error.place.file = m_file;
        error.place.range = range;
        m_errors.push_back(std::move(error));
    }

    const ObjectKey& m_key;
    const std::string& m_file;
    std::map<std::string, const TomlValue*> m_leaves;
    std::set<std::string> m_known;
    Diagnostics m_errors;
};

} // namespace

bool isTomlKind(ObjectKind kind)
{
    return kind != ObjectKind::Program && kind != ObjectKind::VariableTable;
}

TomlLines tomlLines(const Object& object)
{
    TomlLines out;
    if (object.key.kind == ObjectKind::Project)
        out.emplace_back("format", std::to_string(ProjectFormat));
    if (isShortened(stemOf(object.key.name)))
        out.emplace_back("name", tomlString(encodedName(object.key.name)));
    if (hasOrder(object.key.kind))
        out.emplace_back("order", std::to_string(object.order));
    appendContent(out, object.content);
    out.insert(out.end(), object.unknown.begin(), object.unknown.end());
    return out;
}

std::vector<std::string> tomlTables(ObjectKind kind)
{
    return kind == ObjectKind::Axis ? std::vector<std::string>{"simulation"} : std::vector<std::string>{};
}

Result<Object, Diagnostics> readTomlObject(const ObjectKey& key, const std::vector<TomlLeaf>& leaves, const std::string& file)
{
    return ObjectReader(key, leaves, file).read();
}

} // namespace camwright
