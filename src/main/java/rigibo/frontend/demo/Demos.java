package rigibo.frontend.demo;

import rigibo.backend.effect.Effects;
import rigibo.frontend.scene.Director;
import rigibo.frontend.scene.Scene;
import rigibo.frontend.scene.SceneEntry;
import rigibo.frontend.scene.Words;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/** The demos in the order of the menu. */
public final class Demos {

    private Demos() {}

    /** One menu entry per demo. */
    public static List<SceneEntry> entries() {
        return List.of(
                CrateDemo.entry(),
                WheelDemo.entry(),
                FrictionDemo.entry(),
                FloodDemo.entry(),
                PendulumDemo.entry(),
                CarDemo.entry());
    }

    /** The effects that each demo declares, by its English name. */
    public static Map<String, Effects> effects() {
        Map<String, Effects> effects = new LinkedHashMap<>();
        Words words = new Words("en");
        for (Demo demo :
                List.of(
                        new CrateDemo(words),
                        new WheelDemo(words),
                        new FrictionDemo(words),
                        new FloodDemo(words),
                        new PendulumDemo(words),
                        new CarDemo(words))) {
            effects.put(words.of("scene." + demo.name()), demo.effects());
        }
        return effects;
    }

    /**
     * Returns the demo before (−1) or after (1) one by its name; after the last comes the first.
     */
    static Scene beside(String name, int direction, Director director) {
        List<SceneEntry> all = entries();
        int at = 0;
        while (!name.equals(all.get(at).name())) {
            at++;
        }
        int next = Math.floorMod(at + direction, all.size());
        return all.get(next).open().apply(director);
    }
}
