#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace camwright::kinco {

/// Most parameters one MC_RPARAS or MC_WPARAS transfers (KS-MC-11).
inline constexpr unsigned kMaxParameters = 32;

/// ERRID of MC_POWER, MC_RESET, MC_HOME, MC_MABS, MC_MREL, MC_JOG (KS-MC-10).
enum class ErrorId : std::uint8_t {
    None = 0, AxisAbsent = 1, NotLocked = 2, Busy = 3, SendBufferFull = 4, SdoTimeout = 5, SdoAnswer = 6, StateNotSeen = 7,
};

/// ERRID of MC_RESTART (KS-MC-21).
enum class RestartError : std::uint8_t {
    None = 0, WrongAxis = 1, AlreadyRestarting = 2, SendError = 3, SdoTimeout = 4, SdoAnswer = 5, Stopped = 6,
};

/// ERRID of MC_RPARAS and MC_WPARAS when nothing could be executed (KS-MC-13).
inline constexpr std::uint32_t kNothingExecuted = 0xFFFFFFFF;

/// What a scan tells the motion task about one call of an MC_* instruction. Plain data, handed over at the scan's end.
struct CallInputs {
    std::uint32_t execution = 0;   ///< counts the edges that start something; 0: none since the program started
    bool enabled = false;          ///< EN
    bool exec = false;             ///< EXEC as the last enabled pass saw it
    std::int16_t axis = 0;
    std::int16_t mode = 0;
    std::int16_t count = 0;        ///< NUM, or STIME
    std::uint32_t timeMs = 0;
    float position = 0;            ///< mm or degree
    float velocity = 0;            ///< mm/min or degree/min
};

/// The list of an MC_RPARAS or MC_WPARAS as it stood at the edge of EXEC.
struct ParameterList {
    std::array<std::uint8_t, kMaxParameters> numbers{};
    std::array<std::uint32_t, kMaxParameters> values{}; ///< cells as they lie in memory
};

/// What the motion task answers; taken over at a scan's start.
struct CallResult {
    std::uint32_t execution = 0;   ///< the execution the rest speaks of
    bool done = false;
    bool error = false;
    bool active = false;           ///< ACT
    std::uint32_t errorId = 0;
    std::uint32_t valid = 0;       ///< MC_RPARAS: bit n: values[n] has been read
};

/// What MC_STATE shows of an axis (KS-MC-22).
struct AxisView {
    bool reached = false, homed = false, forward = false, backward = false, running = false, fault = false, limit = false;
    bool online = false;
    std::uint16_t inputs = 0;
    std::uint16_t errorCode = 0;
    float position = 0;            ///< mm or degree
    float velocity = 0;            ///< mm/min or degree/min
};

/// One direction of the exchange: what the scan commands.
struct ScanCommands {
    std::vector<CallInputs> calls;          ///< by block instance
    std::vector<ParameterList> lists;       ///< by CallSite::list
};

/// The other: what motion answers and knows.
struct MotionReports {
    std::vector<CallResult> calls;
    std::vector<ParameterList> lists;       ///< values read
    std::vector<AxisView> axes;             ///< by axis number - 1
};

} // namespace camwright::kinco
