package rigibo.backend.geometry;

import java.util.Arrays;

/**
 * A line of straight edges with matter on one side: a landscape, a cave, a drum. It is static or
 * kinematic. Matter lies to the left of the way from corner to corner and air to the right, as
 * round a polygon: a floor goes from right to left, a rock's loop counter-clockwise, a cave's
 * clockwise. What comes out of the air is stopped; what comes out of the matter passes untouched
 * and is stopped only once it has left. Nothing that slides from edge to edge bumps into the corner
 * between them.
 *
 * <p>The body's frame is that of the corners: it sits where the body is, and turns about its
 * origin. Edge i, from corner i to the next, is part i of the shape, with a material and a filter
 * of its own if wanted.
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
     * A line with two ends.
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
     * A line that ends where it began.
     *
     * @param xy corner coordinates x₀, y₀, x₁, y₁, … in m, of 3 to 16,384 corners, matter to the
     *     left
     * @throws IllegalArgumentException as {@link #open}
     */
    public static Chain loop(double... xy) {
        ChainCheck.require("Chain.loop", xy, true);
        return new Chain(xy.clone(), true);
    }

    /** The same line with matter and air exchanged. Its edges are counted from the other end. */
    public Chain reversed() {
        double[] back = new double[xy.length];
        for (int i = 0; i < xy.length; i += 2) {
            back[i] = xy[xy.length - 2 - i];
            back[i + 1] = xy[xy.length - 1 - i];
        }
        return new Chain(back, isLoop);
    }

    /** Number of corners; of edges there are {@link #parts}. */
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
     * An edge by itself, as a chain of one.
     *
     * @param i its number, from 0 to before {@link #parts}
     * @throws IllegalArgumentException when there is none of that number
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

    /** A line has no area: 0. */
    @Override
    public double area() {
        return 0;
    }

    /** A line has no mass: 0 kg and 0 kg·m². */
    @Override
    public MassProperties massProperties(double density) {
        Polygon.requireDensity(density);
        return new MassProperties(0, 0, 0, 0);
    }

    @Override
    public double boundingRadius() {
        return boundingRadius;
    }

    /** Infinite, for no tolerance follows from it: matter is as thick as may be. */
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
