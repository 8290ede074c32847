package rigibo.lab.plot;

/** Where a text is held. */
public enum Anchor {
    START,
    MIDDLE,
    END;

    /** Left end of a text of a width that is held at x. */
    double left(double x, double width) {
        return switch (this) {
            case START -> x;
            case MIDDLE -> x - width / 2;
            case END -> x - width;
        };
    }
}
