#pragma once

#include "core/base/diagnostic.h"
#include "core/model/project.h"

#include <QString>

#include <optional>
#include <set>
#include <string>
#include <vector>

namespace camwright {

class ProjectDocument;

/// One axis of a draft: the object it came from, if it is not new, and what stands in the window.
struct DraftAxis {
    std::optional<ObjectKey> origin;
    Object object;

    const Axis& axis() const { return std::get<Axis>(object.content); }
    Axis& axis() { return std::get<Axis>(object.content); }
    bool operator==(const DraftAxis&) const = default;
};

/// The motion network as the window shows it before Apply (KS-MCN-07): the master's fields and all axes. A value; knows no
/// widget. Numbers may be illegal, twice or with gaps: apply() refuses that (KS-MCN-06).
class MotionNetworkDraft {
public:
    MotionNetworkDraft() = default;
    /// What the project holds. `network` may be missing; apply() then adds one.
    static MotionNetworkDraft of(const Project& project, const ObjectKey& network);

    const Network& network() const { return std::get<Network>(m_network.content); }
    void setNetwork(const Network& network) { m_network.content = network; }
    void setNetworkKey(const ObjectKey& key) { m_network.key = key; }  ///< the network was renamed in the project
    const std::vector<DraftAxis>& axes() const { return m_axes; }
    void setAxis(std::size_t index, const Axis& axis) { m_axes[index].axis() = axis; }
    /// The name is taken as typed; checks say what is wrong with it.
    void setName(std::size_t index, const std::string& name) { m_axes[index].object.key.name = name; }

    /// A new axis with the defaults, the next free number and the name "Axis n name" (KS-MCN-03). Returns its index.
    std::size_t addAxis();
    /// Equal to `copied` but for its number and name (KS-MCN-04).
    std::size_t pasteAxis(const Object& copied);
    void removeAxis(std::size_t index);                    ///< KS-MCN-05
    /// Numbers the axes 1, 2, 3 … in their order: the way out of a gap.
    void renumber();

    /// `project` with this draft in it.
    Project appliedTo(const Project& project) const;
    /// What keeps Apply from being done: errors of the network and its axes, by the project's own checks.
    Diagnostics problems(const Project& project) const;
    /// Puts the draft into the document as one step. False when it changes nothing.
    bool apply(ProjectDocument& document, const QString& label) const;

    bool operator==(const MotionNetworkDraft&) const = default;

private:
    std::string freeName(const std::string& wanted) const;
    std::int64_t freeNumber() const;

    Object m_network;
    std::vector<DraftAxis> m_axes;
    std::set<ObjectKey> m_original; ///< the axes the project had
};

} // namespace camwright
