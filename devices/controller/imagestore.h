#pragma once

#include "core/base/bytes.h"
#include "core/base/hash.h"
#include "core/base/result.h"
#include "core/storage/filesystem.h"

#include <string>

namespace camwright {

/// The controller's program on disk, in two slots: the one in use and the one before it or after it. A record says which
/// slot counts, by its digest; replacing the record is the one step that switches. Whatever happens at any other moment, the
/// old program is found. Nothing read here is believed before its digest fits.
class ImageStore {
public:
    ImageStore(FileSystem& files, std::string folder) : m_files(files), m_folder(std::move(folder)) {}

    struct Stored {
        Bytes image;          ///< empty: none
        Bytes previous;       ///< what to fall back to; empty: none
        std::string trouble;  ///< English, if something was found that cannot be used
    };
    Stored load();

    /// Writes the image into the slot that does not count, then switches to it. On an error the old one still counts.
    Result<void> replace(ByteSpan image);
    /// Takes the last replace() back: the program before it counts again, or none.
    Result<void> goBack();

private:
    struct Record {
        std::uint8_t slot = 0;
        Hash image, previous; ///< previous: of the other slot, null if that holds nothing to fall back to
    };
    Result<Record> readRecord();
    Result<void> writeRecord(const Record& record);
    Result<Bytes> readSlot(std::uint8_t slot, const Hash& expected);
    Diagnostic storeFailed(const Diagnostic& why) const;
    std::string slotPath(std::uint8_t slot) const { return m_folder + (slot == 0 ? "/image.a" : "/image.b"); }

    FileSystem& m_files;
    std::string m_folder;
};

} // namespace camwright
