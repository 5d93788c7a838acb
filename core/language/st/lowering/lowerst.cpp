#include "core/language/st/lowering/lowerst.h"

#include "core/language/lowering/elementtables.h"
#include "core/language/st/lowering/bodylowering.h"

#include <map>

namespace camwright::st {

namespace {

bool isOnlyRun(const Compilation& compilation, const PouInfo& pou)
{
    return compilation.runs.size() == 1 && compilation.runs[0].program == &pou && compilation.runs[0].intervalNs == 0;
}

/// Whether it is the first PROGRAM of its text.
bool isFirstProgram(const Compilation& compilation, const PouInfo& pou)
{
    for (const PouInfo& other : compilation.pous) {
        if (other.tree->kind == PouKind::Program && other.file == pou.file)
            return &other == &pou;
    }
    return false;
}

std::string programName(const Compilation& compilation, const PouInfo& pou)
{
    const Source& source = compilation.sources[pou.file];
    const bool isAlone = isOnlyRun(compilation, pou) || (!source.isMain && isFirstProgram(compilation, pou));
    return isAlone ? source.key.name : source.key.name + "." + std::string(compilation.names.text(pou.tree->name));
}

class Linker {
public:
    Linker(const Compilation& compilation, const Family* family, const std::function<std::uint32_t(std::string_view)>& routineByName, LoweredPrograms& out)
        : m_compilation(compilation), m_out(out), m_firstObject(static_cast<std::uint32_t>(out.debug.objects.size()))
    {
        for (std::size_t i = 0; i + 1 < compilation.sources.size(); ++i)
            out.debug.objects.push_back(compilation.sources[i].key);
        m_link.placeOf = [family](const Address& address) { return irAddress(*family, address); };
        m_link.routineOf = [this](const PouInfo& pou) { return routineOf(pou); };
        m_link.subroutineOf = [this, routineByName](std::uint32_t number) { return routineByName(m_compilation.subroutines[number]); };
        m_link.source = [this](std::uint32_t file, std::uint32_t offset, std::uint32_t end) { return source(file, offset, end); };
    }

    void run()
    {
        for (const PouInfo& pou : m_compilation.pous) {
            if (pou.tree->kind == PouKind::Program)
                routineOf(pou);
        }
        if (!m_compilation.runs.empty())
            makeMain();
        while (m_next < m_queue.size()) { // bodies add what they call
            const auto [pou, index] = m_queue[m_next++];
            IrRoutine routine = std::move(m_out.program.routines[index]);
            BodyLowering(m_link, m_compilation, *pou, routine).lower();
            m_out.program.routines[index] = std::move(routine);
        }
    }

private:
    std::uint32_t routineOf(const PouInfo& pou)
    {
        const auto known = m_routines.find(&pou);
        if (known != m_routines.end())
            return known->second;
        const auto index = static_cast<std::uint32_t>(m_out.program.routines.size());
        IrRoutine& routine = m_out.program.routines.emplace_back();
        routine.name = nameOf(pou);
        const PouInfo& block = pou.owner ? *pou.owner : pou;
        if (pou.tree->kind == PouKind::Program) {
            routine.kind = isOnlyRun(m_compilation, pou) ? RoutineKind::Main : RoutineKind::Subroutine;
        } else if (block.tree->kind == PouKind::FunctionBlock) {
            routine.kind = RoutineKind::Block;
            routine.instanceBytes = block.type->size;
        } else {
            routine.kind = RoutineKind::Subroutine;
        }
        m_routines.emplace(&pou, index);
        m_queue.push_back({&pou, index});
        return index;
    }

    std::string nameOf(const PouInfo& pou) const
    {
        const std::string name(m_compilation.names.text(pou.tree->name));
        if (pou.owner)
            return std::string(m_compilation.names.text(pou.owner->tree->name)) + "." + name + "()";
        if (pou.tree->kind != PouKind::Program)
            return name + "()";
        return programName(m_compilation, pou);
    }

