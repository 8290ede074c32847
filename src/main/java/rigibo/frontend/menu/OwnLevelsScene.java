package rigibo.frontend.menu;

import rigibo.frontend.scene.Canvas;
import rigibo.frontend.scene.Color;
import rigibo.frontend.scene.Director;
import rigibo.frontend.scene.Key;
import rigibo.frontend.scene.Narrator;
import rigibo.frontend.scene.SceneEntry;
import rigibo.frontend.scene.Words;
import rigibo.frontend.scene.widget.Grid;
import rigibo.frontend.scene.widget.Plate;
import rigibo.frontend.scene.widget.Print;
import rigibo.frontend.scene.widget.Tile;
import rigibo.frontend.scene.widget.TiledScene;
import rigibo.frontend.scene.widget.Tiles;

import java.util.ArrayList;
import java.util.List;
import java.util.OptionalInt;

/** The levels that the player made, as cards, a page of them at a time. */
public final class OwnLevelsScene implements TiledScene {

    /** Cards of a page. */
    private static final int PAGE = 12;

    /** Number of tiles before the cards: the way back, and the editor. */
    private static final int BUTTONS = 2;

    private final Director director;
    private final Words words;
    private final LevelList levels;
    private final int broken;
    private final SceneEntry editor;
    private final LevelsPlaces places = LevelsPlaces.ON_A_DESK;
    private int page;
    private Tiles tiles;

    /**
     * A list of levels, all of which are open.
     *
     * @param own levels of the world {@link SceneEntry.Challenge#OWN}
     * @param broken number of files with mistakes, which are not among them
     * @param editor which makes such levels
     */
    public OwnLevelsScene(Director director, List<SceneEntry> own, int broken, SceneEntry editor) {
        this.director = director;
        this.broken = broken;
        this.editor = editor;
        words = director.words();
        levels = LevelList.of(own, director.progress());
        turnTo(0);
    }

    private int pages() {
        return Math.max(1, (levels.levels().size() + PAGE - 1) / PAGE);
    }

    /** Shows a page, from 0, with its first card chosen. */
    private void turnTo(int number) {
        if (number < 0 || number >= pages()) {
            return;
        }
        page = number;
        List<Tile> laid = new ArrayList<>();
        Grid buttons = places.buttons();
        laid.add(Tile.wayBack(buttons.place(0), words.of("menu.levels"), director::showLevels));
        String making = editor.title().apply(words);
        laid.add(Tile.button(buttons.place(1), making, () -> open(editor)));
        int first = page * PAGE;
        int end = Math.min(levels.levels().size(), first + PAGE);
        for (int level = first; level < end; level++) {
            laid.add(card(level, cards().place(level - first)));
        }
        tiles = new Tiles(laid, laid.size() > BUTTONS ? BUTTONS : BUTTONS - 1);
    }

    /** Cards begin where a list of worlds has its row of levels made by chance. */
    private Grid cards() {
        Grid listed = places.cards();
        Plate first = listed.first();
        Plate higher = new Plate(first.x(), places.made().y(), first.width(), first.height());
        return new Grid(higher, listed.columns(), listed.gapX(), listed.gapY());
    }

    private Tile card(int level, Plate place) {
        LevelCard card = new LevelCard(levels, level, words);
        SceneEntry entry = levels.levels().get(level);
        return Tile.at(place, card.name(), card::draw, () -> open(entry));
    }

    private void open(SceneEntry entry) {
        director.sounds().press();
        director.show(entry.open().apply(director));
    }

    @Override
    public String title() {
        return "RigiBo – " + words.of("scene.own");
    }

    @Override
    public void step() {}

    @Override
    public void draw(Canvas canvas) {
        double x = (places.buttons().place(BUTTONS - 1).right() + WIDTH) / 2;
        Print.centred(canvas, words.of("scene.own"), x, places.title().y(), 36, Color.BRASS);
        if (pages() > 1) {
            String number = words.of("gallery.page", page + 1, pages());
            Print.right(canvas, number, places.count().x(), places.count().y(), 18, Color.TEXT);
        }
        tiles.draw(canvas);
        Plate foot = places.foot();
        canvas.panel(foot.x(), foot.y(), foot.width(), foot.height(), 12, Color.PANEL);
        double middle = foot.x() + foot.width() / 2;
        double y = foot.y() + foot.height() / 2;
        boolean hasMistakes = broken > 0;
        Print.centred(canvas, about(), middle, hasMistakes ? y - 12 : y, 16, Color.TEXT);
        if (hasMistakes) {
            Print.centred(canvas, words.of("own.broken", broken), middle, y + 12, 16, Color.BRASS);
        }
    }

    @Override
    public void describe(Narrator narrator) {
        tiles.describe(narrator);
        narrator.says(about());
    }

    private String about() {
        int level = page * PAGE + tiles.chosen() - BUTTONS;
        if (tiles.chosen() < BUTTONS) {
            return words.of(levels.levels().isEmpty() ? "own.none" : "menu.choose");
        }
        int par = levels.levels().get(level).challenge().orElseThrow().par();
        OptionalInt best = levels.done(level).fewestClicks();
        return best.isPresent()
                ? words.of("menu.best", par, best.getAsInt())
                : words.of("menu.par", par);
    }

    @Override
    public boolean escaped() {
        director.showLevels();
        return true;
    }

    @Override
    public Tiles tiles() {
        return tiles;
    }

    @Override
    public void scrolled(double notches, double x, double y) {
        turnTo(page - (int) Math.signum(notches));
    }

    @Override
    public void keyPressed(Key key) {
        switch (key) {
            case LEFT_BRACKET -> turnTo(page - 1);
            case RIGHT_BRACKET -> turnTo(page + 1);
            default -> tiles.keyPressed(key);
        }
    }
}
