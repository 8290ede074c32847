package rigibo.frontend.puzzle.level;

import rigibo.backend.geometry.Aabb;
import rigibo.backend.geometry.Angle;
import rigibo.backend.geometry.Outline;
import rigibo.backend.geometry.Shape;
import rigibo.backend.setup.BodyDefinition;
import rigibo.backend.setup.BodyType;

/**
 * The area of the world that a placed body covers.
 *
 * @param body the body's definition
 * @param corners of each part's core in the world, x₀, y₀, x₁, …, m, counter-clockwise; of a disc
 *     its centre alone
 * @param bounds of the area, m
 */
record Footprint(BodyDefinition body, double[][] corners, Aabb bounds) {

    static Footprint of(BodyDefinition body) {
        double cos = Angle.cos(body.angle());
        double sin = Angle.sin(body.angle());
        Shape shape = body.shape();
        double[][] corners = new double[shape.parts()][];
        for (int part = 0; part < corners.length; part++) {
            corners[part] = corners(shape.outline(part), body, cos, sin);
        }
        Aabb bounds = new Aabb();
        shape.bounds(body.x(), body.y(), cos, sin, bounds);
        return new Footprint(body, corners, bounds);
    }

    private static double[] corners(Outline outline, BodyDefinition at, double cos, double sin) {
        double[] xy = new double[2 * outline.corners()];
        for (int i = 0; i < outline.corners(); i++) {
            double x = outline.cornerX(i);
            double y = outline.cornerY(i);
            xy[2 * i] = at.x() + cos * x - sin * y;
            xy[2 * i + 1] = at.y() + sin * x + cos * y;
        }
        return xy;
    }

    /** Radius of a part's outline about its core, m. */
    double radius(int part) {
        return body.shape().outline(part).radius();
    }

    /** Whether the body never moves, except along its path if it has one. */
    boolean isUnmoved() {
        return body.type() != BodyType.DYNAMIC;
    }

    boolean isOneWay() {
        return body.material().isOneWay();
    }
}
