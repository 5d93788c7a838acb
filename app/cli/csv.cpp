#include "app/cli/csv.h"

#include "core/online/sampletext.h"

#include <QFile>
#include <QSaveFile>

namespace camwright::cli {

CsvTable::CsvTable(const std::vector<std::string>& names)
    : m_bytes("time_s")
{
    for (const std::string& name : names)
        m_bytes += ',' + QByteArray::fromStdString(csvCell(name));
    m_bytes += '\n';
}

void CsvTable::append(const SampleBlock& block)
{
    if (!block.channels.empty())
        m_channels = block.channels;
    if (block.lostRows != 0)
        m_bytes += "# " + QByteArray::number(qulonglong(block.lostRows)) + " samples lost here\n";
    const std::size_t rows = block.columns.empty() ? 0 : block.columns.front().size();
    for (std::size_t row = 0; row < rows; ++row) {
        m_bytes += QByteArray::fromStdString(secondsText(static_cast<std::int64_t>(block.firstCycle + row * block.stride) * block.cycleNs));
        for (std::size_t column = 0; column < block.columns.size(); ++column) {
            const DataType type = column < m_channels.size() ? m_channels[column].type : DataType::Lreal;
            m_bytes += ',' + QByteArray::fromStdString(sampleText(type, block.columns[column][row]));
        }
        m_bytes += '\n';
    }
    m_rows += rows;
}

bool CsvTable::writeTo(const QString& file) const
{
    if (file.isEmpty() || file == QLatin1String("-")) {
        QFile out;
        return out.open(stdout, QIODevice::WriteOnly) && out.write(m_bytes) == m_bytes.size();
    }
    QSaveFile out(file);
    return out.open(QIODevice::WriteOnly) && out.write(m_bytes) == m_bytes.size() && out.commit();
}

} // namespace camwright::cli
