package rigibo.backend;

/**
 * A visit of the last step as {@link Pool#forEachSensorEvent} shows it. It is one object that is
 * written anew for each visit: what must last beyond the visitor's call is copied, or kept as
 * {@link #event}.
 *
 * <pre>{@code
 * int[] entered = {0};
 * pool.forEachSensorEvent(
 *         event -> entered[0] += event.phase == SensorEvent.Phase.ENTERED ? 1 : 0); // no garbage
 * }</pre>
 */
public final class SensorView {

    /** The body whose shape is the sensor. */
    public RigidBody sensor;

    /** Which part of its shape that is, from 0. */
    public int part;

    /** The other body, which may have been removed since. */
    public RigidBody visitor;

    /** Which part of the visitor's shape, from 0. */
    public int visitorPart;

    /** What became of the visit. */
    public SensorEvent.Phase phase;

    SensorView() {}

    /** A copy that lasts. */
    public SensorEvent event() {
        return new SensorEvent(sensor, part, visitor, visitorPart, phase);
    }
}
