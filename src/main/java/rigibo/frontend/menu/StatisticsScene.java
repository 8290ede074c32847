package rigibo.frontend.menu;

import rigibo.frontend.scene.Canvas;
import rigibo.frontend.scene.Color;
import rigibo.frontend.scene.Director;
import rigibo.frontend.scene.Medal;
import rigibo.frontend.scene.Progress;
import rigibo.frontend.scene.SceneEntry;
import rigibo.frontend.scene.Words;
import rigibo.frontend.scene.widget.Print;
import rigibo.frontend.scene.widget.Sign;
import rigibo.frontend.scene.widget.Tile;
import rigibo.frontend.scene.widget.TiledScene;
import rigibo.frontend.scene.widget.Tiles;

import java.time.LocalDate;
import java.util.List;
import java.util.TreeSet;

/** What the player has done, as far as the files of progress know. */
final class StatisticsScene implements TiledScene {

    private static final double LEFT = 60;
    private static final double BREADTH = WIDTH - 2 * LEFT;

    /** Distance between a panel's edge and what is in it, px. */
    private static final double INSET = 24;

    private static final double LEVELS_TOP = 90;
    private static final double LEVELS_HEIGHT = 226;
    private static final double PLAY_TOP = LEVELS_TOP + LEVELS_HEIGHT + 14;
    private static final double PLAY_HEIGHT = 142;
    private static final double DAYS_TOP = PLAY_TOP + PLAY_HEIGHT + 14;
    private static final double DAYS_HEIGHT = 198;
    private static final double ENDLESS_TOP = DAYS_TOP + DAYS_HEIGHT + 14;
    private static final double ENDLESS_HEIGHT = 52;

    /** Size of a number, and the width up to which it is as large, px. */
    private static final double VALUE = 26;

    private static final double MOST_VALUE = 170;

    /** Days shown as dots, up to today. */
    private static final int DAYS = 14;

    private static final int MINUTE = 60;
    private static final int HOUR = 60 * MINUTE;

    private final Director director;
    private final Words words;
    private final LevelList levels;
    private final Progress progress;
    private final LocalDate today;
    private final Tiles tiles;

    /**
     * The player's statistics.
     *
     * @param entries the levels, among other scenes
     * @param today by UTC, as levels of days begin
     */
    StatisticsScene(Director director, List<SceneEntry> entries, LocalDate today) {
        this.director = director;
        this.today = today;
        words = director.words();
        progress = director.progress();
        levels = LevelList.of(entries, progress);
        String back = "‹  " + words.of("menu.back");
        Tile.Look look = (canvas, tile, isChosen) -> Print.button(canvas, tile, back, isChosen);
        tiles = new Tiles(List.of(new Tile(20, 22, 130, 42, look, this::leave)), 0);
    }

    private void leave() {
        director.sounds().press();
        director.showMenu();
    }

    @Override
    public String title() {
        return "RigiBo – " + words.of("menu.statistics");
    }

    @Override
    public void step() {}

    @Override
    public void draw(Canvas canvas) {
        Print.centred(canvas, words.of("menu.statistics"), WIDTH / 2.0, 44, 36, Color.BRASS);
        tiles.draw(canvas);
        drawLevels(canvas);
        drawPlay(canvas);
        drawDays(canvas);
        drawEndless(canvas);
    }

    private void panel(Canvas canvas, double top, double height, String key) {
        canvas.panel(LEFT, top, BREADTH, height, 16, Color.PANEL);
        Print.left(canvas, words.of(key), LEFT + INSET, top + 28, 20, Color.BRASS);
    }

    private void drawLevels(Canvas canvas) {
        panel(canvas, LEVELS_TOP, LEVELS_HEIGHT, "menu.levels");
        int count = levels.levels().size();
        String solved = words.of("menu.solved", levels.solved(), count);
        double right = LEFT + BREADTH - INSET;
        Print.right(canvas, solved, right, LEVELS_TOP + 28, 20, Color.TEXT);
        double share = count == 0 ? 0 : levels.solved() / (double) count;
        double bar = LEVELS_TOP + 52;
        double width = BREADTH - 2 * INSET;
        canvas.panel(LEFT + INSET, bar, width, 14, 7, Color.PANEL_LIT);
        if (share > 0) {
            canvas.panel(LEFT + INSET, bar, Math.max(14, share * width), 14, 7, Color.GOOD);
        }
        double y = LEVELS_TOP + 112;
        for (Medal medal : Medal.values()) {
            double x = column(medal.ordinal(), 4);
            canvas.disc(x, y, 22, medal.color());
            canvas.ring(x, y, 17, 2, 1, Color.DUSK_TOP.alpha(0.5));
            number(canvas, String.valueOf(medal.ordinal() + 1), x, y, 20, Color.DUSK_TOP);
            figure(canvas, x, y + 52, String.valueOf(levels.medals(medal)), name(medal));
        }
        double x = column(3, 4);
        Sign.star(canvas, x, y + 1, 25, Color.BRASS);
        String stars = levels.found() + " / " + levels.hidden();
        figure(canvas, x, y + 52, stars, "statistics.stars");
    }

