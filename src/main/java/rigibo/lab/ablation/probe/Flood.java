package rigibo.lab.ablation.probe;

import rigibo.backend.effect.Contacts;
import rigibo.backend.effect.ContinuousImpacts;
import rigibo.backend.effect.Effects;
import rigibo.backend.effect.Gravity;
import rigibo.backend.effect.Restitution;
import rigibo.backend.geometry.Circle;
import rigibo.backend.setup.BodyDefinition;
import rigibo.backend.setup.Material;

import java.util.List;
import java.util.SplittableRandom;

/** Discs poured into a trough, without friction and without rotation. */
final class Flood implements Workload {

    private static final int DISCS = 600;
    private static final int COLUMNS = 30;
    private static final double WIDTH = 20;
    private static final Material DROP = new Material(1, 0, 0.5);

    private final long seed;

    Flood(long seed) {
        this.seed = seed;
    }

    @Override
    public String name() {
        return "flood";
    }

    @Override
    public String words() {
        return "600 discs of r = 0.25 m and elasticity 0.5 falling into a trough";
    }

    @Override
    public Effects effects() {
        return Effects.of(
                new Gravity(0, -9.81), new Contacts(), new Restitution(), new ContinuousImpacts());
    }

    @Override
    public List<BodyDefinition> bodies() {
        SplittableRandom random = new SplittableRandom(seed);
        List<BodyDefinition> bodies = Trough.of(WIDTH);
        for (int i = 0; i < DISCS; i++) {
            double x = -WIDTH / 2 + 0.5 + (i % COLUMNS) * 0.65 + 0.1 * random.nextDouble();
            bodies.add(
                    BodyDefinition.dynamic(new Circle(0.25))
                            .at(x, 1 + (i / COLUMNS) * 0.6)
                            .material(DROP));
        }
        return bodies;
    }

    @Override
    public int stepsToSettle() {
        return 45;
    }

    @Override
    public int period() {
        return 60;
    }
}
