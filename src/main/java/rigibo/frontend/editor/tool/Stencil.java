package rigibo.frontend.editor.tool;

import rigibo.frontend.editor.draft.Box;
import rigibo.frontend.editor.draft.Corners;
import rigibo.frontend.editor.draft.Disc;
import rigibo.frontend.editor.draft.Form;
import rigibo.frontend.editor.draft.Pill;
import rigibo.frontend.editor.draft.Point;

/** The shapes that can be drawn by dragging, from the press of the button to its release. */
public enum Stencil {
    /** From corner to corner. */
    BOX(new Box(0.8, 0.8)) {
        @Override
        Form form(Point way, int corners) {
            return new Box(
                    Math.max(Handles.LEAST_SIZE, Math.abs(way.x())),
                    Math.max(Handles.LEAST_SIZE, Math.abs(way.y())));
        }

        @Override
        Point middle(Point from, Point way) {
            return from.plus(way.times(0.5));
        }
    },
    /** From the middle to the rim. */
    DISC(new Disc(0.4)) {
        @Override
        Form form(Point way, int corners) {
            return new Disc(Math.max(Handles.LEAST_SIZE, way.length()));
        }
    },
    /** From end to end. */
    CAPSULE(new Pill(0.8, Pill.USUAL)) {
        @Override
        Form form(Point way, int corners) {
            return new Pill(way.length(), Pill.USUAL);
        }

        @Override
        Point middle(Point from, Point way) {
            return from.plus(way.times(0.5));
        }

        @Override
        double degrees(Point way) {
            return way.direction();
        }
    },
    /** From the middle to a corner. */
    REGULAR(new Disc(0.5)) {
        @Override
        Form form(Point way, int corners) {
            return Corners.regular(corners, Math.max(2 * Handles.LEAST_SIZE, way.length()));
        }
    };

    private final Form usual;

    Stencil(Form usual) {
        this.usual = usual;
    }

    abstract Form form(Point way, int corners);

    Point middle(Point from, Point way) {
        return from;
    }

    double degrees(Point way) {
        return 0;
    }

    /** The size of a thing made by a click without dragging. */
    Form usual(int corners) {
        return this == REGULAR ? form(new Point(usual.reach(), 0), corners) : usual;
    }
}
