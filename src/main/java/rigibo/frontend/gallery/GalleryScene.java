package rigibo.frontend.gallery;

import rigibo.frontend.scene.Canvas;
import rigibo.frontend.scene.Color;
import rigibo.frontend.scene.Demonstration;
import rigibo.frontend.scene.Director;
import rigibo.frontend.scene.Words;
import rigibo.frontend.scene.widget.Lines;
import rigibo.frontend.scene.widget.Print;
import rigibo.frontend.scene.widget.Tile;
import rigibo.frontend.scene.widget.TiledScene;
import rigibo.frontend.scene.widget.Tiles;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/** Every exhibit as a card with its picture, section by section; only the selected one moves. */
final class GalleryScene implements TiledScene {

    private static final int COLUMNS = 4;
    private static final int ROWS = 4;
    private static final int PAGE = COLUMNS * ROWS;
    private static final double EDGE = 20;
    private static final double GAP = 10;
    private static final double TABS_TOP = 76;
    private static final double TAB_HEIGHT = 36;
    private static final double TOP = 124;
    private static final double CARD_WIDTH = (WIDTH - 2 * EDGE - (COLUMNS - 1) * GAP) / COLUMNS;
    private static final double CARD_HEIGHT = 144;
    private static final double STRIP = 30;
    private static final double MARGIN = 5;
    private static final double FOOT_TOP = HEIGHT - 52;
    private static final double FOOT_HEIGHT = 40;
    private static final double PAGER = 42;

    private final Director director;
    private final Words words;
    private final ExhibitWords titles;
    private final Map<String, List<Found>> sections;
    private final Map<Found, Showing> showings = new HashMap<>();
    private String section = "";
    private int page;
    private Tiles tiles;
    private int firstCard;

    /** Opens the gallery with a given exhibit selected, or the first one. */
    GalleryScene(Director director, Optional<Found> chosen) {
        this.director = director;
        words = director.words();
        titles = new ExhibitWords(words);
        sections = Exhibits.bySection();
        chosen.map(Found::section)
                .or(() -> sections.keySet().stream().findFirst())
                .ifPresent(name -> section = name);
        int at = chosen.map(found -> types(found.section()).indexOf(found.type())).orElse(0);
        page = Math.max(0, at) / PAGE;
        layOut(Math.max(0, at) % PAGE);
    }

    private List<Class<? extends Exhibit>> types(String name) {
        List<Class<? extends Exhibit>> types = new ArrayList<>();
        sections.getOrDefault(name, List.of()).forEach(found -> types.add(found.type()));
        return types;
    }

    private List<Found> ofSection() {
        return sections.getOrDefault(section, List.of());
    }

    private List<Found> ofPage() {
        List<Found> all = ofSection();
        return all.subList(
                Math.min(page * PAGE, all.size()), Math.min((page + 1) * PAGE, all.size()));
    }

    private int pages() {
        return (ofSection().size() + PAGE - 1) / PAGE;
    }

    /**
     * Everything that can be clicked: the way back, the sections, the cards of this page, and the
     * other pages.
     */
    private void layOut(int card) {
        List<Tile> laid = new ArrayList<>();
        laid.add(new Tile(EDGE, 20, 130, 42, this::drawBack, director::showMenu));
        addTabs(laid);
        firstCard = laid.size();
        List<Found> cards = ofPage();
        for (int i = 0; i < cards.size(); i++) {
            laid.add(card(cards.get(i), i));
        }
        if (pages() > 1) {
            laid.add(pager(WIDTH - EDGE - 2 * PAGER - GAP, "‹", -1));
            laid.add(pager(WIDTH - EDGE - PAGER, "›", 1));
        }
        tiles = new Tiles(laid, cards.isEmpty() ? 0 : firstCard + card);
    }

    private void addTabs(List<Tile> laid) {
        double width = tabWidth();
        for (String name : sections.keySet()) {
            double x = EDGE + (laid.size() - 1) * (width + GAP);
            laid.add(
                    new Tile(
                            x,
                            TABS_TOP,
                            width,
                            TAB_HEIGHT,
                            (canvas, tile, isChosen) -> drawTab(canvas, tile, name, isChosen),
                            () -> turnTo(name, 0)));
        }
    }

    private double tabWidth() {
        double room = WIDTH - 2 * EDGE - 2 * (PAGER + GAP);
        return (room + GAP) / Math.max(1, sections.size()) - GAP;
    }

    private Tile card(Found found, int place) {
        return new Tile(
                EDGE + place % COLUMNS * (CARD_WIDTH + GAP),
                TOP + place / COLUMNS * (CARD_HEIGHT + GAP),
                CARD_WIDTH,
                CARD_HEIGHT,
                (canvas, tile, isChosen) -> drawCard(canvas, tile, found, isChosen),
                () -> open(found));
    }

