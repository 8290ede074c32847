package rigibo.frontend.puzzle;

import rigibo.frontend.puzzle.endless.Making;
import rigibo.frontend.puzzle.endless.MakingNote;
import rigibo.frontend.puzzle.endless.Occasion;
import rigibo.frontend.puzzle.level.Level;
import rigibo.frontend.puzzle.picture.LevelPicture;
import rigibo.frontend.scene.Canvas;
import rigibo.frontend.scene.Color;
import rigibo.frontend.scene.Director;
import rigibo.frontend.scene.Layout;
import rigibo.frontend.scene.Narrator;
import rigibo.frontend.scene.Scene;
import rigibo.frontend.scene.Words;
import rigibo.frontend.scene.widget.Plate;
import rigibo.frontend.scene.widget.Print;
import rigibo.frontend.scene.widget.Tile;
import rigibo.frontend.scene.widget.TiledScene;
import rigibo.frontend.scene.widget.Tiles;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/** Shows a level that is made by chance: its picture as soon as it is made, and earlier results. */
final class MadeLevelScene implements TiledScene {

    private static final double PICTURE_MARGIN = 16;

    /** Largest scale of the picture, px per m: a level of the world's width fills it. */
    private static final double PICTURE_SCALE = 40;

    private static final int MOST_ROWS = 7;

    /** Size of the heading, px, in desktop and handheld windows. */
    private static final double TITLE = 28;

    private static final double TITLE_IN_HAND = 20;

    /** Sizes of the heading over the results, and of the results, px. */
    private static final double HEADING = 20;

    private static final double RESULT = 18;
    private static final double RESULT_IN_HAND = 16;

    /**
     * Positions of the first column of results, and of the last from the right, as shares of the
     * plate.
     */
    private static final double INDENT = 0.17;

    private final Director director;
    private final Words words;
    private final Occasion occasion;
    private final Making making;
    private final List<List<String>> results;
    private Optional<LevelPicture> picture = Optional.empty();
    private MadePlaces places = MadePlaces.ON_A_DESK;
    private Tiles tiles;
    private int steps;

    /** Begins to make the level. */
    MadeLevelScene(Director director, Occasion occasion) {
        this(director, occasion, Making.begin(occasion.seeds()));
    }

    /** Shows a level that is already being made. */
    MadeLevelScene(Director director, Occasion occasion, Making making) {
        this.director = director;
        words = director.words();
        this.occasion = occasion;
        this.making = making;
        results = occasion.results(director);
        layOut(Tiles.NONE);
    }

    /**
     * Chooses the way back if nothing else can be chosen. While the level is made Enter must not
     * lead away, since impatient players press it to play.
     */
    static void chooseWayBack(Tiles tiles, Making making) {
        if (making.isHopeless() && tiles.chosen() == Tiles.NONE) {
            tiles.choose(0);
        }
    }

    /** Lays out the tiles: the way back, then those for the level, the first of which plays it. */
    private void layOut(int chosen) {
        List<Tile> laid = new ArrayList<>();
        laid.add(wayBack(director, places));
        int count = occasion.next().isPresent() ? 2 : 1;
        if (making.made().isPresent()) {
            laid.add(Tile.button(places.button(0, count), words.of("menu.play"), this::play));
        }
        Plate right = places.button(1, 2);
        occasion.next()
                .map(next -> Tile.button(right, words.of("made.other"), () -> other(next)))
                .ifPresent(laid::add);
        tiles = new Tiles(laid, Math.min(chosen, laid.size() - 1));
    }

    /** The tile that leads back to the list of levels. */
    static Tile wayBack(Director director, MadePlaces places) {
        return Tile.wayBack(
                places.back(), director.words().of("menu.levels"), director::showLevels);
    }

    private void play() {
        director.sounds().press();
        making.made().ifPresent(made -> director.show(play(director, occasion, made)));
    }

