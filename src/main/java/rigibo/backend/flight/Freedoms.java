package rigibo.backend.flight;

/** The three freedoms of a body: two of place, which belong together, and one to turn. */
final class Freedoms {

    double x;
    double y;
    double turn;

    void clear() {
        x = 0;
        y = 0;
        turn = 0;
    }

    void set(Freedoms other) {
        x = other.x;
        y = other.y;
        turn = other.turn;
    }

    /** Adds so many times another. */
    void add(double times, Freedoms other) {
        x += times * other.x;
        y += times * other.y;
        turn += times * other.turn;
    }

    /** The square of the two of place. */
    double squaredPlace() {
        return x * x + y * y;
    }

    /** The squared distance of the two freedoms of place from another's. */
    double squaredChange(Freedoms other) {
        double dx = x - other.x;
        double dy = y - other.y;
        return dx * dx + dy * dy;
    }

    /** Whether each is less than so much, either way. */
    boolean isWithin(double most) {
        return Math.abs(x) < most && Math.abs(y) < most && Math.abs(turn) < most;
    }
}
