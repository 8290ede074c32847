package rigibo.frontend.menu;

import rigibo.frontend.scene.Canvas;
import rigibo.frontend.scene.Color;
import rigibo.frontend.scene.Director;
import rigibo.frontend.scene.Medal;
import rigibo.frontend.scene.Narrator;
import rigibo.frontend.scene.Progress;
import rigibo.frontend.scene.SceneEntry;
import rigibo.frontend.scene.Words;
import rigibo.frontend.scene.widget.Plate;
import rigibo.frontend.scene.widget.Print;
import rigibo.frontend.scene.widget.Sign;
import rigibo.frontend.scene.widget.Tile;
import rigibo.frontend.scene.widget.TiledScene;
import rigibo.frontend.scene.widget.Tiles;

import java.time.LocalDate;
import java.util.ArrayList;
import java.util.List;
import java.util.TreeSet;

/** The player's statistics, as far as the saved progress knows them. */
final class StatisticsScene implements TiledScene {

    /** Distance between a panel's edge and its content, px. */
    private static final double INSET = 24;

    /** Size of a number, and the share of its column up to which it is as large. */
    private static final double VALUE = 26;

    private static final double MOST_VALUE = 0.85;

    /** Days shown as dots, up to today. */
    private static final int DAYS = 14;

    private static final int MINUTE = 60;
    private static final int HOUR = 60 * MINUTE;

    /**
     * A number.
     *
     * @param value its text
     * @param key key of the words below it
     */
    private record Figure(String value, String key) {}

