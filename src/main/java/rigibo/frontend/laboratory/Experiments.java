package rigibo.frontend.laboratory;

import rigibo.backend.effect.Contacts;
import rigibo.backend.effect.ContinuousImpacts;
import rigibo.backend.effect.Effects;
import rigibo.backend.effect.Friction;
import rigibo.backend.effect.Gravity;
import rigibo.backend.effect.Restitution;
import rigibo.backend.effect.Rotation;
import rigibo.backend.geometry.Circle;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.setup.BodyDefinition;
import rigibo.backend.setup.Material;
import rigibo.frontend.scene.Skin;

import java.util.List;

/**
 * The experiments of the laboratory, each of which shows one thing. None declares sleep, so that a
 * step at rest is timed as well.
 */
final class Experiments {

    private static final Gravity GRAVITY = new Gravity(0, -9.81);

    /** Elasticity 1 and no friction: nothing takes energy. */
    private static final Material LOSSLESS = new Material(1, 0, 1);

    private static final int BOXES = 20;
    private static final double BOX = 0.4;

    /** Mass of the light bodies, kg; heavy ones have a thousand times as much. */
    private static final double LIGHT = 1;

    private static final double HEAVY = 1000;

    private static final double BILLIARD_RADIUS = 0.22;
    private static final int RACK_ROWS = 5;

    /**
     * Gap between the balls of the rack, m, so that they are struck one after the other rather than
     * all at once.
     */
    private static final double RACK_GAP = 0.004;

    /** m/s. */
    private static final double BREAK = 9;

    private Experiments() {}

    /**
     * The experiments in the order of their buttons. The first one is that in which accuracies part
     * soonest: after half a second, balls are elsewhere.
     */
    static List<Experiment> all() {
        return List.of(billiard(), elasticBalls(), stack(), heavyOnLight());
    }

    private static Experiment elasticBalls() {
        return new Experiment(
                "balls",
                Effects.of(GRAVITY, new Contacts(), new Restitution(), new ContinuousImpacts()),
                Experiments::dropBalls);
    }

    private static void dropBalls(Room room) {
        room.walls(LOSSLESS);
        double[] radii = {0.5, 0.3, 0.42, 0.25, 0.36};
        for (int i = 0; i < radii.length; i++) {
            room.add(
                    BodyDefinition.dynamic(new Circle(radii[i]))
                            .at(-2.7 + 1.3 * i, 2.5 + 0.9 * i)
                            .velocity(0.5 - 0.3 * i, 0)
                            .material(LOSSLESS),
                    i % 2 == 0 ? Skin.BALL : Skin.RUBBER);
        }
    }

    private static Experiment stack() {
        return new Experiment(
                "stack",
                resting(),
                room -> {
                    Material rough = new Material(1, 0.6, 0);
                    room.walls(rough);
                    for (int i = 0; i < BOXES; i++) {
                        room.add(
                                BodyDefinition.dynamic(Polygon.box(BOX, BOX))
                                        .at(0, (i + 0.5) * BOX)
                                        .material(rough),
                                Skin.RIGIBO);
                    }
                });
    }

    private static Experiment heavyOnLight() {
        return new Experiment("heavy", resting(), Experiments::pile);
    }

    /** A heavy box on a light one, and heavy ones that fall upon a plank on light supports. */
    private static void pile(Room room) {
        Material rough = new Material(1, 0.6, 0);
        room.walls(rough);
        box(room, -2.2, 0.4, 0.8, 0.8, LIGHT);
        box(room, -2.2, 1.4, 1.2, 1.2, HEAVY);
        box(room, 0.2, 0.3, 0.6, 0.6, LIGHT);
        box(room, 2.4, 0.3, 0.6, 0.6, LIGHT);
        box(room, 1.3, 0.7, 3.2, 0.2, LIGHT);
        box(room, 0.7, 2.3, 1, 1, HEAVY);
        box(room, 1.9, 3.2, 1, 1, HEAVY);
    }

    private static void box(
            Room room, double x, double y, double width, double height, double mass) {
        room.add(
                BodyDefinition.dynamic(Polygon.box(width, height))
                        .at(x, y)
                        .mass(mass)
                        .material(new Material(1, 0.6, 0)),
                mass > LIGHT ? Skin.IRON : Skin.RIGIBO);
    }

    private static Experiment billiard() {
        return new Experiment(
                "billiard",
                Effects.of(new Contacts(), new Restitution(), new ContinuousImpacts()),
                Experiments::rack);
    }

    private static void rack(Room room) {
        room.walls(LOSSLESS);
        double apart = 2 * BILLIARD_RADIUS + RACK_GAP;
        for (int row = 0; row < RACK_ROWS; row++) {
            for (int i = 0; i <= row; i++) {
                double x = (i - row / 2.0) * apart;
                double y = 5 + row * apart * Math.sqrt(0.75);
                ball(room, x, y, 0, (row + i) % 2 == 0 ? Skin.RUBBER : Skin.ICE);
            }
        }
        ball(room, 0.07, 1.5, BREAK, Skin.BALL);
    }

    private static void ball(Room room, double x, double y, double speed, Skin skin) {
        room.add(
                BodyDefinition.dynamic(new Circle(BILLIARD_RADIUS))
                        .at(x, y)
                        .velocity(0, speed)
                        .material(LOSSLESS),
                skin);
    }

    private static Effects resting() {
        return Effects.of(
                GRAVITY,
                new Contacts(),
                new Rotation(),
                new Friction(),
                new Restitution(),
                new ContinuousImpacts());
    }
}
