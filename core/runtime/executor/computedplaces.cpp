#include "core/runtime/executor/access.h"
#include "core/runtime/executor/handlers.h"
#include "core/runtime/executor/numbers.h"

#include <cstring>
#include <type_traits>

namespace camwright {

// Instances, pointers, indices. The verifier has proved that whatever a guard lets through lies inside VariablesArea.

namespace {

/// A BOOL of memory may be any byte, one of a register is 0 or 1; floats have one NaN.
template <class T>
inline T fetch(const Frame& frame, std::uint32_t offset)
{
    if constexpr (std::is_same_v<T, bool>)
        return frame.bytes[offset] != 0;
    else
        return canonical(load<T>(frame, offset));
}

template <template <class> class Operation>
Handler forType(DataType type)
{
    switch (type) {
    case DataType::Bool: return Operation<bool>::run;
    case DataType::Byte:
    case DataType::Usint:
    case DataType::Sint: return Operation<std::uint8_t>::run;
    case DataType::Word:
    case DataType::Uint:
    case DataType::Int: return Operation<std::uint16_t>::run;
    case DataType::Dword:
    case DataType::Udint:
    case DataType::Time:
    case DataType::Dint: return Operation<std::uint32_t>::run;
    case DataType::Lword:
    case DataType::Ulint:
    case DataType::Lint: return Operation<std::uint64_t>::run;
    case DataType::Real: return Operation<float>::run;
    case DataType::Lreal: return Operation<double>::run;
    }
    return nullptr;
}

inline std::uint32_t indexOf(const Frame& frame, std::uint32_t slot)
{
    return load<std::uint32_t>(frame, slot);
}

template <bool Relative>
inline std::uint32_t base(const Frame& frame)
{
    return Relative ? frame.instance : 0;
}

template <class T>
struct Select {
    static const Step* run(Frame& frame, const Step* step)
    {
        store(frame, step->dest, fetch<T>(frame, frame.bytes[step->a] != 0 ? step->b : step->extra));
        return step + 1;
    }
};

template <class T>
struct LoadAt {
    static const Step* run(Frame& frame, const Step* step)
    {
        store(frame, step->dest, fetch<T>(frame, step->extra + indexOf(frame, step->a)));
        return step + 1;
    }
};

template <class T>
struct StoreAt {
    static const Step* run(Frame& frame, const Step* step)
    {
        store(frame, step->extra + indexOf(frame, step->b), fetch<T>(frame, step->a));
        return step + 1;
    }
};

template <bool Relative>
struct Elements {
    template <class T>
    struct Load {
        static const Step* run(Frame& frame, const Step* step)
        {
            store(frame, step->dest, fetch<T>(frame, base<Relative>(frame) + step->a + indexOf(frame, step->b) * step->extra));
            return step + 1;
        }
    };

    template <class T>
    struct Store {
        static const Step* run(Frame& frame, const Step* step)
        {
            store(frame, base<Relative>(frame) + step->dest + indexOf(frame, step->b) * step->extra, fetch<T>(frame, step->a));
            return step + 1;
        }
    };
};

template <class T>
struct LoadInstance {
    static const Step* run(Frame& frame, const Step* step)
    {
        store(frame, step->dest, fetch<T>(frame, frame.instance + step->a));
        return step + 1;
    }
};

template <class T>
struct StoreInstance {
    static const Step* run(Frame& frame, const Step* step)
    {
        store(frame, frame.instance + step->dest, fetch<T>(frame, step->a));
        return step + 1;
    }
};

template <bool Relative>
const Step* callOn(Frame& frame, const Step* step)
{
    return enterRoutine(frame, step, base<Relative>(frame) + step->a);
}

template <bool Relative>
const Step* place(Frame& frame, const Step* step)
{
    store(frame, step->dest, base<Relative>(frame) + step->a);
    return step + 1;
}

} // namespace

Handler selectHandler(DataType type)
{
    return forType<Select>(type);
}

Handler loadAtHandler(DataType type)
{
    return forType<LoadAt>(type);
}

Handler storeAtHandler(DataType type)
{
    return forType<StoreAt>(type);
}

Handler loadElementHandler(DataType type, bool relative)
{
    return relative ? forType<Elements<true>::Load>(type) : forType<Elements<false>::Load>(type);
}

Handler storeElementHandler(DataType type, bool relative)
{
    return relative ? forType<Elements<true>::Store>(type) : forType<Elements<false>::Store>(type);
}

Handler loadInstanceHandler(DataType type)
{
    return forType<LoadInstance>(type);
}

Handler storeInstanceHandler(DataType type)
{
    return forType<StoreInstance>(type);
}

Handler callOnHandler(bool relative)
{
    return relative ? callOn<true> : callOn<false>;
}

Handler placeHandler(bool relative)
{
    return relative ? place<true> : place<false>;
}

const Step* callAt(Frame& frame, const Step* step)
{
    return enterRoutine(frame, step, indexOf(frame, step->a));
}

const Step* guard(Frame& frame, const Step* step)
{
    const GuardStep& guard = frame.code->guards[step->extra];
    const std::uint32_t number = indexOf(frame, step->a) - guard.lower;
    if (number < guard.count) {
        store(frame, step->dest, number);
        return step + 1;
    }
    frame.fault(guard.instruction);
    frame.count(guard.instruction);
    frame.segment = guard.elseInstruction;
    return frame.code->steps.data() + guard.elseStep;
}

const Step* locateElement(Frame& frame, const Step* step)
{
    store(frame, step->dest, indexOf(frame, step->a) + indexOf(frame, step->b) * step->extra);
    return step + 1;
}

const Step* moveBytes(Frame& frame, const Step* step)
{
    std::memmove(frame.bytes + step->extra + indexOf(frame, step->dest), frame.bytes + step->extra + indexOf(frame, step->a), step->b);
    return step + 1;
}

const Step* readClock(Frame& frame, const Step* step)
{
    store(frame, step->dest, std::int64_t{frame.now.count()});
    return step + 1;
}

} // namespace camwright
