#pragma once

#include "core/family/family.h"
#include "core/language/source/declarations.h"
#include "core/language/source/dialect.h"
#include "core/model/project.h"

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace camwright {

/// A global variable as programs see it.
struct KnownVariable {
    std::string name;
    DataType type = DataType::Bool;
    std::optional<Address> address; ///< none: its row is wrong, or the family has no variables without an address
    bool isBound = false;           ///< the user gave the address; else it lies in VariablesArea
    bool retain = false;
    std::uint32_t elements = 0;     ///< of an array, whose element `type` and first address are; 0: no array
    Place place;                    ///< its row: table and "rows[n]"
};

struct KnownAxis {
    std::string name;
    std::uint32_t number = 0;
};

/// A variable of a subroutine's table: where it lies in the subroutine's own memory (TS-SBR-03), and as an operand of CALL.
struct KnownParameter {
    KnownVariable variable;
    ParameterKind kind = ParameterKind::In;
    Pin pin;                        ///< as CALL's operand
};

/// The variable table laid out: BOOL from LM0, words from V0, in the order of the table. `tooMany`: the first that
/// exceeds 16 BOOL or 16 word variables (TS-SBR-02).
struct ParameterTable {
    std::vector<KnownParameter> parameters;
    std::optional<Parameter> tooMany;
};
ParameterTable layOut(const Declarations& declarations, const Family& family, const ControllerModel& model);

struct KnownProgram {
    std::string name;
    ProgramRole role = ProgramRole::Main;
    std::string number{}; ///< Koyo: "K3", as the SBR at its beginning says; empty if there is none
    std::vector<KnownParameter> parameters{};
};

/// What a program is read against: its family, and what else the project has. A value; made for one snapshot.
struct LanguageContext {
    const Family* family = nullptr;
    const ControllerModel* model = nullptr;
    const Dialect* dialect = nullptr;
    std::vector<KnownVariable> variables;   ///< in the order of the tables and rows
    std::vector<KnownAxis> axes;
    std::vector<KnownProgram> programs;
    std::uint32_t variableBytes = 0;        ///< size of VariablesArea
    bool strictKinco = false;               ///< refuse what the vendor's tool does not take: AND( and OR( (CONTRACTS 32)

    const KnownVariable* findVariable(std::string_view name) const;
    const KnownProgram* findProgram(std::string_view name) const;
    /// Koyo: the subroutine with this number ("K3"); of several the first.
    const KnownProgram* findSubroutine(std::string_view number) const;
    const KnownAxis* findAxis(std::uint32_t number) const;
    const KnownAxis* findAxis(std::string_view name) const;
    /// The variable whose address begins at the same place and is as wide: it forces its type onto it (KS-MEM-06).
    const KnownVariable* variableAt(const Address& address) const;

    /// Fills the look-up tables; contextOf() has done it.
    void index();

private:
    std::map<std::string, std::size_t, std::less<>> m_byName;
    std::map<std::pair<AreaId, std::uint64_t>, std::size_t> m_byPlace; ///< area, then byte * 8 + bit
};

/// The context of a project, valid or not: rows and fields that are wrong are left out, the checks of the project report
/// them. Nothing if the family or the model is unknown. Variables without an address get one in VariablesArea where the
/// family has such variables (TS600): in order, BOOL one byte, all others on even bytes.
std::optional<LanguageContext> contextOf(const Project& project);

} // namespace camwright
