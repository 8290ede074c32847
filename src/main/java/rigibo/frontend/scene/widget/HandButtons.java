package rigibo.frontend.scene.widget;

import rigibo.frontend.scene.Color;
import rigibo.frontend.scene.Control;
import rigibo.frontend.scene.Director;
import rigibo.frontend.scene.Enlarged;
import rigibo.frontend.scene.Narrator;
import rigibo.frontend.scene.Words;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.IntConsumer;

/** Buttons around a scene in a handheld window, in place of keys. */
public final class HandButtons {

    private static final double SIZE = 16;

    private final List<Plate> places = new ArrayList<>();
    private final List<Item> items = new ArrayList<>();
    private Optional<Enlarged> sheet = Optional.empty();

    /**
     * A button.
     *
     * @param words on it
     * @param name its name
     * @param isLit whether it is lit, since what it switches is on
     * @param action its action
     */
    public record Item(String words, String name, boolean isLit, Runnable action) {

        /** A button that is called by the words on it. */
        public Item(String words, boolean isLit, Runnable action) {
            this(words, words, isLit, action);
        }

        /** A button with a sign on it, which says more to the eye than to the ear. */
        Item(String sign, String name, Runnable action) {
            this(sign, name, false, action);
        }

        /** A button that does something once. */
        public Item(String words, Runnable action) {
            this(words, false, action);
        }
    }

    /**
     * The buttons of a running scene that is one of several.
     *
     * @param leave goes back
     * @param beside shows the scene that is a number of places further on
     */
    public static List<Item> ofSeveral(
            Words words,
            Item leave,
            boolean isPaused,
            Runnable pause,
            IntConsumer beside,
            Runnable restart) {
        return List.of(
                leave,
                new Item(words.of("puzzle.command.pause"), isPaused, pause),
                new Item("‹", words.of("hand.previous"), () -> beside.accept(-1)),
                new Item("›", words.of("hand.next"), () -> beside.accept(1)),
                new Item(words.of("puzzle.command.restart"), restart));
    }

    /** The button that shares the address of the scene, if the scene has one. */
    public static List<Item> ofAddress(Director director) {
        return director.hasAddress()
                ? List.of(new Item(director.words().of("hand.link"), director::share))
                : List.of();
    }

    /** Draws buttons at places of a sheet, px; there they are until {@link #clear}. */
    public void draw(Enlarged canvas, List<Plate> there, List<Item> drawn) {
        sheet = Optional.of(canvas);
        for (int i = 0; i < drawn.size(); i++) {
            Plate at = there.get(i);
            Item item = drawn.get(i);
            Color plate = item.isLit ? Color.BRASS : Color.PANEL_LIT;
            canvas.panel(at.x(), at.y(), at.width(), at.height(), 10, plate);
            Color ink = item.isLit ? Color.DUSK_TOP : Color.TEXT;
            double middle = at.y() + at.height() / 2;
            Print.centred(canvas, item.words, at.x() + at.width() / 2, middle, SIZE, ink);
            places.add(at);
            items.add(item);
        }
    }

    /** The button at a point of the scene, px. */
    public Optional<Item> at(double x, double y) {
        for (int i = 0; i < places.size(); i++) {
            Plate place = places.get(i);
            if (sheet.filter(on -> place.contains(on.x(x), on.y(y))).isPresent()) {
                return Optional.of(items.get(i));
            }
        }
        return Optional.empty();
    }

    /** Tells of them, where they were last drawn. */
    public void describe(Narrator narrator) {
        for (int i = 0; i < items.size(); i++) {
            Item item = items.get(i);
            Control.Kind kind = item.isLit ? Control.Kind.ON : Control.Kind.BUTTON;
            Control control = places.get(i).control(item.name, kind, 0.5, false);
            sheet.ifPresent(canvas -> canvas.telling(narrator).offers(control));
        }
    }

    /** Forgets them all, before they are drawn anew. */
    public void clear() {
        places.clear();
        items.clear();
    }
}
