#include "app/cli/exitcode.h"
#include "app/cli/verb.h"
#include "editors/words/words.h"

#include <QCoreApplication>

#include <cstdio>
#include <exception>

namespace camwright::cli {

int wrongUsage(const QString& sentence)
{
    std::fprintf(stderr, "camwright-cli: %s\n", sentence.toUtf8().constData());
    return WrongUsage;
}

namespace {

void printHelp()
{
    std::puts("camwright-cli VERB ... [--json] [--lang en|zh|ru]\n");
    for (const Verb& verb : verbs())
        std::printf("  %-10s %-28s %s\n", verb.name, verb.words, verb.summary);
    std::puts("\n`camwright-cli VERB --help` tells a verb's options.\n"
              "Exit status: 0 done; 1 the answer is no; 2 wrong usage; 3 a file cannot be read; 4 nobody answers at the address;\n"
              "5 the controller refuses; 70 a mistake of Camwright's own.");
}

int runVerb(const Verb& verb, const QStringList& arguments)
{
    QCommandLineParser parser;
    parser.setApplicationDescription(QString::fromUtf8(verb.summary));
    parser.setSingleDashWordOptionMode(QCommandLineParser::ParseAsLongOptions);
    parser.addHelpOption();
    parser.addOption({QStringLiteral("json"), QStringLiteral("One JSON document on standard output.")});
    parser.addOption({QStringLiteral("lang"), QStringLiteral("Language of messages: en, zh, ru."), QStringLiteral("LANG"), QStringLiteral("en")});
    parser.addPositionalArgument(QString::fromUtf8(verb.name), QString(), QString::fromUtf8(verb.name));
    if (*verb.words)
        parser.addPositionalArgument(QStringLiteral("words"), QString(), QString::fromUtf8(verb.words));
    verb.addOptions(parser);
    if (!parser.parse(arguments))
        return wrongUsage(parser.errorText() + QStringLiteral(" See 'camwright-cli %1 --help'.").arg(QString::fromUtf8(verb.name)));
    if (parser.isSet(QStringLiteral("help"))) {
        std::puts(parser.helpText().toUtf8().constData());
        return Done;
    }
    if (!words::setLanguage(*QCoreApplication::instance(), parser.value(QStringLiteral("lang"))))
        return wrongUsage(QStringLiteral("'%1' is not a language Camwright speaks: en, zh, ru.").arg(parser.value(QStringLiteral("lang"))));
    QStringList given = parser.positionalArguments().mid(1);
    if (given.size() < verb.minWords || (verb.maxWords >= 0 && given.size() > verb.maxWords))
        return wrongUsage(QStringLiteral("use it like 'camwright-cli %1 %2'.").arg(QString::fromUtf8(verb.name), QString::fromUtf8(verb.words)));
    Output out(parser.isSet(QStringLiteral("json")));
    Invocation invocation{parser, std::move(given), out};
    const int status = verb.run(invocation);
    if (status != WrongUsage)
        out.finish();
    return status;
}

int run(const QStringList& arguments)
{
    const QString first = arguments.value(1);
    if (first.isEmpty())
        return printHelp(), WrongUsage;
    if (first == QLatin1String("--help") || first == QLatin1String("-h") || first == QLatin1String("help"))
        return printHelp(), Done;
    if (first == QLatin1String("--version"))
        return std::puts("camwright-cli " CAMWRIGHT_VERSION), Done;
    for (const Verb& verb : verbs()) {
        if (first == QLatin1String(verb.name))
            return runVerb(verb, arguments);
    }
    return wrongUsage(QStringLiteral("there is no verb '%1'. 'camwright-cli --help' lists them.").arg(first));
}

} // namespace
} // namespace camwright::cli

int main(int argc, char** argv)
{
    QCoreApplication application(argc, argv);
    QCoreApplication::setApplicationName(QStringLiteral("camwright-cli"));
    QCoreApplication::setApplicationVersion(QStringLiteral(CAMWRIGHT_VERSION));
    try {
        return camwright::cli::run(application.arguments());
    } catch (const std::exception& error) {
        std::fprintf(stderr, "camwright-cli: a mistake of Camwright's own: %s\n", error.what());
        return camwright::cli::OurBug;
    }
}