    private final Director director;
    private final Words words;
    private final LevelList levels;
    private final Progress progress;
    private final LocalDate today;
    private StatisticsPlaces places = StatisticsPlaces.ON_A_DESK;
    private Tiles tiles;

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
        layOut();
    }

    private void layOut() {
        Tile back = Tile.wayBack(places.back(), words.of("menu.back"), this::leave);
        tiles = new Tiles(List.of(back), 0);
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
    public boolean isSheet() {
        return true;
    }

    @Override
    public void step() {}

    @Override
    public void draw(Canvas canvas) {
        StatisticsPlaces now = StatisticsPlaces.of(canvas.layout());
        if (!now.equals(places)) {
            places = now;
            layOut();
        }
        Plate title = places.title();
        Print.centred(
                canvas,
                words.of("menu.statistics"),
                title.x(),
                title.y(),
                title.height(),
                Color.BRASS);
        tiles.draw(canvas);
        drawLevels(canvas);
        drawPlay(canvas);
        drawDays(canvas);
        drawEndless(canvas);
    }

    /** Says every number that is drawn. */
    @Override
    public void describe(Narrator narrator) {
        TiledScene.super.describe(narrator);
        narrator.says(solved());
        List<Figure> figures = new ArrayList<>();
        for (Medal medal : Medal.values()) {
            figures.add(of(medal));
        }
        figures.add(ofStars());
        figures.addAll(ofPlay());
        figures.addAll(ofDays(new TreeSet<>(progress.days().keySet())));
        figures.forEach(it -> narrator.says(words.of(it.key) + ": " + it.value));
        narrator.says(words.of("scene.endless") + ": " + endless());
    }

    private String solved() {
        return words.of("menu.solved", levels.solved(), levels.levels().size());
    }

    private String endless() {
        return words.of("made.endless.results", progress.endless());
    }

    private void panel(Canvas canvas, Plate at, String key) {
        canvas.panel(at.x(), at.y(), at.width(), at.height(), 16, Color.PANEL);
        Print.left(canvas, words.of(key), at.x() + INSET, at.y() + 28, 20, Color.BRASS);
    }

    private void drawLevels(Canvas canvas) {
        Plate at = places.levels();
        panel(canvas, at, "menu.levels");
        int count = levels.levels().size();
        Print.right(canvas, solved(), at.right() - INSET, at.y() + 28, 20, Color.TEXT);
        double share = count == 0 ? 0 : levels.solved() / (double) count;
        double bar = at.y() + 52;
        double left = at.x() + INSET;
        double width = at.width() - 2 * INSET;
        canvas.panel(left, bar, width, 14, 7, Color.PANEL_LIT);
        if (share > 0) {
            canvas.panel(left, bar, Math.max(14, share * width), 14, 7, Color.GOOD);
        }
        double y = at.y() + 112;
        for (Medal medal : Medal.values()) {
            double x = column(at, medal.ordinal(), 4);
            canvas.disc(x, y, 22, medal.color());
            canvas.ring(x, y, 17, 2, 1, Color.DUSK_TOP.alpha(0.5));
            number(canvas, String.valueOf(medal.ordinal() + 1), x, y, 20, Color.DUSK_TOP);
            figure(canvas, at.width() / 4, x, y + 52, of(medal));
        }
        double x = column(at, 3, 4);
        Sign.star(canvas, x, y + 1, 25);
        figure(canvas, at.width() / 4, x, y + 52, ofStars());
    }

    private Figure of(Medal medal) {
        return new Figure(String.valueOf(levels.medals(medal)), name(medal));
    }

    private Figure ofStars() {
        return new Figure(levels.found() + " / " + levels.hidden(), "statistics.stars");
    }

    /** The key of a medal's name. */
    static String name(Medal medal) {
        return switch (medal) {
            case GOLD -> "statistics.gold";
            case SILVER -> "statistics.silver";
            case BRONZE -> "statistics.bronze";
        };
    }

    /** Middle of a column of a panel, px. */
    private static double column(Plate panel, int column, int count) {
        return panel.x() + panel.width() * (column + 0.5) / count;
    }

    /** Three numbers side by side in a panel. */
    private void figures(Canvas canvas, Plate panel, List<Figure> figures) {
        for (int i = 0; i < figures.size(); i++) {
            double x = column(panel, i, figures.size());
            double room = panel.width() / figures.size();
            figure(canvas, room, x, panel.y() + 74, figures.get(i));
        }
    }

    /** Draws a number, with words below it, in a column of the given width. */
    private void figure(Canvas canvas, double room, double x, double y, Figure figure) {
        double width = canvas.textWidth(figure.value, VALUE, Canvas.Font.NUMBERS);
        double size = VALUE * Math.min(1, MOST_VALUE * room / width);
        number(canvas, figure.value, x, y, size, Color.TEXT);
        Print.centred(canvas, words.of(figure.key), x, y + 30, 16, Color.TEXT_DIM);
    }

    private static void number(
            Canvas canvas, String value, double x, double y, double size, Color color) {
        canvas.text(value, x, y, size, Canvas.Font.NUMBERS, Canvas.Align.CENTRE, color);
    }

    private void drawPlay(Canvas canvas) {
        Plate at = places.play();
        panel(canvas, at, "statistics.play");
        if (progress.totals().tries() < levels.solved()) {
            String since = words.of("statistics.since");
            Print.right(canvas, since, at.right() - INSET, at.y() + 28, 16, Color.TEXT_DIM);
        }
        figures(canvas, at, ofPlay());
    }

    private List<Figure> ofPlay() {
        return List.of(
                new Figure(whole(progress.totals().tries()), "statistics.tries"),
                new Figure(whole(progress.totals().clicks()), "statistics.clicks"),
                new Figure(time(), "statistics.time"));
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
        Plate at = places.days();
        panel(canvas, at, "scene.daily");
        TreeSet<LocalDate> days = new TreeSet<>(progress.days().keySet());
        figures(canvas, at, ofDays(days));
        for (int i = 0; i < DAYS; i++) {
            double x = at.x() + INSET + (at.width() - 2 * INSET) * (i + 0.5) / DAYS;
            drawDay(canvas, x, at.y() + 160, days, today.minusDays(DAYS - 1L - i));
        }
    }

    private List<Figure> ofDays(TreeSet<LocalDate> days) {
        Streak streak = Streak.of(days, today);
        return List.of(
                new Figure(whole(days.size()), "statistics.days"),
                new Figure(whole(streak.present()), "statistics.streak"),
                new Figure(whole(streak.longest()), "statistics.longest"));
    }

    /** A day of the last ones: a tick where it was solved; today has a ring of brass. */
    private void drawDay(
            Canvas canvas, double x, double y, TreeSet<LocalDate> days, LocalDate day) {
        boolean isSolved = days.contains(day);
        double radius = Math.min(13, (places.days().width() - 2 * INSET) / DAYS / 2 - 1);
        canvas.disc(x, y, radius, isSolved ? Color.GOOD : Color.PANEL_LIT);
        if (isSolved) {
            Sign.tick(canvas, x, y, 6, 3, Color.DUSK_TOP);
        }
        if (day.equals(today)) {
            canvas.ring(x, y, radius + 4, 2, 1, Color.BRASS);
        }
    }

    private void drawEndless(Canvas canvas) {
        Plate at = places.endless();
        panel(canvas, at, "scene.endless");
        Print.right(canvas, endless(), at.right() - INSET, at.y() + 28, 18, Color.TEXT);
    }

    @Override
    public Tiles tiles() {
        return tiles;
    }
}
