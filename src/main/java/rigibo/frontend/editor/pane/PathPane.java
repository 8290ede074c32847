package rigibo.frontend.editor.pane;

import rigibo.frontend.editor.draft.Course;
import rigibo.frontend.editor.draft.Draft;
import rigibo.frontend.editor.draft.Item;
import rigibo.frontend.scene.Canvas;

import java.util.List;

/** The fields of the path along which a body is driven; its stops are dragged. */
final class PathPane {

    private static final Fields.Range SPEED = new Fields.Range(0.05, 20, 0.1, 1);
    private static final Fields.Range PAUSE = new Fields.Range(0, 60, 0.5, 0);

    private static final List<String> ENDS = List.of("back", "round", "stay");

    private PathPane() {}

    static void draw(Fields fields, Item item) {
        if (item.isSource()) {
            return;
        }
        Course course = new Course(item);
        fields.column()
                .toggle(
                        fields.words("path"),
                        course.isThere(),
                        fields.words("path.told"),
                        () -> change(fields, course.switched()));
        if (course.isThere()) {
            stops(fields, course);
            fields.number("path.speed", item.pointer() + "/path/speed", SPEED);
            fields.stated("path.pause", item.pointer() + "/path/pause", PAUSE);
            end(fields, course);
        }
    }

    private static void stops(Fields fields, Course course) {
        int count = course.stops().size();
        Column.Shown shown = new Column.Shown(String.valueOf(count), Canvas.Font.NUMBERS, false);
        fields.column()
                .stepper(
                        fields.words("path.stops"),
                        shown,
                        () -> {},
                        more -> change(fields, more > 0 ? course.longer() : course.shorter()));
    }

    private static void end(Fields fields, Course course) {
        int now = Math.max(0, ENDS.indexOf(course.end()));
        Column.Shown shown =
                new Column.Shown(
                        fields.words("path.end." + ENDS.get(now)), Canvas.Font.WORDS, false);
        fields.column()
                .stepper(
                        fields.words("path.end"),
                        shown,
                        () -> {},
                        next ->
                                change(
                                        fields,
                                        course.ending(
                                                ENDS.get(Math.floorMod(now + next, ENDS.size())))));
    }

    private static void change(Fields fields, Item changed) {
        Draft next = fields.desk().draft().with(changed);
        fields.desk().change(changed.node().has("path") ? next.inFormatTwo() : next);
    }
}