    private Tile pager(double x, String sign, int direction) {
        return new Tile(
                x,
                TABS_TOP,
                PAGER,
                TAB_HEIGHT,
                (canvas, tile, isChosen) -> Print.button(canvas, tile, sign, isChosen),
                () -> turn(direction));
    }

    private void turn(int direction) {
        turnTo(section, Math.floorMod(page + direction, Math.max(1, pages())));
    }

    private void turnTo(String name, int number) {
        director.sounds().press();
        section = name;
        page = number;
        showings.clear();
        layOut(0);
    }

    private void open(Found found) {
        director.sounds().press();
        director.show(new ExhibitScene(director, found));
    }

    private Optional<Found> chosen() {
        int card = tiles.chosen() - firstCard;
        List<Found> cards = ofPage();
        return card >= 0 && card < cards.size() ? Optional.of(cards.get(card)) : Optional.empty();
    }

    private Showing showing(Found found) {
        return showings.computeIfAbsent(found, one -> new Showing(one.make().get()));
    }

    @Override
    public String title() {
        return "RigiBo – " + words.of("scene.gallery");
    }

    @Override
    public void step() {
        chosen().map(this::showing).ifPresent(Showing::step);
    }

    @Override
    public void draw(Canvas canvas) {
        Print.centred(canvas, words.of("scene.gallery"), WIDTH / 2.0, 42, 36, Color.BRASS);
        int count = sections.values().stream().mapToInt(List::size).sum();
        Print.right(canvas, words.of("gallery.count", count), WIDTH - EDGE, 44, 18, Color.TEXT);
        tiles.draw(canvas);
        double width = WIDTH - 2 * EDGE;
        canvas.panel(EDGE, FOOT_TOP, width, FOOT_HEIGHT, 12, Color.PANEL);
        String foot = chosen().map(titles::about).orElse(words.of("gallery.choose"));
        String fitting = Lines.shortened(canvas, foot, 17, Canvas.Font.WORDS, width - 24);
        Print.centred(canvas, fitting, WIDTH / 2.0, FOOT_TOP + FOOT_HEIGHT / 2, 17, Color.TEXT);
    }

    private void drawBack(Canvas canvas, Tile tile, boolean isChosen) {
        Print.button(canvas, tile, "‹  " + words.of("menu.back"), isChosen);
    }

    private void drawTab(Canvas canvas, Tile tile, String name, boolean isChosen) {
        boolean isOpen = name.equals(section);
        Print.plate(canvas, tile, isChosen);
        String label = titles.section(name) + "  " + sections.get(name).size();
        Color color = isOpen ? Color.BRASS : Color.TEXT_DIM;
        Print.centred(canvas, label, tile.middleX(), tile.middleY(), 18, color);
        if (isOpen) {
            double under = tile.y() + tile.height() - 4;
            canvas.line(tile.x() + 14, under, tile.x() + tile.width() - 14, under, 3, Color.BRASS);
        }
    }

    private void drawCard(Canvas canvas, Tile tile, Found found, boolean isChosen) {
        double picture = tile.height() - STRIP - 2 * MARGIN;
        Showing showing = showing(found);
        new ExhibitPicture(
                        showing.exhibit().view(),
                        tile.x() + MARGIN,
                        tile.y() + MARGIN,
                        tile.width() - 2 * MARGIN,
                        picture)
                .draw(canvas, showing);
        double strip = tile.y() + tile.height() - STRIP;
        Color plate = isChosen ? Color.PANEL_LIT : Color.PANEL;
        canvas.panel(tile.x(), strip, tile.width(), STRIP, 10, plate);
        Color edge = isChosen ? Color.BRASS : Color.EDGE;
        canvas.frame(tile.x(), tile.y(), tile.width(), tile.height(), 10, edge);
        double width = tile.width() - 16;
        String title = Lines.shortened(canvas, titles.title(found), 16, Canvas.Font.WORDS, width);
        Print.centred(canvas, title, tile.middleX(), strip + STRIP / 2, 16, Color.TEXT);
    }

    /** From page to page: a section's tab, then the way on as often as it has pages more. */
    @Override
    public Optional<Demonstration> demonstration() {
        List<Demonstration.Click> ways = new ArrayList<>();
        double middle = TABS_TOP + TAB_HEIGHT / 2;
        int tab = 0;
        for (List<Found> all : sections.values()) {
            if (tab > 0) {
                double x = EDGE + (tab + 0.5) * tabWidth() + tab * GAP;
                ways.add(new Demonstration.Click(x, middle));
            }
            for (int more = 1; more * PAGE < all.size(); more++) {
                ways.add(new Demonstration.Click(WIDTH - EDGE - PAGER / 2, middle));
            }
            tab++;
        }
        return Optional.of(new GalleryWalk(ways));
    }

    @Override
    public Tiles tiles() {
        return tiles;
    }

    @Override
    public void scrolled(double notches, double x, double y) {
        if (pages() > 1 && notches != 0) {
            turn(notches > 0 ? -1 : 1);
        }
    }
}
