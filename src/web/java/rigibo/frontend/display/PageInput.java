package rigibo.frontend.display;

import static org.lwjgl.glfw.GLFW.*;

import org.teavm.jso.JSBody;
import org.teavm.jso.JSFunctor;
import org.teavm.jso.JSObject;
import org.teavm.jso.browser.Performance;
import org.teavm.jso.browser.Window;
import org.teavm.jso.dom.events.Event;
import org.teavm.jso.dom.events.EventListener;
import org.teavm.jso.dom.events.KeyboardEvent;
import org.teavm.jso.dom.events.MouseEvent;
import org.teavm.jso.dom.events.WheelEvent;

import rigibo.frontend.scene.Control;
import rigibo.frontend.scene.Scene;

/**
 * Passes the page's input events on to the game's own {@link Input}, like GLFW's callbacks in a
 * window: a mouse, a pen and the first finger are one pointer.
 */
final class PageInput {

    /** Pixels by which a wheel scrolls a page for each notch. */
    private static final double PER_NOTCH = 100;

    private static final double MILLIS = 1e3;

    private final PageSurface surface;
    private final PageDisplay display;
    private Input input;
    private Fingers fingers;

    /** Time of the last touch, s: a late page must not take a short touch for a long one. */
    private double touched;

    PageInput(PageSurface surface, PageDisplay display) {
        this.surface = surface;
        this.display = display;
        listen("pointermove", this::moved);
        listen("pointerdown", this::pressed);
        listen("pointerup", this::released);
        listen("pointercancel", this::taken);
        listen("wheel", this::scrolled);
        listen("contextmenu", Event::preventDefault);
        takeDropped(display::dropped);
        PageTyping.listen(this::typed, () -> press(GLFW_KEY_ENTER));
        Window.current().addEventListener("keydown", this::keyDown);
        Window.current().addEventListener("keyup", this::keyUp);
        Window.current().addEventListener("paste", event -> display.pasted(pasted(event)));
    }

    /** Takes a file from the browser. */
    @JSFunctor
    interface Taker extends JSObject {
        void take(String name, String text);
    }

    /** Takes the first of several files. */
    @JSBody(
            params = "taker",
            script =
                    "addEventListener('dragover', function(event) { event.preventDefault(); });"
                        + " addEventListener('drop', function(event) { event.preventDefault(); var"
                        + " file = event.dataTransfer.files[0]; if (file) {"
                        + " file.text().then(function(text) { taker(file.name, text); }); } });")
    private static native void takeDropped(Taker taker);

    private void listen(String kind, EventListener<Event> listener) {
        surface.canvas()
                .addEventListener(
                        kind,
                        event -> {
                            if (input != null && !display.isLeaving()) {
                                listener.handleEvent(event);
                            }
                        });
    }

    /** Sets the scene that later presses are meant for. */
    void shows(Scene next) {
        input =
                new Input(
                        next,
                        display::showMenu,
                        display::toggleFullScreen,
                        display::toggleMute,
                        () -> {},
                        () -> display.settings().keys());
        fingers = new Fingers(input, () -> touched);
    }

    /** Called for each picture: a finger may have rested. */
    void turn() {
        look();
        fingers.turn(Performance.now() / MILLIS);
    }

    /** Points at a control. */
    void point(Control control) {
        point(control, control.share());
    }

    /** Presses a control at a share of its width. */
    void use(Control control, double share) {
        if (point(control, share)) {
            input.mouseButton(GLFW_MOUSE_BUTTON_LEFT, GLFW_PRESS);
            input.mouseButton(GLFW_MOUSE_BUTTON_LEFT, GLFW_RELEASE);
        }
    }

    private boolean point(Control control, double share) {
        boolean isMeant = input != null && !display.isLeaving();
        if (isMeant) {
            look();
            double x = control.x() + share * control.width();
            input.point(x, control.y() + control.height() / 2);
        }
        return isMeant;
    }

    private void moved(Event event) {
        if (isFinger(event)) {
            look();
            fingers.slid(id(event), x(event), y(event));
        } else {
            point((MouseEvent) event);
        }
    }

    /** Takes over the layout drawn last, at which presses are aimed. */
    private void look() {
        input.shows(surface.layout(), PageSurface.ratio(), surface.wayBack());
    }

    private void point(MouseEvent event) {
        if (isFirst(event)) {
            look();
            input.cursor(x(event), y(event));
        }
    }

