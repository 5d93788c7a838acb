#include "app/cli/exitcode.h"
#include "app/cli/verbs.h"
#include "core/language/check/resolvedprogram.h"
#include "editors/words/shipped.h"
#include "editors/words/words.h"

#include <QCoreApplication>
#include <QDir>
#include <QFile>
#include <QFileInfo>

#include <algorithm>
#include <tuple>

namespace camwright::cli {

namespace {

std::ptrdiff_t sharedBeginning(std::string_view a, std::string_view b)
{
    return std::ranges::mismatch(a, b).in1 - a.begin();
}

int noSuchCode(const QString& word)
{
    std::vector<std::string_view> ids;
    for (const CodeInfo& info : allCodes())
        ids.push_back(info.id);
    // Of codes that are equally near, the one of the same area: the first digits are seldom the wrong ones.
    const std::string wanted = word.toUpper().toStdString();
    std::ranges::sort(ids, [&wanted](std::string_view a, std::string_view b) {
        return std::tuple(-sharedBeginning(wanted, a), a) < std::tuple(-sharedBeginning(wanted, b), b);
    });
    const std::string near = nearestName(wanted, ids);
    return wrongUsage(near.empty() ? QStringLiteral("there is no message '%1'. Codes are written like CW3001.").arg(word)
                                   : QStringLiteral("there is no message '%1'. Did you mean %2?").arg(word, QString::fromStdString(near)));
}

} // namespace

int runExplain(Invocation& call)
{
    const std::string wanted = call.words.front().trimmed().toUpper().toStdString();
    const auto found = std::ranges::find(allCodes(), wanted, &CodeInfo::id);
    if (found == allCodes().end())
        return noSuchCode(call.words.front());
    const QString path = words::explanationPath(words::codeId(found->code));
    QFile file(path);
    if (path.isEmpty() || !file.open(QIODevice::ReadOnly)) {
        call.out.progress(QStringLiteral("camwright-cli: the page of %1 is not installed. Reinstall Camwright.").arg(words::codeId(found->code)));
        return CannotRead;
    }
    const QString page = QString::fromUtf8(file.readAll()).trimmed();
    call.out.line(page);
    Json& json = call.out.json();
    json = toJson(Diagnostic{found->code, {}, {}, {}});
    json["text"] = QCoreApplication::translate("Diagnostics", std::string(found->text).c_str()).toStdString();
    json["language"] = QFileInfo(path).dir().dirName().toStdString();
    json["page"] = page.toStdString();
    return Done;
}

} // namespace camwright::cli
