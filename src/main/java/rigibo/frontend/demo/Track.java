package rigibo.frontend.demo;

import rigibo.backend.Joint;
import rigibo.backend.RevoluteJoint;
import rigibo.backend.RigidBody;
import rigibo.backend.geometry.Angle;
import rigibo.backend.geometry.Chain;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.setup.BodyDefinition;
import rigibo.backend.setup.Material;
import rigibo.frontend.scene.Skin;

import java.util.ArrayList;
import java.util.List;

/** A track for a car, from the left: level ground, a hill, a bridge of planks, a see-saw. */
final class Track {

    static final double START = -9;
    static final double END = 60;

    private static final double HILL_FROM = 6;
    private static final double HILL_TO = 20;
    private static final double HILL_HEIGHT = 1.3;
    private static final int HILL_PIECES = 56;
    private static final double GAP_FROM = 23;
    private static final double GAP_TO = 33;
    private static final double GAP_DEPTH = 4;
    private static final int PLANKS = 20;

    /**
     * Ratio of the bridge's length to its gap; a longer bridge sags more and bears more with less
     * tension.
     */
    private static final double SLACK = 1.02;

    private static final double PLANK_MASS = 25;
    private static final double PLANK_THICKNESS = 0.12;
    private static final double SEESAW_X = 44;
    private static final double SEESAW_HEIGHT = 0.42;
    private static final double SEESAW_LENGTH = 5;
    private static final double SEESAW_LEAN = 0.14;
    private static final Material ROAD = new Material(1, 0.9, 0);
    private static final int BISECTIONS = 60;

    private final Workbench bench;
    private final List<Joint> joints = new ArrayList<>();
    private final List<RigidBody> parts = new ArrayList<>();
    private final RigidBody ground;
    private final List<RigidBody> planks = new ArrayList<>();
    private RigidBody seesaw;

    Track(Workbench bench) {
        this.bench = bench;
        ground = bench.add(BodyDefinition.fixed(outline()).material(ROAD), Skin.STONE);
        parts.add(ground);
        layBridge();
        laySeesaw();
    }

    /** Corners from right to left, since the ground lies to the left of a chain's direction. */
    private static Chain outline() {
        List<Double> xy = new ArrayList<>();
        corner(xy, END, 3);
        corner(xy, END, 0);
        corner(xy, GAP_TO, 0);
        corner(xy, GAP_TO, -GAP_DEPTH);
        corner(xy, GAP_FROM, -GAP_DEPTH);
        corner(xy, GAP_FROM, 0);
        for (int i = HILL_PIECES; i >= 0; i--) {
            double t = (double) i / HILL_PIECES;
            double height = HILL_HEIGHT / 2 * (1 - Angle.cos(2 * Math.PI * t));
            corner(xy, HILL_FROM + t * (HILL_TO - HILL_FROM), height);
        }
        corner(xy, START, 0);
        corner(xy, START, 3);
        return Chain.open(xy.stream().mapToDouble(Double::doubleValue).toArray());
    }

    private static void corner(List<Double> xy, double x, double y) {
        xy.add(x);
        xy.add(y);
    }

    /**
     * Lays the planks along the funicular polygon of their own weight, so that the bridge begins at
     * rest. Plank k of n leans by tan θ = (2k − n − 1)·w/(2H), with H chosen so that the bridge
     * spans the gap.
     */
    private void layBridge() {
        double length = SLACK * (GAP_TO - GAP_FROM) / PLANKS;
        double low = 1e-3;
        double high = 1e3;
        for (int i = 0; i < BISECTIONS; i++) {
            double middle = Math.sqrt(low * high);
            if (span(length, middle) < GAP_TO - GAP_FROM) {
                low = middle;
            } else {
                high = middle;
            }
        }
        double x = GAP_FROM;
        double y = -PLANK_THICKNESS / 2;
        RigidBody before = ground;
        for (int k = 1; k <= PLANKS; k++) {
            double angle = lean(k, high);
            double dx = length * Angle.cos(angle);
            double dy = length * Angle.sin(angle);
            RigidBody plank = plank(length, x + dx / 2, y + dy / 2, angle);
            joints.add(bench.join(RevoluteJoint.at(before, plank, x, y)));
            x += dx;
            y += dy;
            before = plank;
        }
        joints.add(bench.join(RevoluteJoint.at(before, ground, x, y)));
    }

    private static double lean(int plank, double pull) {
        return Angle.atan2(2 * plank - PLANKS - 1, 2 * pull);
    }

    private static double span(double length, double pull) {
        double sum = 0;
        for (int k = 1; k <= PLANKS; k++) {
            sum += length * Angle.cos(lean(k, pull));
        }
        return sum;
    }

    private RigidBody plank(double length, double x, double y, double angle) {
        RigidBody plank =
                bench.add(
                        BodyDefinition.dynamic(Polygon.box(length, PLANK_THICKNESS))
                                .at(x, y)
                                .angle(angle)
                                .mass(PLANK_MASS)
                                .material(ROAD),
                        Skin.WOOD);
        planks.add(plank);
        parts.add(plank);
        return plank;
    }

    private void laySeesaw() {
        RigidBody stand =
                bench.add(
                        BodyDefinition.fixed(
                                        Polygon.of(
                                                -0.3,
                                                0,
                                                0.3,
                                                0,
                                                0.06,
                                                SEESAW_HEIGHT - 0.1,
                                                -0.06,
                                                SEESAW_HEIGHT - 0.1))
                                .at(SEESAW_X, 0.1),
                        Skin.IRON);
        seesaw =
                bench.add(
                        BodyDefinition.dynamic(Polygon.box(SEESAW_LENGTH, PLANK_THICKNESS))
                                .at(SEESAW_X, SEESAW_HEIGHT)
                                .angle(SEESAW_LEAN)
                                .mass(60)
                                .material(ROAD),
                        Skin.WOOD);
        parts.add(stand);
        parts.add(seesaw);
        joints.add(bench.join(RevoluteJoint.at(stand, seesaw, SEESAW_X, SEESAW_HEIGHT)));
    }

    boolean isWhole() {
        return joints.stream().allMatch(Joint::isAlive);
    }

    void remove() {
        parts.forEach(bench::remove);
    }

    /** Depth of the bridge's lowest plank below the road, m. */
    double sag() {
        double lowest = planks.stream().mapToDouble(RigidBody::y).min().orElseThrow();
        return -lowest - PLANK_THICKNESS / 2;
    }

    /** Largest tension in the bridge, N, as the mean over the last step. */
    double pull() {
        double most = 0;
        for (int i = 0; i <= PLANKS && isWhole(); i++) {
            most = Math.max(most, joints.get(i).reactionForce());
        }
        return most;
    }

    /** The widest gap of a joint, m. */
    double gap() {
        return isWhole() ? joints.stream().mapToDouble(Joint::error).max().orElse(0) : 0;
    }

    /** rad, counter-clockwise. */
    double lean() {
        return seesaw.angle();
    }
}
