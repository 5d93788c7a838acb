#include "editors/words/shipped.h"

#include "editors/words/words.h"

#include <QCoreApplication>
#include <QDir>
#include <QFileInfo>

namespace camwright {

QString sharedPath(const QString& name)
{
    const QString path = QDir::cleanPath(QCoreApplication::applicationDirPath() + QStringLiteral("/../share/camwright/") + name);
    return QFileInfo::exists(path) ? path : QString();
}

namespace words {

QString explanationPath(const QString& code, const QString& language)
{
    for (const QString& wanted : {language, QStringLiteral("en")}) {
        const QString path = sharedPath(QStringLiteral("diagnostics/%1/%2.md").arg(wanted, code));
        if (!path.isEmpty())
            return path;
    }
    return {};
}

QString explanationPath(const QString& code)
{
    return explanationPath(code, currentLanguage());
}

} // namespace words
} // namespace camwright
