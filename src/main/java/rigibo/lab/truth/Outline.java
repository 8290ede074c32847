package rigibo.lab.truth;

import rigibo.backend.geometry.Angle;
import rigibo.backend.geometry.Shape;

/**
 * The outline of a body in the world, and its distance from others. It compares every edge with
 * every corner and uses no code of an engine.
 */
public final class Outline {

    private final Shape shape;
    private final Piece[] pieces;
    private double x;
    private double y;

    /** The outline of a shape, at the origin until it is placed. */
    public Outline(Shape shape) {
        this.shape = shape;
        pieces = new Piece[shape.parts()];
        for (int part = 0; part < pieces.length; part++) {
            pieces[part] = new Piece(shape.outline(part));
        }
        place(0, 0, 0);
    }

    /** The shape of the outline. */
    public Shape shape() {
        return shape;
    }

    /**
     * Places the outline.
     *
     * @param metresX of the centre of mass
     * @param metresY of the centre of mass, up
     * @param angle rad, counter-clockwise
     */
    public void place(double metresX, double metresY, double angle) {
        x = metresX;
        y = metresY;
        double cos = Angle.cos(angle);
        double sin = Angle.sin(angle);
        for (Piece piece : pieces) {
            piece.place(x, y, cos, sin);
        }
    }

    /** The x of its leftmost point, m. */
    double left() {
        return x - shape.boundingRadius();
    }

    /** The x of its rightmost point, m. */
    double right() {
        return x + shape.boundingRadius();
    }

    /** Whether the circles around the two overlap: if not, they are apart. */
    public boolean isNear(Outline other) {
        double dx = other.x - x;
        double dy = other.y - y;
        double reach = shape.boundingRadius() + other.shape.boundingRadius();
        return dx * dx + dy * dy < reach * reach;
    }

    /**
     * The largest gap to another outline along any edge normal, m. Below 0 it is the least depth of
     * their overlap, above 0 a lower bound of the gap. For compounds it is that of the two parts
     * with the deepest overlap.
     */
    public double separation(Outline other) {
        double least = Double.POSITIVE_INFINITY;
        for (Piece piece : pieces) {
            for (Piece against : other.pieces) {
                least = Math.min(least, piece.separation(against));
            }
        }
        return least;
    }
}
