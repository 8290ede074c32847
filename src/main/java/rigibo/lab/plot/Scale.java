package rigibo.lab.plot;

import java.util.List;

/** Where values lie along an edge of a plot. */
public sealed interface Scale permits LinearScale, LogScale {

    /** Where a value is, px; what is beyond an end is at that end. */
    double at(double value);

    /** Round values, a few, between the ends. */
    List<Double> ticks();

    /** Where the first end is, px. */
    double start();

    /** Where the other end is, px; less than the first where values rise upwards. */
    double end();
}
