package rigibo.frontend.puzzle;

import rigibo.frontend.puzzle.endless.Making;
import rigibo.frontend.puzzle.endless.Occasion;
import rigibo.frontend.scene.Director;
import rigibo.frontend.scene.Scene;

import java.util.Optional;
import java.util.function.Supplier;

/** A level that is made by chance while the one before it is played. */
final class PreparedSequel implements Sequel {

    private final Director director;
    private final Occasion next;
    private final Making making;
    private boolean isHandedOver;

    /** Begins to make the level. */
    PreparedSequel(Director director, Occasion next) {
        this.director = director;
        this.next = next;
        making = Making.begin(next.seeds());
    }

    /** The level, or the scene that shows it being made. */
    @Override
    public Optional<Supplier<Scene>> next() {
        return Optional.of(this::scene);
    }

    private Scene scene() {
        return making.made()
                .map(made -> MadeLevelScene.play(director, next, made))
                .orElseGet(this::waiting);
    }

    private Scene waiting() {
        isHandedOver = true;
        return new MadeLevelScene(director, next, making);
    }

    @Override
    public void close() {
        if (!isHandedOver) {
            making.stop();
        }
    }
}
