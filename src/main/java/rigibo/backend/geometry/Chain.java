package rigibo.backend.geometry;

import java.util.Arrays;

/**
 * A line of straight edges with matter on one side: a landscape, a cave, a drum. Its body must be
 * static or kinematic. Seen in the direction from corner to corner, matter lies to the left and air
 * to the right, as it does for a polygon: a floor runs from right to left, the loop of a rock
 * counter-clockwise, the loop of a cave clockwise. A chain stops bodies that come from the air. It
 * lets bodies pass that come from the matter, and stops them only once they have left it. A body
 * that slides from edge to edge does not catch on the corner between them.
 *
 * <p>The corners are stated in the body's frame; the body turns about the origin of that frame.
 * Edge i, from corner i to the next, is part i of the shape and may have a material and a filter of
 * its own.
 *
 * <pre>{@code
 * Chain hills = Chain.open(20, 0, 10, 1, 5, 0, 0, 2, -10, 2);
 * pool.add(BodyDefinition.fixed(hills).material(0, ice));
 * }</pre>
 */
public final class Chain implements Shape {

    /** Most edges of a chain. */
    public static final int MAX_EDGES = 16_384;

    /** Shortest edge accepted, m. */
    public static final double SHORTEST_EDGE = 1e-4;

    private final double[] xy;
    private final boolean isLoop;
    private final Outline[] outlines;
    private final double boundingRadius;

    private Chain(double[] xy, boolean isLoop) {
        this.xy = xy;
        this.isLoop = isLoop;
        outlines = ChainEdges.of(xy, isLoop);
        double reach = 0;
        for (Outline edge : outlines) {
            reach = Math.max(reach, edge.boundingRadius());
        }
        boundingRadius = reach;
    }

    /**
     * An open chain.
     *
     * @param xy corner coordinates x₀, y₀, x₁, y₁, … in m, of 2 to 16,385 corners, matter to the
     *     left
     * @throws IllegalArgumentException naming the corner that is not finite, the edge that is
     *     shorter than 0.1 mm or goes right back, or the two edges that cross or touch
     */
    public static Chain open(double... xy) {
        ChainCheck.require("Chain.open", xy, false);
        return new Chain(xy.clone(), false);
    }

    /**
     * A closed chain, whose last corner is joined to the first.
     *
     * @param xy corner coordinates x₀, y₀, x₁, y₁, … in m, of 3 to 16,384 corners, matter to the
     *     left
     * @throws IllegalArgumentException as {@link #open}
     */
    public static Chain loop(double... xy) {
        ChainCheck.require("Chain.loop", xy, true);
        return new Chain(xy.clone(), true);
    }

    /** The chain with matter and air exchanged; its edges are counted from the other end. */
    public Chain reversed() {
        double[] back = new double[xy.length];
        for (int i = 0; i < xy.length; i += 2) {
            back[i] = xy[xy.length - 2 - i];
            back[i + 1] = xy[xy.length - 1 - i];
        }
        return new Chain(back, isLoop);
    }

    /** Number of corners; {@link #parts} is the number of edges. */
    public int corners() {
        return xy.length / 2;
    }

    /** A corner's x in the body's frame, m. */
    public double cornerX(int i) {
        return xy[2 * i];
    }

    /** A corner's y in the body's frame, m, up. */
    public double cornerY(int i) {
        return xy[2 * i + 1];
    }

    /** Whether the last corner is joined to the first. */
    public boolean isLoop() {
        return isLoop;
    }

    /**
     * One edge as a chain of its own.
     *
     * @param i number of the edge, from 0 to {@link #parts} − 1
     * @throws IllegalArgumentException when there is no such edge
     */
    public Chain edge(int i) {
        if (i < 0 || i >= parts()) {
            throw new IllegalArgumentException(
                    "Chain.edge must be 0 to " + (parts() - 1) + ", was " + i);
        }
        int next = (i + 1) % corners();
        return new Chain(
                new double[] {cornerX(i), cornerY(i), cornerX(next), cornerY(next)}, false);
    }

    @Override
    public ShapeKind kind() {
        return ShapeKind.CHAIN;
    }

    @Override
    public int parts() {
        return outlines.length;
    }

    @Override
    public Outline outline(int part) {
        return outlines[part];
    }

    /** Returns 0: a line has no area. */
    @Override
    public double area() {
        return 0;
    }

    /** Returns 0 kg and 0 kg·m²: a line has no mass. */
    @Override
    public MassProperties massProperties(double density) {
        Polygon.requireDensity(density);
        return new MassProperties(0, 0, 0, 0);
    }

    @Override
    public double boundingRadius() {
        return boundingRadius;
    }

    /**
     * Returns infinity: the matter behind a chain has no thickness, so no tolerance follows from
     * it.
     */
    @Override
    public double smallestWidth() {
        return Double.POSITIVE_INFINITY;
    }

    @Override
    public void bounds(double x, double y, double cos, double sin, Aabb out) {
        Outline.bounds(outlines, x, y, cos, sin, out);
    }

    @Override
    public boolean equals(Object other) {
        return other instanceof Chain chain
                && isLoop == chain.isLoop
                && Arrays.equals(xy, chain.xy);
    }

    @Override
    public int hashCode() {
        return 31 * Arrays.hashCode(xy) + Boolean.hashCode(isLoop);
    }

    @Override
    public String toString() {
        return "Chain[" + outlines.length + (isLoop ? " edges, a loop]" : " edges]");
    }
}