    private static String name(Medal medal) {
        return switch (medal) {
            case GOLD -> "statistics.gold";
            case SILVER -> "statistics.silver";
            case BRONZE -> "statistics.bronze";
        };
    }

    /** Middle of a column of the panels, px. */
    private static double column(int column, int count) {
        return LEFT + BREADTH * (column + 0.5) / count;
    }

    /** A number with what it counts below. */
    private void figure(Canvas canvas, double x, double y, String value, String key) {
        double width = canvas.textWidth(value, VALUE, Canvas.Font.NUMBERS);
        number(canvas, value, x, y, VALUE * Math.min(1, MOST_VALUE / width), Color.TEXT);
        Print.centred(canvas, words.of(key), x, y + 30, 16, Color.TEXT_DIM);
    }

    private static void number(
            Canvas canvas, String value, double x, double y, double size, Color color) {
        canvas.text(value, x, y, size, Canvas.Font.NUMBERS, Canvas.Align.CENTRE, color);
    }

    private void drawPlay(Canvas canvas) {
        panel(canvas, PLAY_TOP, PLAY_HEIGHT, "statistics.play");
        if (progress.totals().tries() < levels.solved()) {
            String since = words.of("statistics.since");
            Print.right(canvas, since, LEFT + BREADTH - INSET, PLAY_TOP + 28, 16, Color.TEXT_DIM);
        }
        double y = PLAY_TOP + 74;
        figure(canvas, column(0, 3), y, whole(progress.totals().tries()), "statistics.tries");
        figure(canvas, column(1, 3), y, whole(progress.totals().clicks()), "statistics.clicks");
        figure(canvas, column(2, 3), y, time(), "statistics.time");
    }

    private String whole(int value) {
        return String.format(words.locale(), "%,d", value);
    }

    private String time() {
        int seconds = (int) progress.totals().seconds();
        return seconds < HOUR
                ? words.of("statistics.minutes", seconds / MINUTE, seconds % MINUTE)
                : words.of("statistics.hours", whole(seconds / HOUR), seconds % HOUR / MINUTE);
    }

    private void drawDays(Canvas canvas) {
        panel(canvas, DAYS_TOP, DAYS_HEIGHT, "scene.daily");
        TreeSet<LocalDate> days = new TreeSet<>(progress.days().keySet());
        Streak streak = Streak.of(days, today);
        double y = DAYS_TOP + 74;
        figure(canvas, column(0, 3), y, whole(days.size()), "statistics.days");
        figure(canvas, column(1, 3), y, whole(streak.present()), "statistics.streak");
        figure(canvas, column(2, 3), y, whole(streak.longest()), "statistics.longest");
        for (int i = 0; i < DAYS; i++) {
            double x = LEFT + INSET + (BREADTH - 2 * INSET) * (i + 0.5) / DAYS;
            drawDay(canvas, x, y + 86, days, today.minusDays(DAYS - 1L - i));
        }
    }

    /** A day of the last ones: a tick where it was solved; today has a ring of brass. */
    private void drawDay(
            Canvas canvas, double x, double y, TreeSet<LocalDate> days, LocalDate day) {
        boolean isSolved = days.contains(day);
        canvas.disc(x, y, 13, isSolved ? Color.GOOD : Color.PANEL_LIT);
        if (isSolved) {
            Sign.tick(canvas, x, y, 6, 3, Color.DUSK_TOP);
        }
        if (day.equals(today)) {
            canvas.ring(x, y, 17, 2, 1, Color.BRASS);
        }
    }

    private void drawEndless(Canvas canvas) {
        panel(canvas, ENDLESS_TOP, ENDLESS_HEIGHT, "scene.endless");
        String next = words.of("made.endless.results", progress.endless());
        double right = LEFT + BREADTH - INSET;
        Print.right(canvas, next, right, ENDLESS_TOP + 28, 18, Color.TEXT);
    }

    @Override
    public Tiles tiles() {
        return tiles;
    }
}
