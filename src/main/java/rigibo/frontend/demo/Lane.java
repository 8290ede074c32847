package rigibo.frontend.demo;

import rigibo.backend.RigidBody;
import rigibo.backend.geometry.Angle;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.setup.BodyDefinition;
import rigibo.backend.setup.Material;
import rigibo.frontend.scene.Scene;
import rigibo.frontend.scene.Skin;

import java.util.ArrayList;
import java.util.List;

/**
 * A floor at an angle, a box launched up it, and the distance that Coulomb's law predicts for it.
 */
final class Lane {

    private static final double GRAVITY = 9.81;

    /**
     * Length of the floor, m. It exceeds the way of the fastest launch on ice, 8²/(2·0.03·g) = 109
     * m.
     */
    private static final double LENGTH = 120;

    private static final double THICKNESS = 0.4;

    /**
     * Length of the floor behind the start, m; a block at its end catches boxes that slide back.
     */
    private static final double RUN_OUT = 2;

    private static final double BLOCK = 0.3;

    /** Speed below which a box counts as standing, m/s. */
    private static final double STILL = 1e-6;

    /** Width of the box, m, more than its height, since rubber would otherwise tumble the box. */
    private static final double BOX_WIDTH = 0.9;

    private static final double HALF_HEIGHT = 0.3;

    final String name;
    final double friction;

    private final double x;
    private final double y;
    private final Skin skin;
    private final List<RigidBody> parts = new ArrayList<>();
    private RigidBody box;
    private double slope;
    private double launched;
    private double lastSpeed;
    private double slowing;
    private double farthest;
    private boolean hasTurned;

    /** Makes a lane with a coefficient of friction that starts at (x, y), m. */
    Lane(String name, double friction, double x, double y, Skin skin) {
        this.name = name;
        this.friction = friction;
        this.x = x;
        this.y = y;
        this.skin = skin;
    }

    /** Lays the floor at an angle, rad, and launches a box of a mass, kg, up it at a speed, m/s. */
    void launch(Workbench bench, double angle, double speed, double mass) {
        parts.forEach(bench::remove);
        parts.clear();
        slope = angle;
        Polygon ground = Polygon.box(LENGTH, THICKNESS);
        place(bench, BodyDefinition.fixed(ground), LENGTH / 2 - RUN_OUT, -THICKNESS / 2, skin);
        Polygon block = Polygon.box(BLOCK, 2 * HALF_HEIGHT);
        place(bench, BodyDefinition.fixed(block), BLOCK / 2 - RUN_OUT, HALF_HEIGHT, skin);
        BodyDefinition thrown =
                BodyDefinition.dynamic(Polygon.box(BOX_WIDTH, 2 * HALF_HEIGHT))
                        .velocity(speed * Angle.cos(slope), speed * Angle.sin(slope))
                        .mass(mass);
        box = place(bench, thrown, 0, HALF_HEIGHT, Skin.RIGIBO);
        launched = speed;
        lastSpeed = speed;
        farthest = 0;
        hasTurned = false;
    }

    private RigidBody place(
            Workbench bench, BodyDefinition body, double along, double above, Skin look) {
        double px = floorX(along) - above * Angle.sin(slope);
        double py = floorY(along) + above * Angle.cos(slope);
        Material material = new Material(1, friction, 0);
        RigidBody part = bench.add(body.at(px, py).angle(slope).material(material), look);
        parts.add(part);
        return part;
    }

    /**
     * Follows the box. A box that slides back has turned within the step; its farthest point
     * follows from its last speed and deceleration.
     */
    void afterStep() {
        double speed = speed();
        if (!hasTurned && speed <= STILL) {
            hasTurned = true;
            boolean isBack = speed < -STILL;
            farthest = isBack ? farthest + lastSpeed * lastSpeed / (2 * slowing) : gone();
        } else if (!hasTurned) {
            farthest = gone();
        }
        slowing = (lastSpeed - speed) / Scene.STEP;
        lastSpeed = speed;
    }

    /** Speed of the box up the floor, m/s. */
    private double speed() {
        return box.velocityX() * Angle.cos(slope) + box.velocityY() * Angle.sin(slope);
    }

    /** Distance of the box up the floor from where it was launched, m. */
    double gone() {
        return (box.x() - x) * Angle.cos(slope) + (box.y() - y) * Angle.sin(slope);
    }

    /** Distance that the box should reach, v²/(2g(μ·cos + sin)), m. */
    double predicted() {
        double held = GRAVITY * (friction * Angle.cos(slope) + Angle.sin(slope));
        return launched * launched / (2 * held);
    }

    /** Largest distance that the box has reached so far, m. */
    double farthest() {
        return farthest;
    }

    /** Whether the box has reached its largest distance. */
    boolean hasTurned() {
        return hasTurned;
    }

    /** Whether friction holds the box where it stops, which it does up to the angle arctan μ. */
    boolean holds() {
        return Angle.sin(slope) <= friction * Angle.cos(slope);
    }

    boolean isStill() {
        return Math.abs(speed()) <= STILL;
    }

    /** Energy that the floor has taken from the launch, J. */
    double heat() {
        double given = box.mass() * launched * launched / 2;
        double risen = box.mass() * GRAVITY * (box.y() - y - HALF_HEIGHT * Angle.cos(slope));
        return given - box.kineticEnergy() - risen;
    }

    /** World x of a position on the floor, given in m from the start. */
    double floorX(double along) {
        return x + along * Angle.cos(slope);
    }

    /** World y of a position on the floor, given in m from the start. */
    double floorY(double along) {
        return y + along * Angle.sin(slope);
    }
}
