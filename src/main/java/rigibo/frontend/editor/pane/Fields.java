package rigibo.frontend.editor.pane;

import rigibo.frontend.editor.desk.Desk;
import rigibo.frontend.editor.desk.Leaf;
import rigibo.frontend.editor.desk.Typing;
import rigibo.frontend.editor.draft.Decimal;
import rigibo.frontend.editor.draft.Draft;
import rigibo.frontend.scene.Canvas;

import tools.jackson.databind.JsonNode;
import tools.jackson.databind.node.JsonNodeFactory;

import java.text.DecimalFormatSymbols;
import java.util.List;
import java.util.Locale;
import java.util.function.Consumer;
import java.util.regex.Pattern;

/** Fields that show values of the draft by their JSON pointers, and change them. */
final class Fields {

    private static final Pattern NUMBER = Pattern.compile("\\s*[-+]?\\d{0,9}[.,]?\\d{1,9}\\s*");

    private final Column column;
    private final Pane pane;
    private final Desk desk;
    private final Typing typing;

    /**
     * The range of a number.
     *
     * @param least its lower bound
     * @param most its upper bound
     * @param notch the amount that a press on plus adds
     * @param usual the default where the draft states none
     */
    record Range(double least, double most, double notch, double usual) {

        double within(double value) {
            return Math.max(least, Math.min(most, value));
        }
    }

    Fields(Column column, Pane pane, Desk desk, Typing typing) {
        this.column = column;
        this.pane = pane;
        this.desk = desk;
        this.typing = typing;
    }

    Column column() {
        return column;
    }

    String words(String key, Object... values) {
        return pane.words().of("editor." + key, values);
    }

    String language() {
        return pane.words().locale().getLanguage();
    }

    Desk desk() {
        return desk;
    }

    /** Makes the draft with a number changed. */
    interface Edit {
        Draft of(Draft draft, double value);
    }

    /** A number. */
    void number(String key, String pointer, Range range) {
        number(key, pointer, range, (draft, value) -> draft.with(pointer, Decimal.of(value)));
    }

    /** A number that the draft states only where it is not the usual one. */
    void stated(String key, String pointer, Range range) {
        number(
                key,
                pointer,
                range,
                (draft, value) ->
                        value == range.usual()
                                ? draft.without(pointer)
                                : draft.with(pointer, Decimal.of(value)));
    }

    /** A whole number. */
    void count(String key, String pointer, Range range) {
        number(key, pointer, range, (draft, value) -> draft.with(pointer, whole(value)));
    }

    /** A whole number, where its least stands for none. */
    void limit(String key, String pointer, Range range) {
        number(
                key,
                pointer,
                range,
                (draft, value) ->
                        value == range.least()
                                ? draft.without(pointer)
                                : draft.with(pointer, whole(value)));
    }

    private static JsonNode whole(double value) {
        return JsonNodeFactory.instance.numberNode(Math.round(value));
    }

    void number(String key, String pointer, Range range, Edit edit) {
        JsonNode held = desk.draft().at(pointer);
        double value = Decimal.read(held, range.usual());
        boolean isNone = held.isMissingNode() && range.usual() == range.least();
        String text = isNone ? "–" : plain(value);
        column.stepper(
                words(key),
                shown(pointer, text, Canvas.Font.NUMBERS),
                () ->
                        typing.begin(
                                pointer,
                                isNone ? "" : plain(value),
                                typed -> take(typed, range, edit)),
                direction -> change(edit, range.within(value + direction * range.notch())));
    }

    private void take(String typed, Range range, Edit edit) {
        // Half a number changes nothing: the field shows again what holds.
        if (NUMBER.matcher(typed).matches()) {
            double value = Double.parseDouble(typed.trim().replace(',', '.'));
            change(edit, range.within(value));
        }
    }

    private void change(Edit edit, double value) {
        desk.change(edit.of(desk.draft(), value));
    }

    /** A text field; {@code edit} puts the typed text into the draft. */
    void text(String name, String key, String held, Consumer<String> edit) {
        column.entry(
                words(key),
                shown(name, held, Canvas.Font.WORDS),
                () -> typing.begin(name, held, edit));
    }

    /** A switch that stands for a member of true or false. */
    void flag(String key, String pointer, boolean isOn) {
        JsonNode other = JsonNodeFactory.instance.booleanNode(!isOn);
        column.toggle(
                words(key),
                isOn,
                words(key + ".told"),
                () -> desk.change(desk.draft().with(pointer, other)));
    }

    /** A switch that gives the draft a member or takes it away. */
    void member(String key, String pointer, boolean has, JsonNode usual) {
        column.toggle(
                words(key), has, words(key + ".told"), () -> desk.member(pointer, usual, !has));
    }

    /** The leaves that can be turned to, side by side. */
    void leaves(List<Leaf> leaves, Leaf open) {
        column.tabs(
                leaves.stream().map(leaf -> words(leaf.key())).toList(),
                leaves.indexOf(open),
                i -> desk.turnTo(leaves.get(i)));
    }

    Column.Shown shown(String field, String held, Canvas.Font font) {
        return new Column.Shown(typing.shown(field, held), font, typing.isIn(field));
    }

    /** Without places that say nothing, with the decimal mark of the player's language. */
    private String plain(double value) {
        String text = String.format(Locale.ROOT, "%.3f", value);
        String shortest = text.replaceFirst("\\.?0+$", "").replaceFirst("^-0$", "0");
        return shortest.replace('.', mark());
    }

    private char mark() {
        return DecimalFormatSymbols.getInstance(pane.words().locale()).getDecimalSeparator();
    }
}
