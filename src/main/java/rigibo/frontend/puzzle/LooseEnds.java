package rigibo.frontend.puzzle;

import rigibo.frontend.puzzle.rules.Link;
import rigibo.frontend.scene.Scene;
import rigibo.frontend.scene.joint.JointPen;
import rigibo.frontend.scene.joint.RopeLine;

import java.util.ArrayList;
import java.util.List;

/**
 * The two parts of each rope that was cut, which fall and then hang from what the rope held. They
 * are drawn and touch nothing: a rope has no mass in the game.
 */
final class LooseEnds {

    /** Length of a piece, m; a shorter part has two pieces all the same. */
    private static final double PIECE = 0.12;

    private static final int FEWEST = 2;

    /** Rounds in which the pieces get their lengths back in each frame. */
    private static final int ROUNDS = 12;

    /** Share of its motion that a point keeps in each frame. */
    private static final double KEPT = 0.985;

    /** By which two ends spring apart, m per frame; without it one could stand upright. */
    private static final double SWING = 0.02;

    /** Radius of the pin that still holds a part, m. */
    private static final double PIN = 0.05;

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

    /** A rope is cut now at a share of its length: its parts begin where it was. */
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

    /** A rope was cut earlier: its parts hang straight down. */
    void hang(Link link, double share) {
        hang(part(link.a(), share * link.definition().length()));
        hang(part(link.b(), (1 - share) * link.definition().length()));
    }

    private static void hang(Part part) {
        if (part.anchor.body().isAlive()) {
            for (int i = 0; i < part.points(); i++) {
                part.at(i, part.anchor.x(), part.anchor.y() - i * part.piece);
            }
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
     */
    void step(double gravityX, double gravityY) {
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
        }
    }

    private static void keepLengths(Part part) {
        double[] xy = part.xy;
        for (int i = 2; i < xy.length; i += 2) {
            double dx = xy[i] - xy[i - 2];
            double dy = xy[i + 1] - xy[i - 1];
            double length = Math.hypot(dx, dy);
            double excess = length > 0 ? (length - part.piece) / length : 0;
            // The anchor gives way to nothing; elsewhere both points take half.
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
