#pragma once

#include "core/language/source/ilparser.h"

namespace camwright {

/// Tells where one rung ends and the next begins in a list without network headers (TS600): at an LD after a flow that has
/// driven something, outside MPS branches.
class RungSplitter {
public:
    bool startsRung(StatementRole role) const { return role == StatementRole::Load && m_hasAction && m_branches == 0; }
    void follow(StatementRole role);

private:
    unsigned m_branches = 0;
    bool m_hasAction = false;
};

/// Undoes the splits that went too far: an LD after an output that begins a block joined by ANB or ORB to the flow before
/// ("LD A, OUT Y, LD B, OR C, ANB, OUT Z") belongs to the rung before. Numbers derived networks anew.
void joinSplitRungs(ParsedProgram& program, std::uint32_t firstNetwork);

} // namespace camwright
