#pragma once

#include "core/online/piecesizer.h"
#include "core/online/sampleblock.h"

#include <deque>
#include <optional>

namespace camwright {

/// The samples one client has not got yet. It cuts them into pieces that suit the line, numbers them anew, keeps two in
/// flight, and when the client is too slow drops the oldest rows, counts them and so shows the gap (CONTRACTS 16, 17).
class SampleQueue {
public:
    void add(SampleBlock block);
    /// The next piece to send, if any may be sent now.
    std::optional<SampleBlock> next();
    /// The client has taken a piece; `now` is any clock that does not go back.
    void taken(std::uint32_t channelSet, std::uint64_t sequence, Time now);
    std::size_t rowsWaiting() const { return m_rows; }

    static constexpr std::size_t MaximumValues = 1 << 20; ///< rows × channels held at most, besides the newest block

private:
    SampleBlock cutFront(std::size_t rows);
    void dropOldest();

    std::deque<SampleBlock> m_waiting;
    std::size_t m_rows = 0, m_values = 0;
    std::uint32_t m_channelSet = 0;
    bool m_started = false;
    std::uint64_t m_nextSequence = 0, m_takenSequences = 0;
    std::uint64_t m_lost = 0;
    std::vector<ChannelInfo> m_channels; ///< until sent
    PieceSizer m_sizer;
    std::size_t m_lastPiece = 0;       ///< bytes of the piece sent last
    unsigned m_burst = 0;              ///< pieces sent since anything else happened
    bool m_isPair = false;             ///< the two in flight left back to back
    std::optional<Time> m_firstTaken;  ///< of such a pair, while its second piece is under way
};

} // namespace camwright
