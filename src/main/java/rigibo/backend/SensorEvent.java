package rigibo.backend;

/**
 * An event of a sensor in the last step: plain data, read after the step. When a visitor comes in,
 * the pool reports {@code ENTERED}, then {@code INSIDE} in each further step, and {@code LEFT} in
 * the step in which it goes out, or in the step after an edit that takes it out. A visitor that
 * passes through within one step causes both {@code ENTERED} and {@code LEFT}. The parts of a
 * compound cause events of their own.
 *
 * <pre>{@code
 * for (SensorEvent event : pool.sensorEvents()) {
 *     if (event.phase() == SensorEvent.Phase.ENTERED) {
 *         System.out.println(event.visitor() + " entered " + event.sensor());
 *     }
 * }
 * }</pre>
 *
 * @param sensor the body whose shape is the sensor
 * @param part index of the part of its shape that is the sensor, from 0
 * @param visitor the other body, which may have been removed since
 * @param visitorPart index of the part of the visitor's shape, from 0
 * @param phase whether the visitor entered, stayed inside or left
 */
public record SensorEvent(
        RigidBody sensor, int part, RigidBody visitor, int visitorPart, Phase phase) {

    /** What happened to a visit in the step. */
    public enum Phase {
        /** It came in; if it also left within the step, {@code LEFT} is reported too. */
        ENTERED,
        /** It was inside before the step and still is. */
        INSIDE,
        /** It is no longer inside. */
        LEFT
    }
}
