#pragma once

#include "app/cli/output.h"

#include <QCommandLineParser>
#include <QStringList>

#include <span>

namespace camwright::cli {

/// What a verb is called with: its options parsed, its words counted.
struct Invocation {
    const QCommandLineParser& options;
    QStringList words; ///< positional arguments behind the verb
    Output& out;

    QString value(const char* option) const { return options.value(QString::fromLatin1(option)); }
    bool has(const char* option) const { return options.isSet(QString::fromLatin1(option)); }
};

/// One job of the command line: a row of the table in verbs.cpp.
struct Verb {
    const char* name;
    const char* words;    ///< "PROJECT", "[NAME...]"; how many are allowed follows
    int minWords;
    int maxWords;         ///< -1: any number
    const char* summary;
    void (*addOptions)(QCommandLineParser&);
    int (*run)(Invocation&);
};

std::span<const Verb> verbs();

/// Says what is wrong with the call on standard error; returns WrongUsage.
int wrongUsage(const QString& sentence);

} // namespace camwright::cli
