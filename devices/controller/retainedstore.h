#pragma once

#include "core/base/bytes.h"
#include "core/base/result.h"
#include "core/storage/filesystem.h"

#include <cstdint>
#include <string>

namespace camwright {

/// Retained data on disk, in two files written in turn, each with a number that counts up and a CRC: a cut during a write
/// leaves the set before it (CONTRACTS 13).
class RetainedStore {
public:
    RetainedStore(FileSystem& files, std::string folder) : m_files(files), m_folder(std::move(folder)) {}

    struct Stored {
        Bytes data;             ///< the newest whole set; empty: none
        bool damaged = false;   ///< files are there, but none is whole
    };
    Stored load();

    /// Writes the set if it differs from the one written last.
    Result<void> save(ByteSpan data);

private:
    std::string path(std::uint64_t number) const { return m_folder + (number % 2 == 0 ? "/retained.a" : "/retained.b"); }

    FileSystem& m_files;
    std::string m_folder;
    std::uint64_t m_number = 0;
    Bytes m_last;
    bool m_hasLast = false;
};

} // namespace camwright
