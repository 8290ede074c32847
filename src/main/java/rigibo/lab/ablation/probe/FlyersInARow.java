package rigibo.lab.ablation.probe;

import rigibo.backend.effect.Effects;
import rigibo.backend.effect.Gravity;
import rigibo.backend.geometry.Circle;
import rigibo.backend.setup.BodyDefinition;

import java.util.ArrayList;
import java.util.List;

/** Discs side by side that never meet, each free to use an effect by itself. */
final class FlyersInARow implements Workload {

    private static final int DISCS = 1000;
    private static final double DISTANCE = 3;

    @Override
    public String name() {
        return "flyers";
    }

    @Override
    public String words() {
        return "1,000 discs in a row, 3 m apart";
    }

    @Override
    public Effects effects() {
        return Effects.of(new Gravity(0, -9.81));
    }

    @Override
    public List<BodyDefinition> bodies() {
        List<BodyDefinition> bodies = new ArrayList<>();
        for (int i = 0; i < DISCS; i++) {
            bodies.add(BodyDefinition.dynamic(new Circle(0.3)).at(DISTANCE * i, 0));
        }
        return bodies;
    }

    @Override
    public int stepsToSettle() {
        return 0;
    }

    /** One second and a half: long enough to fall asleep in. */
    @Override
    public int period() {
        return 90;
    }
}
