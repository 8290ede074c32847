package rigibo.lab.plot;

import java.util.List;

/** Maps values to places along an edge of a plot. */
public sealed interface Scale permits LinearScale, LogScale {

    /** The place of a value, px; values beyond an end are at that end. */
    double at(double value);

    /** A few round values between the ends. */
    List<Double> ticks();

    /** The place of the first end, px. */
    double start();

    /** The place of the other end, px; less than the first if values rise upwards. */
    double end();
}
