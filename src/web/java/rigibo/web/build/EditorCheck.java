package rigibo.web.build;

import rigibo.backend.setup.Accuracy;
import rigibo.frontend.editor.file.DraftFiles;
import rigibo.frontend.puzzle.level.Level;
import rigibo.frontend.puzzle.level.LevelLoader;
import rigibo.frontend.puzzle.replay.Recording;
import rigibo.frontend.puzzle.rules.Outcome;
import rigibo.frontend.puzzle.rules.Playback;
import rigibo.frontend.scene.Words;

import java.io.IOException;

/**
 * Makes a level by touch: a ball on a box on the platform, drawn while the draft is enlarged, with
 * a name. The level is settled, played and saved, and its code is solved here.
 */
final class EditorCheck {

    private static final String NAME = "Made by touch";

    /** Positions of a new level's ball and platform, m. */
    private static final double BALL_X = 2;

    private static final double BALL_Y = 2.55;
    private static final double PLATFORM_X = 7;

    /** Steps until the ball was held long enough and the verdict is shown. */
    private static final int UNTIL_SOLVED = 360;

    /** Steps until the drawn bodies are at rest. */
    private static final int UNTIL_SETTLED = 240;

    /** Steps until a new level allows a click on a box. */
    private static final int UNTIL_CLICKED = 72;

    /** Longest run, steps: half a minute. */
    private static final int MOST_STEPS = 1800;

    /** Script that stores the page's copied texts where the check can read them. */
    private static final String CLIPBOARD =
            "navigator.clipboard.writeText = text => { window.copied = text; return"
                    + " Promise.resolve(); }; 1";

    private static final String REFUSAL =
            "navigator.clipboard.writeText = () => Promise.reject(new Error('refused')); 1";

    private final Phone phone;
    private final Words words;
    private Page.Spot ball;
    private double scale;
    private boolean isEnlarged;

    EditorCheck(Phone phone) throws IOException, InterruptedException {
        this.phone = phone;
        words = phone.words();
    }

    /**
     * Makes the level and prints the result; returns whether the level was saved and its code is
     * won in the same way.
     */
    boolean isLevelMade() throws IOException, InterruptedException {
        phone.open("editor");
        phone.page().value(CLIPBOARD);
        phone.goUntilTold();
        name();
        build();
        play();
        save();
        phone.picture("editor-end");
        boolean isSaved = phone.stepped().isKept("levels/", NAME);
        boolean isWon = isWon(phone.page().value("window.copied"));
        boolean isRefusalTold = isRefusalTold();
        System.out.printf(
                "level made by touch: enlarged %s, saved %s, won %s, refusal told %s%n",
                isEnlarged, isSaved, isWon, isRefusalTold);
        return isEnlarged && isSaved && isWon && isRefusalTold;
    }

    /** Whether the page reports that a browser refused to copy. */
    private boolean isRefusalTold() throws IOException, InterruptedException {
        phone.page().value(REFUSAL);
        code();
        phone.goUntilTold();
        return phone.stepped().said().contains(words.of("toast.not-copied"));
    }

    private void tab(String key) throws IOException, InterruptedException {
        phone.tap(words.of("editor.hand." + key));
    }

    private void take(String tool) throws IOException, InterruptedException {
        tab("build");
        String told = words.of("editor.tool." + tool);
        phone.tap(told.substring(0, told.indexOf('(')));
    }

    /** Names the level, by the screen's keyboard. */
    private void name() throws IOException, InterruptedException {
        tab("fields");
        phone.tap(words.of("editor.title"));
        phone.page().send("Input.insertText", "\"text\":\" – " + NAME + "\"");
        phone.goUntilTold();
        phone.picture("editor-typing");
        phone.tap(words.of("editor.hand.typed"));
        tab("fields");
    }

    private void build() throws IOException, InterruptedException {
        look();
        double before = scale;
        phone.pinch(ball, ball.plus(0, -100), ball.plus(0, -130));
        look();
        isEnlarged = scale > 1.2 * before;
        take("select");
        phone.drag(ball, at(PLATFORM_X, 3));
        take("box");
        phone.drag(at(6.5, 1.5), at(7.5, 2.5));
        phone.picture("editor-drawn");
        tab("more");
        phone.tap(words.of("editor.settle"));
        phone.go(UNTIL_SETTLED);
    }

    /** Measures the enlargement of the draft before a part of it is moved. */
    private void look() throws IOException, InterruptedException {
        phone.goUntilTold();
        ball = phone.place(words.of("editor.ball"));
        Page.Spot platform = phone.place(words.of("editor.platform"));
        scale = (platform.x() - ball.x()) / (PLATFORM_X - BALL_X);
    }

    /** The place on the page of a point of the world, m. */
    private Page.Spot at(double x, double y) {
        return ball.plus(scale * (x - BALL_X), scale * (BALL_Y - y));
    }

    private void play() throws IOException, InterruptedException {
        phone.tap(words.of("editor.test"));
        phone.go(UNTIL_CLICKED);
        phone.tap("RigiBo");
        phone.go(UNTIL_SOLVED);
        phone.picture("editor-solved");
        phone.tap(words.of("puzzle.command.editor"));
        phone.tap(words.of("editor.won.keep"));
    }

    private void save() throws IOException, InterruptedException {
        tab("more");
        phone.tap(words.of("editor.save"));
        code();
    }

    private void code() throws IOException, InterruptedException {
        tab("more");
        phone.tap(words.of("editor.code"));
    }

    /** Whether the level of a code is valid and won by the clicks that the page has stored. */
    private static boolean isWon(String code) throws IOException {
        String text = DraftFiles.ofCode(code).draft().toString();
        Level level = new LevelLoader().parse(NAME, text).level().orElseThrow();
        Playback here =
                new Playback(
                        level,
                        Recording.of(level, level.solutions().get(0), Accuracy.GAME, MOST_STEPS)
                                .replay());
        while (here.game().outcome() == Outcome.RUNNING && here.game().steps() < MOST_STEPS) {
            here.step();
        }
        return here.game().isSolved();
    }
}
