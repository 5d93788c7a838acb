#pragma once

#include "core/checks/checkproject.h"
#include "core/checks/validproject.h"
#include "core/model/arraytype.h"

#include <set>
#include <string>

namespace camwright {

/// One run over a project: collects diagnostics and, as far as it is legal, the valid project.
class ProjectCheck {
public:
    explicit ProjectCheck(const Project& project) : m_project(project) {}

    Validation run();

private:
    void checkNames();
    void checkAlphabet(const Place& place, const std::string& name);
    void checkController();
    void checkAxes();
    void checkAxisNumbers();
    void checkAxisLimit(std::size_t count);
    void checkNetworks();
    void checkBusLoad();
    void checkPrograms();
    void checkVariables();
    void checkArray(const Place& row, const Variable& variable, const ArrayType& array);
    std::optional<Address> checkArrayAddress(const Place& place, const Variable& variable, const ArrayType& array);
    void checkInitial(const Place& place, const Variable& variable, ValidVariable& valid);
    void checkVariable(const Place& row, const Variable& variable);
    void checkVariableName(const Place& place, const std::string& name);
    std::optional<Address> checkAddress(const Place& place, const Variable& variable);
    void checkSharedMemory();
    bool isIdentifier(const std::string& name) const;

    void report(Code code, std::vector<std::string> arguments, Place place, std::optional<Place> related = std::nullopt);

    const Project& m_project;
    ValidProject m_valid;
    Diagnostics m_out;
    std::map<std::string, Place> m_variableNames; ///< folded case
};

} // namespace camwright
