package rigibo.backend;

import rigibo.backend.geometry.Aabb;

/**
 * Draws what a pool holds, by the means of the caller: {@link Pool#draw} calls one method for each
 * thing, and the caller decides on colours and lines. Each method does nothing until it is
 * overridden. World coordinates in m, y up.
 *
 * <pre>{@code
 * StringBuilder svg = new StringBuilder();
 * DebugDraw pen =
 *         new DebugDraw() {
 *             @Override
 *             public void outline(RigidBody body, double[] x, double[] y, int points, Look look) {
 *                 svg.append("<polygon points='");
 *                 for (int i = 0; i < points; i++) {
 *                     svg.append(x[i]).append(',').append(-y[i]).append(' ');
 *                 }
 *                 svg.append(look == Look.ASLEEP ? "' fill='gray'/>" : "' fill='teal'/>");
 *             }
 *         };
 * pool.draw(pen, DebugDraw.Layer.SHAPES);
 * }</pre>
 */
public interface DebugDraw {

    /** What is drawn, in this order. */
    enum Layer {
        /** The rectangles that the broadphase keeps. */
        BOUNDS,
        /** The outline of each part of each body's shape. */
        SHAPES,
        /** Joints. */
        JOINTS,
        /** Contacts of the last step that have not ended. */
        CONTACTS,
        /** Centres of mass of dynamic bodies. */
        CENTRES
    }

    /** What a body, or a part of it, does at the moment. */
    enum Look {
        /** It is static. */
        FIXED,
        /** It is kinematic. */
        DRIVEN,
        /** It is dynamic and simulated. */
        AWAKE,
        /** It is dynamic and asleep. */
        ASLEEP,
        /** It is a sensor, whatever its body does. */
        SENSOR,
        /** Its body is disabled. */
        DISABLED
    }

    /**
     * Draws the outline of a part, counter-clockwise and closed; round parts come as short chords.
     * Of a disc, the first point tells how far it has turned. An edge of a chain has two points.
     *
     * @param body whose part it is
     * @param x world x of each point, m; overwritten by the next call
     * @param y world y of each point, m; overwritten by the next call
     * @param points how many of them are set
     * @param look what the part does
     */
    default void outline(RigidBody body, double[] x, double[] y, int points, Look look) {}

    /** Draws a joint, whose anchors are at {@link Joint#xA} to {@link Joint#yB}. */
    default void joint(Joint joint) {}

    /**
     * Draws a contact.
     *
     * @param contact its points, forces and normal; overwritten by the next call
     */
    default void contact(ContactView contact) {}

    /** Draws the centre of mass of a dynamic body. */
    default void centre(RigidBody body, Look look) {}

    /**
     * Draws the rectangle that the broadphase keeps for a body.
     *
     * @param body whose it is
     * @param bounds its corners, m; overwritten by the next call
     */
    default void bounds(RigidBody body, Aabb bounds) {}
}
