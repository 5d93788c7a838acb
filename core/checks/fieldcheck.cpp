#include "core/checks/fieldcheck.h"

#include "core/checks/checkproject.h"

#include <charconv>
#include <cmath>

namespace camwright {

std::string numberText(double value)
{
    char buffer[400];
    const bool whole = std::abs(value) < 1e15 && std::nearbyint(value) == value;
    const auto format = whole ? std::chars_format::fixed : std::chars_format::general;
    return {buffer, std::to_chars(buffer, buffer + sizeof buffer, value, format).ptr};
}

void FieldCheck::operator()(const char* key, const Field<std::int64_t>& field)
{
    if (field.isValid())
        checkRange(key, static_cast<double>(field.value()), std::to_string(field.value()));
    else
        report(Code::FieldNotWhole, key, {field.text(), key});
}

void FieldCheck::operator()(const char* key, const Field<double>& field)
{
    if (field.isValid())
        checkRange(key, field.value(), numberText(field.value()));
    else
        report(Code::FieldNotNumber, key, {field.text(), key});
}

void FieldCheck::operator()(const char* key, const Field<AxisType>& field)
{
    if (!field.isValid())
        report(Code::FieldNotOneOf, key, {field.text(), key, "linear, rotary"});
}

void FieldCheck::operator()(const char* key, const Field<bool>& field)
{
    if (!field.isValid())
        report(Code::FieldNotOneOf, key, {field.text(), key, "false, true"});
}

void FieldCheck::checkRange(const char* key, double value, const std::string& text)
{
    const auto range = fieldRange(m_object.kind, key);
    if (range && !(value >= range->low && value <= range->high))
        report(Code::FieldOutOfRange, key, {text, key, numberText(range->low), numberText(range->high)});
}

void FieldCheck::report(Code code, const char* key, std::vector<std::string> arguments)
{
    m_out.push_back(diagnostic(code, std::move(arguments), Place{m_object, key, {}, {}}));
}

} // namespace camwright
