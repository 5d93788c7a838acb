#include "core/family/family.h"

#include "core/family/embedded.h"
#include "core/family/familydata.h"

#include <algorithm>
#include <array>
#include <cassert>

namespace camwright {

bool ControllerModel::has(Capability capability) const
{
    switch (capability) {
    case Capability::PulseOutputs: return pulseOutputs > 0;
    case Capability::MotionAxes: return axesMax > 0;
    case Capability::None: break;
    }
    return true;
}

Family::Family(std::unique_ptr<const FamilyData> data) : m_data(std::move(data)) {}
Family::~Family() = default;

const std::string& Family::id() const { return m_data->id; }
const std::string& Family::displayName() const { return m_data->displayName; }
std::span<const ControllerModel> Family::models() const { return m_data->models; }

const ControllerModel* Family::findModel(std::string_view name) const
{
    const auto found = std::ranges::find(m_data->models, name, &ControllerModel::name);
    return found == m_data->models.end() ? nullptr : &*found;
}

const ControllerModel& Family::defaultModel() const
{
    const ControllerModel* model = findModel(m_data->defaultModel);
    assert(model);
    return *model;
}

std::span<const MemoryArea> Family::areas() const { return m_data->areas; }

const MemoryArea& Family::area(AreaId id) const
{
    assert(id < m_data->areas.size());
    return m_data->areas[id];
}

const MemoryArea* Family::findArea(std::string_view name) const
{
    const auto found = std::ranges::find(m_data->areas, name, &MemoryArea::name);
    return found == m_data->areas.end() ? nullptr : &*found;
}

Result<Address> Family::parseAddress(std::string_view text, const ControllerModel& model, AddressMode mode) const
{
    return m_data->syntax->parse({text, m_data->areas, model, mode});
}

std::string Family::formatAddress(const Address& address) const
{
    return address.area < m_data->areas.size() ? m_data->syntax->format(area(address.area), address) : std::string();
}

Result<Address> Family::withType(const Address& address, DataType type, const ControllerModel& model) const
{
    if (type == DataType::Bool && !address.isBit && m_data->syntax->valuesNameBits()) {
        if (const auto bit = bitOf(address))
            return *bit;
    }
    if (type != DataType::Bool && address.isBit) {
        if (const auto value = valueOf(address))
            return withType(*value, type, model);
    }
    const TypeSet types = m_data->syntax->types(area(address.area), address);
    Address out = address;
    out.type = type;
    if (types.contains(type) && blockFits(out, byteWidth(type), model))
        return out;
    std::string legal;
    for (DataType possible : types.list())
        legal += (legal.empty() ? "" : ", ") + std::string(name(possible));
    return diagnostic(Code::AddressNotOfType, {formatAddress(address), std::string(name(type)), legal});
}

std::optional<Address> Family::valueOf(const Address& address) const
{
    if (address.area >= m_data->areas.size())
        return std::nullopt;
    const MemoryArea& bits = area(address.area);
    const bool timer = bits.kind == AreaKind::TimerBits;
    if (!timer && bits.kind != AreaKind::CounterBits)
        return std::nullopt;
    const auto values = std::ranges::find(m_data->areas, timer ? AreaKind::TimerValues : AreaKind::CounterValues, &MemoryArea::kind);
    const std::uint32_t number = elementNumber(address);
    const DataType type = !timer && counterIs32Bit(number) ? DataType::Dint : m_data->syntax->elementValueType();
    return valueAddress(values->id, number * values->elementBytes, type);
}

std::optional<Address> Family::bitOf(const Address& address) const
{
    if (address.area >= m_data->areas.size())
        return std::nullopt;
    const MemoryArea& values = area(address.area);
    const bool timer = values.kind == AreaKind::TimerValues;
    if (!timer && values.kind != AreaKind::CounterValues)
        return std::nullopt;
    const auto bits = std::ranges::find(m_data->areas, timer ? AreaKind::TimerBits : AreaKind::CounterBits, &MemoryArea::kind);
    const std::uint32_t number = elementNumber(address);
    return bits->isPacked() ? bitAddress(bits->id, number / 8, number % 8) : bitAddress(bits->id, number * bits->elementBytes);
}

std::uint32_t Family::elementNumber(const Address& address) const
{
    const MemoryArea& place = area(address.area);
    return place.isPacked() && address.isBit ? address.byte * 8 + address.bit : address.byte / place.elementBytes;
}

const Text& Family::meaningOf(const Address& address) const
{
    const auto found = m_data->places.find(address);
    return found != m_data->places.end() ? found->second : area(address.area).meaning;
}

bool Family::isWritable(const Address& address) const
{
    if (address.area >= m_data->areas.size())
        return true;
    const MemoryArea& place = area(address.area);
    const std::uint32_t last = place.isPacked() ? elementNumber(address) : (address.byte + byteWidth(address.type) - 1) / place.elementBytes;
    return place.writable && elementNumber(address) >= place.writableFirst && last <= place.writableLast;
}

bool Family::blockFits(const Address& address, std::uint64_t bytes, const ControllerModel& model) const
{
    return address.byte + bytes <= m_data->syntax->endOf(address, model.area(address.area).bytes);
}

Time Family::timerBase(std::uint32_t timer) const
{
    for (const TimerRange& range : m_data->timers) {
        if (timer >= range.first && timer <= range.last)
            return range.base;
    }
    return m_data->timers.back().base;
}

bool Family::counterIs32Bit(std::uint32_t counter) const { return counter >= m_data->firstWideCounter; }
Time Family::modelledScanTime() const { return m_data->modelledScanTime; }
const Catalogue& Family::catalogue() const { return m_data->catalogue; }
std::span<const DriveParameter> Family::driveParameters() const { return m_data->driveParameters; }
std::span<const AxisState> Family::axisStates() const { return m_data->axisStates; }

const AxisState* Family::findAxisState(int number) const
{
    const auto found = std::ranges::find(m_data->axisStates, number, &AxisState::number);
    return found == m_data->axisStates.end() ? nullptr : &*found;
}

std::span<const ErrorText> Family::errors() const { return m_data->errors; }
std::span<const ErrorCategory> Family::errorCategories() const { return m_data->errorCategories; }

const ErrorText* Family::findError(std::string_view scope, std::uint32_t code) const
{
    const auto found = m_data->errorCodes.find({std::string(scope), code});
    return found == m_data->errorCodes.end() ? nullptr : &m_data->errors[found->second];
}

std::string Family::errorText(std::string_view scope, std::uint32_t code, TextLanguage language) const
{
    if (const ErrorText* whole = findError(scope, code))
        return whole->text.in(language);
    std::string out;
    for (const ErrorText& error : m_data->errors) {
        const bool isSet = error.kind == ErrorText::Kind::Bit && error.scope == scope && error.code < 32 && ((code >> error.code) & 1u) != 0;
        if (isSet)
            out += (out.empty() ? "" : " ") + error.text.in(language);
    }
    return out;
}

namespace {

/// A family whose data are part of the program. That they can be read is what tests/core/family shows.
std::unique_ptr<const Family> embeddedFamily(std::string_view id)
{
    auto data = readFamily([id](std::string_view name) { return embeddedFamilyFile(std::string(id) + "/" + std::string(name)); });
    assert(data.ok());
    return std::make_unique<const Family>(std::make_unique<const FamilyData>(std::move(data).value()));
}

} // namespace

std::span<const Family* const> families()
{
    static const std::unique_ptr<const Family> kinco = embeddedFamily("kinco");
    static const std::unique_ptr<const Family> invt = embeddedFamily("invt");
    static const std::unique_ptr<const Family> koyo = embeddedFamily("koyo");
    static const std::array<const Family*, 3> all{kinco.get(), invt.get(), koyo.get()};
    return all;
}

const Family* findFamily(std::string_view id)
{
    const auto all = families();
    const auto found = std::ranges::find(all, id, [](const Family* family) -> const std::string& { return family->id(); });
    return found == all.end() ? nullptr : *found;
}

} // namespace camwright
