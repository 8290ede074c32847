package rigibo.backend.impact;

import rigibo.backend.storage.RoundOff;

import java.util.Arrays;

/**
 * Newton's law of impact with Coulomb's friction, for one or two points of one pair at once.
 *
 * <p>Rows 0 and 1 are the normals at the points. Row 2 is the tangent at the midpoint of the
 * points, which both points of a flat contact share. kᵢⱼ is the speed that a unit impulse in row j
 * gives row i (Baraff, "Analytical methods for dynamic simulation", 1989, eq. 9). The law requires
 * impulses j ≥ 0, and vₙ' = −e·vₙ wherever j &gt; 0. Sticking is tried first: vₜ' = 0, valid if
 * |jₜ| ≤ μ·Σjₙ. Otherwise the contact slides, and jₜ = ±μ·Σjₙ is put into the normal equations,
 * since friction can lift or press the points. An impact never adds energy: where the law would
 * (Kane and Levinson, "Dynamics", 1985), all impulses are scaled down until it does not. With
 * running surfaces vₜ is measured relative to them, so that sticking aims at their speed, and the
 * work of their drives is not counted as added energy.
 */
public final class ImpactLaw {

    private static final int TANGENT = 2;

    /** Relative determinant of two rows below which their points count as one point. */
    private static final double SINGULAR = 1e-9;

    private Impact impact;
    private final double[] k = new double[9];
    private final double[] velocity = new double[3];
    private final double[] target = new double[2];
    private final double[] result = new double[3];
    private final double[] leverA = new double[3];
    private final double[] leverB = new double[3];

    /** Resolves an impact with its own elasticity: writes impulses and new velocities into it. */
    public void resolve(Impact impact) {
        resolve(impact, impact.elasticity);
    }

    /** Resolves an impact with another elasticity, 0 to 1. */
    public void resolve(Impact impact, double elasticity) {
        this.impact = impact;
        if (impact.points == 2 && isOnePoint()) {
            impact.keepOnly(impact.parting(0) <= impact.parting(1) ? 0 : 1);
        }
        buildRows();
        for (int i = 0; i < impact.points; i++) {
            target[i] = velocity[i] < 0 ? -elasticity * velocity[i] : 0;
        }
        Arrays.fill(result, 0);
        if (impact.slowestParting() < 0) {
            if (!solve(impact.friction) && !solve(0)) {
                pushFaster();
            }
            limitEnergy();
        }
        apply();
    }

    /** Applies an impulse only at the point that closes faster. */
    private void pushFaster() {
        Arrays.fill(result, 0);
        int first = velocity[0] <= velocity[1] ? 0 : 1;
        result[first] = (target[first] - velocity[first]) / k[4 * first];
    }

    private boolean isOnePoint() {
        buildRows();
        return k[0] * k[4] - k[1] * k[1] < SINGULAR * k[0] * k[4];
    }

    private void buildRows() {
        Impact b = impact;
        double nx = b.normalX;
        double ny = b.normalY;
        int last = b.points - 1;
        for (int i = 0; i < b.points; i++) {
            leverA[i] = b.armAX[i] * ny - b.armAY[i] * nx;
            leverB[i] = b.armBX[i] * ny - b.armBY[i] * nx;
            velocity[i] = b.parting(i);
        }
        double ax = (b.armAX[0] + b.armAX[last]) / 2;
        double ay = (b.armAY[0] + b.armAY[last]) / 2;
        double bx = (b.armBX[0] + b.armBX[last]) / 2;
        double by = (b.armBY[0] + b.armBY[last]) / 2;
        leverA[TANGENT] = ax * nx + ay * ny;
        leverB[TANGENT] = bx * nx + by * ny;
        double vx = b.velocityBX - b.spinB * by - b.velocityAX + b.spinA * ay;
        double vy = b.velocityBY + b.spinB * bx - b.velocityAY - b.spinA * ax;
        velocity[TANGENT] = vy * nx - vx * ny - b.surfaceSpeed;
        if (last == 0) {
            leverA[1] = 0;
            leverB[1] = 0;
            velocity[1] = 0;
        }
        double inverseMass = b.inverseMassA + b.inverseMassB;
        for (int i = 0; i < 3; i++) {
            for (int j = 0; j < 3; j++) {
                double direct = (i == TANGENT) == (j == TANGENT) ? inverseMass : 0;
                k[3 * i + j] =
                        direct
                                + b.inverseInertiaA * leverA[i] * leverA[j]
                                + b.inverseInertiaB * leverB[i] * leverB[j];
            }
        }
    }

    /**
     * Finds the points that push: both, or one if the other then parts by itself. Returns whether
     * there is such a solution.
     */
    private boolean solve(double friction) {
        if (impact.points == 1) {
            return solveOne(0, friction);
        }
        return solveBoth(friction)
                || solveOne(0, friction) && partsBy(1)
                || solveOne(1, friction) && partsBy(0);
    }

    private boolean partsBy(int i) {
        double after = velocity[i];
        for (int j = 0; j < 3; j++) {
            after += k[3 * i + j] * result[j];
        }
        // The other point's impulse may lift this one exactly at the limit: allow for round-off.
        return after
                >= target[i] - RoundOff.OF_SUMS * (Math.abs(velocity[i]) + Math.abs(target[i]));
    }