    /** The scene that plays a level made for an occasion. */
    static Scene play(Director director, Occasion occasion, Making.Made made) {
        Occasion played = occasion.of(made);
        Level level = played.named(made.level(), director.words());
        Sequel sequel =
                played.next()
                        .<Sequel>map(next -> new PreparedSequel(director, next))
                        .orElseGet(Sequel::none);
        return new PuzzleScene(director, level, played.ledger(director, level), sequel);
    }

    /** Goes on to another level without solving this one. */
    private void other(Occasion next) {
        director.sounds().press();
        next.reached(director);
        director.show(new MadeLevelScene(director, next));
    }

    @Override
    public String title() {
        return "RigiBo – " + occasion.title(words);
    }

    @Override
    public void step() {
        steps++;
        if (picture.isEmpty() && making.made().isPresent()) {
            picture = making.made().map(made -> new LevelPicture(made.level(), PICTURE_SCALE));
            layOut(1);
        }
        chooseWayBack(tiles, making);
    }

    @Override
    public boolean isForHands() {
        return true;
    }

    @Override
    public void draw(Canvas canvas) {
        fit(canvas.layout());
        drawTitle(canvas, occasion.title(words), places);
        Plate frame = places.picture();
        // A panel would lie over the bodies of the picture.
        canvas.frame(frame.x(), frame.y(), frame.width(), frame.height(), 16, Color.EDGE);
        picture.ifPresentOrElse(level -> drawPicture(canvas, level), () -> drawNote(canvas));
        tiles.draw(canvas);
        drawResults(canvas);
    }

    @Override
    public void describe(Narrator narrator) {
        TiledScene.super.describe(narrator);
        if (picture.isEmpty()) {
            MakingNote.describe(narrator, words, making);
        }
    }

    private void fit(Layout layout) {
        MadePlaces fitting = MadePlaces.of(layout);
        if (!fitting.equals(places)) {
            places = fitting;
            layOut(tiles.chosen());
        }
    }

    /** Draws the heading of a scene that shows a level, or waits for one. */
    static void drawTitle(Canvas canvas, String title, MadePlaces places) {
        double size = canvas.layout().isInHand() ? TITLE_IN_HAND : TITLE;
        Print.centred(canvas, title, places.title().x(), places.title().y(), size, Color.BRASS);
    }

    private void drawPicture(Canvas canvas, LevelPicture level) {
        Plate frame = places.picture();
        level.draw(
                canvas,
                frame.x() + PICTURE_MARGIN,
                frame.y() + PICTURE_MARGIN,
                frame.width() - 2 * PICTURE_MARGIN,
                frame.height() - 2 * PICTURE_MARGIN);
    }

    private void drawNote(Canvas canvas) {
        Plate frame = places.picture();
        double x = frame.x() + frame.width() / 2;
        double y = frame.y() + frame.height() / 2;
        MakingNote.draw(canvas, words, making, x, y, steps, director.settings().motion());
    }

    private void drawResults(Canvas canvas) {
        Plate plate = places.results();
        int rows = Math.min(Math.min(MOST_ROWS, places.rows()), results.size());
        double height = 2 * places.head() + rows * places.row();
        canvas.panel(plate.x(), plate.y(), plate.width(), height, 16, Color.PANEL);
        double y = plate.y() + places.head();
        double middle = plate.x() + plate.width() / 2;
        boolean isInHand = canvas.layout().isInHand();
        double size = isInHand ? RESULT_IN_HAND : HEADING;
        Print.centred(canvas, occasion.resultsTitle(director), middle, y, size, Color.TEXT);
        for (List<String> row : results.subList(0, rows)) {
            y += places.row();
            double x = plate.x() + INDENT * plate.width();
            double pitch = (1 - 2 * INDENT) * plate.width() / (row.size() - 1);
            for (String column : row) {
                Print.centred(canvas, column, x, y, isInHand ? RESULT_IN_HAND : RESULT, Color.TEXT);
                x += pitch;
            }
        }
    }

    @Override
    public void closed() {
        making.stop();
    }

    @Override
    public Tiles tiles() {
        return tiles;
    }
}
