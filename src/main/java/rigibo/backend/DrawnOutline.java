package rigibo.backend;

import rigibo.backend.geometry.Angle;
import rigibo.backend.geometry.Outline;

import java.util.Arrays;

/** The outline of a part of a body as points of the world, round parts as chords. */
final class DrawnOutline {

    /** Chords of a full turn: they stay within 0.5 % of the radius of the circle. */
    private static final int ROUND = 32;

    private static final double[] COS = new double[ROUND];
    private static final double[] SIN = new double[ROUND];

    static {
        for (int i = 0; i < ROUND; i++) {
            COS[i] = Angle.cos(2 * StrictMath.PI * i / ROUND);
            SIN[i] = Angle.sin(2 * StrictMath.PI * i / ROUND);
        }
    }

    /** World coordinates, m; the first {@link #points} of them are set. */
    double[] x = new double[ROUND];

    double[] y = new double[ROUND];
    int points;

    /** Overwrites the points by those of an outline of a body. */
    void trace(RigidBody body, Outline outline) {
        points = 0;
        double radius = outline.radius();
        if (outline.edges() == 0) {
            for (int i = 0; i < ROUND; i++) {
                add(body, outline, 0, radius * COS[i], radius * SIN[i]);
            }
            return;
        }
        for (int corner = 0; corner < outline.corners(); corner++) {
            if (radius == 0) {
                add(body, outline, corner, 0, 0);
            } else {
                turn(body, outline, corner, radius);
            }
        }
    }

    /** The arc about a corner, from the normal of the edge before it to that of the edge after. */
    private void turn(RigidBody body, Outline outline, int corner, double radius) {
        int before = corner == 0 ? outline.edges() - 1 : corner - 1;
        double fromX = radius * outline.normalX(before);
        double fromY = radius * outline.normalY(before);
        double toX = radius * outline.normalX(corner);
        double toY = radius * outline.normalY(corner);
        double angle = Angle.atan2(fromX * toY - fromY * toX, fromX * toX + fromY * toY);
        // By round-off the half turn at the end of a capsule may come out negative.
        angle = angle < 0 ? angle + 2 * StrictMath.PI : angle;
        int chords = Math.max(1, (int) StrictMath.ceil(angle * ROUND / (2 * StrictMath.PI)));
        for (int i = 0; i <= chords; i++) {
            double cos = Angle.cos(angle * i / chords);
            double sin = Angle.sin(angle * i / chords);
            add(body, outline, corner, cos * fromX - sin * fromY, sin * fromX + cos * fromY);
        }
    }

    private void add(RigidBody body, Outline outline, int corner, double aside, double above) {
        if (points == x.length) {
            x = Arrays.copyOf(x, 2 * points);
            y = Arrays.copyOf(y, 2 * points);
        }
        double localX = outline.cornerX(corner) + aside;
        double localY = outline.cornerY(corner) + above;
        x[points] = body.worldX(localX, localY);
        y[points] = body.worldY(localX, localY);
        points++;
    }
}
