#include "editors/commissioning/panelcontrol.h"
#include "editors/shell/actions.h"
#include "editors/shell/context.h"
#include "editors/shell/registry.h"
#include "fakelink.h"

#include <QSignalSpy>
#include <QThreadPool>
#include <QtTest>

using namespace camwright;
using Said = std::vector<std::string>;

/// PanelControl without widgets: what it sends, when, and that nothing resumes.
class PanelControlTest : public QObject {
    Q_OBJECT

private slots:
    void init()
    {
        m_link = std::make_unique<FakeLink>();
        m_document = std::make_unique<ProjectDocument>();
        m_context = std::make_unique<Context>(*m_document, m_actions, m_registry, m_pool);
        m_context->setLink(m_link.get());
        m_control = std::make_unique<PanelControl>(*m_context, "Feed");
    }
    void cleanup()
    {
        m_control.reset();
        m_context.reset();
    }

    void armingTakesControlFirst()
    {
        m_link->status_.control = ControlHolder::Nobody;
        m_link->push();
        m_control->arm();
        QCOMPARE(m_link->take(), Said({"takeControl", "arm Feed"}));
        QVERIFY(m_control->isArmed());
        QVERIFY(m_context->isArmed());
    }

    void armingWithControlOnlyArms()
    {
        arm();
    }

    void refusedControlLeavesItOff()
    {
        m_link->autoAnswer = false;
        m_link->status_.control = ControlHolder::Somebody;
        m_link->push();
        QSignalSpy failed(m_control.get(), &PanelControl::failed);
        m_control->arm();
        m_link->answer(diagnostic(Code::ControlHeld, {"Anna"}));
        QVERIFY(!m_control->isArmed());
        QCOMPARE(failed.size(), 1);
        QVERIFY(failed[0][0].toString().contains("Anna"));
        QCOMPARE(m_link->take(), Said({"takeControl"}));
        QVERIFY(!m_context->isArmed());
    }

    void heartBeatsOnlyWhileArmed()
    {
        QCOMPARE(m_link->beats, 0);
        arm();
        QVERIFY(m_link->beats >= 1);
        QTRY_VERIFY(m_link->beats >= 4);
        m_control->disarm();
        const int beats = m_link->beats;
        QTest::qWait(80);
        QCOMPARE(m_link->beats, beats);
    }

    void disarmWhileArmingIsSaidToo()
    {
        m_link->autoAnswer = false;
        m_control->arm();
        m_control->disarm();
        QCOMPARE(m_link->take(), Said({"arm Feed", "disarm Feed"}));
        m_link->answer();
        m_link->answer();
        QVERIFY(!m_control->isArmed());
        QVERIFY(!m_context->isArmed());
    }

    void jogIsRefusedUnlessArmedEnabledAndWell()
    {
        QVERIFY(!m_control->jog(5));
        arm();
        m_link->axis().enabled = false;
        m_link->push();
        QVERIFY(!m_control->jog(5));
        m_link->axis().enabled = true;
        m_link->axis().error = 0x8611;
        m_link->push();
        QVERIFY(!m_control->jog(5));
        m_link->axis().error = 0;
        m_link->axis().online = false;
        m_link->push();
        QVERIFY(!m_control->jog(5));
        QCOMPARE(m_link->take(), Said());
        m_link->axis().online = true;
        m_link->push();
        QVERIFY(m_control->jog(-5));
        QCOMPARE(m_link->take(), Said({"jog Feed -5"}));
    }

    void jogsAreNeverQueued()
    {
        arm();
        m_link->autoAnswer = false;
        QVERIFY(m_control->jog(5));
        m_control->endMotion();
        QVERIFY(!m_control->jog(5)); // neither jog nor stop is answered
        m_link->answer();
        QVERIFY(!m_control->jog(5));
        m_link->answer();
        m_link->answer();            // the stop said again, see below
        QVERIFY(m_control->jog(5));
        QCOMPARE(m_link->take(), Said({"jog Feed 5", "stop Feed", "stop Feed", "jog Feed 5"}));
    }

    void jogAcceptedAfterItsEndIsStoppedAgain()
    {
        arm();
        m_link->autoAnswer = false;
        m_control->jog(5);
        m_control->endMotion();
        QCOMPARE(m_link->take(), Said({"jog Feed 5", "stop Feed"}));
        m_link->answer();
        QCOMPARE(m_link->take(), Said({"stop Feed"}));
    }

