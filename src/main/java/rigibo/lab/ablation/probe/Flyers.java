package rigibo.lab.ablation.probe;

import rigibo.backend.effect.Effects;
import rigibo.backend.effect.Gravity;
import rigibo.backend.geometry.Circle;
import rigibo.backend.setup.BodyDefinition;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;

/** Discs in free flight. */
final class Flyers implements Workload {

    private static final int DISCS = 20_000;
    private static final int COLUMNS = 200;

    private final long seed;

    Flyers(long seed) {
        this.seed = seed;
    }

    @Override
    public String name() {
        return "flyers";
    }

    @Override
    public String words() {
        return "20,000 discs in free flight";
    }

    @Override
    public Effects effects() {
        return Effects.of(new Gravity(0, -9.81));
    }

    @Override
    public List<BodyDefinition> bodies() {
        SplittableRandom random = new SplittableRandom(seed);
        List<BodyDefinition> bodies = new ArrayList<>();
        Circle disc = new Circle(0.3);
        for (int i = 0; i < DISCS; i++) {
            bodies.add(
                    BodyDefinition.dynamic(disc)
                            .at(i % COLUMNS, i / COLUMNS)
                            .velocity(random.nextDouble() - 0.5, 5 * random.nextDouble()));
        }
        return bodies;
    }

    @Override
    public int stepsToSettle() {
        return 0;
    }

    @Override
    public int period() {
        return 30;
    }
}
