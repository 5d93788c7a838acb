#include "editors/shell/quantity.h"
#include "editors/shell/quantityfield.h"

#include <QLineEdit>
#include <QSignalSpy>
#include <QtTest>

using namespace camwright;

namespace {

QuantitySpec guardTime()
{
    QuantitySpec out;
    out.name = "Guard time";
    out.unit = "ms";
    out.minimum = 0;
    out.maximum = 65535;
    out.integer = true;
    out.defaultValue = 1000;
    out.reference = "KS-MCN-09";
    return out;
}

void type(QuantityField& field, const QString& text)
{
    field.lineEdit()->setFocus();
    field.lineEdit()->selectAll();
    QTest::keyClicks(field.lineEdit(), text);
    QTest::keyClick(field.lineEdit(), Qt::Key_Return);
}

} // namespace

class QuantityFieldTest : public QObject {
    Q_OBJECT

private slots:
    void readsTypedUnits_data()
    {
        QTest::addColumn<QString>("text");
        QTest::addColumn<QString>("unit");
        QTest::addColumn<double>("perTurn");
        QTest::addColumn<double>("value");
        QTest::newRow("plain") << "12" << "mm" << 0.0 << 12.0;
        QTest::newRow("decimal comma") << "1,5" << "mm" << 0.0 << 1.5;
        QTest::newRow("inch") << "1 in" << "mm" << 0.0 << 25.4;
        QTest::newRow("metre without blank") << "0.5m" << "mm" << 0.0 << 500.0;
        QTest::newRow("half a turn of a screw") << "0.5 turn" << "mm" << 100.0 << 50.0;
        QTest::newRow("half a turn of a table") << "0.5 turn" << "°" << 0.0 << 180.0;
        QTest::newRow("kilo") << "2.5k" << "" << 0.0 << 2500.0;
        QTest::newRow("kilo with unit") << "1 kbit/s" << "bit/s" << 0.0 << 1000.0;
        QTest::newRow("hexadecimal IEC") << "16#FF" << "" << 0.0 << 255.0;
        QTest::newRow("hexadecimal C") << "0x1A0" << "" << 0.0 << 416.0;
        QTest::newRow("time literal") << "T#5s" << "ms" << 0.0 << 5000.0;
        QTest::newRow("seconds") << "2 s" << "ms" << 0.0 << 2000.0;
        QTest::newRow("rate per minute") << "6 m/min" << "mm/s" << 0.0 << 100.0;
        QTest::newRow("rpm of a screw") << "60 rpm" << "mm/s" << 10.0 << 10.0;
        QTest::newRow("own unit") << "7 mm" << "mm" << 0.0 << 7.0;
        QTest::newRow("exponent") << "1e3" << "mm" << 0.0 << 1000.0;
        QTest::newRow("grouped digits") << "8 388 608" << "pulses" << 0.0 << 8388608.0;
        QTest::newRow("Russian unit") << "2 с" << "мс" << 0.0 << 2000.0;
        QTest::newRow("Russian field, Latin rate") << "6 m/min" << "мм/с" << 0.0 << 100.0;
        QTest::newRow("rpm in a Russian field") << "60 rpm" << "об/мин" << 0.0 << 60.0;
        QTest::newRow("minus sign") << "−4" << "mm" << 0.0 << -4.0;
    }

    void readsTypedUnits()
    {
        QFETCH(QString, text);
        QFETCH(QString, unit);
        QFETCH(double, perTurn);
        QFETCH(double, value);
        const auto read = parseQuantity(text, unit, perTurn);
        QVERIFY(read.has_value());
        QVERIFY2(qFuzzyCompare(*read + 1e6, value + 1e6), qPrintable(QString::number(*read)));
    }

    void refusesWhatDoesNotFit()
    {
        for (const char* text : {"", "abc", "1 kg", "1 s", "1..2", "16#G", "1 in 2"})
            QVERIFY2(!parseQuantity(text, "mm"), text);
    }

    void convertedValueIsShownInTheFieldsUnit()
    {
        QuantityField field(guardTime());
        QSignalSpy edited(&field, &QuantityField::edited);
        type(field, "2 s");
        QCOMPARE(edited.size(), 1);
        QCOMPARE(field.integerField().value(), 2000);
        QCOMPARE(field.lineEdit()->text(), QString("2000"));
    }

    void illegalTextIsKeptWithASentence()
    {
        QuantityField field(guardTime());
        type(field, "many");
        QVERIFY(!field.realField().isValid());
        QCOMPARE(field.lineEdit()->text(), QString("many"));
        QCOMPARE(field.problem(), QString("\"many\" is not a whole number of ms."));
        QCOMPARE(field.integerField().text(), std::string("many"));
    }

    void valueOutsideTheRangeIsKeptWithASentence()
    {
        QuantityField field(guardTime());
        type(field, "70000");
        QCOMPARE(field.integerField().value(), 70000);
        QCOMPARE(field.problem(), QString("Above the range 0 to 65535 ms."));
    }

    void emptyMeansDefault()
    {
        QuantityField field(guardTime());
        field.setValue(5);
        field.lineEdit()->setFocus();
        field.lineEdit()->selectAll();
        QTest::keyClick(field.lineEdit(), Qt::Key_Delete);
        QTest::keyClick(field.lineEdit(), Qt::Key_Return);
        QCOMPARE(field.integerField().value(), 1000);
    }

    void wheelWithoutFocusChangesNothing()
    {
        QWidget window;
        QuantityField field(guardTime(), &window);
        field.setValue(5);
        window.show();
        QVERIFY(QTest::qWaitForWindowExposed(&window));
        field.lineEdit()->clearFocus();
        QWheelEvent wheel({5, 5}, {5, 5}, {}, {0, 120}, Qt::NoButton, Qt::NoModifier, Qt::NoScrollPhase, false);
        QCoreApplication::sendEvent(field.lineEdit(), &wheel);
        QCOMPARE(field.integerField().value(), 5);
    }

    void arrowKeysStepWithinTheRange()
    {
        QuantityField field(guardTime());
        field.setValue(65535);
        QTest::keyClick(field.lineEdit(), Qt::Key_Up);
        QCOMPARE(field.integerField().value(), 65535);
        QTest::keyClick(field.lineEdit(), Qt::Key_Down);
        QCOMPARE(field.integerField().value(), 65534);
    }

    void toolTipTellsRangeDefaultAndSource()
    {
        QuantityField field(guardTime());
        for (const char* part : {"0 to 65535 ms", "Default: 1000 ms", "KS-MCN-09"})
            QVERIFY2(field.lineEdit()->toolTip().contains(part), part);
    }
};

QTEST_MAIN(QuantityFieldTest)
#include "tst_quantityfield.moc"
