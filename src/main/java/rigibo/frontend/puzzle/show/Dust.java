package rigibo.frontend.puzzle.show;

import rigibo.backend.ContactEvent;
import rigibo.backend.ContactView;
import rigibo.backend.Pool;
import rigibo.frontend.puzzle.level.Steps;
import rigibo.frontend.scene.Canvas;
import rigibo.frontend.scene.Color;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;

/** Dust where bodies strike each other, more of it for harder impacts. For display only. */
final class Dust {

    /** Change of a body's speed below which an impact raises no dust, m/s. */
    private static final double LEAST_BLOW = 0.8;

    /** Impulse of an impact, N·s, that raises one puff; four times the impulse raises one more. */
    private static final double PER_PUFF = 22;

    private static final int MOST_PER_BLOW = 9;
    private static final int MOST = 160;

    /**
     * Speed of puffs per m/s of the impact, their highest speed, m/s, and the rate at which air
     * slows them down, 1/s.
     */
    private static final double SPEED = 0.35;

    private static final double MOST_SPEED = 1.6;
    private static final double DRAG = 4;

    /** Speed at which they rise, and at which they grow, m/s. */
    private static final double RISE = 0.25;

    private static final double GROWTH = 0.45;
    private static final Color COLOR = Color.of(0xC9BFB4);

    private final SplittableRandom random = new SplittableRandom(2);
    private final List<Puff> puffs = new ArrayList<>();

    /** One puff; s, m, m/s. */
    private static final class Puff {
        double life;
        double left;
        double x;
        double y;
        double velocityX;
        double velocityY;
        double size;
    }

    /** Raises dust from the contacts that began in the pool's last step. */
    void raise(Pool pool) {
        pool.forEachContact(this::raise);
    }

    private void raise(ContactView contact) {
        boolean isNew = contact.phase == ContactEvent.Phase.BEGIN && contact.bothAlive();
        if (!isNew || puffs.size() >= MOST) {
            return;
        }
        double lighter = Math.min(contact.a.mass(), contact.b.mass());
        double blow = contact.impulse / lighter;
        if (blow < LEAST_BLOW) {
            return;
        }
        int count = (int) Math.min(MOST_PER_BLOW, 2 + Math.sqrt(contact.impulse / PER_PUFF));
        double speed = Math.min(MOST_SPEED, SPEED * blow);
        for (int i = 0; i < count; i++) {
            // Puffs go to both sides along the surface, since the normal leads into one of the
            // bodies.
            double aside = (i % 2 == 0 ? 1 : -1) * between(0.3, 1) * speed;
            Puff puff = new Puff();
            puff.life = between(0.35, 0.8);
            puff.left = puff.life;
            puff.x = contact.x;
            puff.y = contact.y;
            puff.velocityX = -contact.normalY * aside;
            puff.velocityY = contact.normalX * aside + between(0, RISE);
            puff.size = between(0.12, 0.24);
            puffs.add(puff);
        }
    }

    void step() {
        double slowed = Math.exp(-DRAG * Steps.SECONDS);
        for (Puff puff : puffs) {
            puff.left -= Steps.SECONDS;
            puff.velocityX *= slowed;
            puff.velocityY = RISE + (puff.velocityY - RISE) * slowed;
            puff.x += puff.velocityX * Steps.SECONDS;
            puff.y += puff.velocityY * Steps.SECONDS;
            puff.size += GROWTH * Steps.SECONDS;
        }
        puffs.removeIf(puff -> puff.left <= 0);
    }

    void clear() {
        puffs.clear();
    }

    void draw(Canvas canvas) {
        for (Puff puff : puffs) {
            double fading = puff.left / puff.life;
            canvas.puff(puff.x, puff.y, puff.size, COLOR.alpha(0.55 * fading));
        }
    }

    private double between(double least, double most) {
        return least + (most - least) * random.nextDouble();
    }
}
