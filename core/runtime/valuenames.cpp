#include "core/runtime/valuenames.h"

#include <array>
#include <charconv>
#include <optional>

namespace camwright {

namespace {

struct FieldName {
    std::string_view name;
    AxisField field;
    DataType type;
};

constexpr std::array<FieldName, 7> kFields{{
    {"position", AxisField::Position, DataType::Lreal},
    {"setPosition", AxisField::SetPosition, DataType::Lreal},
    {"velocity", AxisField::Velocity, DataType::Lreal},
    {"followingError", AxisField::FollowingError, DataType::Lreal},
    {"torque", AxisField::Torque, DataType::Lreal},
    {"state", AxisField::State, DataType::Usint},
    {"error", AxisField::Error, DataType::Udint},
}};

struct AxisName {
    std::string_view axis;
    bool quoted = false;
    std::string_view field;
};

/// "Feed.position", "1.state", "\"Axis 1 name\".torque".
std::optional<AxisName> split(std::string_view rest)
{
    AxisName out;
    std::size_t end = 0;
    if (!rest.empty() && rest.front() == '"') {
        rest.remove_prefix(1);
        end = rest.find('"');
        if (end == std::string_view::npos)
            return std::nullopt;
        out.axis = rest.substr(0, end);
        out.quoted = true;
        ++end;
    } else {
        end = rest.find('.');
        if (end == std::string_view::npos)
            return std::nullopt;
        out.axis = rest.substr(0, end);
    }
    if (end >= rest.size() || rest[end] != '.')
        return std::nullopt;
    out.field = rest.substr(end + 1);
    return out;
}

bool isPlain(std::string_view name)
{
    return name.find_first_of(". \"") == std::string_view::npos;
}

std::optional<std::size_t> axisNumber(std::string_view text)
{
    std::size_t number = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (error != std::errc{} || end != text.data() + text.size() || number == 0)
        return std::nullopt;
    return number - 1;
}

} // namespace

ValueRef refOf(const Address& address)
{
    ValueRef ref;
    ref.source = ValueRef::Source::Memory;
    ref.type = address.type;
    ref.area = address.area;
    ref.isBit = address.isBit;
    ref.bit = address.bit;
    ref.byte = address.byte;
    return ref;
}

Address addressOf(const ValueRef& ref)
{
    return {ref.area, ref.bit, ref.isBit, ref.type, ref.byte};
}

Result<ValueRef> ValueNames::resolve(std::string_view name) const
{
    if (name.starts_with("axis."))
        return resolveAxis(name, name.substr(5), ValueRef::Source::Axis);
    if (name.starts_with("plant."))
        return resolveAxis(name, name.substr(6), ValueRef::Source::Plant);
    if (const Symbol* symbol = findSymbol(m_image, name))
        return refOf(symbol->address);
    const Result<Address> address = m_family.parseAddress(name, m_model, AddressMode::Typed);
    if (address)
        return refOf(*address);
    const bool looksLikeAddress = !name.empty() && name.front() == '%';
    if (looksLikeAddress)
        return address.error();
    return diagnostic(Code::NameUnknown, {std::string(name)});
}

Result<ValueRef> ValueNames::resolveAxis(std::string_view name, std::string_view rest, ValueRef::Source source) const
{
    const auto parts = split(rest);
    if (!parts)
        return diagnostic(Code::NameUnknown, {std::string(name)});
    std::optional<std::size_t> index;
    for (std::size_t i = 0; i < m_motion.axisCount() && !index; ++i) {
        if (m_motion.axisName(i) == parts->axis)
            index = i;
    }
    if (!index && !parts->quoted)
        index = axisNumber(parts->axis);
    if (!index || *index >= m_motion.axisCount())
        return diagnostic(Code::NoSuchAxis, {"\"" + std::string(parts->axis) + "\"", std::to_string(m_motion.axisCount())});
    for (const FieldName& candidate : kFields) {
        if (candidate.name != parts->field)
            continue;
        ValueRef ref;
        ref.source = source;
        ref.axis = static_cast<std::uint16_t>(*index);
        ref.field = candidate.field;
        ref.type = candidate.type;
        return ref;
    }
    return diagnostic(Code::UnknownAxisField, {std::string(parts->field)});
}

std::string ValueNames::unitOf(const ValueRef& ref) const
{
    if (ref.source == ValueRef::Source::Memory || ref.axis >= m_motion.axisCount())
        return {};
    switch (ref.field) {
    case AxisField::Position: case AxisField::SetPosition: case AxisField::FollowingError:
        return m_motion.axisUnit(ref.axis);
    case AxisField::Velocity:
        return m_motion.axisUnit(ref.axis) + "/s";
    case AxisField::Torque:
        return "%";
    case AxisField::State: case AxisField::Error:
        break;
    }
    return {};
}

std::vector<std::string> ValueNames::all() const
{
    std::vector<std::string> out;
    for (const Symbol& symbol : m_image.symbols)
        out.push_back(symbol.name);
    for (std::size_t i = 0; i < m_motion.axisCount(); ++i) {
        const std::string axis = m_motion.axisName(i);
        const std::string prefix = "axis." + (isPlain(axis) ? axis : "\"" + axis + "\"") + ".";
        for (const FieldName& field : kFields)
            out.push_back(prefix + std::string(field.name));
    }
    return out;
}

} // namespace camwright