    private boolean solveOne(int i, double friction) {
        Arrays.fill(result, 0);
        double wanted = target[i] - velocity[i];
        if (wanted <= 0) {
            // Sticking friction could press a parting point on, and so hold it.
            return false;
        }
        double kn = k[4 * i];
        double kt = k[8];
        double knt = k[3 * i + TANGENT];
        if (friction > 0) {
            double determinant = kn * kt - knt * knt;
            double normal = (kt * wanted + knt * velocity[TANGENT]) / determinant;
            double tangent = (-knt * wanted - kn * velocity[TANGENT]) / determinant;
            if (normal >= 0 && Math.abs(tangent) <= friction * normal) {
                result[i] = normal;
                result[TANGENT] = tangent;
                return true;
            }
            double slope = tangent > 0 ? friction : -friction;
            double sliding = kn + slope * knt;
            if (!(sliding > 0)) {
                return false;
            }
            result[i] = wanted / sliding;
            result[TANGENT] = slope * result[i];
        } else {
            result[i] = wanted / kn;
        }
        return true;
    }

    private boolean solveBoth(double friction) {
        if (friction > 0) {
            return stickBoth(friction) || slideBoth(friction);
        }
        return slideBoth(0);
    }

    /**
     * Solves sticking at both points, by elimination of the tangent; returns whether it is valid.
     */
    private boolean stickBoth(double friction) {
        double kt = k[8];
        double k00 = k[0] - k[2] * k[2] / kt;
        double k01 = k[1] - k[2] * k[5] / kt;
        double k11 = k[4] - k[5] * k[5] / kt;
        double wanted0 = target[0] - velocity[0] + k[2] * velocity[TANGENT] / kt;
        double wanted1 = target[1] - velocity[1] + k[5] * velocity[TANGENT] / kt;
        double determinant = k00 * k11 - k01 * k01;
        if (!(determinant > SINGULAR * k00 * k11)) {
            result[TANGENT] = -velocity[TANGENT];
            return false;
        }
        result[0] = (k11 * wanted0 - k01 * wanted1) / determinant;
        result[1] = (k00 * wanted1 - k01 * wanted0) / determinant;
        result[TANGENT] = -(velocity[TANGENT] + k[2] * result[0] + k[5] * result[1]) / kt;
        return result[0] >= 0
                && result[1] >= 0
                && Math.abs(result[TANGENT]) <= friction * (result[0] + result[1]);
    }

    /**
     * Solves sliding at both points, in the direction that the sticking friction would have had to
     * oppose; returns whether it is valid.
     */
    private boolean slideBoth(double friction) {
        double slope = result[TANGENT] > 0 ? friction : -friction;
        double k00 = k[0] + slope * k[2];
        double k01 = k[1] + slope * k[2];
        double k10 = k[1] + slope * k[5];
        double k11 = k[4] + slope * k[5];
        double wanted0 = target[0] - velocity[0];
        double wanted1 = target[1] - velocity[1];
        double determinant = k00 * k11 - k01 * k10;
        if (!(determinant > 0)) {
            return false;
        }
        result[0] = (k11 * wanted0 - k01 * wanted1) / determinant;
        result[1] = (k00 * wanted1 - k10 * wanted0) / determinant;
        result[TANGENT] = slope * (result[0] + result[1]);
        return result[0] >= 0 && result[1] >= 0 && rubs();
    }

    /**
     * Whether friction opposes the sliding that remains. Where sticking failed only because a point
     * would have had to pull, friction would drive the sliding; then that point parts instead.
     */
    private boolean rubs() {
        double after = velocity[TANGENT];
        for (int j = 0; j < 3; j++) {
            after += k[3 * TANGENT + j] * result[j];
        }
        return result[TANGENT] * after
                <= RoundOff.OF_SUMS * Math.abs(result[TANGENT] * velocity[TANGENT]);
    }

    /** The work of impulses scaled by s is s·j·v + ½s²·j·K·j; it must not be positive. */
    private void limitEnergy() {
        double linear = 0;
        double quadratic = 0;
        for (int i = 0; i < 3; i++) {
            linear += result[i] * velocity[i];
            for (int j = 0; j < 3; j++) {
                quadratic += result[i] * k[3 * i + j] * result[j];
            }
        }
        if (linear + quadratic / 2 > 0) {
            double scale = Math.max(0, -2 * linear / quadratic);
            for (int i = 0; i < 3; i++) {
                result[i] *= scale;
            }
        }
    }

    private void apply() {
        Impact b = impact;
        double normal = 0;
        double momentA = result[TANGENT] * leverA[TANGENT];
        double momentB = result[TANGENT] * leverB[TANGENT];
        for (int i = 0; i < b.points; i++) {
            b.normalImpulse[i] = result[i];
            normal += result[i];
            momentA += result[i] * leverA[i];
            momentB += result[i] * leverB[i];
        }
        b.tangentImpulse = result[TANGENT];
        double jx = normal * b.normalX - result[TANGENT] * b.normalY;
        double jy = normal * b.normalY + result[TANGENT] * b.normalX;
        b.velocityAX -= b.inverseMassA * jx;
        b.velocityAY -= b.inverseMassA * jy;
        b.spinA -= b.inverseInertiaA * momentA;
        b.velocityBX += b.inverseMassB * jx;
        b.velocityBY += b.inverseMassB * jy;
        b.spinB += b.inverseInertiaB * momentB;
    }
}
