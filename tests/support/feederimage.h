#pragma once

#include "core/family/family.h"
#include "core/family/kinco/kincoareas.h"
#include "core/language/image/controllerimage.h"
#include "tests/core/runtime/executor/irbuilder.h"

namespace camwright::test {

/// A program for the tests of everything online, as an image: two axes, Feed and Turn. Each scan counts %VD0 up by one and
/// copies it to %VD4, so that the two are always equal at the end of a scan; %Q0.0 follows %I0.0. `variant` changes a
/// constant of the program and so its hash; `payload` makes the image longer by an archived file, and its hash stays.
inline ControllerImage feederImage(std::uint32_t variant = 0, std::size_t payload = 0)
{
    IrBuilder b;
    ControllerImage& image = b.image();
    const Family& family = *findFamily("kinco");
    const ControllerModel& model = *family.findModel(image.target.model);
    const Symbol retained{"Pieces", valueAddress(VariablesArea, 0, DataType::Dint), true};
    const Symbol count{"Count", valueAddress(kinco::V, 0, DataType::Dint), false};
    image.layout.areas.clear();
    for (const MemoryArea& area : family.areas()) {
        const AreaLayout& size = model.area(area.id);
        image.layout.areas.push_back({area.id, area.name, size.bytes, size.retainedFirst, size.retainedEnd});
    }
    image.layout.areas.push_back({VariablesArea, {}, 4, 0, 4});
    image.symbols = {count, retained};

    const IrRegister cycles = b.load(Dint, byteAt(0, kinco::V));
    const IrRegister one = b.constant(Dint, 1);
    const IrRegister next = b.op(IrOp::Add, Dint, cycles, one);
    b.store(Dint, byteAt(0, kinco::V), next);
    b.store(Dint, byteAt(4, kinco::V), next);
    b.store(Dint, byteAt(8, kinco::V), b.constant(Dint, variant));
    b.store(Bool, bitAt(0, 0, kinco::Q), b.load(Bool, bitAt(0, 0, kinco::I)));

    image.configuration.watchdog = 500ms;
    image.configuration.network = {true, 1000000, 100};
    AxisConfiguration feed, turn;
    feed.name = "Feed";
    feed.mechanicalEquivalent = 100;
    turn.name = "Turn";
    turn.number = 2;
    turn.rotary = true;
    turn.mechanicalEquivalent = 45;
    image.configuration.axes = {feed, turn};
    image.debug.projectName = "feeder";
    image.debug.objects = {{ObjectKind::Program, "Main"}};
    image.debug.sources = {{0, 0, {1, 1, 1, 9}}};
    image.source = {{"programs/Main.il", std::string(payload, 'x')}};
    return image;
}

} // namespace camwright::test
