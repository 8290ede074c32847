package rigibo.frontend.gallery;

import rigibo.frontend.scene.SceneEntry;

import java.util.List;
import java.util.Optional;

/** Opens the gallery. */
public final class Gallery {

    private Gallery() {}

    /** Menu entry of the gallery. */
    public static SceneEntry entry() {
        return SceneEntry.of(
                GalleryScene.NAME, director -> new GalleryScene(director, Optional.empty()));
    }

    /** One entry per exhibit, for the command line. */
    public static List<SceneEntry> exhibits() {
        return Exhibits.all().stream().map(Gallery::entry).toList();
    }

    private static SceneEntry entry(Found found) {
        return new SceneEntry(
                found.name(),
                words -> new ExhibitWords(words).title(found),
                words -> new ExhibitWords(words).about(found),
                Optional.empty(),
                director -> new ExhibitScene(director, found));
    }
}
