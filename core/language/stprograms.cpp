#include "core/language/stprograms.h"

#include "core/language/st/check/checker.h"

namespace camwright {

namespace {

/// IEC writes %IX0.0 for the bit that Kinco writes as %I0.0.
std::string withoutBitLetter(std::string_view address)
{
    std::string out(address);
    if (out.size() > 2 && (out[2] == 'X' || out[2] == 'x'))
        out.erase(2, 1);
    return out;
}

std::optional<Address> findAddress(const LanguageContext& context, std::string_view text, DataType type)
{
    for (const std::string& written : {std::string(text), withoutBitLetter(text)}) {
        const auto address = context.family->parseAddress(written, *context.model, AddressMode::Typed);
        if (!address)
            continue;
        const auto typed = context.family->withType(*address, type, *context.model);
        return typed ? std::optional(*typed) : std::nullopt;
    }
    return std::nullopt;
}

st::Environment environmentOf(std::span<const ProgramSource> others, const LanguageContext& context)
{
    st::Environment out;
    for (const KnownVariable& variable : context.variables) {
        if (variable.address)
            out.variables.push_back({variable.name, variable.type, *variable.address, context.family->isWritable(*variable.address)});
    }
    for (const ProgramSource& other : others) {
        if (other.role == ProgramRole::Subroutine)
            out.subroutines.push_back(other.key.name);
    }
    out.findAddress = [&context](std::string_view text, DataType type) { return findAddress(context, text, type); };
    constexpr std::uint32_t Alignment = 8;
    out.variablesFrom = (context.variableBytes + Alignment - 1) / Alignment * Alignment;
    return out;
}

} // namespace

std::unique_ptr<st::Compilation> checkSt(std::span<const ProgramSource> sources, std::span<const ProgramSource> others, const LanguageContext& context)
{
    std::vector<st::Source> texts;
    for (const ProgramSource& source : sources)
        texts.push_back({source.key, source.text, source.role == ProgramRole::Main});
    return st::check(std::move(texts), environmentOf(others, context));
}

Diagnostics diagnosticsOf(const st::Compilation& compilation, const LanguageContext& context)
{
    Diagnostics out;
    for (std::size_t i = 0; i + 1 < compilation.sources.size(); ++i) {
        out.insert(out.end(), compilation.diagnostics[i].begin(), compilation.diagnostics[i].end());
        out.push_back(diagnostic(Code::StOnlyVirtual, {context.family->displayName()}, {compilation.sources[i].key, {}, {}, {}}));
    }
    return out;
}

Diagnostics checkLooseSt(std::string_view text, const std::string& file)
{
    st::Environment environment;
    environment.isLoose = true;
    const auto compilation = st::check({{{ObjectKind::Program, file}, text, false}}, environment);
    Diagnostics out = compilation->diagnostics[0];
    for (Diagnostic& d : out) {
        d.place.object = {};
        d.place.file = file;
        if (d.related) {
            d.related->object = {};
            d.related->file = file;
        }
    }
    return out;
}

} // namespace camwright
