package rigibo.web.gallery;

import org.teavm.jso.browser.Window;
import org.teavm.jso.dom.html.HTMLCanvasElement;
import org.teavm.jso.dom.html.HTMLDocument;
import org.teavm.jso.dom.html.HTMLElement;
import org.teavm.jso.dom.html.HTMLSelectElement;

import rigibo.backend.setup.Accuracy;
import rigibo.frontend.gallery.Exhibit;

import java.util.List;
import java.util.ServiceLoader;

/** Shows the exhibit and the accuracy that are chosen, until the page is left. */
public final class GalleryPage {

    /** In the order of the page's dial. */
    private static final List<Accuracy> DIAL =
            List.of(Accuracy.DRAFT, Accuracy.GAME, Accuracy.FINE, Accuracy.EXACT);

    private final HTMLDocument document = HTMLDocument.current();
    private final HTMLCanvasElement canvas = (HTMLCanvasElement) document.getElementById("canvas");
    private final HTMLSelectElement scenes = (HTMLSelectElement) document.getElementById("scenes");
    private final HTMLSelectElement dial = (HTMLSelectElement) document.getElementById("accuracy");
    private final HTMLElement pause = document.getElementById("pause");
    private final HTMLElement figure = document.getElementById("figure");
    private final FrameSteps steps = new FrameSteps();
    private final CanvasPainter painter = new CanvasPainter(canvas);
    private Running running;
    private boolean isPaused;

    private GalleryPage() {}

    public static void main(String[] arguments) {
        new GalleryPage().begin();
    }

    private void begin() {
        scenes.addEventListener("change", event -> open());
        dial.addEventListener("change", event -> open());
        document.getElementById("restart").addEventListener("click", event -> open());
        pause.addEventListener("click", event -> pauseOrGoOn());
        open();
        Window.requestAnimationFrame(this::frame);
    }

    private void open() {
        running =
                new Running(exhibit(scenes.getSelectedIndex()), DIAL.get(dial.getSelectedIndex()));
        figure.setInnerText("");
    }

    /** A new instance, for exhibits hold their bodies. */
    private static Exhibit exhibit(int index) {
        int at = 0;
        for (Exhibit exhibit : ServiceLoader.load(Exhibit.class)) {
            if (at++ == index) {
                return exhibit;
            }
        }
        throw new IllegalStateException("the page lists more exhibits than there are");
    }

    private void pauseOrGoOn() {
        isPaused = !isPaused;
        pause.setAttribute("aria-pressed", "" + isPaused);
    }

    private void frame(double millis) {
        int due = steps.due(millis);
        if (!isPaused) {
            running.advance(due);
        }
        painter.paint(running);
        if (!figure.getInnerText().equals(painter.figure())) {
            figure.setInnerText(painter.figure());
        }
        Window.requestAnimationFrame(this::frame);
    }
}
