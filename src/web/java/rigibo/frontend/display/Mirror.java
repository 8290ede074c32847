package rigibo.frontend.display;

import org.teavm.jso.JSBody;
import org.teavm.jso.dom.html.HTMLDocument;
import org.teavm.jso.dom.html.HTMLElement;
import org.teavm.jso.dom.html.HTMLInputElement;

import rigibo.frontend.scene.Control;
import rigibo.frontend.scene.Layout;
import rigibo.frontend.scene.Narrator;
import rigibo.frontend.scene.Scene;

import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;

/**
 * Mirrors a scene's description in the document, for screen readers: its controls as invisible
 * elements at their places, which no pointer hits, and its events in a log. Focusing a control
 * means pointing at it, clicking it means pressing there; the control selected by keys has the
 * focus.
 */
final class Mirror implements Narrator {

    /** Time from one look at the scene to the next, ns, however slow the pictures are. */
    private static final long PERIOD = 100_000_000;

    /** Sentences that the log keeps, more than a scene says at once: it is read as it grows. */
    private static final int KEPT = 20;

    private static final int NONE = -1;

    private final HTMLDocument document = HTMLDocument.current();
    private final HTMLElement canvas;
    private final PageInput input;
    private final HTMLElement place = document.getElementById("controls");
    private final HTMLElement log = document.getElementById("said");
    private final List<HTMLElement> elements = new ArrayList<>();
    private List<Control> shown = List.of();
    private Layout placed = Layout.ALONE;
    private List<Control> offered = new ArrayList<>();
    private Set<String> known = Set.of();
    private Set<String> said = new LinkedHashSet<>();
    private int chosen = NONE;
    private long looked = -PERIOD;

    /** Whether the focus follows the selection, and was not set by the player. */
    private boolean isFollowing;

    /**
     * A mirror of a canvas.
     *
     * @param input receives the actions on its elements
     */
    Mirror(HTMLElement canvas, PageInput input) {
        this.canvas = canvas;
        this.input = input;
    }

    /** Called when another scene is shown; its title is read. */
    void begins(String title) {
        canvas.setAttribute("aria-label", title);
        known = Set.of();
        chosen = NONE;
        looked = -PERIOD;
        tell(title);
    }

    /** Called after a picture of a scene, with the page's own controls beside it. */
    void drawn(Scene scene, Layout layout, List<Control> beside) {
        long now = System.nanoTime();
        if (now - looked < PERIOD) {
            return;
        }
        looked = now;
        offered = new ArrayList<>();
        said = new LinkedHashSet<>();
        scene.describe(this);
        offered.addAll(beside);
        if (!offered.equals(shown) || !layout.equals(placed)) {
            shown = offered;
            placed = layout;
            arrange(layout);
        }
        follow();
        said.stream().filter(words -> !known.contains(words)).forEach(this::tell);
        known = said;
    }

    @Override
    public void offers(Control control) {
        offered.add(control);
    }

    @Override
    public void says(String words) {
        said.add(words);
    }

    /** Has a sentence read. */
    void tell(String words) {
        HTMLElement line = document.createElement("p");
        line.setTextContent(words);
        log.appendChild(line);
        while (log.getChildNodes().getLength() > KEPT) {
            log.removeChild(log.getFirstChild());
        }
    }

    private void arrange(Layout layout) {
        for (int i = 0; i < shown.size(); i++) {
            element(i, tag(shown.get(i)));
            describe(elements.get(i), shown.get(i), layout);
        }
        while (elements.size() > shown.size()) {
            place.removeChild(elements.remove(elements.size() - 1));
        }
    }

    private static String tag(Control control) {
        return control.kind() == Control.Kind.SLIDER ? "input" : "button";
    }

    /** Keeps an existing element of the right kind, so that it keeps the focus. */
    private void element(int number, String tag) {
        boolean isThere = number < elements.size();
        if (isThere && elements.get(number).getTagName().equalsIgnoreCase(tag)) {
            return;
        }
        HTMLElement made = document.createElement(tag);
        made.setAttribute("type", tag.equals("input") ? "range" : "button");
        made.addEventListener("focus", event -> focused(number));
        made.addEventListener("click", event -> clicked(number));
        made.addEventListener("input", event -> slid(number));
        if (isThere) {
            place.replaceChild(made, elements.set(number, made));
        } else {
            place.appendChild(made);
            elements.add(made);
        }
    }

    private static void describe(HTMLElement element, Control control, Layout layout) {
        switch (control.kind()) {
            case BUTTON -> element.removeAttribute("aria-pressed");
            case ON -> element.setAttribute("aria-pressed", "true");
            case OFF -> element.setAttribute("aria-pressed", "false");
            case SLIDER -> {
                element.setAttribute("step", "any");
                ((HTMLInputElement) element)
                        .setValue(String.valueOf(Math.round(100 * control.share())));
                element.setAttribute("aria-valuetext", control.name());
            }
        }
        element.setAttribute("aria-label", control.name());
        double ratio = PageSurface.ratio();
        pixels(element, "left", layout.windowX(control.x()) / ratio);
        pixels(element, "top", layout.windowY(control.y()) / ratio);
        pixels(element, "width", layout.ratio() * control.width() / ratio);
        pixels(element, "height", layout.ratio() * control.height() / ratio);
    }

    private static void pixels(HTMLElement element, String property, double value) {
        element.getStyle().setProperty(property, Math.round(value) + "px");
    }

    /** Gives the focus to the control that became selected. */
    private void follow() {
        int now = NONE;
        for (int i = 0; i < shown.size() && now == NONE; i++) {
            now = shown.get(i).isChosen() ? i : NONE;
        }
        if (now != chosen && now != NONE) {
            isFollowing = true;
            focus(elements.get(now));
            isFollowing = false;
        }
        chosen = now;
    }

    private void focused(int number) {
        if (!isFollowing) {
            input.point(shown.get(number));
        }
    }

    private void clicked(int number) {
        Control control = shown.get(number);
        if (control.kind() != Control.Kind.SLIDER) {
            input.use(control, control.share());
        }
    }

    private void slid(int number) {
        String percent = ((HTMLInputElement) elements.get(number)).getValue();
        input.use(shown.get(number), Double.parseDouble(percent) / 100);
    }

    @JSBody(params = "element", script = "element.focus({preventScroll: true});")
    private static native void focus(HTMLElement element);
}
