package rigibo.backend.geometry;

/**
 * The neighbour of an edge of a {@link Chain} at one of its ends, or an open end. A contact at the
 * corner pushes along a normal between the edge's own and {@code normalX}, {@code normalY}.
 *
 * <pre>{@code
 * Chain floor = Chain.open(4, 0, 2, 0, 0, 1);
 * boolean isLast = floor.outline(1).after().isOpen(); // nothing lies beyond its left end
 * }</pre>
 *
 * @param normalX x of the outward unit normal of the neighbour; at an open end, of the direction
 *     out along the edge
 * @param normalY y of that normal
 * @param run length of the chain from the corner up to where it turns away from the air, m; 0 at an
 *     open end
 * @param straight length for which the chain goes on in a straight line, m
 */
public record EdgeEnd(double normalX, double normalY, double run, double straight) {

    /** Whether the chain ends here. */
    public boolean isOpen() {
        return run == 0;
    }
}
