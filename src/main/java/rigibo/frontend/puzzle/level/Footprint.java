package rigibo.frontend.puzzle.level;

import rigibo.backend.geometry.Outline;
import rigibo.backend.setup.BodyDefinition;
import rigibo.backend.setup.BodyType;

/**
 * What a placed body covers of the world.
 *
 * @param body what is placed
 * @param corners in the world, x₀, y₀, x₁, …, m, counter-clockwise; of a disc its centre alone
 * @param radius at which its outline goes round the corners, m; 0 of a sharp polygon
 */
record Footprint(BodyDefinition body, double[] corners, double radius) {

    static Footprint of(BodyDefinition body) {
        return new Footprint(body, corners(body), body.shape().outline(0).radius());
    }

    boolean isDisc() {
        return corners.length == 2;
    }

    boolean isFixed() {
        return body.type() == BodyType.STATIC;
    }

    double left() {
        return least(0);
    }

    double right() {
        return most(0);
    }

    double bottom() {
        return least(1);
    }

    double top() {
        return most(1);
    }

    private double least(int axis) {
        double least = Double.POSITIVE_INFINITY;
        for (int i = axis; i < corners.length; i += 2) {
            least = Math.min(least, corners[i]);
        }
        return least - radius;
    }

    private double most(int axis) {
        double most = Double.NEGATIVE_INFINITY;
        for (int i = axis; i < corners.length; i += 2) {
            most = Math.max(most, corners[i]);
        }
        return most + radius;
    }

    private static double[] corners(BodyDefinition placed) {
        Outline outline = placed.shape().outline(0);
        double cos = StrictMath.cos(placed.angle());
        double sin = StrictMath.sin(placed.angle());
        double[] xy = new double[2 * outline.corners()];
        for (int i = 0; i < outline.corners(); i++) {
            double x = outline.cornerX(i);
            double y = outline.cornerY(i);
            xy[2 * i] = placed.x() + cos * x - sin * y;
            xy[2 * i + 1] = placed.y() + sin * x + cos * y;
        }
        return xy;
    }
}
