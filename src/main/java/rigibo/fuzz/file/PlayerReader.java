package rigibo.fuzz.file;

import rigibo.frontend.save.Places;
import rigibo.frontend.save.SavedPlayer;
import rigibo.frontend.scene.Progress;
import rigibo.frontend.scene.Words;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;

/** Reads settings or progress as at the start: the game must start whatever they contain. */
record PlayerReader(String title) implements Reader {

    @Override
    public List<Sample> samples(Path folder) throws IOException {
        try (SavedPlayer player = new SavedPlayer(Places.in(folder), "de")) {
            player.settings(player.settings().withVolume(0.3));
            player.progress(
                    Progress.none()
                            .solved("two-storeys", 0x123456789abcdef0L, 2)
                            .failed("tilt", -1)
                            .failed("tilt", -1));
        }
        String name = title + ".json";
        return List.of(new Sample(name, Files.readAllBytes(folder.resolve(name))));
    }

    @Override
    public String read(Path file) {
        try (SavedPlayer player = new SavedPlayer(Places.in(file.getParent()), "en")) {
            player.progress().of("two-storeys", 1);
            player.settings().volume();
            return String.join(" ", player.notices(new Words("en")));
        }
    }
}
