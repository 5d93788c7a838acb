// What clients read, write and force.
#include "devices/controller/hoststate.h"

namespace camwright {

namespace {
unsigned costOf(const std::vector<std::string>& names)
{
    return 1 + static_cast<unsigned>(names.size());
}
} // namespace

Result<ValueRef> ControllerHost::Impl::resolve(const std::string& name) const
{
    return engine.resolve(name);
}

Result<void> ControllerHost::Impl::checkProgram(const Hash& asked) const
{
    if (program.isNull())
        return diagnostic(Code::NoProgram);
    if (asked != program)
        return diagnostic(Code::OtherProgram, {shortHex(program), asked.isNull() ? std::string("-") : shortHex(asked)});
    return {};
}

Result<void> ControllerHost::Impl::checkControl(ClientId client, const char* what) const
{
    if (lease.isHeldBy(client))
        return {};
    if (lease.holder() != 0)
        return diagnostic(Code::ControlHeld, {lease.owner()});
    return diagnostic(Code::ControlNeeded, {what});
}

void ControllerHost::read(Hash program, std::vector<std::string> names, Reply<Values> reply)
{
    const unsigned cost = costOf(names);
    m_impl->post({[impl = m_impl.get(), program, names = std::move(names), reply = std::move(reply)] {
        const auto fail = [&](Diagnostic why) { impl->reply<Values>(reply, std::move(why)); };
        if (const auto checked = impl->checkProgram(program); !checked)
            return fail(checked.error());
        Values out;
        out.cycle = impl->engine.cycle();
        for (const std::string& name : names) {
            const auto ref = impl->resolve(name);
            if (!ref)
                return fail(ref.error());
            const auto value = impl->engine.read(*ref);
            if (!value)
                return fail(value.error());
            out.values.push_back({name, *value, impl->engine.isForced(*ref)});
        }
        impl->reply<Values>(reply, std::move(out));
    }, cost});
}

void ControllerHost::describe(Hash program, std::vector<std::string> names, Reply<std::vector<DataType>> reply)
{
    const unsigned cost = costOf(names);
    m_impl->post({[impl = m_impl.get(), program, names = std::move(names), reply = std::move(reply)] {
        const auto fail = [&](Diagnostic why) { impl->reply<std::vector<DataType>>(reply, std::move(why)); };
        if (const auto checked = impl->checkProgram(program); !checked)
            return fail(checked.error());
        std::vector<DataType> out;
        for (const std::string& name : names) {
            const auto ref = impl->resolve(name);
            if (!ref)
                return fail(ref.error());
            out.push_back(ref->type);
        }
        impl->reply<std::vector<DataType>>(reply, std::move(out));
    }, cost});
}

namespace {

/// The value as the target's own type; an integer that does not fit is refused rather than cut.
Result<Value> fitted(const Value& value, DataType type)
{
    if (value.type == type)
        return value;
    if (isFloat(type) || isFloat(value.type))
        return Value::ofDouble(type, value.asDouble());
    const Value out = Value::ofInteger(type, value.asInteger());
    if (out.asInteger() != value.asInteger())
        return diagnostic(Code::NotAValue, {formatValue(value), std::string(name(type)), formatValue(Value{type, 0})});
    return out;
}

} // namespace

void ControllerHost::write(ClientId client, Hash program, std::string name, Value value, Done done)
{
    m_impl->post({[impl = m_impl.get(), client, program, name = std::move(name), value, done = std::move(done)] {
        const auto write = [&]() -> Result<void> {
            if (auto checked = impl->checkControl(client, "write"); !checked)
                return checked;
            if (auto checked = impl->checkProgram(program); !checked)
                return checked;
            const auto ref = impl->resolve(name);
            if (!ref)
                return ref.error();
            const auto fits = fitted(value, ref->type);
            return fits ? impl->apply(input::Write{*ref, *fits}) : Result<void>(fits.error());
        };
        impl->reply(done, write());
    }});
}

void ControllerHost::force(ClientId client, Hash program, std::string name, Value value, Done done)
{
    m_impl->post({[impl = m_impl.get(), client, program, name = std::move(name), value, done = std::move(done)] {
        const auto force = [&]() -> Result<void> {
            if (auto checked = impl->checkControl(client, "force"); !checked)
                return checked;
            if (auto checked = impl->checkProgram(program); !checked)
                return checked;
            const auto ref = impl->resolve(name);
            if (!ref)
                return ref.error();
            const auto fits = fitted(value, ref->type);
            return fits ? impl->apply(input::Force{*ref, *fits}) : Result<void>(fits.error());
        };
        impl->reply(done, force());
        impl->statusDue = true;
    }});
}

void ControllerHost::release(ClientId client, Hash program, std::string name, Done done)
{
    m_impl->post({[impl = m_impl.get(), client, program, name = std::move(name), done = std::move(done)] {
        const auto release = [&]() -> Result<void> {
            if (auto checked = impl->checkControl(client, "release"); !checked)
                return checked;
            if (name.empty())
                return impl->apply(input::ReleaseAll{});
            if (auto checked = impl->checkProgram(program); !checked)
                return checked;
            const auto ref = impl->resolve(name);
            return ref ? impl->apply(input::Release{*ref}) : Result<void>(ref.error());
        };
        impl->reply(done, release());
        impl->statusDue = true;
    }});
}

void ControllerHost::forced(Reply<std::vector<MonitoredValue>> reply)
{
    m_impl->post({[impl = m_impl.get(), reply = std::move(reply)] {
        std::vector<MonitoredValue> out;
        for (const std::string& name : impl->engine.forced()) {
            const auto ref = impl->engine.resolve(name);
            if (!ref)
                continue;
            if (const auto value = impl->engine.read(*ref))
                out.push_back({name, *value, true});
        }
        impl->reply<std::vector<MonitoredValue>>(reply, std::move(out));
    }, 32});
}

void ControllerHost::terminals(Reply<std::vector<TerminalInfo>> reply)
{
    m_impl->post({[impl = m_impl.get(), reply = std::move(reply)] {
        std::vector<TerminalInfo> out;
        for (const Terminal& terminal : impl->engine.terminals())
            out.push_back({terminal.name, terminal.isInput});
        impl->reply<std::vector<TerminalInfo>>(reply, std::move(out));
    }, 32});
}

} // namespace camwright
