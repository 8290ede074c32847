package rigibo.backend.law;

import rigibo.backend.effect.Contacts;
import rigibo.backend.effect.ContinuousImpacts;
import rigibo.backend.effect.Effects;
import rigibo.backend.effect.Friction;
import rigibo.backend.effect.Gravity;
import rigibo.backend.effect.Restitution;
import rigibo.backend.effect.RollingResistance;
import rigibo.backend.effect.Rotation;
import rigibo.backend.geometry.Circle;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.geometry.Shape;
import rigibo.backend.setup.Accuracy;
import rigibo.backend.setup.BodyDefinition;
import rigibo.backend.setup.Material;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Function;

/** Kinds of scenes that several laws are held against. */
final class Surroundings {

    /** Nothing from outside: no gravity, nothing fixed. */
    static final Effects SPACE =
            Effects.of(
                    new Contacts(),
                    new Rotation(),
                    new Friction(),
                    new Restitution(),
                    new ContinuousImpacts());

    static final Effects EARTH = SPACE.with(new Gravity(0, -9.81));

    /** m, of the circles that hold the bodies. */
    static final double SMALLEST = 0.15;

    static final double LARGEST = 0.5;

    /** One second: thrown bodies have met the others in the middle and left. */
    private static final int STEPS_OF_A_MEETING = 60;

    /** Three seconds: most of what was thrown into a tray has come to rest. */
    private static final int STEPS_OF_A_FALL = 180;

    /** Ten seconds. */
    private static final int STEPS_TO_REST = 600;

    private Surroundings() {}

    /** Two to twelve bodies of all kinds thrown at each other. */
    static RandomScene meeting(long seed, Accuracy accuracy) {
        return meeting(seed, accuracy, draw -> draw.shape(draw.between(SMALLEST, LARGEST)));
    }

    /** Two to twelve discs thrown at each other. */
    static RandomScene meetingOfDiscs(long seed, Accuracy accuracy) {
        return meeting(seed, accuracy, draw -> new Circle(draw.between(SMALLEST, LARGEST)));
    }

    /** Two to twelve discs and boxes: they are their own mirror images to the last bit. */
    static RandomScene meetingOfDiscsAndBoxes(long seed, Accuracy accuracy) {
        return meeting(seed, accuracy, draw -> draw.plainShape(draw.between(SMALLEST, LARGEST)));
    }

    private static RandomScene meeting(long seed, Accuracy accuracy, Function<Draw, Shape> shape) {
        Draw draw = new Draw(seed);
        List<BodyDefinition> bodies = new ArrayList<>();
        for (double[] place : draw.places(draw.whole(2, 12), LARGEST, 0.5)) {
            BodyDefinition body =
                    BodyDefinition.dynamic(shape.apply(draw))
                            .at(place[0], place[1])
                            .angle(draw.between(-3, 3))
                            .material(draw.material());
            bodies.add(draw.thrownInwards(body, 8));
        }
        return new RandomScene(seed, SPACE, accuracy, STEPS_OF_A_MEETING, bodies);
    }

    /** A few bodies thrown onto a wide floor, side by side. */
    static RandomScene landing(long seed, Accuracy accuracy, int count) {
        Draw draw = new Draw(seed);
        List<BodyDefinition> bodies = new ArrayList<>();
        bodies.add(BodyDefinition.fixed(Polygon.box(200, 1)).at(0, -0.5).material(draw.material()));
        for (int i = 0; i < count; i++) {
            bodies.add(thrown(draw, 1.1 * i, 0.6 + draw.between(0, 1)));
        }
        return new RandomScene(seed, EARTH, accuracy, STEPS_OF_A_FALL, bodies);
    }

    /** One to twelve bodies thrown about in a tray, where they pile up. */
    static RandomScene tray(long seed, Accuracy accuracy) {
        Draw draw = new Draw(seed);
        double half = draw.between(2, 6);
        BodyDefinition wall = BodyDefinition.fixed(Polygon.box(1, 40)).material(draw.material());
        List<BodyDefinition> bodies = new ArrayList<>();
        bodies.add(
                BodyDefinition.fixed(Polygon.box(2 * half + 2, 1))
                        .at(0, -0.5)
                        .material(draw.material()));
        bodies.add(wall.at(-half - 0.5, 20));
        bodies.add(wall.at(half + 0.5, 20));
        int count = draw.whole(1, 12);
        int perRow = (int) ((2 * half - 0.1) / 1.1);
        for (int i = 0; i < count; i++) {
            double x = 0.6 - half + 1.1 * (i % perRow);
            bodies.add(thrown(draw, x, 0.6 + 1.2 * (i / perRow) + draw.between(0, 0.2)));
        }
        return new RandomScene(seed, EARTH, accuracy, STEPS_OF_A_FALL, bodies);
    }

    /**
     * Up to so many bodies thrown gently into a box six metres wide; friction, little elasticity
     * and rolling resistance bring them to rest.
     */
    static RandomScene settling(long seed, Accuracy accuracy, int most) {
        Draw draw = new Draw(seed);
        Material ground = new Material(1, draw.between(0.4, 1), draw.between(0, 0.5));
        BodyDefinition wall = BodyDefinition.fixed(Polygon.box(1, 40)).material(ground);
        List<BodyDefinition> bodies = new ArrayList<>();
        bodies.add(BodyDefinition.fixed(Polygon.box(40, 1)).at(0, -0.5).material(ground));
        bodies.add(wall.at(-3, 20));
        bodies.add(wall.at(3, 20));
        int count = draw.whole(1, most);
        for (int i = 0; i < count; i++) {
            Material matter =
                    new Material(
                            draw.ofAnySize(0.5, 5), draw.between(0.3, 1), draw.between(0, 0.4));
            bodies.add(
                    BodyDefinition.dynamic(draw.shape(draw.between(SMALLEST, LARGEST)))
                            .at(1.2 * (i % 4 - 1.5), 0.6 + 1.2 * (i / 4))
                            .angle(draw.between(-3, 3))
                            .velocity(draw.between(-2, 2), draw.between(-2, 2))
                            .spin(draw.between(-4, 4))
                            .material(matter.rollingResistance(0.01)));
        }
        Effects effects = EARTH.with(new RollingResistance());
        return new RandomScene(seed, effects, accuracy, STEPS_TO_REST, bodies);
    }

    private static BodyDefinition thrown(Draw draw, double x, double y) {
        return BodyDefinition.dynamic(draw.shape(draw.between(SMALLEST, LARGEST)))
                .at(x, y)
                .angle(draw.between(-3, 3))
                .velocity(draw.between(-5, 5), draw.between(-5, 5))
                .spin(draw.between(-10, 10))
                .material(draw.material());
    }
}
