package rigibo.frontend.gallery;

import rigibo.frontend.scene.Canvas;
import rigibo.frontend.scene.Color;
import rigibo.frontend.scene.Demonstration;
import rigibo.frontend.scene.Director;
import rigibo.frontend.scene.Link;
import rigibo.frontend.scene.Words;
import rigibo.frontend.scene.widget.Caption;
import rigibo.frontend.scene.widget.Lines;
import rigibo.frontend.scene.widget.Plate;
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

    static final String NAME = "gallery";

    private static final double MARGIN = 5;

    private final Director director;
    private final Words words;
    private final ExhibitWords titles;
    private final Map<String, List<Found>> sections;
    private final Map<Found, Showing> showings = new HashMap<>();
    private GalleryPlaces places;
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
        places = GalleryPlaces.onADesk(sections.size());
        chosen.map(Found::section)
                .or(() -> sections.keySet().stream().findFirst())
                .ifPresent(name -> section = name);
        int at = chosen.map(found -> types(found.section()).indexOf(found.type())).orElse(0);
        layOut(places, Math.max(0, at));
    }

    /** Lays all out at other places, with an exhibit of the section selected. */
    private void layOut(GalleryPlaces there, int exhibit) {
        places = there;
        page = exhibit / places.onAPage();
        layOut(exhibit % places.onAPage());
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
        int first = page * places.onAPage();
        return all.subList(
                Math.min(first, all.size()), Math.min(first + places.onAPage(), all.size()));
    }

    private int pages() {
        return (ofSection().size() + places.onAPage() - 1) / places.onAPage();
    }

    /**
     * Everything that can be clicked: the way back, the sections, the cards of this page, and the
     * other pages.
     */
    private void layOut(int card) {
        List<Tile> laid = new ArrayList<>();
        laid.add(Tile.wayBack(places.back(), words.of("menu.back"), director::showMenu));
        addTabs(laid);
        firstCard = laid.size();
        List<Found> cards = ofPage();
        for (int i = 0; i < cards.size(); i++) {
            laid.add(card(cards.get(i), i));
        }
        if (pages() > 1) {
            laid.add(pager(0, "action.previous", "‹", -1));
            laid.add(pager(1, "action.next", "›", 1));
        }
        tiles = new Tiles(laid, cards.isEmpty() ? 0 : firstCard + card);
    }

    private void addTabs(List<Tile> laid) {
        for (String name : sections.keySet()) {
            Plate at = places.tabs().place(laid.size() - 1);
            Tile.Look look = (canvas, tile, isChosen) -> drawTab(canvas, tile, name, isChosen);
            laid.add(Tile.at(at, titles.section(name), look, () -> turnTo(name, 0)));
        }
    }

    private Tile card(Found found, int place) {
        return Tile.at(
                places.cards().place(place),
                titles.title(found) + ": " + titles.about(found),
                (canvas, tile, isChosen) -> drawCard(canvas, tile, found, isChosen),
                () -> open(found));
    }

    private Tile pager(int place, String key, String sign, int direction) {
        return Tile.at(
                places.pagers().place(place),
                words.of(key),
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
    public Link link() {
        return Link.to(NAME);
    }

    @Override
    public boolean isSheet() {
        return true;
    }

    @Override
    public void step() {
        chosen().map(this::showing).ifPresent(Showing::step);
    }

    @Override
    public void draw(Canvas canvas) {
        boolean isInHand = canvas.layout().isInHand();
        GalleryPlaces now = GalleryPlaces.of(canvas.layout(), sections.size());
        if (!now.equals(places)) {
            int card = Math.max(0, tiles.chosen() - firstCard);
            layOut(now, page * places.onAPage() + card);
        }
        tiles.draw(canvas);
        if (isInHand) {
            Plate at = places.count();
            String count = words.of("gallery.page", page + 1, Math.max(1, pages()));
            Print.centred(canvas, count, at.x(), at.y(), 16, Color.TEXT);
        } else {
            drawFrame(canvas);
        }
    }

    /** The heading above and the sentence of the selected exhibit below, in a desktop window. */
    private void drawFrame(Canvas canvas) {
        Print.centred(canvas, words.of("scene.gallery"), WIDTH / 2.0, 42, 36, Color.BRASS);
        Plate at = places.count();
        int count = sections.values().stream().mapToInt(List::size).sum();
        Print.right(canvas, words.of("gallery.count", count), at.x(), at.y(), 18, Color.TEXT);
        Plate plate = places.foot();
        canvas.panel(plate.x(), plate.y(), plate.width(), plate.height(), 12, Color.PANEL);
        String foot = chosen().map(titles::about).orElse(words.of("gallery.choose"));
        String fitting = Lines.shortened(canvas, foot, 17, Canvas.Font.WORDS, plate.width() - 24);
        double middle = plate.y() + plate.height() / 2;
        Print.centred(canvas, fitting, WIDTH / 2.0, middle, 17, Color.TEXT);
    }

    private void drawTab(Canvas canvas, Tile tile, String name, boolean isChosen) {
        boolean isOpen = name.equals(section);
        Print.plate(canvas, tile, isChosen);
        boolean isInHand = canvas.layout().isInHand();
        String count = isInHand ? "" : "  " + sections.get(name).size();
        Color color = isOpen ? Color.BRASS : Color.TEXT_DIM;
        double size = isInHand ? 16 : 18;
        String label = titles.section(name) + count;
        Print.centred(canvas, label, tile.middleX(), tile.middleY(), size, color);
        if (isOpen) {
            double under = tile.y() + tile.height() - 4;
            canvas.line(tile.x() + 14, under, tile.x() + tile.width() - 14, under, 3, Color.BRASS);
        }
    }

    private void drawCard(Canvas canvas, Tile tile, Found found, boolean isChosen) {
        Caption caption = Caption.of(canvas, titles.title(found), tile);
        double picture = tile.height() - caption.height() - 2 * MARGIN;
        Showing showing = showing(found);
        new ExhibitPicture(
                        showing.exhibit().view(),
                        tile.x() + MARGIN,
                        tile.y() + MARGIN,
                        tile.width() - 2 * MARGIN,
                        picture)
                .draw(canvas, showing);
        caption.draw(canvas, tile, isChosen);
    }

    /** From page to page: a section's tab, then the way on as often as it has pages more. */
    @Override
    public Optional<Demonstration> demonstration() {
        List<Demonstration.Click> ways = new ArrayList<>();
        Plate on = places.pagers().place(1);
        int tab = 0;
        for (List<Found> all : sections.values()) {
            if (tab > 0) {
                ways.add(click(places.tabs().place(tab)));
            }
            for (int more = 1; more * places.onAPage() < all.size(); more++) {
                ways.add(click(on));
            }
            tab++;
        }
        return Optional.of(new GalleryWalk(ways));
    }

    private static Demonstration.Click click(Plate at) {
        return new Demonstration.Click(at.x() + at.width() / 2, at.y() + at.height() / 2);
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
