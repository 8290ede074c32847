package rigibo.backend.flight;

/** A value for each degree of freedom of a body: two of place and one of angle. */
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

    /** Adds a multiple of another. */
    void add(double times, Freedoms other) {
        x += times * other.x;
        y += times * other.y;
        turn += times * other.turn;
    }

    /** Squared length of the part of place. */
    double squaredPlace() {
        return x * x + y * y;
    }

    /** Squared distance of the part of place from another's. */
    double squaredChange(Freedoms other) {
        double dx = x - other.x;
        double dy = y - other.y;
        return dx * dx + dy * dy;
    }

    /** Whether the magnitude of each value is less than a bound. */
    boolean isWithin(double most) {
        return Math.abs(x) < most && Math.abs(y) < most && Math.abs(turn) < most;
    }
}
