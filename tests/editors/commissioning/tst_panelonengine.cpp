#include "core/checks/checkproject.h"
#include "core/language/compile.h"
#include "core/runtime/engine.h"
#include "core/storage/projectstore.h"
#include "panelbench.h"

#include <cmath>

using namespace camwright;

namespace {

/// The controller itself behind the link, in manual time.
class EngineLink final : public FakeLink {
public:
    explicit EngineLink(ByteSpan image)
    {
        if (!engine.load(image))
            qFatal("the example does not load");
        engine.step(2s); // the drives boot
        follow();
    }
    RequestId command(AxisCommand order, Reply<void> reply) override
    {
        reply(engine.apply(input::Panel{0, order.kind, order.position, order.velocity, order.acceleration}));
        return {};
    }
    RequestId stopAllAxes(Reply<void> reply) override
    {
        reply(engine.apply(input::StopAllAxes{}));
        return {};
    }
    void heartbeat() override { (void)engine.apply(input::Heartbeat{engine.cycle()}); }
    void follow()
    {
        status_ = engine.status();
        status_.control = ControlHolder::You;
        push();
    }

    ControllerEngine engine;
};

Bytes exampleImage()
{
    PosixFileSystem files;
    const auto loaded = openProject(files, CAMWRIGHT_SOURCE_DIR "/examples/kinco-feeder");
    Job job;
    return write(*compile(*validate(loaded->project).project, {}, job).image);
}

} // namespace

/// The panel's control on the virtual controller: what it sends does move the simulated axis, and stops it.
class PanelOnEngineTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { m_image = exampleImage(); }

    void init()
    {
        m_link = std::make_unique<EngineLink>(m_image);
        m_context = std::make_unique<Context>(m_document, m_actions, m_registry, m_pool);
        m_context->setLink(m_link.get());
        m_control = std::make_unique<PanelControl>(*m_context, "Feed");
        m_control->arm();
        QVERIFY(m_control->isArmed());
        m_control->enable();
        pass(1s);
        QVERIFY2(m_control->mayMove(), qPrintable(m_control->whyNotMove()));
    }
    void cleanup()
    {
        m_control.reset();
        m_context.reset();
    }

    void jogMovesAtItsSpeedAndReleaseStops()
    {
        QVERIFY(m_control->jog(50));
        pass(1s);
        QVERIFY(std::abs(axis().velocity - 50) < 2);
        m_control->endMotion();
        pass(1s);
        QVERIFY(std::abs(axis().velocity) < 0.5);
        QVERIFY(!m_control->isDriving());
        QVERIFY(m_control->isArmed());
    }

    void moveReachesItsTarget()
    {
        QVERIFY(m_control->moveTo(120, 100, 0));
        pass(4s);
        QVERIFY2(std::abs(axis().position - 120) < 0.2, qPrintable(QString::number(axis().position)));
        QVERIFY(!m_control->isDriving());
    }

    void frozenInterfaceStopsTheAxisAndDisarms()
    {
        QVERIFY(m_control->jog(100));
        pass(1s);
        const double moving = axis().position;
        m_link->engine.step(100ms); // no beat from here on
        m_link->engine.step(900ms);
        m_link->follow();
        QVERIFY(std::abs(axis().velocity) < 0.5);
        QVERIFY(axis().position - moving < 40);
        QVERIFY(!m_control->isArmed());
        pass(1s);
        QVERIFY(std::abs(axis().velocity) < 0.5); // nothing resumes
    }

    void disarmingStops()
    {
        QVERIFY(m_control->jog(-50));
        pass(500ms);
        m_control->disarm();
        pass(1s);
        QVERIFY(std::abs(axis().velocity) < 0.5);
        QVERIFY(!axis().panelArmed);
        QVERIFY(axis().enabled); // power stays on
    }

    void stopAllStops()
    {
        QVERIFY(m_control->moveTo(500, 100, 0));
        pass(500ms);
        m_control->stopAll();
        pass(1s);
        QVERIFY(std::abs(axis().velocity) < 0.5);
        QVERIFY(axis().position < 120);
        QVERIFY(m_control->isArmed());
    }

private:
    const AxisStatus& axis() const { return m_link->status_.axes[0]; }

    /// Time passes while the interface lives: beats as Context sends them.
    void pass(Time span)
    {
        for (Time t{0}; t < span; t += 20ms) {
            if (m_context->isArmed())
                m_link->heartbeat();
            m_link->engine.step(20ms);
            m_link->follow();
        }
    }

    Bytes m_image;
    ProjectDocument m_document;
    ActionCatalogue m_actions;
    Registry m_registry;
    QThreadPool m_pool;
    std::unique_ptr<EngineLink> m_link;
    std::unique_ptr<Context> m_context;
    std::unique_ptr<PanelControl> m_control;
};

QTEST_MAIN(PanelOnEngineTest)
#include "tst_panelonengine.moc"
