package rigibo.frontend.editor.pane;

import rigibo.frontend.editor.draft.Draft;
import rigibo.frontend.editor.draft.Prize;
import rigibo.frontend.scene.Canvas;

import tools.jackson.databind.node.JsonNodeFactory;
import tools.jackson.databind.node.ObjectNode;

import java.util.List;
import java.util.Optional;

/** The fields of the level's secret star. */
final class StarPane {

    private static final Fields.Range COUNT = new Fields.Range(1, 50, 1, 1);
    private static final Fields.Range SECONDS = new Fields.Range(0.5, 3600, 0.5, 10);

    private StarPane() {}

    static void draw(Fields fields) {
        Draft draft = fields.desk().draft();
        Optional<String> feat = Prize.feat(draft);
        if (feat.isEmpty() && !Prize.canBe(draft)) {
            fields.column().note(fields.words("star.unsolved"));
            fields.column().note(fields.words("star.unsolved.how"));
            return;
        }
        fields.column().note(fields.words("star.feat"));
        choice(fields, feat);
        switch (feat.orElse("")) {
            case "clicks" -> fields.count("star.count", Prize.STAR + "/count", COUNT);
            case "quick" -> fields.number("star.seconds", Prize.STAR + "/seconds", SECONDS);
            case "avoid", "touch", "keep", "first" -> target(fields, draft);
            default -> {}
        }
        if (feat.isPresent()) {
            LevelPane.wording(fields, "star.text", Prize.STAR + "/text");
        }
    }

    private static void choice(Fields fields, Optional<String> feat) {
        int now = feat.map(Prize.FEATS::indexOf).orElse(-1) + 1;
        int count = Prize.FEATS.size() + 1;
        fields.column()
                .wide(
                        fields.words("star.feat." + feat.orElse("none")),
                        turn -> choose(fields, Math.floorMod(now + turn, count)));
    }

    private static void choose(Fields fields, int number) {
        Optional<String> feat =
                number == 0 ? Optional.empty() : Optional.of(Prize.FEATS.get(number - 1));
        ObjectNode text = JsonNodeFactory.instance.objectNode();
        feat.map(one -> fields.words("star.usual." + one))
                .ifPresent(words -> text.put("en", words).put(fields.language(), words));
        fields.desk().change(Prize.of(fields.desk().draft(), feat, text));
    }

    private static void target(Fields fields, Draft draft) {
        List<String> targets = Prize.targets(draft);
        String target = Prize.target(draft);
        if (targets.isEmpty()) {
            return;
        }
        int now = targets.indexOf(target);
        fields.column()
                .stepper(
                        fields.words("star.target"),
                        new Column.Shown(target, Canvas.Font.WORDS, false),
                        () -> {},
                        turn ->
                                fields.desk()
                                        .change(
                                                Prize.aimed(
                                                        draft,
                                                        targets.get(
                                                                Math.floorMod(
                                                                        now + turn,
                                                                        targets.size())))));
    }
}
