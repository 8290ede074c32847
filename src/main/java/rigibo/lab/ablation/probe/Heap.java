package rigibo.lab.ablation.probe;

import rigibo.backend.effect.Contacts;
import rigibo.backend.effect.Effects;
import rigibo.backend.effect.Friction;
import rigibo.backend.effect.Gravity;
import rigibo.backend.effect.Rotation;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.setup.BodyDefinition;

import java.util.List;
import java.util.SplittableRandom;

/** Boxes that fall on each other in a trough and never sleep. */
final class Heap implements Workload {

    private static final int BOXES = 500;
    private static final int COLUMNS = 20;
    private static final double WIDTH = 20;

    private final long seed;

    Heap(long seed) {
        this.seed = seed;
    }

    @Override
    public String name() {
        return "heap";
    }

    @Override
    public String words() {
        return "500 boxes tumbling onto a heap, sleep off";
    }

    @Override
    public Effects effects() {
        return Effects.of(new Gravity(0, -9.81), new Contacts(), new Rotation(), new Friction());
    }

    @Override
    public List<BodyDefinition> bodies() {
        SplittableRandom random = new SplittableRandom(seed);
        List<BodyDefinition> bodies = Trough.of(WIDTH);
        for (int i = 0; i < BOXES; i++) {
            double x = -WIDTH / 2 + 0.5 + (i % COLUMNS) * 0.98 + 0.1 * random.nextDouble();
            bodies.add(
                    BodyDefinition.dynamic(Polygon.box(0.5, 0.5))
                            .at(x, 0.6 + (i / COLUMNS) * 0.75)
                            .angle(random.nextDouble()));
        }
        return bodies;
    }

    /** Begins in the air: put back into a heap, boxes would have lost what carried them. */
    @Override
    public int stepsToSettle() {
        return 0;
    }

    @Override
    public int period() {
        return 60;
    }
}
