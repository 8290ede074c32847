package rigibo.frontend.puzzle.picture;

import rigibo.backend.geometry.Polygon;
import rigibo.frontend.puzzle.level.Level;
import rigibo.frontend.puzzle.level.Platform;
import rigibo.frontend.scene.Canvas;
import rigibo.frontend.scene.Skin;

import java.util.ArrayList;
import java.util.List;

/**
 * The look of a level's goal: a chequered cushion with a flag. The flag is only drawn, behind all
 * bodies, at the place where the bodies hide least of it at the start; it stays there in play.
 */
public final class Goal {

    private final List<Part> parts;

    /**
     * A goal among bodies.
     *
     * @param bodies of the level's start
     */
    public Goal(Platform goal, List<Part> bodies) {
        parts = new ArrayList<>(Flag.best(goal, bodies).parts());
        Polygon cushion = Polygon.box(goal.width(), goal.height());
        parts.add(new Part(cushion, goal.x(), goal.y(), goal.angle(), Skin.GOAL));
    }

    public static Goal of(Level level) {
        return new Goal(level.platform(), level.bodies().stream().map(Part::of).toList());
    }

    /** The pole, the cloth and the cushion, from back to front. */
    List<Part> parts() {
        return List.copyOf(parts);
    }

    /** Draws it; bodies drawn later are in front of it. */
    public void draw(Canvas canvas) {
        parts.forEach(part -> part.draw(canvas));
    }
}
