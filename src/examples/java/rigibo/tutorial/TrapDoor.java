package rigibo.tutorial;

import rigibo.backend.HitEvent;
import rigibo.backend.Pool;
import rigibo.backend.RayHit;
import rigibo.backend.RigidBody;
import rigibo.backend.SensorEvent;
import rigibo.backend.effect.Effects;
import rigibo.backend.effect.Sensors;
import rigibo.backend.geometry.Circle;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.setup.Accuracy;
import rigibo.backend.setup.BodyDefinition;

/** Chapter 4: a sensor opens a door for a ball that falls. */
public final class TrapDoor {

    static final double STEP = 1.0 / 60; // s
    static final double GRAVITY = 9.81; // m/s²
    static final double TOP = 6.2; // m, of the ball's centre
    static final double ABOVE = 1; // m, from the eye to the ball

    /** The bodies that the program asks about. */
    record Trap(RigidBody ball, RigidBody eye, RigidBody door) {}

    private TrapDoor() {}

    /** The usual effects, and sensors. */
    static Pool open() {
        return new Pool(Effects.usual().with(new Sensors()), Accuracy.GAME);
    }

    /** Adds a floor, a door above it, an eye above the door, and a ball above the eye. */
    static Trap build(Pool pool) {
        pool.add(BodyDefinition.fixed(Polygon.box(8, 1)).at(0, -0.5).name("floor"));
        RigidBody door =
                pool.add(BodyDefinition.kinematic(Polygon.box(1.6, 0.2)).at(0, 1.9).name("door"));
        RigidBody eye =
                pool.add(BodyDefinition.fixed(Polygon.box(1.6, 1)).at(0, 5.5 - ABOVE).sensor());
        RigidBody ball = pool.add(BodyDefinition.dynamic(new Circle(0.2)).at(0, TOP).name("ball"));
        return new Trap(ball, eye, door);
    }

    /** Moves the door aside once the ball is in the eye. */
    static boolean opens(Pool pool, Trap trap) {
        for (SensorEvent event : pool.sensorEvents()) {
            if (event.phase() == SensorEvent.Phase.ENTERED && event.sensor() == trap.eye()) {
                trap.door().driveTo(-1.8, 1.9, 0, 0.3);
                return true;
            }
        }
        return false;
    }

    /**
     * Prints the distance to the body below the ball, the step in which the eye sees the ball, and
     * its speed at the floor.
     */
    public static void main(String[] arguments) {
        Pool pool = open();
        Trap trap = build(pool);
        RayHit below = pool.rayCast(0, TOP, 0, -1).orElseThrow();
        System.out.printf(
                "%.1f m below the ball is the %s%n", TOP - 0.2 - below.y(), below.body().name());
        int steps = 0;
        boolean isOpen = false;
        while (pool.hits().isEmpty()) {
            pool.step(STEP);
            steps++;
            if (!isOpen && opens(pool, trap)) {
                isOpen = true;
                double fall = Math.sqrt(2 * ABOVE / GRAVITY);
                System.out.printf(
                        "the eye sees it in step %d, by formula %.0f%n",
                        steps, Math.ceil(fall / STEP));
            }
        }
        HitEvent hit = pool.hits().get(0);
        double speed = Math.sqrt(2 * GRAVITY * (TOP - 0.2));
        System.out.printf(
                "lands on the %s at %.3f m/s, by formula %.3f m/s%n",
                hit.a() == trap.ball() ? hit.b().name() : hit.a().name(), hit.speed(), speed);
    }
}
