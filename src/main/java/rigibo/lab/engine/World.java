package rigibo.lab.engine;

import rigibo.backend.setup.BodyDefinition;
import rigibo.lab.child.Work;

/** A scene in some engine. Bodies are numbered from 0 on, as they were added. */
public interface World extends AutoCloseable {

    /** Adds a body and returns its number. */
    int add(BodyDefinition body);

    /**
     * Joins two bodies.
     *
     * @throws UnsupportedOperationException naming what the engine's joint cannot have
     */
    void join(Link link);

    /** Takes a body out, which nothing is asked about any more; the others keep their numbers. */
    void remove(int body);

    /** Goes on by so many seconds. */
    void step(double seconds);

    /**
     * Pushes a body's centre of mass with so many newtons, to the right and up, in the next step.
     */
    void push(int body, double forceX, double forceY);

    /**
     * Has a kinematic body move with a velocity of its centre of mass, m/s to the right and up, and
     * an angular velocity, rad/s counter-clockwise, from the next step on.
     */
    void drive(int body, double velocityX, double velocityY, double spin);

    /** World x of the centre of mass, m. */
    double x(int body);

    /** World y of the centre of mass, m. */
    double y(int body);

    /** rad, counter-clockwise. */
    double angle(int body);

    /** Of the centre of mass, m/s. */
    double velocityX(int body);

    /** Of the centre of mass, m/s, up. */
    double velocityY(int body);

    /** rad/s, counter-clockwise. */
    double spin(int body);

    /**
     * Has the normal impulses of every step from the next one on kept. Engines that tell them to
     * listeners only are up to a quarter slower then, so that they are asked just before the steps
     * that matter; those that keep them anyway do nothing.
     */
    default void watchImpulses() {}

    /**
     * What two bodies did to each other along their contact's normal in the last step, N·s; 0 where
     * they did not touch.
     *
     * @throws IllegalStateException where it is not kept and nobody watched
     */
    double normalImpulse(int a, int b);

    /**
     * Share of the way from one world point in m to another at which a ray enters the first body,
     * but none that it begins in; 1 where it meets nobody.
     *
     * @throws UnsupportedOperationException where the engine is not asked about rays
     */
    default double rayCast(double fromX, double fromY, double toX, double toY) {
        throw new UnsupportedOperationException("rays");
    }

    /** What the last step did, counted; nothing where the engine does not tell. */
    Work lastStep();

    /** Gives back what it holds outside the heap. */
    @Override
    void close();
}
