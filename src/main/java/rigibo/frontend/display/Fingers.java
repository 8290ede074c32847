package rigibo.frontend.display;

import java.util.ArrayList;
import java.util.List;
import java.util.function.DoubleSupplier;

/**
 * Fingers on a screen. One alone is a pointer. When a second one comes down, what the first has
 * begun is cancelled, and the two move and enlarge the view until all are lifted.
 */
final class Fingers {

    /** Fingers that are nearer to each other than they are wide tell no direction, px. */
    private static final double LEAST_APART = 20;

    private final Input input;
    private final Finger pointer;
    private final List<Contact> down = new ArrayList<>();

    /** Whether there were two of them since the first came down. */
    private boolean arePinching;

    /** Where a finger is. */
    private static final class Contact {
        final int id;
        double x;
        double y;

        Contact(int id, double x, double y) {
            this.id = id;
            this.x = x;
            this.y = y;
        }
    }

    /** Fingers that come to an input, timed by a clock in s. */
    Fingers(Input input, DoubleSupplier seconds) {
        this.input = input;
        pointer = new Finger(input, seconds);
    }

    /** A finger came down at a point of the window. */
    void down(int id, double x, double y) {
        down.add(new Contact(id, x, y));
        if (down.size() == 1) {
            pointer.down(x, y);
        } else if (!arePinching) {
            arePinching = true;
            pointer.taken();
        }
    }

    /** A finger slid to a point of the window. */
    void slid(int id, double x, double y) {
        for (int i = 0; i < down.size(); i++) {
            if (down.get(i).id == id) {
                slid(i, down.get(i), x, y);
            }
        }
    }

    private void slid(int number, Contact finger, double x, double y) {
        if (!arePinching) {
            pointer.slid(x, y);
        } else if (number < 2 && down.size() > 1) {
            pinch(finger, down.get(1 - number), x, y);
        }
        finger.x = x;
        finger.y = y;
    }

    private void pinch(Contact moving, Contact other, double x, double y) {
        double before = Math.hypot(moving.x - other.x, moving.y - other.y);
        double after = Math.hypot(x - other.x, y - other.y);
        input.pinched(
                Math.max(LEAST_APART, after) / Math.max(LEAST_APART, before),
                (x + other.x) / 2,
                (y + other.y) / 2,
                (x - moving.x) / 2,
                (y - moving.y) / 2);
    }

    /** A picture is made, at a time of the clock, s. */
    void turn(double now) {
        pointer.turn(now);
    }

    /** A finger was lifted. */
    void lifted(int id) {
        if (!arePinching) {
            pointer.lifted();
        }
        leave(id);
    }

    /** The system took over a finger for a gesture of its own. */
    void taken(int id) {
        pointer.taken();
        leave(id);
    }

    private void leave(int id) {
        down.removeIf(finger -> finger.id == id);
        arePinching &= !down.isEmpty();
    }
}
