package rigibo.backend.geometry;

/**
 * An axis-aligned box in world coordinates, m; mutable, so that stages can reuse one object.
 *
 * <pre>{@code
 * List<RigidBody> found = new ArrayList<>();
 * pool.overlapping(new Aabb(-1, 0, 1, 2), found::add); // 2 m by 2 m
 * }</pre>
 */
public final class Aabb {

    /** Left edge, m. */
    public double minX;

    /** Lower edge, m. */
    public double minY;

    /** Right edge, m. */
    public double maxX;

    /** Upper edge, m. */
    public double maxY;

    /** An empty box at the origin, to be filled by {@link #set}. */
    public Aabb() {}

    /**
     * A box from its corners.
     *
     * @param minX left edge, m
     * @param minY lower edge, m
     * @param maxX right edge, m, not left of {@code minX}
     * @param maxY upper edge, m, not below {@code minY}
     * @throws IllegalArgumentException when an edge is NaN or the corners are swapped
     */
    public Aabb(double minX, double minY, double maxX, double maxY) {
        if (!(minX <= maxX && minY <= maxY)) {
            throw new IllegalArgumentException(
                    "Aabb needs min <= max on both axes (m), was x "
                            + minX
                            + " to "
                            + maxX
                            + ", y "
                            + minY
                            + " to "
                            + maxY);
        }
        set(minX, minY, maxX, maxY);
    }

    /** Overwrites all four edges, m. */
    public void set(double left, double bottom, double right, double top) {
        minX = left;
        minY = bottom;
        maxX = right;
        maxY = top;
    }

    /** Enlarges this box so that it also holds the other. */
    public void enclose(Aabb other) {
        set(
                Math.min(minX, other.minX),
                Math.min(minY, other.minY),
                Math.max(maxX, other.maxX),
                Math.max(maxY, other.maxY));
    }

    /** Whether the two boxes share a point; boxes that only touch do. */
    public boolean overlaps(Aabb other) {
        return minX <= other.maxX && other.minX <= maxX && minY <= other.maxY && other.minY <= maxY;
    }

    /** Whether a point (m) lies inside or on the edge. */
    public boolean contains(double x, double y) {
        return x >= minX && x <= maxX && y >= minY && y <= maxY;
    }
}
