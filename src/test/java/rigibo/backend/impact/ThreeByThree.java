package rigibo.backend.impact;

/**
 * What two points' impact comes to, by trying the law's cases one after the other, each as a dense
 * 3 × 3 system: the impulses at the points, and that along the tangent in their middle. What a unit
 * impulse gives the points is read off the bodies that it moves.
 */
final class ThreeByThree {

    /** Which points push, in the order in which the law tries it. */
    private static final boolean[][] PUSHING = {{true, true}, {true, false}, {false, true}};

    private final Impact impact;
    private final double[][] given = new double[3][];
    private final double[] before;
    private final double[] wanted = new double[2];

    /** N·s. */
    double[] impulse = new double[3];

    /** How near a condition came to holding, or to failing: round-off decides there. */
    double margin = Double.POSITIVE_INFINITY;

    /** Cases that failed before the one that holds: two of each kind of pushing, then smooth. */
    int tried;

    ThreeByThree(Impact impact) {
        this.impact = impact;
        before = rows(impact);
        for (int i = 0; i < 2; i++) {
            wanted[i] = Math.max(0, -impact.elasticity * before[i]) - before[i];
        }
        for (int j = 0; j < 3; j++) {
            given[j] = givenBy(j);
        }
        if (Math.max(wanted[0], wanted[1]) > 0) {
            solve();
            keepEnergy();
        }
    }

    /** Speeds of B's points seen from A's: both along the normal, their mean along the belt. */
    private static double[] rows(Impact impact) {
        double[] rows = {0, 0, -impact.surfaceSpeed};
        for (int i = 0; i < 2; i++) {
            double x = TwoByTwo.pointX(impact, i);
            double y = TwoByTwo.pointY(impact, i);
            rows[i] = x * impact.normalX + y * impact.normalY;
            rows[2] += (y * impact.normalX - x * impact.normalY) / 2;
        }
        return rows;
    }

    /** The speeds of bodies that nothing moves but a unit impulse, at a point or shared by both. */
    private double[] givenBy(int row) {
        Impact pushed = Meet.stopped(impact);
        double x = row < 2 ? impact.normalX : -impact.normalY;
        double y = row < 2 ? impact.normalY : impact.normalX;
        for (int i = 0; i < 2; i++) {
            double share = row == 2 ? 0.5 : row == i ? 1 : 0;
            pushed.velocityAX -= share * x * impact.inverseMassA;
            pushed.velocityAY -= share * y * impact.inverseMassA;
            pushed.spinA -=
                    share * (impact.armAX[i] * y - impact.armAY[i] * x) * impact.inverseInertiaA;
            pushed.velocityBX += share * x * impact.inverseMassB;
            pushed.velocityBY += share * y * impact.inverseMassB;
            pushed.spinB +=
                    share * (impact.armBX[i] * y - impact.armBY[i] * x) * impact.inverseInertiaB;
        }
        return rows(pushed);
    }

    private void solve() {
        for (double friction : new double[] {impact.friction, 0}) {
            for (boolean[] pushing : PUSHING) {
                if (sticks(pushing, friction) || slides(pushing, friction)) {
                    return;
                }
            }
        }
        throw new AssertionError("without friction there is an answer");
    }

    private boolean sticks(boolean[] pushing, double friction) {
        equate(pushing, new double[] {given[0][2], given[1][2], given[2][2], -before[2]});
        double most = friction * (impulse[0] + impulse[1]);
        return counts(friction > 0 && isLawful(pushing) && holds(most - Math.abs(impulse[2])));
    }

    /** The way that sticking would have had to be held against, and against the sliding. */
    private boolean slides(boolean[] pushing, double friction) {
        double slope = Math.copySign(friction, impulse[2]);
        equate(pushing, new double[] {-slope, -slope, 1, 0});
        return counts(isLawful(pushing) && (slope == 0 || holds(-slope * after(2))));
    }

    private boolean counts(boolean isAnswer) {
        tried += isAnswer ? 0 : 1;
        return isAnswer;
    }

    /** Nothing pulls, what does not push is fast enough, and one that pushes alone has to. */
    private boolean isLawful(boolean[] pushing) {
        boolean isLawful = true;
        for (int i = 0; i < 2; i++) {
            isLawful &= holds(pushing[i] ? impulse[i] : after(i) - before[i] - wanted[i]);
            isLawful &= !pushing[i] || pushing[1 - i] || holds(wanted[i]);
        }
        return isLawful;
    }

    private boolean holds(double condition) {
        margin = Math.min(margin, Math.abs(condition));
        return condition >= 0;
    }

    private double after(int row) {
        double after = before[row];
        for (int j = 0; j < 3; j++) {
            after += given[j][row] * impulse[j];
        }
        return after;
    }

    /** Points that push reach the wanted speed; the others have no impulse. */
    private void equate(boolean[] pushing, double[] tangent) {
        double[][] a = {new double[4], new double[4], tangent};
        for (int i = 0; i < 2; i++) {
            a[i][i] = 1;
            if (pushing[i]) {
                a[i] = new double[] {given[0][i], given[1][i], given[2][i], wanted[i]};
            }
        }
        double all = determinant(a, 0, 1, 2);
        impulse =
                new double[] {
                    determinant(a, 3, 1, 2) / all,
                    determinant(a, 0, 3, 2) / all,
                    determinant(a, 0, 1, 3) / all
                };
    }

    private static double determinant(double[][] a, int i, int j, int k) {
        return a[0][i] * (a[1][j] * a[2][k] - a[1][k] * a[2][j])
                + a[0][j] * (a[1][k] * a[2][i] - a[1][i] * a[2][k])
                + a[0][k] * (a[1][i] * a[2][j] - a[1][j] * a[2][i]);
    }

    /**
     * Scaled by s impulses do s·j·v + ½s²·j·Δv, which is to be none if all of them would do any.
     */
    private void keepEnergy() {
        double linear = 0;
        double quadratic = 0;
        for (int i = 0; i < 3; i++) {
            linear += impulse[i] * before[i];
            quadratic += impulse[i] * (after(i) - before[i]);
        }
        if (linear + quadratic / 2 > 0) {
            for (int i = 0; i < 3; i++) {
                impulse[i] *= Math.max(0, -2 * linear / quadratic);
            }
        }
    }
}
