#pragma once

#include "core/base/result.h"
#include "core/family/family.h"
#include "core/language/image/controllerimage.h"
#include "core/runtime/motionsystem.h"
#include "core/runtime/valueref.h"

#include <string>
#include <string_view>
#include <vector>

namespace camwright {

/// Finds what people call a value (CONTRACTS 18): a variable, an address as the family writes it, or
/// `axis.NAME.position` with NAME plain, quoted or the axis number; `plant.` in place of `axis.` for the simulated truth.
class ValueNames {
public:
    ValueNames(const ControllerImage& image, const Family& family, const ControllerModel& model, const MotionSystem& motion)
        : m_image(image), m_family(family), m_model(model), m_motion(motion) {}

    Result<ValueRef> resolve(std::string_view name) const;
    std::string unitOf(const ValueRef& ref) const;
    /// Variables, then every axis value.
    std::vector<std::string> all() const;
    std::string nameOf(const Address& address) const { return m_family.formatAddress(address); }

private:
    Result<ValueRef> resolveAxis(std::string_view name, std::string_view rest, ValueRef::Source source) const;

    const ControllerImage& m_image;
    const Family& m_family;
    const ControllerModel& m_model;
    const MotionSystem& m_motion;
};

ValueRef refOf(const Address& address);
Address addressOf(const ValueRef& ref);

} // namespace camwright
