package rigibo.lab.ablation.probe;

import rigibo.backend.effect.Effects;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.setup.BodyDefinition;
import rigibo.backend.setup.Material;

import java.util.ArrayList;
import java.util.List;

/** A stack that stays and falls asleep beside a pyramid that a heavy crate runs into. */
final class Crate implements Workload {

    private static final double SIZE = 0.6;
    private static final int STACKED = 10;
    private static final int BASE = 5;
    private static final Material WOOD = new Material(1, 0.5, 0.1);

    @Override
    public String name() {
        return "crate";
    }

    @Override
    public String words() {
        return "a stack of 10 that falls asleep, a pyramid of 15 struck by a crate of ten times the"
                + " mass";
    }

    @Override
    public Effects effects() {
        return Effects.usual();
    }

    @Override
    public List<BodyDefinition> bodies() {
        List<BodyDefinition> bodies = new ArrayList<>();
        bodies.add(
                BodyDefinition.fixed(Polygon.box(60, 1))
                        .at(0, -0.5)
                        .material(new Material(1, 0.6, 0)));
        for (int i = 0; i < STACKED; i++) {
            bodies.add(crate(-12, i));
        }
        for (int row = 0; row < BASE; row++) {
            for (int i = 0; i < BASE - row; i++) {
                bodies.add(crate(6 + (i - (BASE - row - 1) / 2.0) * 1.04 * SIZE, row));
            }
        }
        bodies.add(crate(-2, 1).mass(10 * SIZE * SIZE).velocity(11, 2));
        return bodies;
    }

    private static BodyDefinition crate(double x, int row) {
        return BodyDefinition.dynamic(Polygon.box(SIZE, SIZE))
                .at(x, (row + 0.5) * SIZE)
                .material(WOOD);
    }

    @Override
    public int stepsToSettle() {
        return 0;
    }

    @Override
    public int period() {
        return 120;
    }
}
