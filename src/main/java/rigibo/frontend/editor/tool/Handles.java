package rigibo.frontend.editor.tool;

import rigibo.frontend.editor.desk.Desk;
import rigibo.frontend.editor.draft.Box;
import rigibo.frontend.editor.draft.Corners;
import rigibo.frontend.editor.draft.Course;
import rigibo.frontend.editor.draft.Disc;
import rigibo.frontend.editor.draft.Form;
import rigibo.frontend.editor.draft.Item;
import rigibo.frontend.editor.draft.Landscape;
import rigibo.frontend.editor.draft.Pill;
import rigibo.frontend.editor.draft.Point;
import rigibo.frontend.scene.Modifier;

import java.util.ArrayList;
import java.util.List;

/** The handles of an item: one to turn it, and one for each corner, or for a radius. */
final class Handles {

    /** Thinnest and smallest that a level file may state, m. */
    static final double LEAST_SIZE = 0.05;

    /** Above the outline, px. */
    private static final double STALK = 26;

    private static final double FREE_STEP = 1;
    private static final double HELD_STEP = 15;

    private Handles() {}

    static List<Handle> of(Desk desk, Item item) {
        List<Handle> handles = new ArrayList<>();
        Form form = item.form();
        if (form instanceof Box box) {
            for (int i = 0; i < box.corners().size(); i++) {
                handles.add(corner(desk, item, box, i));
            }
        } else if (form instanceof Corners polygon) {
            for (int i = 0; i < polygon.corners().size(); i++) {
                handles.add(corner(desk, item, polygon, i));
            }
        } else if (form instanceof Landscape landscape) {
            for (int i = 0; i < landscape.corners().size(); i++) {
                handles.add(point(desk, item, landscape, i));
            }
        } else if (form instanceof Pill pill) {
            handles.add(end(desk, item, pill, 1));
            handles.add(end(desk, item, pill, -1));
            handles.add(thickness(desk, item, pill));
        } else if (form instanceof Disc) {
            handles.add(radius(desk, item, form.reach()));
        }
        Course course = new Course(item);
        for (int i = 0; i < course.stops().size(); i++) {
            handles.add(stop(desk, course, i));
        }
        if (item.kind() != Item.Kind.BALL) {
            handles.add(turn(desk, item, form.reach()));
        }
        return handles;
    }

    private static Handle stop(Desk desk, Course course, int i) {
        return new Handle(
                Handle.Kind.STOP,
                course.stops().get(i),
                to -> course.moved(i, desk.grid().snap(to)));
    }

    private static Handle radius(Desk desk, Item item, double radius) {
        Point at = item.place().plus(new Point(radius, 0));
        return new Handle(
                Handle.Kind.SIZE,
                at,
                to -> item.formed(new Disc(size(desk, to.minus(item.place()).length()))));
    }

    private static double size(Desk desk, double metres) {
        return Math.max(LEAST_SIZE, desk.grid().snap(metres));
    }

    /** The opposite corner stays where it is. */
    private static Handle corner(Desk desk, Item item, Box box, int i) {
        Point own = box.corners().get(i);
        double right = Math.signum(own.x());
        double up = Math.signum(own.y());
        Point opposite = item.toWorld(own.times(-1));
        return new Handle(
                Handle.Kind.SIZE,
                item.toWorld(own),
                to -> {
                    Point way = to.minus(opposite).turned(-item.degrees());
                    double width = size(desk, way.x() * right);
                    double height = size(desk, way.y() * up);
                    Point half = new Point(right * width / 2, up * height / 2);
                    return item.formed(box.sized(width, height))
                            .at(opposite.plus(half.turned(item.degrees())));
                });
    }

    private static Handle corner(Desk desk, Item item, Corners polygon, int i) {
        return new Handle(
                Handle.Kind.SIZE,
                item.toWorld(polygon.corners().get(i)),
                to -> item.formed(polygon.with(i, item.toOwn(desk.grid().snap(to)))));
    }

    private static Handle point(Desk desk, Item item, Landscape landscape, int i) {
        return new Handle(
                Handle.Kind.SIZE,
                item.toWorld(landscape.corners().get(i)),
                to -> item.formed(landscape.with(i, item.toOwn(desk.grid().snap(to)))));
    }

    /** The other end stays where it is. */
    private static Handle end(Desk desk, Item item, Pill pill, int side) {
        Point other = item.toWorld(pill.end(-side));
        return new Handle(
                Handle.Kind.SIZE,
                item.toWorld(pill.end(side)),
                to -> {
                    Point way = desk.grid().snap(to).minus(other).times(side);
                    return item.formed(new Pill(way.length(), pill.radius()))
                            .at(other.plus(way.times(side / 2.0)))
                            .turnedTo(way.direction());
                });
    }

    private static Handle thickness(Desk desk, Item item, Pill pill) {
        return new Handle(
                Handle.Kind.SIZE,
                item.toWorld(new Point(0, pill.radius())),
                to ->
                        item.formed(
                                new Pill(pill.length(), size(desk, Math.abs(item.toOwn(to).y())))));
    }

    private static Handle turn(Desk desk, Item item, double reach) {
        Point stalk = new Point(0, reach + desk.metres(STALK));
        return new Handle(
                Handle.Kind.TURN,
                item.toWorld(stalk),
                to -> {
                    double step = desk.isHeld(Modifier.SHIFT) ? HELD_STEP : FREE_STEP;
                    double degrees = to.minus(item.place()).direction() - stalk.direction();
                    return item.turnedTo(Math.round(degrees / step) * step);
                });
    }
}
