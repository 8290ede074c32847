package rigibo.lab.hardcase;

import rigibo.backend.RigidBody;
import rigibo.backend.setup.BodyType;
import rigibo.lab.truth.Outline;

import java.util.ArrayList;
import java.util.List;

/**
 * Counts pairs that pass through each other within a step, where no overlap is seen before or after
 * it: those whose straight ways from pose to pose lead deep into each other.
 */
final class Passages {

    /** As a share of the smaller width; a rebound from a corner cuts it by less. */
    private static final double DEEP = 0.5;

    /** Poses between the two ends that are looked at. */
    private static final int LOOKS = 8;

    private final List<RigidBody> bodies;
    private final List<Outline> outlines = new ArrayList<>();
    private final double[] x;
    private final double[] y;
    private final double[] angle;

    Passages(List<RigidBody> bodies) {
        this.bodies = List.copyOf(bodies);
        bodies.forEach(body -> outlines.add(new Outline(body.shape())));
        x = new double[bodies.size()];
        y = new double[bodies.size()];
        angle = new double[bodies.size()];
        remember();
    }

    private void remember() {
        for (int i = 0; i < x.length; i++) {
            x[i] = bodies.get(i).x();
            y[i] = bodies.get(i).y();
            angle[i] = bodies.get(i).angle();
        }
    }

    /** How many pairs have passed through each other since the last time it was asked. */
    int count() {
        int passed = 0;
        for (int i = 0; i < x.length; i++) {
            for (int j = i + 1; j < x.length; j++) {
                passed += mayPass(i, j) && passes(i, j) ? 1 : 0;
            }
        }
        remember();
        return passed;
    }

    /** Whether one of them can give way, and they came near enough, fast enough. */
    private boolean mayPass(int i, int j) {
        RigidBody a = bodies.get(i);
        RigidBody b = bodies.get(j);
        double wayX = b.x() - x[j] - a.x() + x[i];
        double wayY = b.y() - y[j] - a.y() + y[i];
        double square = wayX * wayX + wayY * wayY;
        double width = DEEP * width(i, j);
        if (square < width * width || !(moves(a) || moves(b))) {
            return false;
        }
        double fromX = x[j] - x[i];
        double fromY = y[j] - y[i];
        double share = -(fromX * wayX + fromY * wayY) / square;
        double nearest = Math.max(0, Math.min(1, share));
        double distance = Math.hypot(fromX + nearest * wayX, fromY + nearest * wayY);
        return distance < a.shape().boundingRadius() + b.shape().boundingRadius();
    }

    private boolean passes(int i, int j) {
        for (int look = 1; look < LOOKS; look++) {
            place(i, (double) look / LOOKS);
            place(j, (double) look / LOOKS);
            if (outlines.get(i).separation(outlines.get(j)) < -DEEP * width(i, j)) {
                return true;
            }
        }
        return false;
    }

    private void place(int i, double share) {
        RigidBody body = bodies.get(i);
        outlines.get(i)
                .place(
                        x[i] + share * (body.x() - x[i]),
                        y[i] + share * (body.y() - y[i]),
                        angle[i] + share * (body.angle() - angle[i]));
    }

    private double width(int i, int j) {
        return Math.min(
                bodies.get(i).shape().smallestWidth(), bodies.get(j).shape().smallestWidth());
    }

    private static boolean moves(RigidBody body) {
        return body.type() == BodyType.DYNAMIC;
    }
}
