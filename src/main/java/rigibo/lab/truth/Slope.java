package rigibo.lab.truth;

import rigibo.backend.geometry.Angle;
import rigibo.backend.setup.BodyDefinition;
import rigibo.backend.setup.Material;

/**
 * A fixed plank whose upper face passes through the origin and falls to the right.
 *
 * @param angle rad below the horizontal
 */
public record Slope(double angle) {

    private static final double LENGTH = 400;
    private static final double THICKNESS = 2;

    /** The plank, of a material. */
    public BodyDefinition plank(Material material) {
        double x = -THICKNESS / 2 * Angle.sin(angle);
        double y = -THICKNESS / 2 * Angle.cos(angle);
        return Solid.fixed(LENGTH, THICKNESS).at(x, y).angle(-angle).material(material);
    }

    /** A body at the origin, its centre at a height above the face. */
    public BodyDefinition place(BodyDefinition body, double above) {
        return body.at(above * Angle.sin(angle), above * Angle.cos(angle)).angle(-angle);
    }

    /** The component of a vector down the slope. */
    public double down(double x, double y) {
        return x * Math.cos(angle) - y * Math.sin(angle);
    }
}
