package rigibo.lab.ablation.probe;

import rigibo.backend.effect.Contacts;
import rigibo.backend.effect.Effects;
import rigibo.backend.effect.Friction;
import rigibo.backend.effect.Gravity;
import rigibo.backend.effect.Rotation;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.setup.BodyDefinition;
import rigibo.backend.setup.Material;

import java.util.ArrayList;
import java.util.List;

/** Boxes that slide on ice, wood and rubber, too far apart to meet. */
final class FrictionLanes implements Workload {

    private static final double[] LANES = {0.03, 0.4, 0.9};
    private static final int BOXES_PER_LANE = 20;
    private static final double HALF_HEIGHT = 0.3;

    /** Between one box and the next, m: more than the fastest slides in a period. */
    private static final double DISTANCE = 10;

    private static final double LENGTH = (BOXES_PER_LANE + 2) * DISTANCE;

    @Override
    public String name() {
        return "friction";
    }

    @Override
    public String words() {
        return "60 boxes sliding on lanes of ice, wood and rubber";
    }

    @Override
    public Effects effects() {
        return Effects.of(new Gravity(0, -9.81), new Contacts(), new Rotation(), new Friction());
    }

    @Override
    public List<BodyDefinition> bodies() {
        List<BodyDefinition> bodies = new ArrayList<>();
        for (int lane = 0; lane < LANES.length; lane++) {
            Material matter = new Material(1, LANES[lane], 0);
            double floor = -4.0 * lane;
            bodies.add(
                    BodyDefinition.fixed(Polygon.box(LENGTH, 1))
                            .at(LENGTH / 2 - DISTANCE, floor - 0.5)
                            .material(matter));
            for (int i = 0; i < BOXES_PER_LANE; i++) {
                bodies.add(
                        BodyDefinition.dynamic(Polygon.box(0.9, 2 * HALF_HEIGHT))
                                .at(DISTANCE * i, floor + HALF_HEIGHT)
                                .velocity(5, 0)
                                .material(matter));
            }
        }
        return bodies;
    }

    @Override
    public int stepsToSettle() {
        return 2;
    }

    /** Half a second, in which rubber does not stop a box from 5 m/s. */
    @Override
    public int period() {
        return 30;
    }
}
