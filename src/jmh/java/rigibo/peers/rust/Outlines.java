package rigibo.peers.rust;

import rigibo.backend.geometry.Chain;
import rigibo.backend.geometry.Outline;
import rigibo.backend.geometry.Shape;
import rigibo.backend.geometry.ShapeKind;
import rigibo.peers.Box2dFamily;

/** Our shapes as the library's, where a convex shape is a core and a radius, too. */
final class Outlines {

    private Outlines() {}

    /**
     * Adds the shapes of the next body.
     *
     * @throws UnsupportedOperationException if it has more corners than Box2D allows
     */
    static void tell(long world, int engine, Shape shape) {
        if (shape.kind() == ShapeKind.CHAIN) {
            Chain chain = (Chain) shape;
            for (int i = 0; i < chain.corners(); i++) {
                Calls.corner(world, chain.cornerX(i), chain.cornerY(i));
            }
            Calls.chain(world, chain.isLoop());
            return;
        }
        for (int part = 0; engine == Box2dV3Engine.NUMBER && part < shape.parts(); part++) {
            Box2dFamily.requireRoom(shape.outline(part));
        }
        for (int part = 0; part < shape.parts(); part++) {
            tell(world, shape.outline(part));
        }
    }

    private static void tell(long world, Outline outline) {
        for (int i = 0; i < outline.corners(); i++) {
            Calls.corner(world, outline.cornerX(i), outline.cornerY(i));
        }
        Calls.outline(world, outline.radius());
    }
}
