package rigibo.frontend.display;

import org.lwjgl.opengl.GL33C;
import org.teavm.jso.JSBody;
import org.teavm.jso.JSObject;
import org.teavm.jso.browser.Window;
import org.teavm.jso.canvas.CanvasRenderingContext2D;
import org.teavm.jso.dom.events.Event;
import org.teavm.jso.dom.html.HTMLCanvasElement;
import org.teavm.jso.dom.html.HTMLDocument;
import org.teavm.jso.webgl.WebGL2RenderingContext;
import org.teavm.jso.webgl.WebGLRenderingContext;

import rigibo.frontend.draw.Detail;
import rigibo.frontend.draw.DetailChoice;
import rigibo.frontend.draw.Painter;
import rigibo.frontend.draw.Paper;
import rigibo.frontend.scene.DisplayException;
import rigibo.frontend.scene.Edges;
import rigibo.frontend.scene.Layout;
import rigibo.frontend.scene.Pane;
import rigibo.frontend.scene.Scene;
import rigibo.frontend.scene.Settings;
import rigibo.frontend.scene.widget.Plate;

/**
 * The two canvases that fill the page: WebGL for bodies, and above it one for plates, lines and
 * words.
 */
final class PageSurface {

    private final HTMLCanvasElement below = canvas("world");
    private final HTMLCanvasElement above = canvas("paper");
    private final WebGL2RenderingContext gl;
    private final Painter painter;
    private final DetailChoice choice = new DetailChoice();
    private Layout layout = Layout.ALONE;
    private Plate wayBack = Plate.NONE;

    PageSurface() {
        gl = webGl(below);
        if (gl == null) {
            throw new DisplayException("this browser has no WebGL 2");
        }
        GL33C.use(gl);
        // Phones take the context from hidden pages; the page then starts again from its stored
        // state.
        below.addEventListener("webglcontextlost", Event::preventDefault);
        below.addEventListener(
                "webglcontextrestored", event -> Window.current().getLocation().reload());
        Paper.use((CanvasRenderingContext2D) above.getContext("2d"));
        painter = new Painter();
    }

    /** The canvas that receives pointers. */
    HTMLCanvasElement canvas() {
        return above;
    }

    Layout layout() {
        return layout;
    }

    /** The plate that acts as Esc. */
    Plate wayBack() {
        return wayBack;
    }

    /** Pixels of the screen for each of the page. */
    static double ratio() {
        return Window.current().getDevicePixelRatio();
    }

    /** Draws trial pictures of a new scene, while the amount of detail is undecided. */
    void begin(Scene scene, Settings settings) {
        choice.renderer(renderer(gl));
        while (choice.isOpen(settings.detail())) {
            long begin = System.nanoTime();
            draw(scene, settings, new Toast(), 0);
            finish(gl);
            choice.tried(System.nanoTime() - begin);
        }
    }

    /** Waits until all is drawn; reading a pixel is the only way. */
    @JSBody(
            params = "gl",
            script = "gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, new Uint8Array(4));")
    private static native void finish(JSObject gl);

    /** Draws a picture; returns the page's time for it, ns. */
    long draw(Scene scene, Settings settings, Toast toast, double dark) {
        long begin = System.nanoTime();
        layOut(scene, settings);
        // Otherwise Chromium clears the copied background with the first drawing over it.
        gl.clear(WebGLRenderingContext.COLOR_BUFFER_BIT);
        Paper.clear();
        Detail detail = choice.detail(settings.detail());
        painter.begin(layout, scene.scenery(), begin / 1e9, detail);
        scene.draw(painter);
        WayBack.draw(painter, wayBack);
        toast.draw(painter);
        painter.end(dark);
        return System.nanoTime() - begin;
    }

    private void layOut(Scene scene, Settings settings) {
        int width = (int) Math.round(ratio() * above.getClientWidth());
        int height = (int) Math.round(ratio() * above.getClientHeight());
        if (above.getWidth() != width || above.getHeight() != height) {
            size(below, width, height);
            size(above, width, height);
        }
        Pane pane = new Pane(width, height, ratio(), hidden(), isTouched());
        layout = pane.layout(scene, settings.text().share());
        wayBack = WayBack.place(pane, layout, scene);
    }

    /**
     * Widths of the page's edges hidden by notches and round corners, in pixels; see {@code
     * #hidden}.
     */
    private static Edges hidden() {
        return new Edges(
                ratio() * padding("Left"),
                ratio() * padding("Top"),
                ratio() * padding("Right"),
                ratio() * padding("Bottom"));
    }

    /** A width that only the browser knows, and tells only to style sheets. */
    @JSBody(
            params = "side",
            script =
                    "return parseFloat(getComputedStyle(document.getElementById('hidden'))["
                            + "'padding' + side]) || 0;")
    private static native double padding(String side);

    /** Whether no pointing device is as precise as a mouse, as on phones and tablets. */
    @JSBody(
            script =
                    "return matchMedia('(any-pointer: coarse) and (not (any-pointer:"
                            + " fine))').matches;")
    private static native boolean isTouched();

    private static void size(HTMLCanvasElement canvas, int width, int height) {
        canvas.setWidth(width);
        canvas.setHeight(height);
    }

    private static HTMLCanvasElement canvas(String id) {
        return (HTMLCanvasElement) HTMLDocument.current().getElementById(id);
    }

    @JSBody(
            params = "canvas",
            script =
                    "return canvas.getContext('webgl2', {alpha: false, antialias: false, depth:"
                            + " false, stencil: false});")
    private static native WebGL2RenderingContext webGl(HTMLCanvasElement canvas);

    @JSBody(
            params = "gl",
            script =
                    "var told = gl.getExtension('WEBGL_debug_renderer_info');"
                            + "return told ? gl.getParameter(told.UNMASKED_RENDERER_WEBGL) : '';")
    private static native String renderer(JSObject gl);
}