    void aJogWhoseStartIsSlowIsStillStopped()
    {
        arm();
        m_control->jog(5);
        for (int i = 0; i < 6; ++i)
            m_link->push(); // the axis does not move yet
        m_control->endMotion();
        QCOMPARE(m_link->take(), Said({"jog Feed 5", "stop Feed"}));
    }

    void disarmingStopsWhatMoves()
    {
        arm();
        m_control->moveTo(100, 20, 0);
        m_control->disarm();
        QCOMPARE(m_link->take(), Said({"moveTo Feed 100 20", "stop Feed", "disarm Feed"}));
        QVERIFY(m_control->isDriving()); // until it is seen at rest
        m_link->push();
        m_link->push();
        QVERIFY(!m_control->isDriving());
    }

    void theMoveEndsWhenTheAxisRests()
    {
        arm();
        m_control->moveBy(10, 20, 0);
        m_link->axis().moving = true;
        for (int i = 0; i < 4; ++i)
            m_link->push();
        QVERIFY(m_control->isDriving());
        m_link->axis().moving = false;
        m_link->push();
        m_link->push();
        QVERIFY(!m_control->isDriving());
        m_control->endMotion();
        QCOMPARE(m_link->take(), Said({"moveBy Feed 10 20"}));
    }

    void lostLinkDisarmsAndNothingResumes()
    {
        arm();
        m_control->jog(5);
        m_link->take();
        m_link->setState(LinkState::Lost);
        QVERIFY(!m_control->isArmed());
        QVERIFY(!m_control->isDriving());
        QVERIFY(!m_context->isArmed());
        QCOMPARE(m_link->take(), Said());
        m_link->setState(LinkState::Online);
        m_link->push();
        QVERIFY(!m_control->isArmed());
        QCOMPARE(m_link->take(), Said());
        const int beats = m_link->beats;
        QTest::qWait(60);
        QCOMPARE(m_link->beats, beats);
    }

    void goingOfflineStopsAndDisarmsFirst()
    {
        arm();
        m_control->jog(5);
        m_link->take();
        m_context->setLink(nullptr);
        QCOMPARE(m_link->take(), Said({"stop Feed", "disarm Feed"}));
        QVERIFY(!m_control->isArmed());
    }

    void theEndOfThePanelStopsAndDisarms()
    {
        arm();
        m_control->jog(5);
        m_link->take();
        m_control.reset();
        QCOMPARE(m_link->take(), Said({"stop Feed", "disarm Feed"}));
        QVERIFY(!m_context->isArmed());
    }

    void armingEndedByTheControllerIsFollowed()
    {
        arm();
        m_link->push();
        QSignalSpy failed(m_control.get(), &PanelControl::failed);
        m_link->axis().panelArmed = false;
        m_link->push();
        QVERIFY(!m_control->isArmed());
        QCOMPARE(failed.size(), 1);
    }

    void lostControlDisarmsAndNamesTheHolder()
    {
        arm();
        m_link->push();
        QSignalSpy failed(m_control.get(), &PanelControl::failed);
        m_link->status_.control = ControlHolder::Somebody;
        m_link->status_.controlOwner = "Anna";
        m_link->push();
        QVERIFY(!m_control->isArmed());
        QVERIFY(failed[0][0].toString().contains("Anna"));
    }

    void stopAllNeedsNoArming()
    {
        m_link->status_.control = ControlHolder::Somebody;
        m_link->push();
        m_control->stopAll();
        QCOMPARE(m_link->take(), Said({"stopAll"}));
    }

    void disableStopsFirst()
    {
        arm();
        m_control->jog(5);
        m_control->disable();
        QCOMPARE(m_link->take(), Said({"jog Feed 5", "stop Feed", "disable Feed"}));
    }

    void withoutMotionThereIsNoArming()
    {
        m_link->m_can.motion = false;
        m_control->arm();
        QCOMPARE(m_link->take(), Said());
        QVERIFY(!m_control->mayArm());
    }

private:
    void arm()
    {
        m_control->arm();
        QVERIFY(m_control->isArmed());
        QCOMPARE(m_link->take(), Said({"arm Feed"}));
    }

    ActionCatalogue m_actions;
    Registry m_registry;
    QThreadPool m_pool;
    std::unique_ptr<FakeLink> m_link;
    std::unique_ptr<ProjectDocument> m_document;
    std::unique_ptr<Context> m_context;
    std::unique_ptr<PanelControl> m_control;
};

QTEST_MAIN(PanelControlTest)
#include "tst_panelcontrol.moc"
