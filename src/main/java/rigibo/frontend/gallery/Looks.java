package rigibo.frontend.gallery;

import rigibo.backend.RigidBody;
import rigibo.backend.geometry.Aabb;
import rigibo.backend.geometry.Circle;
import rigibo.backend.geometry.Shape;
import rigibo.backend.setup.BodyType;
import rigibo.backend.setup.Material;
import rigibo.frontend.scene.Skin;

/** Derives the skin of an exhibit's body from its material, since exhibits know no skins. */
public final class Looks {

    /**
     * Elasticity from which on a body is rubber, friction below which it is ice, density from which
     * on it is iron.
     */
    private static final double RUBBER_ELASTICITY = 0.6;

    private static final double ICE_FRICTION = 0.05;
    private static final double IRON_DENSITY = 5000;

    /** Ratio of length to width from which on a box is a plank. */
    private static final double PLANK_RATIO = 2.5;

    private Looks() {}

    /** The skin of a body. */
    public static Skin of(RigidBody body) {
        Material material = body.material();
        if (body.type() == BodyType.KINEMATIC || material.density() >= IRON_DENSITY) {
            return Skin.IRON;
        }
        boolean isStill = body.type() == BodyType.STATIC;
        if (!isStill && body.shape() instanceof Circle) {
            return Skin.BALL;
        }
        if (material.elasticity() >= RUBBER_ELASTICITY) {
            return Skin.RUBBER;
        }
        if (material.friction() <= ICE_FRICTION) {
            return Skin.ICE;
        }
        return isStill ? Skin.STONE : isStocky(body.shape()) ? Skin.RIGIBO : Skin.WOOD;
    }

    /** In one piece and about as wide as high: it has room for a face. */
    private static boolean isStocky(Shape shape) {
        Aabb own = new Aabb();
        shape.bounds(0, 0, 1, 0, own);
        double width = own.maxX - own.minX;
        double height = own.maxY - own.minY;
        return shape.parts() == 1
                && Math.max(width, height) < PLANK_RATIO * Math.min(width, height);
    }
}
