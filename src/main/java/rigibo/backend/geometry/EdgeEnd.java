package rigibo.backend.geometry;

/**
 * What lies beyond an end of an edge of a {@link Chain}: the next edge, or nothing. Whatever
 * touches the corner there pushes along a normal between the edge's own and this one.
 *
 * <pre>{@code
 * Chain floor = Chain.open(4, 0, 2, 0, 0, 1);
 * boolean isLast = floor.outline(1).after().isOpen(); // nothing lies beyond its left end
 * }</pre>
 *
 * @param normalX outward unit normal of the edge beyond; where there is none, out along the edge
 * @param normalY likewise
 * @param run how far the chain goes on from there until it turns away from the air, m; 0 where
 *     there is no edge beyond
 * @param straight how far it goes on in the same line, m
 */
public record EdgeEnd(double normalX, double normalY, double run, double straight) {

    /** Whether nothing lies beyond. */
    public boolean isOpen() {
        return run == 0;
    }
}
