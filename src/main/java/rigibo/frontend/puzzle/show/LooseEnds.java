package rigibo.frontend.puzzle.show;

import rigibo.backend.Pool;
import rigibo.backend.RayHit;
import rigibo.frontend.puzzle.picture.Part;
import rigibo.frontend.puzzle.rules.Link;
import rigibo.frontend.scene.Scene;
import rigibo.frontend.scene.joint.JointPen;
import rigibo.frontend.scene.joint.RopeLine;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/**
 * The two parts of each rope that was cut, which fall and then hang from their bodies, or lie on
 * bodies below. They are drawn but push nothing: a rope has no mass in the game.
 */
final class LooseEnds {

    /** Length of a piece, m; a shorter part still has two pieces. */
    private static final double PIECE = 0.12;

    private static final int FEWEST = 2;

    /** Iterations that restore the lengths of the pieces in each frame. */
    private static final int ROUNDS = 12;

    /** Share of its velocity that a point keeps in each frame. */
    private static final double KEPT = 0.985;

    /**
     * Speed at which the two ends spring apart, m per frame; without it an end could stand upright.
     */
    private static final double SWING = 0.02;

    /** Radius of the pin that holds a part, m. */
    private static final double PIN = 0.05;

    /** Distance from a surface to the middle of a cord that lies on it, m. */
    private static final double LIES = 0.03;

    private final List<Part> parts = new ArrayList<>();

    /** A part of a rope: points from the anchor to the loose end, now and a frame ago. */
    private static final class Part {
        final Link.Anchor anchor;
        final double[] xy;
        final double[] before;
        final double piece;

        Part(Link.Anchor anchor, int pieces, double length) {
            this.anchor = anchor;
            xy = new double[2 * (pieces + 1)];
            before = new double[xy.length];
            piece = length / pieces;
        }

        void at(int point, double x, double y) {
            xy[2 * point] = x;
            xy[2 * point + 1] = y;
            before[2 * point] = x;
            before[2 * point + 1] = y;
        }

        /** Gives the loose end a speed to the right, m per frame. */
        void swing(double perFrame) {
            before[before.length - 2] -= perFrame;
        }

        int points() {
            return xy.length / 2;
        }
    }

    void clear() {
        parts.clear();
    }

    /** A rope is cut now at a share of its length: its parts begin at its place. */
    void cut(Link link, double share) {
        RopeLine line = link.line();
        Part a = part(link.a(), share * link.definition().length());
        Part b = part(link.b(), (1 - share) * link.definition().length());
        for (int i = 0; i < a.points(); i++) {
            double at = share * i / (a.points() - 1.0);
            a.at(i, line.x(at), line.y(at));
        }
        a.swing(-SWING);
        for (int i = 0; i < b.points(); i++) {
            double at = 1 - (1 - share) * i / (b.points() - 1.0);
            b.at(i, line.x(at), line.y(at));
        }
        b.swing(SWING);
    }

    /** A rope was cut earlier: its parts hang straight down, until they meet a body. */
    void hang(Link link, double share, Pool pool) {
        hang(part(link.a(), share * link.definition().length()), pool);
        hang(part(link.b(), (1 - share) * link.definition().length()), pool);
    }

    private static void hang(Part part, Pool pool) {
        if (!part.anchor.body().isAlive()) {
            return;
        }
        part.at(0, part.anchor.x(), part.anchor.y());
        for (int i = 1; i < part.points(); i++) {
            double x = part.xy[2 * i - 2];
            double y = part.xy[2 * i - 1];
            part.at(i, x, y - part.piece);
            lay(part, i, x, y, pool);
        }
    }

    /** Stops a point that came from (x, y) at the first body on its way, except its own. */
    private static void lay(Part part, int point, double x, double y, Pool pool) {
        Optional<RayHit> met = pool.rayCast(x, y, part.xy[2 * point], part.xy[2 * point + 1]);
        if (met.isPresent() && !met.get().body().equals(part.anchor.body())) {
            RayHit hit = met.get();
            part.at(point, hit.x() + LIES * hit.normalX(), hit.y() + LIES * hit.normalY());
        }
    }

    private Part part(Link.Anchor anchor, double length) {
        int pieces = Math.max(FEWEST, (int) Math.round(length / PIECE));
        Part part = new Part(anchor, pieces, length);
        parts.add(part);
        return part;
    }

    /**
     * Makes one frame of 1/60 s, by Verlet's method.
     *
     * @param gravityX m/s²
     * @param gravityY m/s², up
     * @param pool the bodies on which the parts may lie
     */
    void step(double gravityX, double gravityY, Pool pool) {
        parts.removeIf(part -> !part.anchor.body().isAlive());
        double fallX = gravityX * Scene.STEP * Scene.STEP;
        double fallY = gravityY * Scene.STEP * Scene.STEP;
        for (Part part : parts) {
            for (int i = 2; i < part.xy.length; i++) {
                double now = part.xy[i];
                double fall = i % 2 == 0 ? fallX : fallY;
                part.xy[i] += KEPT * (now - part.before[i]) + fall;
                part.before[i] = now;
            }
            part.xy[0] = part.anchor.x();
            part.xy[1] = part.anchor.y();
            for (int round = 0; round < ROUNDS; round++) {
                keepLengths(part);
            }
            for (int i = 1; i < part.points(); i++) {
                lay(part, i, part.before[2 * i], part.before[2 * i + 1], pool);
            }
        }
    }

    private static void keepLengths(Part part) {
        double[] xy = part.xy;
        for (int i = 2; i < xy.length; i += 2) {
            double dx = xy[i] - xy[i - 2];
            double dy = xy[i + 1] - xy[i - 1];
            double length = Math.hypot(dx, dy);
            double excess = length > 0 ? (length - part.piece) / length : 0;
            // The anchor does not give way; elsewhere both points take half.
            double share = i == 2 ? 0 : 0.5;
            xy[i - 2] += share * excess * dx;
            xy[i - 1] += share * excess * dy;
            xy[i] -= (1 - share) * excess * dx;
            xy[i + 1] -= (1 - share) * excess * dy;
        }
    }

    void draw(JointPen pen) {
        for (Part part : parts) {
            pen.cord(part.xy, part.points());
            pen.pin(part.xy[0], part.xy[1], PIN, part.anchor.body().angle());
        }
    }
}
