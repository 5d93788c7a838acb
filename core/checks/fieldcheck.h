#pragma once

#include "core/base/diagnostic.h"
#include "core/model/objects.h"

namespace camwright {

/// Checks every field of an object against its type and range. Fields that are no `Field` are left to others.
class FieldCheck {
public:
    FieldCheck(const ObjectKey& object, Diagnostics& out) : m_object(object), m_out(out) {}

    void operator()(const char* key, const Field<std::int64_t>& field);
    void operator()(const char* key, const Field<double>& field);
    void operator()(const char* key, const Field<AxisType>& field);
    void operator()(const char* key, const Field<bool>& field);
    void operator()(const char*, const std::string&) {}

private:
    void checkRange(const char* key, double value, const std::string& text);
    void report(Code code, const char* key, std::vector<std::string> arguments);

    const ObjectKey& m_object;
    Diagnostics& m_out;
};

/// A number as the checks' messages show it.
std::string numberText(double value);

} // namespace camwright
