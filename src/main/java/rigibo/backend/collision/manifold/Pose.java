package rigibo.backend.collision.manifold;

/**
 * Position and orientation of a shape: its centre of mass, and cosine and sine of its angle.
 * Mutable, so that stages can reuse one object.
 */
public final class Pose {

    /** Centre of mass in the world, m. */
    public double x;

    public double y;

    /** Cosine and sine of the angle from the shape's frame to the world's, counter-clockwise. */
    public double cos = 1;

    public double sin;

    /**
     * Overwrites the pose.
     *
     * @param x centre of mass, m
     * @param y centre of mass, m
     * @param cos cosine of the angle
     * @param sin sine of the angle
     */
    public void set(double x, double y, double cos, double sin) {
        this.x = x;
        this.y = y;
        this.cos = cos;
        this.sin = sin;
    }

    /** World x in m of a point of the shape's frame. */
    public double worldX(double localX, double localY) {
        return x + (cos * localX - sin * localY);
    }

    /** World y in m of a point of the shape's frame. */
    public double worldY(double localX, double localY) {
        return y + (sin * localX + cos * localY);
    }

    /** Copies another pose into this one. */
    public void set(Pose other) {
        set(other.x, other.y, other.cos, other.sin);
    }
}
