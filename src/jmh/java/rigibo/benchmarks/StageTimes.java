package rigibo.benchmarks;

import org.openjdk.jmh.annotations.AuxCounters;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.State;

import rigibo.backend.StepReport;
import rigibo.backend.setup.StepStage;

/**
 * Time in the most expensive stages. JMH reports it per second, like the number of steps, that is,
 * as shares of the time, whose sum is almost 1.
 */
@State(Scope.Thread)
@AuxCounters(AuxCounters.Type.OPERATIONS)
public class StageTimes {

    private static final double NANO = 1e-9;

    public double broadphase;
    public double classify;
    public double flight;
    public double contact;

    /** Adds the times of a step. */
    void add(StepReport report) {
        broadphase += NANO * report.nanos(StepStage.BROADPHASE);
        classify += NANO * report.nanos(StepStage.CLASSIFY);
        flight += NANO * report.nanos(StepStage.FLIGHT);
        contact += NANO * report.nanos(StepStage.CONTACT);
    }
}
