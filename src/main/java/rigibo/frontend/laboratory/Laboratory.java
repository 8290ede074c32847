package rigibo.frontend.laboratory;

import rigibo.frontend.scene.SceneEntry;

/** Opens the laboratory. */
public final class Laboratory {

    private Laboratory() {}

    /** How the menu lists it. */
    public static SceneEntry entry() {
        return SceneEntry.of(LaboratoryScene.NAME, LaboratoryScene::new);
    }
}
