package rigibo.backend.force;

import rigibo.backend.effect.Magnet;

/** a = −s·(1 − r/R)·(r/r) towards each magnet, within its reach R. */
final class MagnetForce implements ChangingForce {

    private final Magnet.Pole[] poles;

    MagnetForce(Magnet magnet) {
        poles = magnet.poles().toArray(Magnet.Pole[]::new);
    }

    @Override
    public void add(Instant at) {
        for (Magnet.Pole pole : poles) {
            double dx = pole.x() - at.x;
            double dy = pole.y() - at.y;
            double distance = Math.sqrt(dx * dx + dy * dy);
            boolean isMeant = (pole.category() & at.category) != 0;
            if (isMeant && distance > 0 && distance < pole.reach()) {
                double pull = pole.strength() * (1 - distance / pole.reach());
                at.accelerationX += pull * (dx / distance);
                at.accelerationY += pull * (dy / distance);
            }
        }
    }
}
