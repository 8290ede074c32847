package rigibo.frontend.scene.ghost;

import rigibo.backend.Pool;
import rigibo.frontend.scene.Scene;

import java.util.Optional;

/** Growth of the distance between two pools since they were equal. */
public final class Divergence {

    /** Steps whose distances are kept: ten seconds. */
    static final int KEPT = 600;

    private final double[] recent = new double[KEPT];
    private final Growth growth = new Growth();
    private int steps;
    private Optional<Parting> parting = Optional.empty();

    /** Both have made a step of 1/60 s. */
    public void step(Pool one, Pool other) {
        double distance = Distance.between(one, other);
        recent[steps % KEPT] = distance;
        steps++;
        // The verdict is final: from then on the two scenes move independently.
        if (parting.isEmpty() && !growth.isFull()) {
            growth.add(distance);
            if (growth.hasReached(Distance.size(one))) {
                parting = Optional.of(new Parting(steps * Scene.STEP, growth.isExponential()));
            }
        }
    }

    /** The root mean square over the bodies now, m. */
    public double distance() {
        return steps == 0 ? 0 : recent[(steps - 1) % KEPT];
    }

    /** When and how the two became different worlds, where they did. */
    public Optional<Parting> parting() {
        return parting;
    }

    /** How many distances are kept. */
    int count() {
        return Math.min(steps, KEPT);
    }

    /** One of those kept, m; 0 is the oldest. */
    double distance(int i) {
        return recent[(steps - count() + i) % KEPT];
    }
}
