package rigibo.backend.force;

import rigibo.backend.effect.AirDrag;
import rigibo.backend.effect.Wind;
import rigibo.backend.geometry.ShapeKind;

/** F = −½·ρ·c·A·|u|·u, where u is the velocity relative to the air and A the width across it. */
final class AirDragForce implements ChangingForce {

    private final double half;
    private final Wind wind;
    private final Extent across = new Extent();

    AirDragForce(AirDrag air, Wind wind) {
        half = air.density() * air.coefficient() / 2;
        this.wind = wind;
    }

    @Override
    public void add(Instant at) {
        double share = wind.gusts().at(at.time);
        double ux = at.velocityX - share * wind.x();
        double uy = at.velocityY - share * wind.y();
        double speed = Math.sqrt(ux * ux + uy * uy);
        if (speed > 0) {
            double strength = half * speed * widthAcross(at, ux, uy, speed);
            at.push(-strength * ux, -strength * uy);
        }
    }

    /**
     * Width of the shape across its velocity relative to the air, m; {@code speed} is the amount of
     * that velocity.
     */
    private double widthAcross(Instant at, double ux, double uy, double speed) {
        if (at.shape.kind() == ShapeKind.CIRCLE) {
            return 2 * at.boundingRadius;
        }
        double x = ux / speed;
        double y = uy / speed;
        double acrossX = at.sin() * x - at.cos() * y;
        double acrossY = at.sin() * y + at.cos() * x;
        across.measure(at.shape, acrossX, acrossY);
        return across.most - across.least;
    }
}
