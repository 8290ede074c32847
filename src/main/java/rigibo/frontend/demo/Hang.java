package rigibo.frontend.demo;

import rigibo.backend.Joint;
import rigibo.backend.RevoluteJoint;
import rigibo.backend.RigidBody;
import rigibo.backend.geometry.Angle;
import rigibo.backend.geometry.Capsule;
import rigibo.backend.geometry.Circle;
import rigibo.backend.geometry.Logarithm;
import rigibo.backend.setup.BodyDefinition;
import rigibo.frontend.scene.Skin;

import java.util.ArrayList;
import java.util.List;

/**
 * Pendulums hung from a pin at the origin: bobs on stiff massless rods, or a chain of light links
 * with a weight at its end. They start straight, at rest, at an angle.
 */
final class Hang {

    static final double G = 9.81;

    /** Of the force that the pin bears while a chain hangs still. */
    static final String PULL = "m·g";

    /** Number of links of the chain. */
    static final int LINKS = 30;

    private static final double LINK_MASS = 0.02;
    private static final double LINK_RADIUS = 0.011;
    private static final double BOB_MASS = 1;
    private static final double BOB_RADIUS = 0.14;

    /** Radius that a weight gains per power of ten of its mass, m. */
    private static final double LARGER = 0.035;

    /** Group in which bodies of the pendulum do not collide with each other. */
    private static final int GROUP = 1;

    /** The three kinds, in the order of the control. */
    enum Kind {
        SINGLE("pendulum.single"),
        DOUBLE("pendulum.double"),
        CHAIN("pendulum.chain");

        final String key;

        Kind(String key) {
            this.key = key;
        }
    }

    final Kind kind;
    final double length;

    /** The bodies, from the pin down. */
    final List<RigidBody> bodies = new ArrayList<>();

    final List<Joint> joints = new ArrayList<>();

    private final Workbench bench;
    private final double angle;
    private RigidBody pin;

    /**
     * Hangs the pendulum up.
     *
     * @param length from the pin to the middle of the last bob, m
     * @param angle from the vertical, rad, to the right
     * @param ratio of the lowest mass to the mass it hangs on
     */
    Hang(Workbench bench, Kind kind, double length, double angle, double ratio) {
        this.bench = bench;
        this.kind = kind;
        this.length = length;
        this.angle = angle;
        pin = bench.add(BodyDefinition.fixed(new Circle(0.07)).at(0, 0).group(GROUP), Skin.IRON);
        switch (kind) {
            case SINGLE -> rods(1, BOB_MASS);
            case DOUBLE -> rods(2, BOB_MASS * ratio);
            case CHAIN -> chain(ratio);
        }
    }

    private void rods(int count, double lowest) {
        RigidBody above = pin;
        for (int i = 1; i <= count; i++) {
            double mass = i == count ? lowest : BOB_MASS;
            RigidBody bob = bob(length * i / count, mass, BOB_RADIUS);
            joints.add(bench.join(RevoluteJoint.at(above, bob, above.x(), above.y())));
            above = bob;
        }
    }

    private void chain(double ratio) {
        RigidBody above = pin;
        double half = length / LINKS / 2;
        for (int i = 0; i < LINKS; i++) {
            double way = (2 * i + 1) * half;
            RigidBody link =
                    add(
                            BodyDefinition.dynamic(new Capsule(half, LINK_RADIUS))
                                    .angle(angle - Math.PI / 2)
                                    .mass(LINK_MASS),
                            way,
                            Skin.STONE);
            hinge(above, link, way - half);
            above = link;
        }
        double size = 0.08 + LARGER * Logarithm.log(ratio) / Logarithm.log(10);
        hinge(above, bob(length, LINK_MASS * ratio, size), length);
    }

    private void hinge(RigidBody above, RigidBody below, double way) {
        joints.add(bench.join(RevoluteJoint.at(above, below, x(way), y(way))));
    }

    private RigidBody bob(double way, double mass, double radius) {
        return add(BodyDefinition.dynamic(new Circle(radius)).mass(mass), way, Skin.BALL);
    }

    private RigidBody add(BodyDefinition body, double way, Skin skin) {
        RigidBody added = bench.add(body.at(x(way), y(way)).group(GROUP), skin);
        bodies.add(added);
        return added;
    }

    private double x(double way) {
        return way * Angle.sin(angle);
    }

    private double y(double way) {
        return -way * Angle.cos(angle);
    }

    /** Takes it down. */
    void remove() {
        bodies.forEach(bench::remove);
        bench.remove(pin);
    }

    RigidBody last() {
        return bodies.get(bodies.size() - 1);
    }

    /** Whether the pendulum still hangs; undeclaring joints removes all of them. */
    boolean isWhole() {
        return joints.stream().allMatch(Joint::isAlive);
    }

    /** Energy of motion, and of height above the position in which it hangs straight down, J. */
    double energy() {
        double sum = 0;
        for (RigidBody body : bodies) {
            sum += body.kineticEnergy() + body.mass() * G * body.y();
        }
        return sum - lowest();
    }

    private double lowest() {
        double sum = 0;
        for (int i = 0; i < bodies.size(); i++) {
            double depth =
                    switch (kind) {
                        case SINGLE, DOUBLE -> length * (i + 1) / bodies.size();
                        case CHAIN -> i < LINKS ? (i + 0.5) * length / LINKS : length;
                    };
            sum -= bodies.get(i).mass() * G * depth;
        }
        return sum;
    }

    /** Weight of all that hangs, N. */
    double weight() {
        return G * bodies.stream().mapToDouble(RigidBody::mass).sum();
    }

    /** Sum of the gaps at all joints, as a share of the pendulum's length. */
    double stretch() {
        return joints.stream().mapToDouble(Joint::error).sum() / length;
    }

    /** Force that the pin carries, N, as the mean over the last step. */
    double tension() {
        return joints.get(0).reactionForce();
    }
}
