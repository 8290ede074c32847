package rigibo.tutorial;

import rigibo.backend.DebugDraw;
import rigibo.backend.DistanceJoint;
import rigibo.backend.Joint;
import rigibo.backend.Pool;
import rigibo.backend.RigidBody;
import rigibo.backend.effect.Effects;
import rigibo.backend.effect.Joints;
import rigibo.backend.effect.Sensors;
import rigibo.backend.geometry.Circle;
import rigibo.backend.geometry.Compound;
import rigibo.backend.geometry.Part;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.setup.Accuracy;
import rigibo.backend.setup.BodyDefinition;

/** Chapter 7: a small game. Cut the rope at the right time, and the ball falls into the bucket. */
public final class CutTheRope {

    static final double STEP = 1.0 / 60; // s
    static final double GRAVITY = 9.81; // m/s²
    static final double LENGTH = 2; // m
    static final double BUCKET = 3; // m, right of the nail

    private final Pool pool;

    private CutTheRope(Pool pool) {
        this.pool = pool;
    }

    /** A game at its beginning: the ball is held beside the nail, the rope taut. */
    static CutTheRope begin(Accuracy accuracy) {
        Effects effects = Effects.usual().with(new Joints()).with(new Sensors());
        Pool pool = new Pool(effects, accuracy);
        RigidBody nail = pool.add(BodyDefinition.fixed(Polygon.box(0.2, 0.2)).at(0, 5));
        RigidBody ball = pool.add(BodyDefinition.dynamic(new Circle(0.15)).at(-LENGTH, 5));
        pool.join(DistanceJoint.rope(nail, 0, 5, ball, -LENGTH, 5, LENGTH));
        Compound bucket =
                Compound.of(
                        Part.of(Polygon.box(0.8, 0.1)),
                        Part.of(Polygon.box(0.1, 0.9)).at(-0.45, 0.4),
                        Part.of(Polygon.box(0.1, 0.9)).at(0.45, 0.4),
                        Part.of(Polygon.box(0.7, 0.3)).at(0, 0.25).sensor());
        pool.add(BodyDefinition.fixed(bucket).at(BUCKET, 0.05 + bucket.centroidY()));
        return new CutTheRope(pool);
    }

    Pool pool() {
        return pool;
    }

    RigidBody ball() {
        return pool.bodies().get(1);
    }

    RigidBody bucket() {
        return pool.bodies().get(2);
    }

    /** The player's only verb. */
    void cut() {
        pool.remove(pool.joints().get(0));
    }

    void step() {
        pool.step(STEP);
    }

    boolean isWon() {
        return pool.isInside(bucket(), ball());
    }

    boolean isLost() {
        return ball().y() < -1;
    }

    /** A copy of the game's present state, at another accuracy. */
    CutTheRope copy(Accuracy accuracy) {
        CutTheRope copy = new CutTheRope(Pool.restore(pool.snapshot()));
        copy.pool.accuracy(accuracy);
        return copy;
    }

    /** Cuts the rope, and goes on to the end of the game. */
    boolean winsIfCutNow() {
        cut();
        while (!isWon() && !isLost()) {
            step();
        }
        return isWon();
    }

    /** Digits of the kinetic energy that agree with m·g·h, h being how far the ball fell. */
    int digits() {
        double fallen = GRAVITY * (5 - ball().y()) * ball().mass();
        return (int) -Math.log10(Math.abs(pool.kineticEnergy() / fallen - 1));
    }

    private static void play(String name, Accuracy accuracy, int steps) {
        CutTheRope game = begin(accuracy);
        for (int i = 0; i < steps; i++) {
            game.step();
        }
        int digits = game.digits();
        System.out.printf("%s keeps %d digits, wins: %b%n", name, digits, game.winsIfCutNow());
    }

    /** Draws outlines and joints as a picture in SVG, whose y points down. */
    static final class SvgPen implements DebugDraw {

        final StringBuilder svg = new StringBuilder();

        @Override
        public void outline(RigidBody body, double[] x, double[] y, int points, Look look) {
            svg.append("<polygon fill='").append(look == Look.SENSOR ? "none" : "teal");
            svg.append("' points='");
            for (int i = 0; i < points; i++) {
                svg.append(x[i]).append(',').append(-y[i]).append(' ');
            }
            svg.append("'/>\n");
        }

        @Override
        public void joint(Joint joint) {
            svg.append("<line x1='").append(joint.xA()).append("' y1='").append(-joint.yA());
            svg.append("' x2='").append(joint.xB()).append("' y2='").append(-joint.yB());
            svg.append("' stroke='black'/>\n");
        }
    }

    /** Finds by trial when to cut, then plays that at every accuracy. */
    public static void main(String[] arguments) {
        CutTheRope game = begin(Accuracy.GAME);
        int steps = 0;
        while (!game.copy(Accuracy.DRAFT).winsIfCutNow()) {
            game.step();
            steps++;
        }
        System.out.printf("cut after %d steps%n", steps);
        SvgPen pen = new SvgPen();
        game.pool.draw(pen, DebugDraw.Layer.SHAPES, DebugDraw.Layer.JOINTS);
        System.out.printf("drawn with %d lines of SVG%n", pen.svg.toString().lines().count());
        play("DRAFT", Accuracy.DRAFT, steps);
        play("GAME", Accuracy.GAME, steps);
        play("FINE", Accuracy.FINE, steps);
        play("EXACT", Accuracy.EXACT, steps);
    }
}