    /// Runs the programs in order, each when it is due.
    void makeMain()
    {
        if (isOnlyRun(m_compilation, *m_compilation.runs[0].program))
            return;
        IrRoutine routine;
        IrWriter ir(routine);
        for (const ProgramRun& run : m_compilation.runs) {
            routine.name = m_compilation.sources[run.program->file].key.name;
            const std::uint32_t index = routineOf(*run.program);
            std::size_t skip = 0;
            if (run.intervalNs > 0)
                skip = waitUntilDue(ir, run);
            ir.control(IrOp::Call, index);
            if (run.intervalNs > 0)
                ir.land(skip);
        }
        routine.kind = RoutineKind::Main;
        m_out.program.routines.push_back(std::move(routine));
    }

    /// Due at its time; the next time is one interval later, or from now where that has passed already.
    static std::size_t waitUntilDue(IrWriter& ir, const ProgramRun& run)
    {
        const IrAddress next{VariablesArea, IrAddress::WholeByte, run.nextRun};
        const IrRegister now = ir.define(ir.make(IrOp::Now, DataType::Lint));
        const IrRegister due = ir.load(DataType::Lint, next);
        const std::size_t skip = ir.jumpIf(false, ir.compute(IrOp::GreaterEqual, DataType::Lint, now, due));
        const IrRegister interval = ir.constant(DataType::Lint, static_cast<std::uint64_t>(run.intervalNs));
        const IrRegister planned = ir.compute(IrOp::Add, DataType::Lint, due, interval);
        ir.store(DataType::Lint, next, ir.compute(IrOp::Max, DataType::Lint, planned, now));
        return skip;
    }

    std::uint32_t source(std::uint32_t file, std::uint32_t offset, std::uint32_t end)
    {
        if (file + 1 >= m_compilation.sources.size())
            return 0; // the standard library
        m_out.debug.sources.push_back({m_firstObject + file, 0, m_compilation.lines[file].range(offset, end)});
        return static_cast<std::uint32_t>(m_out.debug.sources.size());
    }

    const Compilation& m_compilation;
    LoweredPrograms& m_out;
    std::uint32_t m_firstObject = 0;
    LinkContext m_link;
    std::map<const PouInfo*, std::uint32_t> m_routines;
    std::vector<std::pair<const PouInfo*, std::uint32_t>> m_queue;
    std::size_t m_next = 0;
};

void addSymbol(const Compilation& compilation, const Symbol& symbol, const std::string& prefix, LoweredPrograms& out)
{
    if (symbol.storage != Storage::Static || symbol.isPointer || !symbol.type->isScalar())
        return;
    const bool isBool = symbol.type->data == DataType::Bool;
    const Address address = isBool ? bitAddress(VariablesArea, symbol.offset) : valueAddress(VariablesArea, symbol.offset, symbol.type->data);
    out.symbols.push_back({prefix + std::string(compilation.names.text(symbol.name)), address, symbol.isRetain});
}

void addVariables(const Compilation& compilation, LoweredPrograms& out)
{
    out.variableBytes = compilation.variableBytes;
    for (const StartValue& start : compilation.startValues) {
        const bool isBool = start.value.type == DataType::Bool;
        out.initialValues.push_back({isBool ? bitAddress(VariablesArea, start.offset) : valueAddress(VariablesArea, start.offset, start.value.type), start.value});
    }
    for (const Symbol* symbol : compilation.globals)
        addSymbol(compilation, *symbol, {}, out);
    for (const PouInfo& pou : compilation.pous) {
        if (pou.tree->kind != PouKind::Program)
            continue;
        for (const Symbol* symbol : pou.variables)
            addSymbol(compilation, *symbol, std::string(compilation.names.text(pou.tree->name)) + ".", out);
    }
}

} // namespace

std::vector<std::string> programRoutines(const Compilation& compilation)
{
    std::vector<std::string> out;
    for (const PouInfo& pou : compilation.pous) {
        if (pou.tree->kind == PouKind::Program)
            out.push_back(programName(compilation, pou));
    }
    return out;
}

void lowerSt(const Compilation& compilation, const Family* family, const std::function<std::uint32_t(std::string_view)>& routineByName, LoweredPrograms& out)
{
    Linker(compilation, family, routineByName, out).run();
    addVariables(compilation, out);
}

} // namespace camwright::st
