package rigibo.backend;

import rigibo.backend.effect.Contacts;
import rigibo.backend.effect.ContinuousImpacts;
import rigibo.backend.effect.Effects;
import rigibo.backend.effect.Friction;
import rigibo.backend.effect.Gravity;
import rigibo.backend.effect.Joints;
import rigibo.backend.effect.Restitution;
import rigibo.backend.effect.Rotation;
import rigibo.backend.effect.Sleep;
import rigibo.backend.geometry.Circle;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.setup.Accuracy;
import rigibo.backend.setup.BodyDefinition;

/** Parts that scenes with joined bodies share. */
final class JointScenes {

    static final double G = 9.81;

    /** Joined bodies that meet, without weight. */
    static final Effects SPACE =
            Effects.of(
                    new Contacts(),
                    new ContinuousImpacts(),
                    new Rotation(),
                    new Restitution(),
                    new Joints());

    static final Effects EARTH = SPACE.with(new Gravity(0, -G));

    /** Joined bodies that rub and may sleep, with weight; nobody looks for impacts in flight. */
    static final Effects ROUGH_EARTH =
            Effects.of(
                    new Contacts(),
                    new Rotation(),
                    new Friction(),
                    new Restitution(),
                    new Sleep(),
                    new Gravity(0, -G),
                    new Joints());

    private JointScenes() {}

    static Accuracy accuracy(String preset) {
        return preset.equals("EXACT") ? Accuracy.EXACT : Accuracy.GAME;
    }

    /** The energy of motion, height and springs, J. */
    static double energy(Pool pool) {
        double springs = pool.joints().stream().mapToDouble(Joint::energy).sum();
        return pool.kineticEnergy() + pool.potentialEnergy() + springs;
    }

    /** The body that joints hang from. */
    static RigidBody hook(Pool pool, double x, double y) {
        return pool.add(BodyDefinition.fixed(Polygon.box(0.1, 0.1)).at(x, y).group(1));
    }

    /** A box of some width and height, m. */
    static RigidBody bone(Pool pool, double x, double y, double width, double height) {
        return pool.add(BodyDefinition.dynamic(Polygon.box(width, height)).at(x, y));
    }

    private static void bend(Pool pool, RigidBody a, RigidBody b, double x, double y) {
        pool.join(RevoluteJoint.at(a, b, x, y).limits(-0.8, 0.8).motor(0, 1));
    }

    /** Eleven bodies, ten hinges with limits and a motor that only brakes; x and y of its chest. */
    static void addRagdoll(Pool pool, double x, double y) {
        RigidBody chest = bone(pool, x, y, 0.4, 0.3);
        RigidBody belly = bone(pool, x, y - 0.3, 0.35, 0.3);
        bend(pool, chest, belly, x, y - 0.15);
        RigidBody head = pool.add(BodyDefinition.dynamic(new Circle(0.15)).at(x, y + 0.3));
        bend(pool, chest, head, x, y + 0.15);
        for (int side = -1; side <= 1; side += 2) {
            RigidBody arm = bone(pool, x + side * 0.35, y + 0.1, 0.3, 0.1);
            bend(pool, chest, arm, x + side * 0.2, y + 0.1);
            RigidBody hand = bone(pool, x + side * 0.65, y + 0.1, 0.3, 0.09);
            bend(pool, arm, hand, x + side * 0.5, y + 0.1);
            RigidBody thigh = bone(pool, x + side * 0.1, y - 0.65, 0.14, 0.4);
            bend(pool, belly, thigh, x + side * 0.1, y - 0.45);
            RigidBody shin = bone(pool, x + side * 0.1, y - 1.05, 0.12, 0.4);
            bend(pool, thigh, shin, x + side * 0.1, y - 0.85);
        }
    }
}
