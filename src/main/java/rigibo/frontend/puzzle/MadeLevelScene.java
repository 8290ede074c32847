package rigibo.frontend.puzzle;

import rigibo.frontend.puzzle.endless.Making;
import rigibo.frontend.puzzle.endless.MakingNote;
import rigibo.frontend.puzzle.endless.Occasion;
import rigibo.frontend.puzzle.level.Level;
import rigibo.frontend.puzzle.picture.LevelPicture;
import rigibo.frontend.scene.Canvas;
import rigibo.frontend.scene.Color;
import rigibo.frontend.scene.Director;
import rigibo.frontend.scene.Scene;
import rigibo.frontend.scene.Words;
import rigibo.frontend.scene.widget.Print;
import rigibo.frontend.scene.widget.Tile;
import rigibo.frontend.scene.widget.TiledScene;
import rigibo.frontend.scene.widget.Tiles;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/** Shows a level that is made by chance: its picture as soon as it is there, and the results. */
final class MadeLevelScene implements TiledScene {

    private static final double EDGE = 20;
    private static final double BUTTON_WIDTH = 157;
    private static final double BUTTON_HEIGHT = 42;
    private static final double PICTURE_TOP = 84;
    private static final double PICTURE_SIZE = 330;
    private static final double PICTURE_LEFT = (WIDTH - PICTURE_SIZE) / 2;
    private static final double PICTURE_MARGIN = 16;

    /** Largest scale of the picture, px per m: a level of the world's width fills it. */
    private static final double PICTURE_SCALE = 40;

    private static final double PLAY_TOP = PICTURE_TOP + PICTURE_SIZE + 14;
    private static final double RESULTS_TOP = PLAY_TOP + BUTTON_HEIGHT + 22;
    private static final double RESULTS_HEAD = 28;
    private static final double ROW = 30;
    private static final int MOST_ROWS = 7;

    private final Director director;
    private final Words words;
    private final Occasion occasion;
    private final Making making;
    private final List<List<String>> results;
    private Optional<LevelPicture> picture = Optional.empty();
    private Tiles tiles;
    private int steps;

    /** Begins to make the level. */
    MadeLevelScene(Director director, Occasion occasion) {
        this(director, occasion, Making.begin(occasion.seeds()));
    }

    /** Goes on with a level that is being made. */
    MadeLevelScene(Director director, Occasion occasion, Making making) {
        this.director = director;
        words = director.words();
        this.occasion = occasion;
        this.making = making;
        results = occasion.results(director);
        layOut(Tiles.NONE);
    }

    /**
     * Chooses the way back once nothing else is left. While the level is made Enter must not lead
     * away: players who cannot wait press it to play.
     */
    static void chooseWayBack(Tiles tiles, Making making) {
        if (making.isHopeless() && tiles.chosen() == Tiles.NONE) {
            tiles.choose(0);
        }
    }

    /** The tiles: the way back, then those for the level, the first of which plays it. */
    private void layOut(int chosen) {
        List<Tile> laid = new ArrayList<>();
        laid.add(wayBack(director));
        if (making.made().isPresent()) {
            double x = occasion.next().isPresent() ? PICTURE_LEFT : (WIDTH - BUTTON_WIDTH) / 2;
            laid.add(tile(x, PLAY_TOP, BUTTON_WIDTH, words.of("menu.play"), this::play));
        }
        double right = PICTURE_LEFT + PICTURE_SIZE - BUTTON_WIDTH;
        String another = words.of("made.other");
        occasion.next()
                .map(next -> tile(right, PLAY_TOP, BUTTON_WIDTH, another, () -> other(next)))
                .ifPresent(laid::add);
        tiles = new Tiles(laid, chosen);
    }

    /** The tile that leads back to the list of levels. */
    static Tile wayBack(Director director) {
        String name = "‹  " + director.words().of("menu.levels");
        return tile(EDGE, 22, 130, name, director::showLevels);
    }

    private static Tile tile(double x, double y, double width, String name, Runnable action) {
        Tile.Look look = (canvas, tile, isChosen) -> Print.button(canvas, tile, name, isChosen);
        return new Tile(x, y, width, BUTTON_HEIGHT, look, action);
    }

    private void play() {
        director.sounds().press();
        making.made().ifPresent(made -> director.show(play(director, occasion, made)));
    }

    /** The scene in which a level is played that was made for an occasion. */
    static Scene play(Director director, Occasion occasion, Making.Made made) {
        Occasion played = occasion.of(made);
        Level level = played.named(made.level(), director.words());
        Sequel sequel =
                played.next()
                        .<Sequel>map(next -> new PreparedSequel(director, next))
                        .orElseGet(Sequel::none);
        return new PuzzleScene(director, level, played.ledger(director, level), sequel);
    }

    /** Goes on without solving this level. */
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
    public void draw(Canvas canvas) {
        Print.centred(canvas, occasion.title(words), WIDTH / 2.0, 44, 28, Color.BRASS);
        // A panel would lie over the bodies of the picture.
        canvas.frame(PICTURE_LEFT, PICTURE_TOP, PICTURE_SIZE, PICTURE_SIZE, 16, Color.EDGE);
        picture.ifPresentOrElse(level -> drawPicture(canvas, level), () -> drawNote(canvas));
        tiles.draw(canvas);
        drawResults(canvas);
    }

    private static void drawPicture(Canvas canvas, LevelPicture level) {
        double inner = PICTURE_SIZE - 2 * PICTURE_MARGIN;
        level.draw(
                canvas, PICTURE_LEFT + PICTURE_MARGIN, PICTURE_TOP + PICTURE_MARGIN, inner, inner);
    }

    private void drawNote(Canvas canvas) {
        double y = PICTURE_TOP + PICTURE_SIZE / 2;
        MakingNote.draw(canvas, words, making, y, steps, director.settings().motion());
    }

    private void drawResults(Canvas canvas) {
        int rows = Math.min(MOST_ROWS, results.size());
        double height = 2 * RESULTS_HEAD + rows * ROW;
        canvas.panel(EDGE, RESULTS_TOP, WIDTH - 2 * EDGE, height, 16, Color.PANEL);
        double y = RESULTS_TOP + RESULTS_HEAD;
        Print.centred(canvas, occasion.resultsTitle(director), WIDTH / 2.0, y, 20, Color.TEXT);
        for (List<String> row : results.subList(0, rows)) {
            y += ROW;
            double x = PICTURE_LEFT - 60;
            double pitch = (PICTURE_SIZE + 120) / (row.size() - 1);
            for (String column : row) {
                Print.centred(canvas, column, x, y, 18, Color.TEXT);
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
