package rigibo.backend.force;

import rigibo.backend.effect.Fan;
import rigibo.backend.geometry.Angle;

/** F = f·b·(1 − s/R) along each stream, where s is how far down it a body is, and b its width. */
final class FanForce implements ChangingForce {

    private final Fan.Jet[] jets;

    /** Directions of the streams. */
    private final double[] cos;

    private final double[] sin;
    private final Extent across = new Extent();

    FanForce(Fan fan) {
        jets = fan.jets().toArray(Fan.Jet[]::new);
        cos = new double[jets.length];
        sin = new double[jets.length];
        for (int i = 0; i < jets.length; i++) {
            cos[i] = Angle.cos(jets[i].angle());
            sin[i] = Angle.sin(jets[i].angle());
        }
    }

    @Override
    public void add(Instant at) {
        for (int i = 0; i < jets.length; i++) {
            add(jets[i], cos[i], sin[i], at);
        }
    }

    private void add(Fan.Jet jet, double ux, double uy, Instant at) {
        double dx = at.x - jet.x();
        double dy = at.y - jet.y();
        double along = dx * ux + dy * uy;
        if (along >= 0 && along < jet.reach()) {
            double force = jet.force() * exposed(jet, ux, uy, dy * ux - dx * uy, at);
            double faded = force * (1 - along / jet.reach());
            at.push(faded * ux, faded * uy);
        }
    }

    /** Width of a body that is within a stream, m; {@code middle} is where it is across it. */
    private double exposed(Fan.Jet jet, double ux, double uy, double middle, Instant at) {
        // The direction across the stream, (−uy, ux), in the body's own frame.
        double x = at.sin() * ux - at.cos() * uy;
        double y = at.sin() * uy + at.cos() * ux;
        across.measure(at.shape, x, y);
        double half = jet.width() / 2;
        double lower = Math.max(-half, middle + across.least);
        double upper = Math.min(half, middle + across.most);
        return Math.max(0, upper - lower);
    }
}
