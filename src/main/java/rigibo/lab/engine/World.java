package rigibo.lab.engine;

import rigibo.backend.setup.BodyDefinition;
import rigibo.lab.child.Work;

/** A scene in an engine. Bodies are numbered from 0 in the order in which they were added. */
public interface World extends AutoCloseable {

    /** Adds a body and returns its number. */
    int add(BodyDefinition body);

    /**
     * Joins two bodies.
     *
     * @throws UnsupportedOperationException naming what the engine's joint cannot have
     */
    void join(Link link);

    /** Removes a body. Its number must not be used again; the others keep theirs. */
    void remove(int body);

    /** Makes a step of a length in s. */
    void step(double seconds);

    /** Applies a force in N, right and up, to a centre of mass during the next step. */
    void push(int body, double forceX, double forceY);

    /**
     * Sets the velocity of a kinematic body from the next step on: that of its centre of mass, m/s
     * to the right and up, and its angular velocity, rad/s counter-clockwise.
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
     * Records the normal impulses of all further steps. It is called just before the steps that
     * matter, since engines that report impulses only to listeners then run up to a quarter slower.
     * Engines that keep them anyway do nothing.
     */
    default void watchImpulses() {}

    /**
     * The normal impulse between two bodies in the last step, N·s; 0 if they did not touch.
     *
     * @throws IllegalStateException if the engine does not keep it and {@link #watchImpulses} was
     *     not called
     */
    double normalImpulse(int a, int b);

    /**
     * The share of the way between two world points, in m, at which a ray enters the first body; 1
     * if it hits none. A body that contains the start is ignored.
     *
     * @throws UnsupportedOperationException where the engine is not asked about rays
     */
    default double rayCast(double fromX, double fromY, double toX, double toY) {
        throw new UnsupportedOperationException("rays");
    }

    /** The work of the last step; {@link Work#NONE} if the engine does not report it. */
    default Work lastStep() {
        return Work.NONE;
    }

    /** Frees what the world holds outside the heap. */
    @Override
    default void close() {}
}
