package rigibo.frontend.puzzle.show;

import rigibo.frontend.puzzle.level.Steps;
import rigibo.frontend.scene.Camera;
import rigibo.frontend.scene.Canvas;
import rigibo.frontend.scene.Color;

import java.util.ArrayList;
import java.util.List;

/** Light and a widening ring where a bomb blew up or a body became a stone. */
final class Flashes {

    /** Duration of a flash, frames. */
    private static final int SEEN = Steps.of(0.45);

    private static final double STRONGEST = 0.8;

    private final List<Flash> flashes = new ArrayList<>();

    private static final class Flash {
        final double x;
        final double y;
        final double reach;
        final Color color;
        int age;

        Flash(double x, double y, double reach, Color color) {
            this.x = x;
            this.y = y;
            this.reach = reach;
            this.color = color;
        }
    }

    void clear() {
        flashes.clear();
    }

    /** Starts the flash of a bomb at a point of the world, with the bomb's reach, m. */
    void blast(double x, double y, double reach) {
        flashes.add(new Flash(x, y, reach, Bombs.FLAME));
    }

    /** Starts the flash of a body of a radius that became a stone, m. */
    void freeze(double x, double y, double radius) {
        flashes.add(new Flash(x, y, 1.6 * radius, Color.ICE));
    }

    /** Makes one frame of 1/60 s. */
    void step() {
        flashes.forEach(flash -> flash.age++);
        flashes.removeIf(flash -> flash.age >= SEEN);
    }

    void draw(Canvas canvas, Camera camera) {
        for (Flash flash : flashes) {
            double share = flash.age / (double) SEEN;
            double left = (1 - share) * (1 - share);
            canvas.glow(flash.x, flash.y, 2 * flash.reach, flash.color.alpha(STRONGEST * left));
            double radius = (0.25 + 0.75 * share) * flash.reach * camera.scale();
            canvas.ring(
                    camera.screenX(flash.x),
                    camera.screenY(flash.y),
                    radius,
                    2 + 6 * left,
                    1,
                    flash.color.alpha(left));
        }
    }
}