    private void pressed(Event event) {
        event.preventDefault();
        MouseEvent mouse = (MouseEvent) event;
        if (isFinger(event)) {
            look();
            capture(event);
            touched = millis(event) / MILLIS;
            fingers.down(id(event), x(event), y(event));
        } else if (isFirst(mouse)) {
            point(mouse);
            capture(event);
            input.modifiers(held(mouse.getShiftKey(), mouse.getCtrlKey(), mouse.getMetaKey()));
            input.mouseButton(button(mouse), GLFW_PRESS);
        }
    }

    private void released(Event event) {
        MouseEvent mouse = (MouseEvent) event;
        if (isFinger(event)) {
            look();
            touched = millis(event) / MILLIS;
            fingers.lifted(id(event));
            PageTyping.show(display.isTyping());
        } else if (isFirst(mouse)) {
            point(mouse);
            input.mouseButton(button(mouse), GLFW_RELEASE);
        }
    }

    private void taken(Event event) {
        if (isFinger(event)) {
            fingers.taken(id(event));
        } else {
            released(event);
        }
    }

    private static int button(MouseEvent mouse) {
        return switch (mouse.getButton()) {
            case MouseEvent.RIGHT_BUTTON -> GLFW_MOUSE_BUTTON_RIGHT;
            case MouseEvent.MIDDLE_BUTTON -> GLFW_MOUSE_BUTTON_MIDDLE;
            default -> GLFW_MOUSE_BUTTON_LEFT;
        };
    }

    private void scrolled(Event event) {
        event.preventDefault();
        point((MouseEvent) event);
        input.scroll(-((WheelEvent) event).getDeltaY() / PER_NOTCH);
    }

    private void keyDown(Event event) {
        KeyboardEvent key = (KeyboardEvent) event;
        if (input == null || display.isLeaving()) {
            return;
        }
        int code = PageKeys.code(key.getCode(), key.getKey());
        input.modifiers(held(key.isShiftKey(), key.isCtrlKey(), key.isMetaKey()), code, GLFW_PRESS);
        if (PageKeys.isOurs(code, key)) {
            event.preventDefault();
        }
        input.key(code, key.isRepeat() ? GLFW_REPEAT : GLFW_PRESS);
        if (key.getKey().codePointCount(0, key.getKey().length()) == 1 && !key.isCtrlKey()) {
            input.character(key.getKey().codePointAt(0));
        }
    }

    private void keyUp(Event event) {
        KeyboardEvent key = (KeyboardEvent) event;
        if (input != null) {
            int code = PageKeys.code(key.getCode(), key.getKey());
            // Firefox clicks the focused element when the space bar is released.
            if (PageKeys.isOurs(code, key)) {
                event.preventDefault();
            }
            input.modifiers(
                    held(key.isShiftKey(), key.isCtrlKey(), key.isMetaKey()), code, GLFW_RELEASE);
        }
    }

    private void typed(int removed, String text) {
        for (int i = 0; i < removed; i++) {
            press(GLFW_KEY_BACKSPACE);
        }
        text.codePoints().forEach(input::character);
    }

    /** Presses a key, if the scene accepts typing. */
    private void press(int key) {
        if (display.isTyping()) {
            input.key(key, GLFW_PRESS);
            PageTyping.show(display.isTyping());
        }
    }

    private static int held(boolean shift, boolean control, boolean meta) {
        return (shift ? GLFW_MOD_SHIFT : 0)
                | (control ? GLFW_MOD_CONTROL : 0)
                | (meta ? GLFW_MOD_SUPER : 0);
    }

    @JSBody(params = "event", script = "return event.offsetX;")
    private static native double x(Event event);

    @JSBody(params = "event", script = "return event.offsetY;")
    private static native double y(Event event);

    /** Whether a pointer is the first one; a wheel is no pointer, and so not a second one. */
    @JSBody(params = "event", script = "return event.isPrimary !== false;")
    private static native boolean isFirst(Event event);

    @JSBody(params = "event", script = "return event.pointerType === 'touch';")
    private static native boolean isFinger(Event event);

    @JSBody(params = "event", script = "return event.pointerId;")
    private static native int id(Event event);

    @JSBody(params = "event", script = "return event.timeStamp;")
    private static native double millis(Event event);

    /** Keeps a drag going beyond the page's edge. */
    @JSBody(params = "event", script = "event.target.setPointerCapture(event.pointerId);")
    private static native void capture(Event event);

    @JSBody(params = "event", script = "return event.clipboardData.getData('text/plain');")
    private static native String pasted(Event event);
}
