package rigibo.frontend.draw;

import rigibo.frontend.scene.Layout;
import rigibo.frontend.scene.Scenery;

import java.util.HashMap;
import java.util.Map;

/** Pictures of sceneries, each computed when it is first shown. */
final class Backdrops {

    private final Map<Backdrop, Baked> baked = new HashMap<>();

    /** A scenery as a window shows it. */
    private record Backdrop(Scenery scenery, Layout window) {}

    /** A scenery as a window shows it, in a certain detail. */
    Baked of(Scenery scenery, Layout window, Detail detail) {
        return baked.computeIfAbsent(
                new Backdrop(scenery, window),
                any ->
                        new Baked(
                                shader(scenery),
                                (int) Math.round(window.width() * window.ratio()),
                                (int) Math.round(window.height() * window.ratio()),
                                1,
                                detail,
                                shader -> shader.set("window", window)));
    }

    private static String shader(Scenery scenery) {
        return switch (scenery) {
            case WORKSHOP -> "workshop";
            case MOON -> "moon";
        };
    }

    /** Forgets all pictures, and frees what OpenGL holds of them. */
    void free() {
        baked.values().forEach(Baked::free);
        baked.clear();
    }
}
