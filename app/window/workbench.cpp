#include "app/window/workbench.h"

#include "editors/shell/context.h"
#include "editors/words/words.h"

#include <QElapsedTimer>

namespace camwright {

Workbench::Workbench(Context& context, Services& services, QObject* parent)
    : QObject(parent), m_context(context), m_services(services)
{
    m_quiet.setSingleShot(true);
    m_quiet.setInterval(400);
    connect(&m_quiet, &QTimer::timeout, this, [this] {
        if (!isBuilt() && !m_background && m_context.document().isOpen())
            start(false, {});
    });
    connect(&context.document(), &ProjectDocument::changed, this, [this] {
        emit builtChanged();
        compare();
        if (m_context.isOnline())
            m_quiet.start();
    });
    connect(&context, &Context::linkStateChanged, this, [this](LinkState state) {
        if (state == LinkState::Online)
            m_quiet.start();
    });
    connect(&context, &Context::statusChanged, this, &Workbench::compare);
}

bool Workbench::isBuilt() const
{
    return m_builtRevision == m_context.document().revision();
}

void Workbench::compare()
{
    const bool null = m_context.status().program == Hash{};
    m_context.setProgramMatches(m_context.isOnline() && isBuilt() && !null && m_context.status().program == m_builtHash);
}

void Workbench::check()
{
    const Project project = m_context.document().project();
    m_context.runInBackground<Diagnostics>(this, [check = m_services.check, project] { return check(project); }, [this](Diagnostics found) {
        m_context.document().setDiagnostics(std::move(found));
        const int errors = m_context.document().errorCount();
        const int warnings = m_context.document().warningCount();
        if (errors + warnings == 0) {
            m_context.notify(Severity::Information, tr("Checked: no problems."));
        } else {
            m_context.output(tr("Checked: %1, %2.").arg(tr("%n errors", nullptr, errors), tr("%n warnings", nullptr, warnings)));
            m_context.showPanel(QStringLiteral("problems"));
        }
    });
}

void Workbench::build(std::function<void(const DownloadPackage&)> done)
{
    if (!isBusy())
        start(true, std::move(done));
}

void Workbench::cancel()
{
    if (m_job)
        m_job->cancel();
}

void Workbench::start(bool asked, std::function<void(const DownloadPackage&)> done)
{
    auto job = std::make_shared<Job>();
    if (asked) {
        m_job = job;
        emit busyChanged(true);
    } else {
        m_background = true;
    }
    const Project project = m_context.document().project();
    const quint64 revision = m_context.document().revision();
    m_context.runInBackground<BuildOutcome>(this, [build = m_services.build, project, job] { return build(project, *job); },
        [this, revision, asked, done = std::move(done)](BuildOutcome outcome) { take(std::move(outcome), revision, asked, done); });
}

void Workbench::take(BuildOutcome outcome, quint64 revision, bool asked, const std::function<void(const DownloadPackage&)>& done)
{
    if (asked) {
        m_job.reset();
        emit busyChanged(false);
    } else {
        m_background = false;
    }
    if (outcome.package) {
        m_builtRevision = revision;
        m_builtHash = outcome.package->program;
    }
    emit builtChanged();
    compare();
    if (!asked) {
        if (revision != m_context.document().revision())
            m_quiet.start();
        return;
    }
    if (outcome.package) {
        m_context.output(tr("Built \"%1\": %2 bytes.").arg(m_context.document().displayName()).arg(outcome.package->image.size()));
        if (done)
            done(*outcome.package);
        else
            m_context.notify(Severity::Information, tr("Built without errors."));
        return;
    }
    for (const Diagnostic& problem : outcome.diagnostics) {
        m_context.output(QStringLiteral("%1 %2: %3").arg(words::codeId(problem.code), words::placeText(problem.place), words::sentence(problem)));
        if (problem.code == Code::Cancelled)
            return;
    }
    m_context.document().setDiagnostics(std::move(outcome.diagnostics));
    m_context.notify(Severity::Error, tr("Not built: the project has errors. The Problems list names them."));
    m_context.showPanel(QStringLiteral("problems"));
}

} // namespace camwright
