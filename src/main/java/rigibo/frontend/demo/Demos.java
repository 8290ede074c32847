package rigibo.frontend.demo;

import rigibo.frontend.scene.SceneEntry;

import java.util.List;

/** The demos in the order of the menu. */
public final class Demos {

    private Demos() {}

    /** An entry each. */
    public static List<SceneEntry> entries() {
        return List.of(
                CrateDemo.entry(), WheelDemo.entry(), FrictionDemo.entry(), FloodDemo.entry());
    }
}
