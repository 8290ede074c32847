package rigibo.lab.hardcase;

import rigibo.backend.geometry.Angle;
import rigibo.backend.setup.BodyDefinition;
import rigibo.lab.truth.Solid;

import java.util.ArrayList;
import java.util.List;

/**
 * A bowl of n flat plates whose upper faces are chords of the lower half of a circle about the
 * origin. Two neighbours meet in a kink of the angle δ = π/n.
 *
 * @param radius of the circle, m
 * @param plates n
 * @param lap length of a plate, in chords
 */
record PlateBowl(double radius, int plates, double lap) {

    private static final double THICKNESS = 0.5;

    /** Plates that end where they meet. */
    static final double BUTTED = 1;

    /** Plates that reach below the faces of their neighbours, so that no face ends in a corner. */
    static final double LAPPED = 1.4;

    /** Angle of a kink, rad. */
    double kink() {
        return Math.PI / plates;
    }

    /** Length of a plate's face, m. */
    double length() {
        return 2 * radius * Angle.sin(kink() / 2);
    }

    /** Slope of a plate against the horizontal, rad; from the left −π/2 to π/2. */
    double slope(int plate) {
        return -Math.PI / 2 + (plate + 0.5) * kink();
    }

    /** The plate whose slope is nearest to an angle, rad. */
    int plateAt(double angle) {
        return (int) ((angle + Math.PI / 2) / kink());
    }

    /** The plates, smooth. */
    List<BodyDefinition> bodies() {
        List<BodyDefinition> bodies = new ArrayList<>();
        for (int plate = 0; plate < plates; plate++) {
            double[] at = on(plate, 0, -THICKNESS / 2);
            bodies.add(
                    Solid.fixed(lap * length(), THICKNESS, 0, 0)
                            .at(at[0], at[1])
                            .angle(slope(plate)));
        }
        return bodies;
    }

    /**
     * The point at a distance along a plate from its middle, uphill to the right, and at a height
     * above its face.
     */
    double[] on(int plate, double along, double above) {
        double cos = Angle.cos(slope(plate));
        double sin = Angle.sin(slope(plate));
        double apothem = radius * Angle.cos(kink() / 2);
        return new double[] {
            along * cos + (apothem - above) * sin, along * sin - (apothem - above) * cos
        };
    }

    /**
     * Heights of a disc's centre where it touches two plates, m, from the left.
     *
     * @param disc its radius, m
     */
    double[] discAtKinks(double disc) {
        double[] heights = new double[plates - 1];
        for (int i = 0; i < heights.length; i++) {
            double half = (radius * Math.cos(kink() / 2) - disc) * Math.tan(kink() / 2);
            heights[i] = on(i, half, disc)[1];
        }
        return heights;
    }

    /**
     * Heights of a box's centre where its leading corner and where its trailing corner is at a
     * kink, m, from the left.
     */
    double[] boxAtKinks(double width, double height) {
        double[] heights = new double[2 * (plates - 1)];
        double end = length() / 2 - width / 2;
        for (int i = 0; i < plates - 1; i++) {
            heights[2 * i] = on(i, end, height / 2)[1];
            heights[2 * i + 1] = on(i + 1, -end, height / 2)[1];
        }
        return heights;
    }
}
