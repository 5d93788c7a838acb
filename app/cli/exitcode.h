#pragma once

namespace camwright::cli {

/// What the shell is told (docs/command-line.md).
enum ExitCode : int {
    Done = 0,
    AnswerIsNo = 1,      ///< errors found, files differ, a limit not met
    WrongUsage = 2,
    CannotRead = 3,      ///< a file is missing or malformed
    NobodyAnswers = 4,
    ControllerRefuses = 5,
    OurBug = 70,
};

} // namespace camwright::cli
