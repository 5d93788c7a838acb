#pragma once

#include "core/online/sampleblock.h"

#include <QByteArray>
#include <QString>

namespace camwright::cli {

/// Turns sample blocks into CSV: header "time_s,NAME,…", one row a sample, a comment line where samples were lost.
class CsvTable {
public:
    /// The head row, so that a recording without samples still has one.
    explicit CsvTable(const std::vector<std::string>& names);

    void append(const SampleBlock& block);
    const QByteArray& bytes() const { return m_bytes; }
    std::size_t rows() const { return m_rows; }

    /// To the file, whole or not at all; to standard output for "" and "-".
    bool writeTo(const QString& file) const;

private:
    QByteArray m_bytes;
    std::vector<ChannelInfo> m_channels;
    std::size_t m_rows = 0;
};

} // namespace camwright::cli
