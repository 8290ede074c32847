package rigibo.lab.plot;

/** The point of a text that is placed. */
public enum Anchor {
    START,
    MIDDLE,
    END;

    /** The left end of a text of a width that is anchored at x. */
    double left(double x, double width) {
        return switch (this) {
            case START -> x;
            case MIDDLE -> x - width / 2;
            case END -> x - width;
        };
    }
}
