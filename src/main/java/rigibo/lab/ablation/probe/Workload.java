package rigibo.lab.ablation.probe;

import rigibo.backend.Pool;
import rigibo.backend.effect.Effects;
import rigibo.backend.setup.BodyDefinition;

import java.util.List;

/** A scene that is measured: it runs for a while, is put back, and runs the same way again. */
public interface Workload {

    /** One word for the command line and the tables. */
    String name();

    /** What it is, for a reader who does not see it. */
    String words();

    /** What it calls for. */
    Effects effects();

    /** Its bodies, in the order they are added. */
    List<BodyDefinition> bodies();

    /** Steps before the state that every period begins with. */
    int stepsToSettle();

    /** Steps until it is put back: as long as it keeps moving. */
    int period();

    /** Before each step; allocates nothing. */
    default void drive(Pool pool) {}
}
