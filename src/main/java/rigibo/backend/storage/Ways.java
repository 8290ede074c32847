package rigibo.backend.storage;

import java.util.Arrays;

/**
 * Where and when bodies in flight were struck within the step, in order of time; between two such
 * places a body flew under its forces alone. Kept only for sensors.
 */
public final class Ways {

    public int[] body = new int[16];

    /** Time, s after the step's start; position, m; angle, rad. */
    public double[] time = new double[16];

    public double[] x = new double[16];
    public double[] y = new double[16];
    public double[] angle = new double[16];
    public int count;

    /** Notes the pose of a body at a time, s after the step's start. */
    public void note(Bodies bodies, int slot, double when) {
        if (count == body.length) {
            body = Arrays.copyOf(body, 2 * count);
            time = Arrays.copyOf(time, 2 * count);
            x = Arrays.copyOf(x, 2 * count);
            y = Arrays.copyOf(y, 2 * count);
            angle = Arrays.copyOf(angle, 2 * count);
        }
        body[count] = slot;
        time[count] = when;
        x[count] = bodies.x[slot];
        y[count] = bodies.y[slot];
        angle[count] = bodies.angle[slot];
        count++;
    }
}
