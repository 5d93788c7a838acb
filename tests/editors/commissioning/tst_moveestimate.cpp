#include "editors/commissioning/causetext.h"
#include "editors/commissioning/moveestimate.h"
#include "editors/commissioning/numbers.h"
#include "editors/commissioning/travelbar.h"

#include <QtTest>

using namespace camwright;

class MoveEstimateTest : public QObject {
    Q_OBJECT

private slots:
    void longMoveReachesItsVelocity()
    {
        const MoveEstimate move = estimateMove(120, 50, 500);
        QCOMPARE(move.topVelocity, 50.0);
        QCOMPARE(move.rampTime, 0.1);
        QCOMPARE(move.duration, 120.0 / 50 + 0.1);
    }

    void shortMoveIsATriangle()
    {
        const MoveEstimate move = estimateMove(-1, 50, 100);
        QCOMPARE(move.topVelocity, 10.0);
        QCOMPARE(move.duration, 0.2);
    }

    void nonsenseTakesNoTime()
    {
        QCOMPARE(estimateMove(0, 50, 100).duration, 0.0);
        QCOMPARE(estimateMove(1, 0, 100).duration, 0.0);
        QCOMPARE(estimateMove(1, 50, -1).duration, 0.0);
        QCOMPARE(estimateMove(std::numeric_limits<double>::quiet_NaN(), 50, 1).duration, 0.0);
    }

    void stoppingDistanceHasTheSignOfTheVelocity()
    {
        QCOMPARE(stoppingDistance(10, 100), 0.5);
        QCOMPARE(stoppingDistance(-10, 100), -0.5);
        QCOMPARE(stoppingDistance(10, 0), 0.0);
    }

    void numbersAlignOnThePoint()
    {
        QCOMPARE(shownNumber(-0.0001, 3), QString("0.000"));
        QCOMPARE(shownNumber(-1.5, 1, 3), QString("\u22121.5\u00a0\u00a0"));
        QCOMPARE(shownNumber(7, 0, 3), QString("7") + QString(4, QChar(0x00a0)));
    }

    void scaleStepsAreRound()
    {
        QCOMPARE(roundStep(260, 3), 100.0);
        QCOMPARE(roundStep(1, 4), 0.5);
        QCOMPARE(roundStep(36, 2), 20.0);
    }

    void errorsAreTold()
    {
        QCOMPARE(errorCodeText(0x8130), QString("16#8130"));
        QCOMPARE(axisErrorText("kinco", 0), QString());
        QCOMPARE(axisErrorText("kinco", 0x8130), QString("the drive no longer answers on the bus"));
        QVERIFY(!axisErrorText("kinco", 0xFF07).isEmpty());
        QCOMPARE(causeText("something new"), QString("something new"));
    }
};

QTEST_GUILESS_MAIN(MoveEstimateTest)
#include "tst_moveestimate.moc"
