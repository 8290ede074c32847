package rigibo.frontend.editor;

import rigibo.frontend.editor.desk.Finding;
import rigibo.frontend.editor.pane.Area;
import rigibo.frontend.editor.pane.Craft;
import rigibo.frontend.editor.pane.EffectPane;
import rigibo.frontend.editor.pane.FieldPane;
import rigibo.frontend.editor.pane.Pages;
import rigibo.frontend.editor.pane.Pane;
import rigibo.frontend.editor.pane.ProblemPane;
import rigibo.frontend.editor.pane.Spots;
import rigibo.frontend.editor.pane.ToolPane;
import rigibo.frontend.scene.Camera;
import rigibo.frontend.scene.Canvas;
import rigibo.frontend.scene.Color;
import rigibo.frontend.scene.widget.Grid;
import rigibo.frontend.scene.widget.Plate;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;

/**
 * All around the draft in a handheld window: some commands, a line that tells what is going on, and
 * a drawer for everything else. The drawer has several leaves, one of which is open at a time.
 */
final class HandPanes {

    private static final double MARGIN = 10;
    private static final double GAP = 6;
    private static final double ZOOM = 1.25;
    private static final int COLUMNS = 2;

    /** The names of keys, which button texts give in brackets. */
    private static final String KEYS = " \\((Ctrl\\+|Strg\\+)?\\p{Lu}[a-z]*\\)";

    /** The leaves of the drawer. */
    private enum Leaf {
        BUILD,
        FIELDS,
        EFFECTS,
        PROBLEMS,
        MORE
    }

    private final Workshop shop;
    private final Runnable back;
    private final Pages pages = new Pages();
    private Optional<Leaf> open = Optional.empty();
    private Optional<Finding> looked = Optional.empty();

    /**
     * Panes of a workshop.
     *
     * @param back leaves the innermost thing that is open, as Esc does
     */
    HandPanes(Workshop shop, Runnable back) {
        this.shop = shop;
        this.back = back;
    }

    /** Shuts the drawer; returns whether it was open. */
    boolean shut() {
        boolean wasOpen = open.isPresent();
        open = Optional.empty();
        return wasOpen;
    }

    /** Gives the draft its part of a window. */
    void makeRoom(Pane pane, List<Finding> findings) {
        EditorPlaces places = EditorPlaces.of(pane.canvas().layout());
        shop.view().see(free(pane, places, findings), places.draft());
    }

    /** The part of the window in which the draft is seen. */
    private Area free(Pane pane, EditorPlaces places, List<Finding> findings) {
        return open.map(leaf -> places.beside(drawer(pane, places, leaf, findings)))
                .orElse(places.draft());
    }

    /** The drawer, as high as a leaf of it needs. */
    private Area drawer(Pane pane, EditorPlaces places, Leaf leaf, List<Finding> findings) {
        Area inner = places.drawer().inset(MARGIN);
        double height =
                switch (leaf) {
                    case BUILD -> ToolPane.heightInRows(pane, inner.width());
                    case EFFECTS -> EffectPane.height(pane, inner);
                    case MORE -> entries(pane, inner).height(entries().size());
                    case PROBLEMS -> ProblemPane.height(pane, findings.size());
                    case FIELDS -> inner.height();
                };
        return places.drawer(height + 2 * MARGIN);
    }

    void draw(Pane pane, List<Finding> findings) {
        EditorPlaces places = EditorPlaces.of(pane.canvas().layout());
        places.frame(pane.canvas().layout()).forEach(pane::plate);
        open.ifPresent(leaf -> draw(pane, drawer(pane, places, leaf, findings), leaf, findings));
        status(pane, places, findings);
        tabs(pane, places, findings.size());
        new HandQuestion(shop, pane, free(pane, places, findings)).draw(open.isEmpty());
        if (shop.typing().isOn()) {
            typing(pane, places);
        } else {
            commands(pane, places.commands());
        }
        shop.list().ifPresent(list -> list.draw(pane, places.draft()));
    }

    private String words(String key, Object... values) {
        return shop.words().of("editor." + key, values);
    }

    private void button(Pane pane, Area area, String key, boolean isBright, Runnable action) {
        Color plate = isBright ? Color.PANEL_LIT : Color.DUSK_TOP;
        pane.button(area, words(key), plate, "", action);
    }

    private void commands(Pane pane, List<Area> places) {
        pane.button(places.get(0), "‹", words("hand.back"), Color.PANEL_LIT, "", back);
        button(pane, places.get(1), "undo", shop.desk().history().canUndo(), shop::undo);
        button(pane, places.get(2), "redo", shop.desk().history().canRedo(), shop::redo);
        button(pane, places.get(3), "test", true, shop::startTest);
    }

    /**
     * Draws the text that is typed at the top, since a keyboard on the screen hides the lower half.
     */
    private void typing(Pane pane, EditorPlaces places) {
        Area first = places.commands().get(0);
        Area last = places.commands().get(EditorPlaces.COMMANDS - 1);
        Area before = places.commands().get(EditorPlaces.COMMANDS - 2);
        boolean isRow = last.y() == first.y();
        double right = isRow ? before.right() : last.right();
        Area typed = new Area(first.x(), first.y(), right - first.x(), first.height());
        pane.value(typed, shop.typing().text(), Canvas.Font.WORDS, true);
        button(pane, last, "hand.typed", true, shop.typing()::end);
    }

