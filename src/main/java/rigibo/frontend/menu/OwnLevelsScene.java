package rigibo.frontend.menu;

import rigibo.frontend.scene.Canvas;
import rigibo.frontend.scene.Color;
import rigibo.frontend.scene.Director;
import rigibo.frontend.scene.Key;
import rigibo.frontend.scene.Layout;
import rigibo.frontend.scene.Narrator;
import rigibo.frontend.scene.SceneEntry;
import rigibo.frontend.scene.Words;
import rigibo.frontend.scene.widget.Grid;
import rigibo.frontend.scene.widget.Lines;
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

    private static final double GAP = 10;

    /** Height of the buttons that turn pages, and between the lines of the foot, px. */
    private static final double PAGER = 42;

    private static final double LINE = 24;

    /** Number of tiles before the cards: the way back, and the editor. */
    private static final int BUTTONS = 2;

    private final Director director;
    private final Words words;
    private final LevelList levels;
    private final int broken;
    private final SceneEntry editor;
    private LevelsPlaces places = LevelsPlaces.ON_A_DESK;
    private boolean isInHand;
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
        layOut(BUTTONS);
    }

    private void layOut(int chosen) {
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
        if (pages() > 1) {
            laid.add(pager(0, "action.previous", "‹", -1));
            laid.add(pager(1, "action.next", "›", 1));
        }
        tiles = new Tiles(laid, Math.min(chosen, laid.size() - 1));
    }

    private Tile pager(int place, String key, String sign, int direction) {
        return Tile.at(
                pagers().place(place),
                words.of(key),
                (canvas, tile, isChosen) -> Print.button(canvas, tile, sign, isChosen),
                () -> turnTo(page + direction));
    }

    /** The buttons that turn pages: below the cards on a desk, above or beside them in a hand. */
    private Grid pagers() {
        if (isInHand) {
            return Grid.of(places.made(), 2, GAP);
        }
        Plate last = cards().place(PAGE - 1);
        return Grid.of(new Plate(last.x(), last.bottom() + GAP, last.width(), PAGER), 2, GAP);
    }

    /** Number of cards on the page that is shown. */
    private int shown() {
        return Math.min(PAGE, levels.levels().size() - page * PAGE);
    }

    /** On a desk they begin where a list of worlds has its row of levels made by chance. */
    private Grid cards() {
        Grid listed = places.cards();
        if (isInHand) {
            return listed;
        }
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
    public boolean isForHands() {
        return true;
    }

    @Override
    public void step() {}

    @Override
    public void draw(Canvas canvas) {
        fit(canvas.layout());
        if (!isInHand) {
            double x = (places.buttons().place(BUTTONS - 1).right() + WIDTH) / 2;
            Print.centred(canvas, words.of("scene.own"), x, places.title().y(), 36, Color.BRASS);
        }
        if (pages() > 1 && places.count() != Plate.NONE) {
            String number = words.of("gallery.page", page + 1, pages());
            Print.right(canvas, number, places.count().x(), places.count().y(), 18, Color.TEXT);
        }
        tiles.draw(canvas);
        drawFoot(canvas, foot());
    }

    /** In a window that lies it has the room below the buttons that turn pages. */
    private Plate foot() {
        Plate foot = places.foot();
        if (!isInHand || places.count() != Plate.NONE) {
            return foot;
        }
        double top = places.made().bottom() + GAP;
        return new Plate(foot.x(), top, foot.width(), places.watch().bottom() - top);
    }

    /** In a hand there is room for one of its two texts, and mistakes are said nowhere else. */
    private void drawFoot(Canvas canvas, Plate foot) {
        canvas.panel(foot.x(), foot.y(), foot.width(), foot.height(), 12, Color.PANEL);
        double line = canvas.layout().lettered(LINE);
        boolean hasMistakes = broken > 0;
        List<String> lines = new ArrayList<>();
        if (!hasMistakes || !isInHand) {
            lines.add(about());
        }
        if (hasMistakes) {
            String told = words.of("own.broken", broken);
            double width = foot.width() - 2 * GAP;
            lines.addAll(Lines.of(canvas, told, 16, Canvas.Font.WORDS, width));
        }
        double y = foot.y() + (foot.height() - (lines.size() - 1) * line) / 2;
        for (String text : lines) {
            Color ink = text.equals(about()) ? Color.TEXT : Color.BRASS;
            Print.centred(canvas, text, foot.x() + foot.width() / 2, y, 16, ink);
            y += line;
        }
    }

    private void fit(Layout layout) {
        LevelsPlaces fitting = LevelsPlaces.of(layout, false);
        if (!fitting.equals(places)) {
            places = fitting;
            isInHand = layout.isInHand();
            layOut(tiles.chosen());
        }
    }

    @Override
    public void describe(Narrator narrator) {
        tiles.describe(narrator);
        narrator.says(about());
    }

    private String about() {
        int level = page * PAGE + tiles.chosen() - BUTTONS;
        if (tiles.chosen() < BUTTONS || tiles.chosen() >= BUTTONS + shown()) {
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
