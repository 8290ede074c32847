package rigibo.backend;

/**
 * What a sensor saw in the last step; plain data, read after the step. A visitor that came in tells
 * {@code ENTERED}, then {@code INSIDE} with each further step, and {@code LEFT} in the step that
 * takes it out or that follows an edit which does. One that passed through within one step tells
 * {@code ENTERED} and {@code LEFT}. Of compounds each part tells for itself.
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
 * @param part which part of its shape that is, from 0
 * @param visitor the other body, which may have been removed since
 * @param visitorPart which part of the visitor's shape, from 0
 * @param phase what became of the visit
 */
public record SensorEvent(
        RigidBody sensor, int part, RigidBody visitor, int visitorPart, Phase phase) {

    /** What became of a visit in the step. */
    public enum Phase {
        /** It came in, and may have left again: then {@code LEFT} is told, too. */
        ENTERED,
        /** It was inside before the step and is. */
        INSIDE,
        /** It is not inside any more. */
        LEFT
    }
}