    private void tabs(Pane pane, EditorPlaces places, int problems) {
        for (Leaf leaf : Leaf.values()) {
            String name =
                    leaf == Leaf.PROBLEMS && problems > 0
                            ? words("hand.problems.some", problems)
                            : words("hand." + leaf.name().toLowerCase(Locale.ROOT));
            boolean isOpen = open.filter(leaf::equals).isPresent();
            Area place = places.tabs().get(leaf.ordinal());
            Color plate = isOpen ? Color.BRASS : Color.PANEL_LIT;
            pane.button(place, name, plate, "", () -> turnTo(leaf));
        }
    }

    private void turnTo(Leaf leaf) {
        boolean isOpen = open.filter(leaf::equals).isPresent();
        open = isOpen ? Optional.empty() : Optional.of(leaf);
        looked = Optional.empty();
    }

    private void draw(Pane pane, Area area, Leaf leaf, List<Finding> findings) {
        Area inner = area.inset(MARGIN);
        switch (leaf) {
            case BUILD -> {
                pane.plate(area);
                ToolPane.drawInRows(pane, inner, shop.desk(), shop.craft(), this::take);
            }
            case FIELDS -> FieldPane.draw(pane, area, shop.desk(), shop.typing(), pages);
            case EFFECTS -> {
                pane.plate(area);
                EffectPane.draw(pane, inner, shop.desk());
            }
            case PROBLEMS ->
                    ProblemPane.draw(pane, area, findings, shop.desk()::choose)
                            .ifPresent(finding -> looked = Optional.of(finding));
            case MORE -> {
                pane.plate(area);
                more(pane, inner);
            }
        }
    }

    /** A tool that was just chosen is used on the draft, so the drawer closes. */
    private void take(Craft craft) {
        shop.take(craft);
        shut();
    }

    private void more(Pane pane, Area area) {
        List<Entry> entries = entries();
        Grid grid = entries(pane, area);
        for (int i = 0; i < entries.size(); i++) {
            Entry entry = entries.get(i);
            button(pane, Area.of(grid.place(i)), entry.key, entry.isBright, () -> use(entry));
        }
    }

    private static Grid entries(Pane pane, Area area) {
        double finger = pane.canvas().layout().clickable(0);
        return Grid.of(new Plate(area.x(), area.y(), area.width(), finger), COLUMNS, GAP);
    }

    private List<Entry> entries() {
        List<Entry> entries = new ArrayList<>();
        boolean isUnsaved = !shop.drawer().isSaved(shop.desk().draft());
        entries.add(new Entry("new", true, shop::beginNew));
        entries.add(new Entry("open", true, shop::showFiles));
        entries.add(new Entry("save", isUnsaved, shop::save));
        entries.add(new Entry("settle", true, shop::settle));
        entries.add(new Entry("check", !shop.isProving(), shop::check));
        entries.add(new Entry("code", true, shop::copyCode));
        entries.add(new Entry("hand.paste", true, shop::askForCode));
        if (shop.handsOver()) {
            entries.add(new Entry("file", true, shop::handOver));
        }
        entries.add(new Entry("hand.whole", true, shop.view()::home));
        entries.add(new Entry("hand.next", true, () -> shop.desk().chooseNext(1)));
        return entries;
    }

    /** A button of the drawer, dimmed where there is nothing to do. */
    private record Entry(String key, boolean isBright, Runnable action) {}

    /** The effect of a command shows on the draft, so the drawer closes. */
    private void use(Entry entry) {
        shut();
        entry.action.run();
    }

    private void status(Pane pane, EditorPlaces places, List<Finding> findings) {
        zoom(pane, places.zoom().get(0), "hand.smaller", "–", 1 / ZOOM);
        zoom(pane, places.zoom().get(1), "hand.larger", "+", ZOOM);
        Area area = places.status();
        Color ink = shop.remark().isEmpty() ? Color.TEXT_DIM : Color.BRASS;
        Optional<String> told = told(pane, findings);
        String sentence = told.orElseGet(() -> shop.remark().isEmpty() ? hint() : shop.remark());
        pane.lines(area, sentence, told.isPresent() ? Color.TEXT : ink);
    }

    private void zoom(Pane pane, Area place, String key, String sign, double factor) {
        Camera camera = shop.desk().camera();
        Area seen = shop.view().seen();
        pane.button(
                place,
                sign,
                words(key),
                Color.PANEL_LIT,
                "",
                () -> camera.zoom(factor, seen.middleX(), seen.middleY()));
    }

    /**
     * The sentence about the thing under a finger, or about the problem that was chosen from the
     * list.
     */
    private Optional<String> told(Pane pane, List<Finding> findings) {
        return pane.spots()
                .at(pane.pointerX(), pane.pointerY())
                .map(Spots.Spot::words)
                .filter(words -> !words.isEmpty())
                .map(words -> words.replaceAll(KEYS, ""))
                .or(
                        () ->
                                looked.filter(findings::contains)
                                        .filter(this::isStillLookedAt)
                                        .map(finding -> ProblemPane.told(pane, finding)));
    }

    private boolean isStillLookedAt(Finding finding) {
        boolean isChosen = !finding.item().isEmpty() && finding.item().equals(shop.desk().chosen());
        return isChosen || open.filter(Leaf.PROBLEMS::equals).isPresent();
    }

    private String hint() {
        return words("hand.hint." + shop.craft().hint());
    }
}
