package rigibo.frontend.editor.pane;

import rigibo.frontend.puzzle.level.Verb;
import rigibo.frontend.scene.Canvas;

import tools.jackson.databind.node.ObjectNode;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;

/** A row in which the author chooses what a click does in play, and how a switch begins. */
final class ClickRow {

    /**
     * An option of the row.
     *
     * @param verb the click's effect; empty for a body that clicks leave alone
     * @param isOn whether a switch is on at the start
     */
    record Choice(Optional<Verb> verb, boolean isOn) {

        static final Choice NONE = new Choice(Optional.empty(), true);

        private String key() {
            return verb.map(Verb::title).orElse("none") + (isOn ? "" : "-off");
        }
    }

    private ClickRow() {}

    /** Draws it for a body or joint as the file states it. */
    static void draw(Fields fields, ObjectNode stated, List<Verb> fitting, Consumer<Choice> edit) {
        List<Choice> choices = choices(fitting);
        Optional<Verb> verb = Verb.titled(stated.path("click").asString(""));
        Choice held = new Choice(verb, stated.path("on").asBoolean(true));
        int now = Math.max(0, choices.indexOf(held));
        fields.column()
                .stepper(
                        fields.words("click"),
                        new Column.Shown(
                                fields.words("click." + choices.get(now).key()),
                                Canvas.Font.WORDS,
                                false),
                        () -> {},
                        direction ->
                                edit.accept(
                                        choices.get(
                                                Math.floorMod(now + direction, choices.size()))));
    }

    private static List<Choice> choices(List<Verb> fitting) {
        List<Choice> choices = new ArrayList<>();
        choices.add(Choice.NONE);
        for (Verb verb : fitting) {
            choices.add(new Choice(Optional.of(verb), true));
            if (verb == Verb.SWITCH) {
                choices.add(new Choice(Optional.of(verb), false));
            }
        }
        return choices;
    }
}
