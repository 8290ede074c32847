package rigibo.backend;

/**
 * A sensor event of the last step as {@link Pool#forEachSensorEvent} passes it to its reader. The
 * pool overwrites this one object for each event: copy what must outlast the call, or keep {@link
 * #event}.
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

    /** Index of the part of its shape that is the sensor, from 0. */
    public int part;

    /** The other body, which may have been removed since. */
    public RigidBody visitor;

    /** Index of the part of the visitor's shape, from 0. */
    public int visitorPart;

    /** Whether the visitor entered, stayed inside or left. */
    public SensorEvent.Phase phase;

    SensorView() {}

    /** A permanent copy. */
    public SensorEvent event() {
        return new SensorEvent(sensor, part, visitor, visitorPart, phase);
    }
}
