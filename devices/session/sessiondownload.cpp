// A download: begin, pieces two at a time, commit (CONTRACTS 16).
#include "core/online/imagemanifest.h"
#include "devices/session/sessionimpl.h"

namespace camwright {

RequestId OnlineSession::planDownload(DownloadPackage package, Reply<DownloadPlan> reply)
{
    Manifest manifest = manifestOf(package.image);
    manifest.program = package.program;
    const std::vector<ManifestPart> parts = std::move(manifest.parts);
    std::size_t sent = 0;
    while (parts.size() - sent > message::PartsAtOnce && m_impl->stage == SessionStage::Online) {
        message::PlanDownload some{manifest, true};
        some.manifest.parts.assign(parts.begin() + static_cast<std::ptrdiff_t>(sent),
                                   parts.begin() + static_cast<std::ptrdiff_t>(sent + message::PartsAtOnce));
        sent += message::PartsAtOnce;
        m_impl->send(std::move(some));
    }
    message::PlanDownload last{manifest, false};
    last.manifest.parts.assign(parts.begin() + static_cast<std::ptrdiff_t>(sent), parts.end());
    return m_impl->request<message::Plan, DownloadPlan>(std::move(last), std::move(reply),
        [](message::Plan&& answer) { return Result<DownloadPlan>(std::move(answer.plan)); });
}

RequestId OnlineSession::download(DownloadPackage package, std::function<void(double)> progress, Reply<void> reply)
{
    auto [id, finish] = m_impl->calls.open<void>(std::move(reply));
    if (m_impl->stage != SessionStage::Online) {
        finish(diagnostic(Code::NotConnected));
        return id;
    }
    auto download = std::make_shared<Impl::Download>();
    download->package = std::move(package);
    download->progress = std::move(progress);
    download->finish = std::move(finish);
    download->call = id;
    message::BeginDownload begin;
    begin.size = download->package.image.size();
    begin.image = hashOf(download->package.image);
    begin.program = download->package.program;
    m_impl->ask("beginDownload", begin, m_impl->options.requestTimeout, [impl = m_impl.get(), download](Result<Message> answer) {
        if (!answer)
            return download->finish(answer.error());
        const auto* begun = std::get_if<message::DownloadBegun>(&*answer);
        if (begun == nullptr)
            return impl->lose(diagnostic(Code::ProtocolBroken, {impl->connector->address(), "a wrong answer to beginDownload"}), false);
        download->transfer = begun->transfer;
        impl->nextPieces(download);
    });
    return id;
}

void OnlineSession::Impl::nextPieces(const std::shared_ptr<Download>& download)
{
    if (!calls.isOpen(download->call)) // cancelled
        return send(message::AbortDownload{download->transfer});
    const Bytes& image = download->package.image;
    if (download->taken == image.size())
        return commit(download);
    // Pairs: the time between the two answers tells how fast the line is.
    download->lastSize = download->sizer.size();
    while (download->inFlight < message::PiecesInFlight && download->sent < image.size()) {
        const std::size_t size = std::min(download->lastSize, image.size() - download->sent);
        message::Piece piece;
        piece.transfer = download->transfer;
        piece.offset = download->sent;
        piece.bytes.assign(image.begin() + static_cast<std::ptrdiff_t>(download->sent),
                           image.begin() + static_cast<std::ptrdiff_t>(download->sent + size));
        download->sent += size;
        ++download->inFlight;
        ask("piece", std::move(piece), options.requestTimeout,
            [this, download](Result<Message> answer) { pieceTaken(download, answer); });
    }
}

void OnlineSession::Impl::pieceTaken(const std::shared_ptr<Download>& download, const Result<Message>& answer)
{
    if (!answer)
        return download->finish(answer.error());
    const auto* taken = std::get_if<message::PieceTaken>(&*answer);
    if (taken == nullptr || taken->received > download->sent || taken->received <= download->taken)
        return lose(diagnostic(Code::ProtocolBroken, {connector->address(), CW_TEXT("Arguments", "a wrong answer to piece")}), false);
    download->taken = static_cast<std::size_t>(taken->received);
    --download->inFlight;
    if (download->progress && calls.isOpen(download->call)) {
        const double share = static_cast<double>(download->taken) / static_cast<double>(download->package.image.size());
        executor.post([this, guard = std::weak_ptr(alive), download, share] {
            if (!guard.expired() && calls.isOpen(download->call))
                download->progress(share);
        });
    }
    if (download->inFlight > 0) {
        download->gap.start();
        return;
    }
    if (download->gap.isValid())
        download->sizer.onPair(download->lastSize, Time(download->gap.nsecsElapsed()));
    download->gap.invalidate();
    nextPieces(download);
}

void OnlineSession::Impl::commit(const std::shared_ptr<Download>& download)
{
    ask("commitDownload", message::CommitDownload{download->transfer}, options.commitTimeout, [download](Result<Message> answer) {
        if (!answer)
            download->finish(answer.error());
        else
            download->finish(Result<void>());
    });
}

} // namespace camwright
